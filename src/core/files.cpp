#include "core/files.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "pantin/error.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void cannot_read(const fs::path& file, const std::string& fact) {
    throw Error(ErrorKind::input, file.string() + ": " + fact);
}

} // namespace

std::vector<unsigned char> read_file(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) cannot_read(file, "no such file");
    if (error) cannot_read(file, "cannot be read: " + error.message());
    if (fs::is_directory(status)) cannot_read(file, "is a directory, not a file");
    if (!fs::is_regular_file(status)) cannot_read(file, "is not a regular file");

    const FileHandle handle(std::fopen(file.c_str(), "rb"));
    if (!handle) cannot_read(file, std::string("cannot be opened: ") + std::strerror(errno));
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) cannot_read(file, "cannot be read: " + error.message());
    if (size > max_input_bytes) cannot_read(file, "is larger than the limit of 1 GiB");
    std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
    const std::size_t count = bytes.empty() ? 0 : std::fread(bytes.data(), 1, bytes.size(), handle.get());
    if (std::ferror(handle.get())) cannot_read(file, std::string("cannot be read: ") + std::strerror(errno));
    bytes.resize(count); // shorter when the file shrank meanwhile
    return bytes;
}

void write_file(const fs::path& file, std::span<const unsigned char> bytes) {
    fs::path temporary = file;
    temporary += ".tmp";
    const auto fail = [&](const std::string& reason) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw Error(ErrorKind::output, file.string() + ": cannot be written: " + reason);
    };

    FileHandle handle(std::fopen(temporary.c_str(), "wb"));
    if (!handle) // what stands at the temporary name is not ours to remove
        throw Error(ErrorKind::output, file.string() + ": cannot be written: " + std::strerror(errno));
    if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), handle.get()) != bytes.size())
        fail(std::strerror(errno));
    if (std::fclose(handle.release()) != 0) fail(std::strerror(errno)); // a full disk may show only here
    std::error_code error;
    fs::rename(temporary, file, error);
    if (error) fail(error.message());
}

} // namespace pantin

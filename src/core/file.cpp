// SPDX-License-Identifier: MIT
// Files in, bytes out, and the other way: regular files of a bounded size, written under a temporary name and
// renamed (own; docs/formats.md).
#include "core/file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include <unistd.h>

#include "pantin/error.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using Handle = std::unique_ptr<std::FILE, Closer>;

std::string reason() { return errno != 0 ? std::strerror(errno) : "unknown error"; }

void require_regular(const fs::path& file) {
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status)) throw Error(ErrorKind::input, file.string() + ": no such file");
    if (fs::is_directory(status)) throw Error(ErrorKind::input, file.string() + ": is a folder, not a file");
    if (!fs::is_regular_file(status))
        throw Error(ErrorKind::input, file.string() + ": is not a regular file");
}

constexpr std::size_t read_step = 65536;

template <class Bytes> Bytes read_all(const fs::path& file, std::size_t limit) {
    require_regular(file);
    errno = 0;
    const Handle handle(std::fopen(file.c_str(), "rb"));
    if (!handle) throw Error(ErrorKind::input, file.string() + ": cannot be opened: " + reason());
    Bytes bytes;
    std::error_code unknown;
    const std::uintmax_t size = fs::file_size(file, unknown);
    if (!unknown && size <= limit)
        bytes.reserve(static_cast<std::size_t>(size) + read_step); // one copy of a large file
    std::size_t used = 0;
    for (;;) {
        bytes.resize(used + read_step);
        const std::size_t got = std::fread(bytes.data() + used, 1, read_step, handle.get());
        used += got;
        if (used > limit) throw Error(ErrorKind::input, file.string() + ": is too large");
        if (got == 0) break;
    }
    if (std::ferror(handle.get()))
        throw Error(ErrorKind::input, file.string() + ": cannot be read: " + reason());
    bytes.resize(used);
    return bytes;
}

// The temporary name carries the process, so that two runs into one folder do not meet in it.
fs::path temporary_name(const fs::path& file) {
    return file.parent_path() / ("." + file.filename().string() + "." + std::to_string(getpid()) + ".part");
}

bool write_all(const fs::path& file, std::span<const unsigned char> bytes) {
    std::FILE* handle = std::fopen(file.c_str(), "wb");
    if (!handle) return false;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), handle) == bytes.size();
    const bool flushed = written && std::fflush(handle) == 0;
    const int cause = errno;
    const bool closed = std::fclose(handle) == 0;
    if (!flushed) errno = cause;
    return flushed && closed;
}

} // namespace

std::vector<unsigned char> read_file(const fs::path& file, std::size_t limit) {
    return read_all<std::vector<unsigned char>>(file, limit);
}
std::string read_text(const fs::path& file, std::size_t limit) { return read_all<std::string>(file, limit); }

void write_file(const fs::path& file, std::span<const unsigned char> bytes) {
    const fs::path part = temporary_name(file);
    errno = 0;
    if (write_all(part, bytes) && std::rename(part.c_str(), file.c_str()) == 0) return;
    const std::string why = reason();
    std::remove(part.c_str());
    throw Error(ErrorKind::output, file.string() + ": cannot be written: " + why);
}

void write_file(const fs::path& file, std::string_view text) {
    write_file(file, std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

void create_folder(const fs::path& folder) {
    std::error_code code;
    fs::create_directories(folder, code);
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) return;
    throw Error(ErrorKind::output, folder.string() + ": folder cannot be created: " +
                                       (code ? code.message() : "a file is in the way"));
}

} // namespace pantin

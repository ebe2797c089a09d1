// SPDX-License-Identifier: MIT
// Whole files: read, replaced, refused.
#include <catch2/catch.hpp>

#include <functional>

#include "core/file.hpp"
#include "pantin/error.hpp"
#include "support/folders.hpp"

using namespace pantin;
using pantin::test::TemporaryFolder;

namespace {

ErrorKind kind_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.kind();
    }
    FAIL("no error");
    return ErrorKind::internal;
}

} // namespace

TEST_CASE("A file is written whole and read back, and nothing else is left in the folder", "[core]") {
    const TemporaryFolder folder;
    for (const std::string& text : {std::string(), std::string("one\0two", 7), std::string(200'000, 'x')}) {
        write_file(folder / "file", text);
        CHECK(read_text(folder / "file") == text);
    }
    CHECK(pantin::test::read_all(folder.path()).size() == 1);
}

TEST_CASE("A write that fails keeps the old file and leaves no temporary one", "[core]") {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "taken/inside");
    CHECK(kind_of([&] { write_file(folder / "taken", "text"); }) == ErrorKind::output);
    CHECK(kind_of([&] { write_file(folder / "none/file", "text"); }) == ErrorKind::output);
    CHECK(pantin::test::read_all(folder.path()).empty());
    CHECK(std::filesystem::is_directory(folder / "taken/inside"));
}

TEST_CASE("What cannot be read is an input error", "[core]") {
    const TemporaryFolder folder;
    CHECK(kind_of([&] { read_file(folder / "none"); }) == ErrorKind::input);
    CHECK(kind_of([&] { read_file(folder.path()); }) == ErrorKind::input);
    write_file(folder / "file", "12345");
    CHECK(kind_of([&] { read_file(folder / "file", 4); }) == ErrorKind::input);
    CHECK(read_file(folder / "file", 5).size() == 5);
}

TEST_CASE("A folder is created with its parents, and once more, but not over a file", "[core]") {
    const TemporaryFolder folder;
    create_folder(folder / "a/b/c");
    create_folder(folder / "a/b/c");
    CHECK(std::filesystem::is_directory(folder / "a/b/c"));
    write_file(folder / "file", "text");
    CHECK(kind_of([&] { create_folder(folder / "file"); }) == ErrorKind::output);
    CHECK(kind_of([&] { create_folder(folder / "file/below"); }) == ErrorKind::output);
}

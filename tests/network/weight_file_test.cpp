// SPDX-License-Identifier: MIT
// The safetensors reader on good files and on every kind of bad one.
#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <cstring>

#include "core/random.hpp"
#include "pantin/error.hpp"
#include "pantin/network.hpp"

namespace pantin::network {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes file_of(const std::string& header, const Bytes& data) {
    Bytes bytes;
    for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<unsigned char>(header.size() >> (8 * i)));
    bytes.insert(bytes.end(), header.begin(), header.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    return bytes;
}

// Two floats 1.5 and −2 under the name "a", metadata model = test.
const std::string good_header =
    R"({"__metadata__":{"model":"test"},"a":{"dtype":"F32","shape":[1,2],"data_offsets":[0,8]}})";
const Bytes good_data = {0, 0, 0xc0, 0x3f, 0, 0, 0, 0xc0};

// The message of the error that reading gives; empty when there is none.
std::string failure(const Bytes& bytes) {
    try {
        const WeightFile file(bytes, "file.safetensors");
        for (const std::string& name : file.names()) file.read(name, file.shape(name));
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::weights);
        CHECK(std::string(error.what()).rfind("file.safetensors: ", 0) == 0);
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
        return error.what();
    }
    return "";
}
std::string failure(const std::string& header, const Bytes& data) { return failure(file_of(header, data)); }

std::string tensor_header(const std::string& entry) { return R"({"a":)" + entry + "}"; }

} // namespace

TEST_CASE("A small weight file is read as written") {
    const Bytes bytes = file_of(good_header, good_data);
    const WeightFile file(bytes, "file.safetensors");
    CHECK(file.metadata("model") == "test");
    CHECK(file.names() == std::vector<std::string>{"a"});
    CHECK(file.read("a", {1, 2}) == std::vector<float>{1.5f, -2.0f});
    CHECK_THROWS_WITH(file.read("a", {2}), "file.safetensors: tensor 'a' has shape [1, 2], not [2]");
    CHECK_THROWS_WITH(file.read("b", {2}), "file.safetensors: tensor 'b' is missing");
    CHECK_THROWS_WITH(file.metadata("version"), "file.safetensors: metadata 'version' is missing");
}

TEST_CASE("Half precision is widened exactly") {
    CHECK(half_to_float(0x3c00) == 1.0f);
    CHECK(half_to_float(0xc000) == -2.0f);
    CHECK(half_to_float(0x0001) == 0x1p-24f);
    CHECK(half_to_float(0x83ff) == -0x3ffp-24f);
    CHECK(half_to_float(0x7bff) == 65504.0f);
    CHECK(half_to_float(0x3555) == 0x1.554p-2f);
    CHECK(std::isinf(half_to_float(0x7c00)));
    CHECK(std::isnan(half_to_float(0x7e00)));
    CHECK(std::bit_cast<std::uint32_t>(half_to_float(0x8000)) == 0x80000000u);
    const Bytes bytes =
        file_of(tensor_header(R"({"dtype":"F16","shape":[2],"data_offsets":[0,4]})"), {0, 0x3c, 0, 0xc0});
    const WeightFile file(bytes, "file.safetensors");
    CHECK(file.read("a", {2}) == std::vector<float>{1.0f, -2.0f});
}

TEST_CASE("A weight file cut anywhere is refused") {
    const Bytes whole = file_of(good_header, good_data);
    CHECK(failure(whole).empty());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        INFO(length << " bytes");
        CHECK_FALSE(
            failure(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))).empty());
    }
}

TEST_CASE("Bytes that belong to no tensor, or to two, are refused") {
    Bytes longer = good_data;
    longer.push_back(0);
    CHECK(failure(good_header, longer) ==
          "file.safetensors: bytes after the last tensor belong to no tensor");
    const std::string two = R"("dtype":"F32","shape":[1],"data_offsets":)";
    CHECK(failure("{\"a\":{" + two + "[0,4]},\"b\":{" + two + "[0,4]}}", {0, 0, 0, 0}) ==
          "file.safetensors: tensor 'b' overlaps another one");
    CHECK(failure("{\"a\":{" + two + "[4,8]}}", good_data) ==
          "file.safetensors: bytes before tensor 'a' belong to no tensor");
}

TEST_CASE("A header that lies about a tensor is refused by name") {
    const auto about = [](const std::string& entry) { return failure(tensor_header(entry), good_data); };
    CHECK(about(R"({"dtype":"F32","shape":[2],"data_offsets":[0,8]})").empty());
    const std::string outside = "file.safetensors: tensor 'a' lies outside the file";
    CHECK(about(R"({"dtype":"F32","shape":[3],"data_offsets":[0,12]})") == outside);
    CHECK(about(R"({"dtype":"F32","shape":[2],"data_offsets":[8,0]})") == outside);
    CHECK(
        about(R"({"dtype":"F32","shape":[2],"data_offsets":[18446744073709551608,18446744073709551615]})") ==
        outside);
    CHECK(about(R"({"dtype":"F32","shape":[3],"data_offsets":[0,8]})") ==
          "file.safetensors: tensor 'a' has another size than its shape [3] says");
    const std::string shape = "file.safetensors: tensor 'a' has no valid shape";
    CHECK(about(R"({"dtype":"F32","shape":[-2],"data_offsets":[0,8]})") == shape);
    CHECK(about(R"({"dtype":"F32","shape":[2.0],"data_offsets":[0,8]})") == shape);
    CHECK(about(R"({"dtype":"F32","shape":2,"data_offsets":[0,8]})") == shape);
    CHECK(about(R"({"dtype":"F32","data_offsets":[0,8]})") == shape);
    CHECK(about(R"({"dtype":"F32","shape":[1,1,1,1,1,1,1,1,2],"data_offsets":[0,8]})") == shape);
    CHECK(about(R"({"dtype":"F32","shape":[99999999999999999999],"data_offsets":[0,8]})") == shape);
    // 2^40 · 2^40 elements would wrap around to 0 bytes
    CHECK(about(R"({"dtype":"F32","shape":[1099511627776,1099511627776],"data_offsets":[0,8]})") ==
          "file.safetensors: tensor 'a' is too large");
    const std::string offsets = "file.safetensors: tensor 'a' has no valid offsets";
    CHECK(about(R"({"dtype":"F32","shape":[2]})") == offsets);
    CHECK(about(R"({"dtype":"F32","shape":[2],"data_offsets":[0]})") == offsets);
    CHECK(about(R"({"dtype":"F32","shape":[2],"data_offsets":[0,-8]})") == offsets);
    CHECK(about(R"({"dtype":"F32","shape":[2],"data_offsets":["0","8"]})") == offsets);
    const std::string type = "file.safetensors: tensor 'a' has no known type";
    CHECK(about(R"({"dtype":"F128","shape":[2],"data_offsets":[0,8]})") == type);
    CHECK(about(R"({"dtype":7,"shape":[2],"data_offsets":[0,8]})") == type);
    CHECK(about(R"({"shape":[2],"data_offsets":[0,8]})") == type);
    CHECK(about(R"({"dtype":"I64","shape":[1],"data_offsets":[0,8]})") ==
          "file.safetensors: tensor 'a' is I64, not F32 or F16");
    CHECK(about("7") == "file.safetensors: header entry 'a' is not a table");
}

TEST_CASE("A header that is no table of tensors is refused") {
    CHECK(failure("", {}) == "file.safetensors: the header: not valid JSON (line 1)");
    CHECK(failure("{", {}) == "file.safetensors: the header: not valid JSON (line 1)");
    CHECK(failure("[]", {}) == "file.safetensors: the header is not a table of tensors");
    CHECK(failure("{\"a\xff\":{}}", {}) == "file.safetensors: the header: not valid JSON (line 1)");
    CHECK(failure(R"({"a":1,"a":2})", {}) == "file.safetensors: the header: 'a' occurs twice");
    CHECK(failure(R"({"a":{"dtype":"F32","dtype":"F32"}})", {}) ==
          "file.safetensors: the header: 'dtype' occurs twice");
    CHECK(failure(R"({"__metadata__":{"x":1}})", {}) == "file.safetensors: metadata 'x' is not a text");
    CHECK(failure(std::string(100000, '['), {}) == "file.safetensors: the header: nested too deeply");
    Bytes huge = file_of(good_header, good_data);
    for (int i = 0; i < 8; ++i) huge[i] = 0xff;
    CHECK(failure(huge) == "file.safetensors: no safetensors file, or truncated inside the header");
    const char png[] = "\x89PNG\r\n\x1a\n0000";
    CHECK_FALSE(failure(Bytes(png, png + sizeof png - 1)).empty());
}

TEST_CASE("Weights that are not finite are refused") {
    Bytes data = good_data;
    data[2] = 0x80, data[3] = 0x7f; // +∞
    CHECK(failure(good_header, data) == "file.safetensors: tensor 'a' holds a value that is not finite");
}

TEST_CASE("Random damage to a weight file never does worse than an error") {
    Random random(5);
    const Bytes whole = file_of(good_header, good_data);
    int refused = 0;
    for (int round = 0; round < 3000; ++round) {
        Bytes bytes = whole;
        const int changes = random.integer(1, 4);
        for (int i = 0; i < changes; ++i) {
            const int place = random.integer(0, static_cast<int>(bytes.size()) - 1);
            bytes[static_cast<std::size_t>(place)] = static_cast<unsigned char>(random.integer(0, 255));
        }
        refused += !failure(bytes).empty();
    }
    CHECK(refused > 1500); // what is left changed a value or a name only
}

} // namespace pantin::network

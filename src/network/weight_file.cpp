// SPDX-License-Identifier: MIT
// The safetensors format: https://github.com/huggingface/safetensors, "Format". Stricter than most readers:
// the tensors must tile the data without gap or overlap, as the specification says.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <type_traits>

#include "core/json.hpp"
#include "pantin/error.hpp"
#include "pantin/network.hpp"

namespace pantin::network {
namespace {

constexpr std::size_t length_bytes = 8;
constexpr std::size_t max_header = 100'000'000; // the specification's limit
constexpr std::size_t max_dimensions = 8;

std::uint64_t little_endian(const unsigned char* bytes, int count) {
    std::uint64_t value = 0;
    for (int i = count - 1; i >= 0; --i) value = value << 8 | bytes[i];
    return value;
}

std::size_t bytes_per_element(const std::string& type) {
    if (type == "F64" || type == "I64" || type == "U64") return 8;
    if (type == "F32" || type == "I32" || type == "U32") return 4;
    if (type == "F16" || type == "BF16" || type == "I16" || type == "U16") return 2;
    if (type == "I8" || type == "U8" || type == "BOOL") return 1;
    return 0;
}

// A key that occurs twice in one object is an error, too.
Json parse_header(const WeightFile& file, const char* begin, const char* end) {
    Json header;
    try {
        header = parse_json(std::string(begin, end), "the header", Twice::is_an_error);
    } catch (const Error& error) {
        file.fail(error.what());
    }
    if (!header.is_object()) file.fail("the header is not a table of tensors");
    return header;
}

// Number of elements; overflow and absurd shapes are errors.
std::size_t element_count(const WeightFile& file, const std::string& name,
                          const std::vector<std::int64_t>& shape) {
    std::size_t count = 1;
    for (const std::int64_t extent : shape) {
        const auto n = static_cast<std::size_t>(extent);
        if (n != 0 && count > std::numeric_limits<std::size_t>::max() / 16 / n)
            file.fail("tensor '" + name + "' is too large");
        count *= n;
    }
    return count;
}

std::string text(const std::vector<std::int64_t>& shape) {
    std::string out = "[";
    for (std::size_t i = 0; i < shape.size(); ++i) out += (i ? ", " : "") + std::to_string(shape[i]);
    return out + "]";
}

std::vector<std::int64_t> read_shape(const WeightFile& file, const std::string& name, const Json& value) {
    if (!value.is_array() || value.size() > max_dimensions)
        file.fail("tensor '" + name + "' has no valid shape");
    std::vector<std::int64_t> shape;
    for (const Json& extent : value) {
        if (!extent.is_number_unsigned() || extent.get<std::uint64_t>() > (std::uint64_t{1} << 40))
            file.fail("tensor '" + name + "' has no valid shape");
        shape.push_back(extent.get<std::int64_t>());
    }
    return shape;
}

std::pair<std::uint64_t, std::uint64_t> read_offsets(const WeightFile& file, const std::string& name,
                                                     const Json& value) {
    if (!value.is_array() || value.size() != 2 || !value[0].is_number_unsigned() ||
        !value[1].is_number_unsigned())
        file.fail("tensor '" + name + "' has no valid offsets");
    return {value[0].get<std::uint64_t>(), value[1].get<std::uint64_t>()};
}

} // namespace

float half_to_float(std::uint16_t half) {
    const std::uint32_t sign = static_cast<std::uint32_t>(half & 0x8000u) << 16;
    const std::uint32_t exponent = half >> 10 & 0x1f, mantissa = half & 0x3ff;
    if (exponent == 0) { // zero or subnormal: mantissa · 2^-24, exact in fp32
        const float magnitude = static_cast<float>(mantissa) * 0x1p-24f;
        return sign ? -magnitude : magnitude;
    }
    const std::uint32_t wide = exponent == 31 ? 255 : exponent + 112;
    return std::bit_cast<float>(sign | wide << 23 | mantissa << 13);
}

void WeightFile::fail(const std::string& fact) const {
    throw Error(ErrorKind::weights, source_ + ": " + fact);
}

WeightFile::WeightFile(std::span<const unsigned char> bytes, std::string source)
    : bytes_(bytes), source_(std::move(source)) {
    if (bytes.empty()) fail("the weight file is empty");
    if (bytes.size() < length_bytes) fail("truncated before the header");
    const std::uint64_t header_size = little_endian(bytes.data(), length_bytes);
    if (header_size > max_header || header_size > bytes.size() - length_bytes)
        fail("no safetensors file, or truncated inside the header");
    const auto* text_begin = reinterpret_cast<const char*>(bytes.data()) + length_bytes;
    const std::size_t data = length_bytes + static_cast<std::size_t>(header_size);
    const Json header = parse_header(*this, text_begin, text_begin + header_size);

    for (const auto& [name, value] : header.items()) {
        if (!value.is_object()) fail("header entry '" + name + "' is not a table");
        if (name == "__metadata__") {
            for (const auto& [key, item] : value.items()) {
                if (!item.is_string()) fail("metadata '" + key + "' is not a text");
                metadata_[key] = item.get<std::string>();
            }
            continue;
        }
        Entry entry;
        entry.type = value.value("dtype", Json()).is_string() ? value["dtype"].get<std::string>() : "";
        const std::size_t width = bytes_per_element(entry.type);
        if (width == 0) fail("tensor '" + name + "' has no known type");
        entry.shape = read_shape(*this, name, value.value("shape", Json()));
        const auto [begin, end] = read_offsets(*this, name, value.value("data_offsets", Json()));
        if (begin > end || end > bytes.size() - data) fail("tensor '" + name + "' lies outside the file");
        if (end - begin != element_count(*this, name, entry.shape) * width)
            fail("tensor '" + name + "' has another size than its shape " + text(entry.shape) + " says");
        entry.begin = data + static_cast<std::size_t>(begin);
        entry.end = data + static_cast<std::size_t>(end);
        entries_[name] = entry;
    }
    check_tiling(data);
}

// The tensors must cover the data, from byte `data` of the file on, exactly once.
void WeightFile::check_tiling(std::size_t data) const {
    std::vector<std::pair<const std::string*, const Entry*>> order;
    for (const auto& [name, entry] : entries_) order.emplace_back(&name, &entry);
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
        return a.second->begin != b.second->begin ? a.second->begin < b.second->begin
                                                  : a.second->end < b.second->end;
    });
    std::size_t covered = data;
    for (const auto& [name, entry] : order) {
        if (entry->begin < covered) fail("tensor '" + *name + "' overlaps another one");
        if (entry->begin > covered) fail("bytes before tensor '" + *name + "' belong to no tensor");
        covered = entry->end;
    }
    if (covered != bytes_.size()) fail("bytes after the last tensor belong to no tensor");
}

std::vector<std::string> WeightFile::names() const {
    std::vector<std::string> all;
    for (const auto& [name, entry] : entries_) all.push_back(name);
    return all;
}

const WeightFile::Entry& WeightFile::entry(const std::string& name) const {
    const auto found = entries_.find(name);
    if (found == entries_.end()) fail("tensor '" + name + "' is missing");
    return found->second;
}

std::vector<std::int64_t> WeightFile::shape(const std::string& name) const { return entry(name).shape; }

const std::string& WeightFile::metadata(const std::string& key) const {
    const auto found = metadata_.find(key);
    if (found == metadata_.end()) fail("metadata '" + key + "' is missing");
    return found->second;
}

const WeightFile::Entry& WeightFile::entry(const std::string& name,
                                           const std::vector<std::int64_t>& expected) const {
    const Entry& tensor = entry(name);
    if (tensor.shape != expected)
        fail("tensor '" + name + "' has shape " + text(tensor.shape) + ", not " + text(expected));
    return tensor;
}

std::vector<float> WeightFile::read(const std::string& name,
                                    const std::vector<std::int64_t>& expected) const {
    const Entry& tensor = entry(name, expected);
    if (tensor.type != "F32" && tensor.type != "F16")
        fail("tensor '" + name + "' is " + tensor.type + ", not F32 or F16");
    const int width = tensor.type == "F32" ? 4 : 2;
    std::vector<float> values((tensor.end - tensor.begin) / width);
    const unsigned char* bytes = bytes_.data() + tensor.begin;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto bits = static_cast<std::uint32_t>(little_endian(bytes + i * width, width));
        values[i] = width == 4 ? std::bit_cast<float>(bits) : half_to_float(static_cast<std::uint16_t>(bits));
        if (!std::isfinite(values[i])) fail("tensor '" + name + "' holds a value that is not finite");
    }
    return values;
}

template <class Number>
std::vector<Number> WeightFile::read_integers(const std::string& name,
                                              const std::vector<std::int64_t>& expected) const {
    const std::string type = (std::is_signed_v<Number> ? "I" : "U") + std::to_string(8 * sizeof(Number));
    const Entry& tensor = entry(name, expected);
    if (tensor.type != type) fail("tensor '" + name + "' is " + tensor.type + ", not " + type);
    std::vector<Number> values((tensor.end - tensor.begin) / sizeof(Number));
    if constexpr (sizeof(Number) == 1)
        std::memcpy(values.data(), bytes_.data() + tensor.begin, values.size());
    else
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<Number>(
                little_endian(bytes_.data() + tensor.begin + i * sizeof(Number), sizeof(Number)));
    return values;
}
template std::vector<std::int8_t> WeightFile::read_integers(const std::string&,
                                                            const std::vector<std::int64_t>&) const;
template std::vector<std::uint8_t> WeightFile::read_integers(const std::string&,
                                                             const std::vector<std::int64_t>&) const;
template std::vector<std::int32_t> WeightFile::read_integers(const std::string&,
                                                             const std::vector<std::int64_t>&) const;
template std::vector<std::int64_t> WeightFile::read_integers(const std::string&,
                                                             const std::vector<std::int64_t>&) const;

} // namespace pantin::network

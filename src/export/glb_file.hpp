// SPDX-License-Identifier: MIT
// Reads a GLB back: chunks, JSON, accessors. Shares no code with the exporter, so that tests may rely on it.
// What is damaged is a std::runtime_error or an exception of the JSON library.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pantin {

struct GlbFile {
    nlohmann::json json;
    std::vector<unsigned char> binary;

    explicit GlbFile(const std::vector<unsigned char>& bytes) {
        const auto word = [&](std::size_t at) {
            if (at + 4 > bytes.size()) throw std::runtime_error("truncated");
            return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
                   static_cast<std::uint32_t>(bytes[at + 2]) << 16 |
                   static_cast<std::uint32_t>(bytes[at + 3]) << 24;
        };
        if (word(0) != 0x46546C67 || word(4) != 2 || word(8) != bytes.size())
            throw std::runtime_error("header");
        const std::size_t text = word(12);
        if (word(16) != 0x4E4F534A || text % 4 != 0 || text > bytes.size() - 20)
            throw std::runtime_error("JSON chunk");
        json = nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + static_cast<long>(text));
        const std::size_t length = word(20 + text);
        if (word(24 + text) != 0x004E4942 || length % 4 != 0 || 28 + text + length != bytes.size())
            throw std::runtime_error("binary chunk");
        binary.assign(bytes.begin() + 28 + static_cast<long>(text), bytes.end());
    }

    // The elements of an accessor, component by component, as doubles.
    std::vector<double> read(std::size_t accessor) const {
        const auto& a = json.at("accessors").at(accessor);
        const auto& view = json.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
        const std::string type = a.at("type");
        if (type.size() < 4) throw std::runtime_error("type of an accessor");
        const std::size_t components = type == "SCALAR" ? 1
                                       : type == "MAT4" ? 16
                                                        : static_cast<std::size_t>(type[3] - '0');
        if (a.at("count").get<std::size_t>() > binary.size())
            throw std::runtime_error("accessor outside the buffer");
        const std::size_t count = a.at("count").get<std::size_t>() * components;
        const int component = a.at("componentType");
        const std::size_t size = component == 5123 ? 2 : 4;
        const std::size_t offset = view.at("byteOffset").get<std::size_t>();
        if (count * size > view.at("byteLength").get<std::size_t>() || offset > binary.size() ||
            count * size > binary.size() - offset)
            throw std::runtime_error("accessor outside the buffer");
        std::vector<double> values;
        for (std::size_t i = 0; i < count; ++i) {
            const unsigned char* at = binary.data() + offset + i * size;
            std::uint32_t raw = 0;
            for (std::size_t b = 0; b < size; ++b) raw |= static_cast<std::uint32_t>(at[b]) << (8 * b);
            float real = 0;
            std::memcpy(&real, &raw, 4);
            values.push_back(component == 5126 ? static_cast<double>(real) : static_cast<double>(raw));
        }
        return values;
    }
};

} // namespace pantin

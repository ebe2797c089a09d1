// SPDX-License-Identifier: MIT
// Numbers in, the binary chunk and the accessors of a GLB out (glTF 2.0 specification, 3.6 and 4.4).
#include "export/glb_buffer.hpp"
#include "core/json.hpp"

#include <algorithm>
#include <bit>

namespace pantin {

namespace {

int components_of(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "MAT4") return 16;
    return type.back() - '0'; // VEC2, VEC3, VEC4
}

void put_little_endian(std::vector<unsigned char>& bytes, std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<unsigned char>(value >> (8 * i) & 255));
}

void pad(std::vector<unsigned char>& bytes, unsigned char filler) {
    while (bytes.size() % 4 != 0) bytes.push_back(filler);
}

} // namespace

GlbBuffer::GlbBuffer()
    : accessors_(std::make_unique<Json>(Json::array())), views_(std::make_unique<Json>(Json::array())) {}
GlbBuffer::~GlbBuffer() = default;

void GlbBuffer::put(std::uint32_t value, int size) { put_little_endian(bytes_, value, size); }

std::size_t GlbBuffer::begin_view() {
    pad(bytes_, 0);
    return bytes_.size();
}

int GlbBuffer::add_view(std::size_t offset, int target) {
    Json view = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes_.size() - offset}};
    if (target != 0) view["target"] = target;
    views_->push_back(std::move(view));
    return static_cast<int>(views_->size()) - 1;
}

int GlbBuffer::add_accessor(int view, int component_type, std::size_t count, const char* type) {
    accessors_->push_back(
        {{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}});
    return static_cast<int>(accessors_->size()) - 1;
}

int GlbBuffer::add_floats(const std::vector<float>& values, const char* type, int target, bool bounds) {
    const std::size_t offset = begin_view();
    for (const float value : values) put(std::bit_cast<std::uint32_t>(value), 4);
    const std::size_t components = static_cast<std::size_t>(components_of(type));
    const int index = add_accessor(add_view(offset, target), gltf_float, values.size() / components, type);
    if (!bounds) return index;
    Json low = Json::array(), high = Json::array();
    for (std::size_t c = 0; c < components; ++c) {
        float least = values[c], most = values[c];
        for (std::size_t i = c; i < values.size(); i += components) {
            least = std::min(least, values[i]);
            most = std::max(most, values[i]);
        }
        low.push_back(static_cast<double>(least));
        high.push_back(static_cast<double>(most));
    }
    accessors_->back()["min"] = std::move(low);
    accessors_->back()["max"] = std::move(high);
    return index;
}

int GlbBuffer::add_joints(const std::vector<std::array<std::uint16_t, 4>>& joints) {
    const std::size_t offset = begin_view();
    for (const auto& four : joints)
        for (const std::uint16_t joint : four) put(joint, 2);
    return add_accessor(add_view(offset, gltf_array_buffer), gltf_unsigned_short, joints.size(), "VEC4");
}

int GlbBuffer::add_indices(const std::vector<std::uint32_t>& indices) {
    const std::size_t offset = begin_view();
    for (const std::uint32_t index : indices) put(index, 4);
    return add_accessor(add_view(offset, gltf_element_array_buffer), gltf_unsigned_int, indices.size(),
                        "SCALAR");
}

int GlbBuffer::add_bytes(std::span<const unsigned char> bytes) {
    const std::size_t offset = begin_view();
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return add_view(offset, 0);
}

std::vector<unsigned char> pack_glb(const std::string& json, const std::vector<unsigned char>& binary) {
    std::vector<unsigned char> text(json.begin(), json.end()), data = binary;
    pad(text, ' ');
    pad(data, 0);
    std::vector<unsigned char> glb;
    glb.reserve(28 + text.size() + data.size());
    put_little_endian(glb, 0x46546C67, 4); // "glTF"
    put_little_endian(glb, 2, 4);
    put_little_endian(glb, static_cast<std::uint32_t>(28 + text.size() + data.size()), 4);
    put_little_endian(glb, static_cast<std::uint32_t>(text.size()), 4);
    put_little_endian(glb, 0x4E4F534A, 4); // "JSON"
    glb.insert(glb.end(), text.begin(), text.end());
    put_little_endian(glb, static_cast<std::uint32_t>(data.size()), 4);
    put_little_endian(glb, 0x004E4942, 4); // "BIN"
    glb.insert(glb.end(), data.begin(), data.end());
    return glb;
}

} // namespace pantin

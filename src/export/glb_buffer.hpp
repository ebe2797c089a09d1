// SPDX-License-Identifier: MIT
// The binary chunk of a GLB and the JSON arrays that describe it (glTF 2.0 specification, 3.6 and 4.4).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/json.hpp"

namespace pantin {

// Values of glTF's enumerations.
inline constexpr int gltf_unsigned_short = 5123, gltf_unsigned_int = 5125, gltf_float = 5126;
inline constexpr int gltf_array_buffer = 34962, gltf_element_array_buffer = 34963;

// Collects typed arrays; every function returns the index that glTF refers to them by.
class GlbBuffer {
public:
    GlbBuffer();
    ~GlbBuffer();

    // `values` holds count × components floats; with `bounds` the accessor gets min and max.
    // target 0: no hint (for what is no vertex attribute).
    int add_floats(const std::vector<float>& values, const char* type, int target, bool bounds = false);
    int add_joints(const std::vector<std::array<std::uint16_t, 4>>& joints);
    int add_indices(const std::vector<std::uint32_t>& indices);
    // A bare buffer view, for an image. Add it last, so that no offset depends on an encoder's length.
    int add_bytes(std::span<const unsigned char> bytes);

    const Json& accessors() const { return *accessors_; }
    const Json& views() const { return *views_; }
    const std::vector<unsigned char>& bytes() const { return bytes_; }

private:
    std::vector<unsigned char> bytes_;
    std::unique_ptr<Json> accessors_, views_;

    int add_view(std::size_t offset, int target);
    int add_accessor(int view, int component_type, std::size_t count, const char* type);
    std::size_t begin_view();
    void put(std::uint32_t value, int size); // little-endian
};

// Header, JSON chunk and binary chunk (glTF 2.0, 4.4), each padded to four bytes.
std::vector<unsigned char> pack_glb(const std::string& json, const std::vector<unsigned char>& binary);

} // namespace pantin

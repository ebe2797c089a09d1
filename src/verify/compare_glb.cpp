// SPDX-License-Identifier: MIT
// A GLB as JSON with the values of its accessors in place, and its picture apart: what it says, whatever the
// PNG encoder.
#include <nlohmann/json.hpp>

#include "core/digest.hpp"
#include "core/json.hpp"
#include "export/glb_file.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "verify/bytes.hpp"
#include "verify/values.hpp"

namespace pantin {

namespace {

struct GlbValues {
    Json json;
    RgbaImage picture; // empty when there is none
};

GlbValues take_apart(const std::string& name, const std::string& bytes) {
    GlbFile glb(std::vector<unsigned char>(bytes.begin(), bytes.end()));
    GlbValues values;
    nlohmann::json& json = glb.json;
    for (std::size_t i = 0; i < json.at("accessors").size(); ++i)
        json["accessors"][i]["values"] = glb.read(i);
    json.at("asset").erase("generator"); // holds the version
    json.erase("buffers");               // its length depends on the encoder of the picture
    if (json.contains("images")) {
        nlohmann::json& view =
            json.at("bufferViews").at(json["images"].at(0).at("bufferView").get<std::size_t>());
        const auto offset = view.at("byteOffset").get<std::size_t>(),
                   length = view.at("byteLength").get<std::size_t>();
        if (offset > glb.binary.size() || length > glb.binary.size() - offset)
            throw std::runtime_error("picture outside the buffer");
        values.picture = decode_rgba(std::span(glb.binary).subspan(offset, length), name);
        view.erase("byteLength");
    }
    values.json = parse_json(json.dump(), name);
    return values;
}

GlbValues values_of(const std::string& name, const std::string& bytes) {
    try {
        return take_apart(name, bytes);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) { // of the reader and of the JSON library
        throw Error(ErrorKind::input, name + ": is damaged or no GLB (" + error.what() + ")");
    }
}

} // namespace

void compare_glb(Differences& differences, const std::string& name, const std::string& first,
                 const std::string& second) {
    const GlbValues a = values_of(name, first), b = values_of(name, second);
    compare_json(differences, name, to_compact_json_text(a.json), to_compact_json_text(b.json));
    compare_pictures(differences, "picture, ", a.picture, b.picture);
}

std::string encoded_values(const std::string& name, const std::string& bytes) {
    const auto pixels = [](const RgbaImage& image) {
        Digest digest;
        digest.add(image);
        return digest.text();
    };
    if (name.ends_with(".png")) return pixels(decode_rgba(as_bytes(bytes), name));
    if (!name.ends_with(".glb")) return bytes;
    const GlbValues glb = values_of(name, bytes);
    return to_compact_json_text(glb.json) + pixels(glb.picture);
}

} // namespace pantin

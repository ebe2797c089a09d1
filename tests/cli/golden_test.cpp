// SPDX-License-Identifier: MIT
// Golden digests of every file of the demo page, of the preset `thesis` and of a model (docs/determinism.md
// says what is digested, and how to update them).
#include <catch2/catch.hpp>

#include <cstdlib>
#include <sstream>

#include "cli/demo.hpp"
#include "core/digest.hpp"
#include "export/glb_file.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "support/films.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

void add(Digest& digest, const Film& film) {
    for (std::size_t i = 0; i < film.frames.size(); ++i) {
        digest.add(film.frames[i]);
        digest.add(film.delays[i]);
    }
}

// The picture's encoded bytes, and the lengths that they decide, are left out; its pixels are put in.
void add_glb(Digest& digest, const std::vector<unsigned char>& bytes) {
    GlbFile glb(bytes);
    glb.json["asset"].erase("generator");
    if (!glb.json.contains("images")) {
        digest.add(glb.binary.data(), glb.binary.size());
        digest.add(glb.json.dump());
        return;
    }
    auto& views = glb.json["bufferViews"];
    auto& picture = views[glb.json["images"][0]["bufferView"].get<std::size_t>()];
    const auto offset = picture["byteOffset"].get<std::size_t>(),
               length = picture["byteLength"].get<std::size_t>();
    const TemporaryFolder folder;
    write(folder / "picture.png", {reinterpret_cast<const char*>(glb.binary.data()) + offset, length});
    digest.add(load_image(folder / "picture.png", 1));
    digest.add(glb.binary.data(), offset);
    picture.erase("byteLength");
    glb.json.erase("buffers");
    digest.add(glb.json.dump());
}

std::string digest_of(const std::filesystem::path& folder, const std::string& name,
                      const std::string& bytes) {
    Digest digest;
    const std::vector<unsigned char> data(bytes.begin(), bytes.end());
    if (name.ends_with(".png"))
        digest.add(load_image(folder / name, 1));
    else if (name.ends_with(".glb"))
        add_glb(digest, data);
    else if (name.ends_with(".webp"))
        add(digest, read_webp(data));
    else if (name.ends_with(".gif"))
        add(digest, read_gif(data));
    else
        digest.add(bytes);
    return digest.text();
}

std::map<std::string, std::string> read_golden(const std::string& golden_file) {
    std::map<std::string, std::string> golden;
    std::istringstream lines(read(golden_file));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        golden[line.substr(18)] = line.substr(0, 16);
    }
    return golden;
}

// `call`: how the folder was made; the first line of the file.
void check_golden(const std::filesystem::path& folder, const std::string& golden_file,
                  const std::string& call) {
    std::map<std::string, std::string> found;
    for (const auto& [name, bytes] : read_all(folder)) found[name] = digest_of(folder, name, bytes);
    if (std::getenv("PANTIN_UPDATE_GOLDEN")) {
        std::string text = "# " + call + "; see docs/determinism.md\n";
        for (const auto& [name, digest] : found) text += digest + "  " + name + "\n";
        write(golden_file, text);
    }
    for (const auto& [name, digest] : read_golden(golden_file)) {
        // A program that was built without an encoder lacks its films, nothing else.
        if (name.ends_with(".webp") && !webp_available()) continue;
        if (name.ends_with(".gif") && !gif_available()) continue;
        CAPTURE(name);
        CHECK(found.count(name) == 1);
        CHECK(found[name] == digest);
        found.erase(name);
    }
    // Without WebP the films are APNGs.
    if (!webp_available())
        std::erase_if(found, [](const auto& file) { return file.first.ends_with(".apng"); });
    CHECK(found.empty());
}

} // namespace

TEST_CASE("Every file of the demo page has its golden digest", "[cli][end-to-end][golden]") {
    check_golden(animated_demo(), "tests/golden/demo.txt",
                 "pantin animate testdata/demo.png --size 64 --fps 5");
}

TEST_CASE("Every file of the preset thesis has its golden digest", "[cli][end-to-end][golden]") {
    check_golden(
        animated_thesis(), "tests/golden/thesis.txt",
        "pantin animate testdata/vectors/thesis/NAME/page.png -o NAME --preset thesis --size 64 --fps 5");
}

TEST_CASE("Every file of a model has its golden digest", "[cli][end-to-end][golden][model]") {
    check_golden(animated_model(), "tests/golden/model.txt",
                 "pantin model testdata/models/cat.json --animate --clip idle --size 64 --fps 5");
}

// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cstdlib>
#include <map>
#include <regex>

#include "pantin/pipeline.hpp"
#include "support/folders.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

std::map<std::string, std::string> values_of(const Options& options) {
    const auto list = list_options(options);
    return {list.begin(), list.end()};
}

// Another value of the same type, for switches and for numbers that may be 0 and 1.
std::string another(const std::string& value) {
    if (value == "true" || value == "false") return value == "true" ? "false" : "true";
    return value == "1" ? "0" : "1";
}

std::string config_error(const std::string& json) {
    const TemporaryFolder folder;
    write(folder / "config.json", json);
    Options options;
    try {
        apply_config(options, folder / "config.json");
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        const std::string message = error.what(), file = (folder / "config.json").string();
        REQUIRE(message.starts_with(file + ": "));
        return message.substr(file.size() + 2);
    }
    return "no error";
}

} // namespace

TEST_CASE("A configuration sets options by name, nested or dotted, and leaves the others", "[pipeline]") {
    const TemporaryFolder folder;
    write(folder / "config.json", R"({"skeletonization": {"residual": "arc", "residual_threshold": 12.5},
                                      "identification.use_evidence": false, "rigging": {"limb_segments": 3}})");
    Options options;
    apply_config(options, folder / "config.json");
    auto expected = values_of(Options{});
    expected["skeletonization.residual"] = "\"arc\"";
    expected["skeletonization.residual_threshold"] = "12.5";
    expected["identification.use_evidence"] = "false";
    expected["rigging.limb_segments"] = "3";
    CHECK(values_of(options) == expected);
    CHECK(options.skeletonization.residual == Residual::arc);
}

TEST_CASE("What list_options prints is a configuration", "[pipeline]") {
    const TemporaryFolder folder;
    const Options thesis = make_preset("thesis");
    std::string json;
    for (const auto& [name, value] : list_options(thesis))
        json += (json.empty() ? "{\"" : ",\"") + name + "\":" + value;
    write(folder / "config.json", json + "}");
    Options options;
    apply_config(options, folder / "config.json");
    CHECK(list_options(options) == list_options(thesis));
}

TEST_CASE("The former name of an option is taken for the new one, and not listed", "[pipeline]") {
    const auto defaults = values_of(Options{});
    CHECK_FALSE(renamed_options().empty());
    for (const auto& [former, name] : renamed_options()) {
        CAPTURE(former, name);
        REQUIRE(defaults.contains(std::string(name)));
        CHECK_FALSE(defaults.contains(std::string(former)));
        const std::string value = another(defaults.at(std::string(name)));
        const std::string quoted = '"' + std::string(former) + "\":" + value;
        Options options;
        apply_config_text(options, "{" + quoted + "}", "test");
        auto expected = defaults;
        expected[std::string(name)] = value;
        CHECK(values_of(options) == expected);
        CHECK(config_error("{" + quoted + ",\"" + std::string(name) + "\":" + value + "}") ==
              std::string(former) + ": is given twice, also as '" + std::string(name) + "'");
    }
    CHECK(config_error(R"({"segmentation": {"sure_enough": "very"}})") ==
          "segmentation.sure_enough: must be a number");
}

TEST_CASE("A former switch counts as the choice that it stands for", "[pipeline]") {
    CHECK_FALSE(former_switches().empty());
    for (const FormerSwitch& option : former_switches())
        for (const bool value : {true, false}) {
            CAPTURE(option.former, value);
            const std::string given = '"' + std::string(option.former) + "\":" + (value ? "true" : "false");
            Options options;
            apply_config_text(options, "{" + given + "}", "test");
            auto expected = values_of(Options{});
            expected[std::string(option.name)] =
                '"' + std::string(value ? option.if_true : option.if_false) + '"';
            CHECK(values_of(options) == expected);
            if (option.former != option.name)
                CHECK(config_error("{" + given + ",\"" + std::string(option.name) + "\":\"literal\"}") ==
                      std::string(option.former) + ": is given twice, also as '" + std::string(option.name) +
                          "'");
        }
    CHECK(config_error(R"({"segmentation": {"grey_erosion": "often"}})") ==
          "segmentation.grey_erosion: must be never or photographs or always");
    CHECK(config_error(R"({"segmentation": {"grey_erosion": 1}})") ==
          "segmentation.grey_erosion: must be a string");
}

TEST_CASE("A wrong configuration is an error that names the file and the option", "[pipeline]") {
    CHECK(config_error(R"({"skeletonization": {"colour": 1}})") ==
          "there is no option 'skeletonization.colour'");
    CHECK(config_error(R"({"skeletonization": 1})") == "there is no option 'skeletonization'");
    CHECK(config_error(R"({"skeletonization": {"residual_threshold": "wide"}})") ==
          "skeletonization.residual_threshold: must be a number");
    CHECK(config_error(R"({"skeletonization": {"residual": "angle"}})") ==
          "skeletonization.residual: must be arc or chord");
    CHECK(config_error(R"({"rigging": {"limb_segments": 1.5}})") ==
          "rigging.limb_segments: must be a whole number");
    CHECK(config_error(R"({"detection": {"working_size": 1000000}})") ==
          "detection.working_size: must lie between 64 and 2048");
    CHECK(config_error(R"({"identification": {"use_ilp": 1}})") ==
          "identification.use_ilp: must be true or false");
    CHECK(config_error(R"({"rigging.alpha": 1, "rigging": {"alpha": 2}})") ==
          "rigging.alpha: is given twice");
    CHECK(config_error("[]") == "must be an object");
    CHECK(config_error("{\"rigging\":") == "not valid JSON (line 1)");
    CHECK(config_error("") == "not valid JSON (line 1)");
    std::string deep;
    for (int i = 0; i < 10000; ++i) deep += "{\"a\":";
    CHECK(config_error(deep + "1" + std::string(10000, '}')) == "nested too deeply");
    CHECK(config_error(deep.substr(0, 50) + "1" + std::string(10, '}')).find("is nested too deeply") !=
          std::string::npos);
}

TEST_CASE("The thesis preset is the thesis: arc residual, 321 pixels, holes kept, its score", "[pipeline]") {
    const Options thesis = make_preset("thesis");
    CHECK(thesis.detection.working_size == 321);
    CHECK(thesis.skeletonization.residual == Residual::arc);
    CHECK(thesis.skeletonization.residual_threshold == 30);
    CHECK(thesis.skeletonization.merge_distance == 5);
    CHECK(thesis.skeletonization.fill_holes_share == 0);
    CHECK(thesis.detection.mask == MaskSource::network);
    CHECK_FALSE(thesis.segmentation.refine_silhouette);
    CHECK(thesis.segmentation.grey_erosion == GreyErosion::photographs);
    CHECK(thesis.skeletonization.thinning_stop == ThinningStop::either);
    CHECK(thesis.identification.thesis_score);
    CHECK(thesis.identification.solver == GgdSolver::literal);
    CHECK(thesis.identification.ilp.gap == 0.00005);
    CHECK(thesis.identification.ilp.iterations == 10'000);
    CHECK(thesis.identification.k_n == 0.38);
    CHECK(thesis.identification.k_n_replaces == KnReading::k_v);
    CHECK(thesis.identification.mirrored == Mirroring::none);
    CHECK_FALSE(thesis.identification.reject_unmovable);
    CHECK(thesis.rigging.weight_ends == WeightEnds::all);
    CHECK(thesis.animation.clips == ClipSet::thesis);
    CHECK_FALSE(thesis.identification.use_evidence);
    CHECK(thesis.rigging.thesis_weights);
    CHECK(thesis.rigging.mapping.length_in_pixels);
    CHECK_FALSE(thesis.rigging.mesh.interpolate_distance);
    CHECK_THROWS_AS(make_preset("fast"), Error);
}

TEST_CASE("docs/formats.md lists every option with its value in both presets", "[pipeline][golden]") {
    std::string document = read("docs/formats.md");
    const auto thesis = values_of(make_preset("thesis"));
    const std::string head = "| option | `default` | `thesis` |\n|---|---|---|\n";
    std::string table = head;
    for (const auto& [name, value] : list_options(make_preset("default")))
        table += "| `" + name + "` | " + value + " | " + (thesis.at(name) == value ? "" : thesis.at(name)) +
                 " |\n";
    const std::size_t begin = document.find(head);
    REQUIRE(begin != std::string::npos);
    const std::size_t end = document.find("\n\n", begin) + 1;
    if (std::getenv("PANTIN_UPDATE_GOLDEN"))
        write("docs/formats.md", document.replace(begin, end - begin, table));
    INFO("PANTIN_UPDATE_GOLDEN=1 make test TEST_ARGS='[golden]' writes the table");
    CHECK(read("docs/formats.md").substr(begin, table.size()) == table);
}

namespace {

// The text between the braces of every `struct …Options {`.
std::vector<std::string> option_structs(const std::string& header) {
    std::vector<std::string> bodies;
    for (std::size_t at = header.find("Options {\n"); at != std::string::npos;
         at = header.find("Options {\n", at + 1))
        bodies.push_back(header.substr(at, header.find("\n};", at) - at));
    return bodies;
}

// The names that a declaration such as `double k_v = 1, k_e = 1;` gives a default.
std::vector<std::string> fields_of(const std::string& body) {
    const std::regex field(R"(\n    (?:double|int|long|bool|Residual|OsbForm|std::array<[^>]*>)\s([^;]*);)");
    const std::regex name(R"((?:^|,)\s*(\w+)\s*=)");
    std::vector<std::string> names;
    for (std::sregex_iterator f(body.begin(), body.end(), field), none; f != none; ++f) {
        const std::string line = (*f)[1].str();
        for (std::sregex_iterator n(line.begin(), line.end(), name); n != none; ++n)
            names.push_back((*n)[1].str());
    }
    return names;
}

} // namespace

TEST_CASE("Every field of the option structs has a name in the configuration", "[pipeline]") {
    std::string options;
    for (const auto& [name, value] : list_options(Options{})) options += "." + name + ".";
    int count = 0;
    for (const std::string header :
         {"detection", "segmentation", "skeletonization", "identification", "rigging"})
        for (const std::string& body : option_structs(read("include/pantin/" + header + ".hpp")))
            for (const std::string& field : fields_of(body)) {
                if (field == "threads") continue; // a setting of the run, not an option
                CAPTURE(header, field);
                ++count;
                CHECK(options.find("." + field + ".") != std::string::npos);
            }
    CHECK(count > 60);
}

// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "core/json.hpp"
#include "core/yaml.hpp"
#include "pantin/error.hpp"

using namespace pantin;

namespace {

std::string message_of(const std::string& text, Twice twice = Twice::last_wins) {
    try {
        parse_json(text, "a.json", twice);
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        return error.what();
    }
    return "no error";
}

} // namespace

TEST_CASE("JSON in braces: pairs with a string first are an object, all else a list") {
    CHECK(to_compact_json_text(Json{{"a", 1}, {"b", {1, 2.5, "x"}}}) == R"({"a":1,"b":[1,2.5,"x"]})");
    CHECK(to_compact_json_text(Json{1, "a"}) == R"([1,"a"])");
    CHECK(to_compact_json_text(Json::array({{{"a", nullptr}}})) == R"([{"a":null}])");
    CHECK(to_compact_json_text(Json(std::vector<std::pair<int, int>>{{1, 2}, {3, 4}})) == "[[1,2],[3,4]]");
    CHECK(to_compact_json_text(Json()) == "null");
    CHECK(to_compact_json_text(Json::object()) == "{}");
}

TEST_CASE("JSON members keep the order of insertion; a second value of a key takes the first one's place") {
    Json json;
    json["z"] = true;
    json["a"]["b"] = -1;
    json["z"] = false;
    json["list"].push_back(std::uint64_t{18446744073709551615u});
    CHECK(to_json_text(json) ==
          "{\n  \"z\": false,\n  \"a\": {\n    \"b\": -1\n  },\n  \"list\": [18446744073709551615]\n}\n");
    const Json copy = json;
    json["a"]["b"] = 2;
    CHECK(copy["a"]["b"].get<int>() == -1);
    CHECK(copy.find("none") == copy.end());
    CHECK(copy.value("none", 7).get<int>() == 7);
}

TEST_CASE("What a JSON value is not is an internal error") {
    const Json list{1, 2};
    CHECK_THROWS_AS(list[2], Error);
    CHECK_THROWS_AS(list["a"], Error);
    CHECK_THROWS_AS(list.get<double>(), Error);
    CHECK_THROWS_AS(list[0].get<std::string>(), Error);
    CHECK_THROWS_AS(list[0].get<bool>(), Error);
    CHECK_THROWS_AS(Json("a").get<int>(), Error);
    CHECK_THROWS_AS(to_json_text(std::nan("")), Error);
    CHECK_THROWS_AS(to_json_text(std::numeric_limits<double>::infinity()), Error);
    Json number = 1;
    CHECK_THROWS_AS(number.push_back(2), Error);
    CHECK_THROWS_AS(number["a"], Error);
}

TEST_CASE("JSON text is parsed to the value that it was written from") {
    const Json json{{"text", "\"\\\n\x01\xC3\xA4"},
                    {"numbers", {0, -7, 0.1, 1e300}},
                    {"nothing", nullptr},
                    {"yes", true},
                    {"none", Json::array()}};
    CHECK(parse_json(to_json_text(json), "a.json") == json);
    CHECK(parse_json(to_compact_json_text(json), "a.json") == json);
    CHECK(parse_json("1", "a.json") == Json(1.0));
    CHECK(parse_json("-1", "a.json") != Json(18446744073709551615u));
    CHECK(parse_json("{\"a\":1,\"a\":2}", "a.json") == Json{{"a", 2}});
}

TEST_CASE("Bad JSON is an error that names file and line") {
    CHECK(message_of("") == "a.json: not valid JSON (line 1)");
    CHECK(message_of("{\n\"a\": 1,\n}") == "a.json: not valid JSON (line 3)");
    CHECK(message_of("[1] 2") == "a.json: not valid JSON (line 1)");
    CHECK(message_of("\"\xff\"") == "a.json: not valid JSON (line 1)");
    CHECK(message_of("[1e999]") == "a.json: not valid JSON (line 1)");
    CHECK(message_of(std::string(100'000, '[')) == "a.json: nested too deeply");
    CHECK(message_of("{\"a\":{},\"a\":2}", Twice::is_an_error) == "a.json: 'a' occurs twice");
    CHECK(is_utf8("\xC3\xA4"));
    CHECK_FALSE(is_utf8("\xC3"));
}

TEST_CASE("YAML becomes JSON", "[needs-yaml]") {
    CHECK(parse_yaml("a: 012\nb: [x, 2.5, '3', true, null]\nc:\n- d: e\n", "a.yaml") ==
          Json{{"a", "012"}, {"b", {"x", "2.5", "3", "true", nullptr}}, {"c", Json::array({{{"d", "e"}}})}});
    CHECK(parse_yaml("a: 1\na: 2\n? [b, c]\n: 3\n", "a.yaml") == Json{{"a", "1"}});
    CHECK_THROWS_WITH(parse_yaml("a: [", "a.yaml"), Catch::Matchers::StartsWith("a.yaml: is not valid YAML"));
    // Ten lists of ten of the list before: a text of few bytes that stands for 10^10 values.
    std::string text = "- &a0 x\n";
    for (int i = 1; i <= 10; ++i) {
        text += "- &a" + std::to_string(i) + " [";
        for (int k = 0; k < 10; ++k) text += (k ? ", *a" : "*a") + std::to_string(i - 1);
        text += "]\n";
    }
    CHECK_THROWS_WITH(parse_yaml(text, "a.yaml"), Catch::Matchers::Contains("too deep or too large"));
}

// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "explain/markup.hpp"
#include "pantin/error.hpp"

using namespace pantin;

namespace {

std::string uri_of(const std::string& text) {
    return data_uri("x/y", {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

} // namespace

TEST_CASE("base64 of RFC 4648's examples", "[explain]") {
    const std::pair<const char*, const char*> examples[] = {{"", ""},
                                                            {"f", "Zg=="},
                                                            {"fo", "Zm8="},
                                                            {"foo", "Zm9v"},
                                                            {"foob", "Zm9vYg=="},
                                                            {"fooba", "Zm9vYmE="},
                                                            {"foobar", "Zm9vYmFy"}};
    for (const auto& [text, code] : examples) CHECK(uri_of(text) == std::string("data:x/y;base64,") + code);
    CHECK(uri_of("\xff\xfe\xfd") == "data:x/y;base64,//79");
}

TEST_CASE("text cannot become markup", "[explain]") {
    CHECK(escaped("a<b>&\"'c") == "a&lt;b&gt;&amp;&quot;&#39;c");
    const Json value = {{"name", "</script><!--"}};
    const std::string text = script_json(value);
    CHECK(text.find('<') == std::string::npos);
    CHECK(nlohmann::json::parse(text)["name"] == "</script><!--");
}

TEST_CASE("decimals are rounded and without trailing zeros", "[explain]") {
    CHECK(decimal(1.25, 1) == "1.2"); // the nearest even of a tie
    CHECK(decimal(3.0) == "3");
    CHECK(decimal(-0.04) == "0");
    CHECK(decimal(-1.26) == "-1.3");
    CHECK(decimal(100, 0) == "100");
    CHECK(percent(0.4567, 1) == "45.7 %");
}

TEST_CASE("a template's places are all filled, or it is an error", "[explain]") {
    CHECK(filled("a {{x}} b {{y z}}", {{"x", "1"}, {"y z", "{{x}}"}}) ==
          "a 1 b {{x}}"); // what is filled in is not filled again
    CHECK_THROWS_AS(filled("{{x}}", {}), Error);
    CHECK_THROWS_AS(filled("{{x", {{"x", "1"}}), Error);
    CHECK_THROWS_AS(asset("no-such-file"), Error);
}

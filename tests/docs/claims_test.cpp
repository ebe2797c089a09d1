// SPDX-License-Identifier: MIT
// What docs/thesis-to-code.md claims for its rows: the words of a claim, its errata, and whatever it names of
// options, presets, recipes and optimisers, against the code.
#include <algorithm>
#include <map>

#include "docs/thesis_to_code.hpp"
#include "pantin/error.hpp"
#include "pantin/options.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

Names split(const std::string& text, const std::string& separator) {
    Names parts;
    std::size_t begin = 0;
    for (std::size_t end = text.find(separator); end != std::string::npos;
         end = text.find(separator, begin)) {
        parts.push_back(text.substr(begin, end - begin));
        begin = end + separator.size();
    }
    parts.push_back(text.substr(begin));
    return parts;
}

// --- errata ----------------------------------------------------------------------------------------------

// "erratum 7", "errata 5, 6", "errata 1 to 7, 9" to the numbers; none for anything else.
std::vector<int> errata_of(const std::string& part) {
    static const std::regex one(R"(erratum (\d+))"), some(R"(errata ([\d, to]+))"),
        range(R"((\d+)(?: to (\d+))?)");
    std::smatch match;
    std::vector<int> numbers;
    if (std::regex_match(part, match, one)) return {std::stoi(match[1])};
    if (!std::regex_match(part, match, some)) return {};
    for (const std::string& item : split(match[1], ", ")) {
        std::smatch ends;
        if (!std::regex_match(item, ends, range)) return {};
        const int first = std::stoi(ends[1]), last = ends[2].matched ? std::stoi(ends[2]) : first;
        if (ends[2].matched && last <= first) return {};
        for (int n = first; n <= last; ++n) numbers.push_back(n);
    }
    if (numbers.size() < 2) return {};
    return numbers;
}

std::vector<int> errata_in(const std::string& document) {
    static const std::regex item("(?:^|\n)(\\d+)\\. ");
    std::vector<int> numbers;
    for (std::sregex_iterator match(document.begin(), document.end(), item), end; match != end; ++match)
        numbers.push_back(std::stoi((*match)[1]));
    return numbers;
}

// --- options and constants -------------------------------------------------------------------------------

// "thesis: identification.k_v=1", or "" when this is the value in that preset, else what is wrong.
std::string wrong_value(const std::string& quoted) {
    static const std::regex value(R"((\w+): ([\w.]+)=(.+))"),
        option(R"((detection|segmentation|skeletonization|identification|rigging|modeling|animation)\..*)");
    std::smatch match;
    if (!std::regex_match(quoted, match, value))
        return std::regex_match(quoted, option) ? "an option without preset and value" : "";
    Options options;
    try {
        options = make_preset(match[1].str());
    } catch (const Error&) {
        return "no preset";
    }
    for (const auto& [name, actual] : list_options(options))
        if (name == match[2]) return actual == match[3] ? "" : "is " + actual;
    return "no option";
}

// `NAME = value` at the beginning of a line of Python.
bool has_constant(const std::string& source, const std::string& name, const std::string& value) {
    return std::regex_search(source, std::regex("(^|\n)" + name + " = " + value + "(?=\\s)"));
}

std::string python_of(const Row& row) {
    std::string text;
    for (const Link& link : links_in(row.code))
        if (link.file.ends_with(".py")) text += read(thesis_to_code.parent_path() / link.file) + "\n";
    return text;
}

struct Optimiser {
    std::string words, call;
};
const std::vector<Optimiser> optimisers = {{"tochastic gradient descent", "torch.optim.SGD("},
                                           {"AdamW", "torch.optim.AdamW("}};

// --- claims ----------------------------------------------------------------------------------------------

// One part of a claim between semicolons; values of options are joined by commas.
bool is_part(const std::string& part) {
    static const std::regex values(R"(`[^`]+=[^`]+`(, `[^`]+=[^`]+`)*)"), reason("(differs|missing): .{6,}");
    return part == "as printed" || !errata_of(part).empty() || std::regex_match(part, reason) ||
           std::regex_match(part, values);
}

bool is_example(const std::string& place) {
    return place.find("Fig.") != std::string::npos || place.find("Table") != std::string::npos;
}

// A claim begins with a word of its own and says nothing twice.
bool is_claim(const Row& row) {
    const bool nothing = row.code.starts_with("not applicable: ");
    if (row.claim == "—") return nothing || is_example(row.place);
    const Names parts = split(row.claim, "; ");
    if (!std::all_of(parts.begin(), parts.end(), is_part) || parts[0].starts_with("`")) return false;
    const auto differs = [](const std::string& p) {
        return p.starts_with("differs") || p.starts_with("missing");
    };
    const bool some_differ = std::any_of(parts.begin(), parts.end(), differs);
    const auto printed = std::count(parts.begin(), parts.end(), "as printed");
    if (printed > 0 && (parts[0] != "as printed" || some_differ || !errata_of(parts.back()).empty()))
        return false;
    return !nothing || some_differ || !errata_of(parts[0]).empty(); // what is not built is not as printed
}

struct Counts {
    long rows = 0, printed = 0, errata = 0, differ = 0, missing = 0;
};
Counts counts_of(const std::vector<Row>& rows) {
    Counts c;
    for (const Row& row : rows) {
        if (row.place.starts_with("RealSkel") || row.claim == "—") continue;
        ++c.rows;
        c.printed += row.claim.starts_with("as printed");
        const bool differs = row.claim.find("differs: ") != std::string::npos,
                   missing = row.claim.find("missing: ") != std::string::npos;
        c.differ += differs;
        c.missing += missing;
        c.errata += row.claim.starts_with("errat") && !differs && !missing;
    }
    return c;
}

} // namespace

TEST_CASE("Every row of thesis-to-code.md says as printed, erratum, differs: why, or missing", "[docs]") {
    for (const Row& row : rows_of(read(thesis_to_code))) {
        CAPTURE(row.place, row.claim);
        CHECK(is_claim(row));
    }
}

TEST_CASE("Every erratum that a claim names stands in errata.md, whose numbers have no gap", "[docs]") {
    const std::vector<int> known = errata_in(read("docs/errata.md"));
    for (std::size_t i = 0; i < known.size(); ++i) CHECK(known[i] == static_cast<int>(i) + 1);
    for (const Row& row : rows_of(read(thesis_to_code)))
        for (const std::string& part : split(row.claim, "; "))
            for (const int number : errata_of(part)) {
                CAPTURE(row.place, number);
                CHECK(std::count(known.begin(), known.end(), number) == 1);
            }
}

TEST_CASE("Values of options in thesis-to-code.md are those of the presets", "[docs]") {
    int values = 0;
    for (const Row& row : rows_of(read(thesis_to_code)))
        for (const std::string& cell : {row.what, row.claim, row.code})
            for (const std::string& quoted : quoted_in(cell)) {
                CAPTURE(row.place, quoted);
                CHECK(wrong_value(quoted) == "");
                values += quoted.find(": ") != std::string::npos && quoted.find('=') != std::string::npos;
            }
    CHECK(values > 20);
}

TEST_CASE("Rows that name an optimiser or a constant of the recipe agree with the linked code", "[docs]") {
    static const std::regex constant(R"(([A-Z_]+)=(.+))");
    int constants = 0, trainings = 0;
    for (const Row& row : rows_of(read(thesis_to_code))) {
        const std::string python = python_of(row);
        CAPTURE(row.place);
        const auto named = [&row](const Optimiser& optimiser) {
            return (row.what + row.claim).find(optimiser.words) != std::string::npos;
        };
        const bool training = std::any_of(optimisers.begin(), optimisers.end(), named);
        for (const Optimiser& optimiser : optimisers) {
            CAPTURE(optimiser.words);
            if (training) CHECK(named(optimiser) == (python.find(optimiser.call) != std::string::npos));
        }
        trainings += training;
        if ((row.what + row.code).find("`--recipe thesis`") != std::string::npos &&
            row.code.find("train_thesis") != std::string::npos)
            CHECK(python.find("args.recipe == \"thesis\"") != std::string::npos);
        for (const std::string& quoted : quoted_in(row.what)) {
            std::smatch match;
            if (!std::regex_match(quoted, match, constant)) continue;
            CAPTURE(quoted);
            CHECK(has_constant(python, match[1], match[2]));
            ++constants;
        }
    }
    CHECK(constants >= 10);
    CHECK(trainings >= 2);
}

TEST_CASE("What is said about the preset thesis counts the rows that differ", "[docs]") {
    const Counts c = counts_of(rows_of(read(thesis_to_code)));
    const std::string sentence = "Of the rows of Korpitsch 2023, " + std::to_string(c.rows) +
                                 " claim something: " + std::to_string(c.printed) + " are as printed, " +
                                 std::to_string(c.errata) + " follow an erratum, " +
                                 std::to_string(c.differ) + " differ and " + std::to_string(c.missing) +
                                 " lack something.";
    CAPTURE(sentence);
    CHECK(read(thesis_to_code).find(sentence) != std::string::npos);
    for (const char* file : {"README.md", "docs/README.md", "src/cli/command.cpp"}) {
        CAPTURE(file);
        if (c.differ + c.missing > 0) CHECK(read(file).find("to the letter") == std::string::npos);
    }
    CHECK((read("src/cli/command.cpp").find("differs in " + std::to_string(c.differ) + " places") !=
           std::string::npos) == (c.differ > 0));
}

TEST_CASE("A claim in other words, a wrong number and a wrong value are found", "[docs]") {
    const auto row = [](const std::string& claim, const std::string& code = "[`f`](f.cpp)",
                        const std::string& place = "4.4") {
        return Row{place, "w", claim, code};
    };
    CHECK(is_claim(row("as printed")));
    CHECK(is_claim(row("erratum 7; `thesis: a.b=1`, `default: a.b=2`")));
    CHECK(is_claim(row("errata 1 to 3, 7; differs: another mask")));
    CHECK(is_claim(row("missing: the stop")));
    CHECK(is_claim(row("—", "not applicable: background")));
    CHECK(is_claim(row("—", "[`f`](f.cpp)", "Fig. 4.1")));
    for (const char* claim : {"", "—", "as implemented", "differs", "differs: ", "erratum", "erratum 7, 8",
                              "errata 7", "errata 8 to 7", "as printed; differs: another mask",
                              "`thesis: a.b=1`", "missing", "erratum 7 differs: another mask"}) {
        CAPTURE(claim);
        CHECK_FALSE(is_claim(row(claim)));
    }
    CHECK_FALSE(is_claim(row("as printed", "not applicable: background")));
    CHECK(errata_of("errata 1 to 3, 7") == std::vector<int>{1, 2, 3, 7});
    CHECK(errata_in("1. a\n2. b 3. c\n  4. d\n") == std::vector<int>{1, 2});
    CHECK(wrong_value("thesis: identification.k_l=5") == "");
    CHECK(wrong_value("thesis: identification.k_l=4") == "is 5");
    CHECK(wrong_value("thesis: identification.k_q=4") == "no option");
    CHECK(wrong_value("paper: identification.k_l=5") == "no preset");
    CHECK(wrong_value("identification.k_l") == "an option without preset and value");
    CHECK(wrong_value("identification.k_l=5") == "an option without preset and value");
    CHECK(wrong_value("--weights") == "");
    CHECK(has_constant("A = 1\nRATE = 0.005   # x\n", "RATE", "0.005"));
    CHECK_FALSE(has_constant("RATE = 0.0051\n", "RATE", "0.005"));
    CHECK_FALSE(has_constant("OTHER_RATE = 0.005\n", "RATE", "0.005"));
}

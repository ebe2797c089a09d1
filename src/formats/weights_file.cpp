// SPDX-License-Identifier: MIT
// The text of weights.txt to skin weights; every bone and vertex is checked against the rig (thesis ch. 5).
#include "formats/weights_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/plural.hpp"
#include "pantin/error.hpp"

namespace pantin {

namespace {

class WeightsReader {
public:
    WeightsReader(const std::string& text, const std::string& file, const Rig& rig)
        : stream_(text), file_(file), rig_(rig), weights_(rig.mesh.vertices.size()),
          seen_(weights_.size(), false) {}

    std::vector<VertexWeights> read() {
        std::string line;
        while (std::getline(stream_, line)) {
            ++number_;
            std::istringstream words(line);
            std::string kind;
            if (!(words >> kind) || kind[0] == '#') continue;
            if (kind == "bone")
                read_bone(words);
            else if (kind == "v")
                read_vertex(words);
            else
                fail("a line begins with bone or v");
        }
        if (bones_ != rig_.bones.size())
            fail("names " + count_of(static_cast<long>(bones_), "bone") + " of " +
                 std::to_string(rig_.bones.size()));
        for (std::size_t v = 0; v < seen_.size(); ++v)
            if (!seen_[v]) fail("misses the weights of vertex " + std::to_string(v + 1));
        return weights_;
    }

private:
    std::istringstream stream_;
    std::string file_;
    const Rig& rig_;
    std::vector<VertexWeights> weights_;
    std::vector<bool> seen_;
    std::size_t bones_ = 0;
    int number_ = 0;

    [[noreturn]] void fail(const std::string& fact) const {
        throw Error(ErrorKind::input, file_ + ": line " + std::to_string(number_) + ": " + fact);
    }

    template <class Number> Number parse(const std::string& word, Number low, Number high) const {
        Number value{};
        const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
        if (result.ec != std::errc() || result.ptr != word.data() + word.size() ||
            !(value >= low && value <= high))
            fail("'" + word + "' is not a number in range");
        return value;
    }
    std::string next(std::istringstream& words, const char* what) const {
        std::string word;
        if (!(words >> word)) fail("misses " + std::string(what));
        return word;
    }

    void read_bone(std::istringstream& words) {
        const std::size_t index = parse<std::size_t>(next(words, "the bone's index"), 0, rig_.bones.size());
        const std::string name = next(words, "the bone's name");
        if (index != bones_ || index == rig_.bones.size() || rig_.bones[index].name != name)
            fail("the bones do not fit skeleton.json and identification.json");
        ++bones_;
    }

    void read_vertex(std::istringstream& words) {
        const std::size_t vertex = parse<std::size_t>(next(words, "the vertex"), 1, weights_.size()) - 1;
        if (seen_[vertex]) fail("the vertex occurs twice");
        seen_[vertex] = true;
        std::vector<std::pair<double, int>> given;
        double sum = 0;
        for (std::string word; words >> word;) {
            const int bone = parse<int>(word, 0, static_cast<int>(rig_.bones.size()) - 1);
            const double weight = parse<double>(next(words, "a weight"), 0, 1);
            sum += weight;
            if (weight > 0) given.emplace_back(weight, bone);
        }
        if (given.size() > 4) fail("more than four bones move the vertex");
        if (!(std::abs(sum - 1) < 1e-6)) fail("the weights of a vertex sum to 1");
        std::stable_sort(given.begin(), given.end(), [](auto& a, auto& b) { return a.first > b.first; });
        for (std::size_t k = 0; k < given.size(); ++k) {
            weights_[vertex].weights[k] = given[k].first;
            weights_[vertex].bones[k] = given[k].second;
        }
    }
};

} // namespace

std::vector<VertexWeights> weights_from_text(const std::string& text, const std::string& file,
                                             const Rig& rig) {
    return WeightsReader(text, file, rig).read();
}

} // namespace pantin

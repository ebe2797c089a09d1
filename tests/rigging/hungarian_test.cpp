// SPDX-License-Identifier: MIT
// Assignment against a search through all permutations.
#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/random.hpp"
#include "pantin/rigging.hpp"

using namespace pantin;

namespace {

using Matrix = std::vector<std::vector<double>>;

double cost_of(const Matrix& costs, const std::vector<int>& columns) {
    double sum = 0;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i] >= 0) sum += costs[i][columns[i]];
    return sum;
}

double best_of_all(const Matrix& costs) {
    const std::size_t n = costs.size(), m = costs[0].size();
    std::vector<int> order(std::max(n, m));
    std::iota(order.begin(), order.end(), 0);
    double best = std::numeric_limits<double>::infinity();
    do {
        double sum = 0; // row i takes column order[i], when both exist
        for (std::size_t i = 0; i < n; ++i)
            if (order[i] < static_cast<int>(m)) sum += costs[i][order[i]];
        best = std::min(best, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

} // namespace

TEST_CASE("the assignment is as cheap as the best permutation, whatever the shape of the matrix") {
    Random random(11);
    for (int round = 0; round < 150; ++round) {
        const int n = random.integer(1, 6), m = random.integer(1, 6);
        const bool ties = random.chance(0.3);
        Matrix costs(n, std::vector<double>(m));
        for (auto& row : costs)
            for (double& c : row) c = ties ? random.integer(-2, 2) : random.uniform(-1, 1);
        const std::vector<int> columns = hungarian(costs);
        REQUIRE(std::ssize(columns) == n);
        std::vector<int> used;
        for (const int c : columns)
            if (c >= 0) used.push_back(c);
        REQUIRE(std::ssize(used) == std::min(n, m));
        std::sort(used.begin(), used.end());
        REQUIRE(std::adjacent_find(used.begin(), used.end()) == used.end());
        REQUIRE(cost_of(costs, columns) == Approx(best_of_all(costs)).margin(1e-9));
    }
}

TEST_CASE("the matrix of the thesis's Eq. 4.14 is assigned by hand") {
    const Matrix costs = {{0.5, 0.7, 0.9, 1.2}, {0.3, 0.4, 3.5, 4.0}, {0.1, 4.0, 2.1, 17.0}};
    CHECK(hungarian(costs) == std::vector<int>{2, 1, 0}); // 0.9 + 0.4 + 0.1
    Matrix padded = costs;
    padded.push_back(std::vector<double>(4, 1000));
    CHECK(hungarian(padded) == std::vector<int>{2, 1, 0, 3}); // a padding row changes nothing
}

TEST_CASE("assignments without rows or columns are empty, and a broken matrix is refused") {
    CHECK(hungarian({}).empty());
    CHECK(hungarian({{}, {}}) == std::vector<int>{-1, -1});
    CHECK_THROWS(hungarian({{1, 2}, {3}}));
    CHECK_THROWS(hungarian({{1, std::numeric_limits<double>::infinity()}}));
}

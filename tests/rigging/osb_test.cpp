// SPDX-License-Identifier: MIT
// The optimal subsequence bijection against the enumeration of all order-preserving matchings.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "pantin/rigging.hpp"

using namespace pantin;

namespace {

using Matrix = std::vector<std::vector<double>>;

// Cheapest continuation after the pair (i, j), by plain recursion on the definition.
double cheapest(const Matrix& d, OsbForm form, double kappa, int i, int j) {
    const int n = static_cast<int>(d.size()), m = static_cast<int>(d[0].size());
    const auto step = [&](int k) -> double { // to row k, or to the end when k = n
        const double skipped = (k - i - 1) * kappa;
        if (form == OsbForm::icdm2007) return skipped;
        if (k > i + 1) return skipped;
        return i < 0 ? 0 : d[i][j];
    };
    double best = step(n);
    for (int k = i + 1; k < n; ++k)
        for (int l = j + 1; l < m; ++l)
            best = std::min(best, step(k) + (form == OsbForm::icdm2007 ? d[k][l] : 0) +
                                      cheapest(d, form, kappa, k, l));
    return best;
}

} // namespace

TEST_CASE("the optimal subsequence bijection is the cheapest order-preserving matching, in both forms") {
    Random random(5);
    for (int round = 0; round < 80; ++round) {
        Matrix d(random.integer(1, 5), std::vector<double>(random.integer(1, 5)));
        for (auto& row : d)
            for (double& x : row) x = random.uniform();
        const double kappa = random.uniform(0, 0.6);
        for (const OsbForm form : {OsbForm::icdm2007, OsbForm::printed}) {
            const OsbResult result = optimal_subsequence_bijection(d, form, kappa);
            REQUIRE(result.cost == Approx(cheapest(d, form, kappa, -1, -1)).margin(1e-12));
            for (std::size_t k = 1; k < result.path.size(); ++k) {
                REQUIRE(result.path[k - 1].first < result.path[k].first);
                REQUIRE(result.path[k - 1].second < result.path[k].second);
            }
        }
    }
}

TEST_CASE("the jump cost is the mean plus the population standard deviation of the row minima") {
    // Minima 1, 3: mean 2, deviation 1, κ = 3. Matching both rows costs 4, skipping one 3 + 1, both 6.
    const Matrix d = {{1, 9}, {9, 3}};
    CHECK(optimal_subsequence_bijection(d).cost == Approx(4));
    CHECK(optimal_subsequence_bijection(d, OsbForm::icdm2007, 0.5).cost == Approx(1)); // skip both
    CHECK(optimal_subsequence_bijection(d, OsbForm::icdm2007, 0.5).path.empty());
    CHECK(optimal_subsequence_bijection(d, OsbForm::icdm2007, 1.5).cost ==
          Approx(2.5)); // match the first alone
    CHECK(optimal_subsequence_bijection(d, OsbForm::icdm2007, 1.5).path ==
          std::vector<std::pair<int, int>>{{0, 0}});
}

TEST_CASE("a sequence matches itself for nothing and skipped columns cost nothing") {
    const Matrix same = {{0, 5, 5}, {5, 0, 5}, {5, 5, 0}};
    const OsbResult result = optimal_subsequence_bijection(same, OsbForm::icdm2007, 1);
    CHECK(result.cost == 0);
    CHECK(result.path == std::vector<std::pair<int, int>>{{0, 0}, {1, 1}, {2, 2}});
    const Matrix wide = {{7, 0, 7, 7}, {7, 7, 7, 0}};
    CHECK(optimal_subsequence_bijection(wide, OsbForm::icdm2007, 1).cost == 0);
}

TEST_CASE("empty sequences have a defined cost") {
    CHECK(optimal_subsequence_bijection({}).cost == 0);
    CHECK(optimal_subsequence_bijection({{}, {}}, OsbForm::icdm2007, 2).cost == 4);
    CHECK_THROWS(optimal_subsequence_bijection({{1, 2}, {3}}));
}

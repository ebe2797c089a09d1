// SPDX-License-Identifier: MIT
// Optimal subsequence bijection: a cheapest order-preserving matching of parts of two sequences.
//
// L. J. Latecki, Q. Wang, S. Koknar-Tezel, V. Megalooikonomou: Optimal Subsequence Bijection, ICDM 2007;
// thesis 4.6, Eq. 4.12 and 4.13. A shortest path through the index pairs, rows and columns strictly
// ascending, from a virtual start before (0, 0) to a virtual end after the last pair. Skipping a row costs κ,
// skipping a column nothing. In the form of 2007 a step pays the skipped rows and the pair that it enters; as
// printed in the thesis it pays either the pair that it leaves (next row) or the skipped rows (ERRATA 17).
// Ties: the predecessor with the lowest row, then the lowest column, the start before all; so skipping wins
// over matching.
#include <algorithm>
#include <limits>

#include "pantin/error.hpp"
#include "pantin/rigging.hpp"

namespace pantin {
namespace {

using Matrix = std::vector<std::vector<double>>;

// κ of Eq. 4.13: mean plus (population) standard deviation of the rows' minima.
double jump_cost_of(const Matrix& costs) {
    std::vector<double> minima;
    for (const auto& row : costs) minima.push_back(*std::min_element(row.begin(), row.end()));
    double mean = 0, variance = 0;
    for (const double x : minima) mean += x;
    mean /= static_cast<double>(minima.size());
    for (const double x : minima) variance += (x - mean) * (x - mean);
    return mean + std::sqrt(variance / static_cast<double>(minima.size()));
}

struct State {
    double cost = std::numeric_limits<double>::infinity(); // of the cheapest path that ends here
    int row = -1, column = -1;                             // its last pair but one; −1: the start
};

class ShortestPath {
public:
    ShortestPath(const Matrix& costs, OsbForm form, double kappa)
        : costs_(costs), form_(form), kappa_(kappa), n_(static_cast<int>(costs.size())),
          m_(static_cast<int>(costs.front().size())) {}

    OsbResult solve() {
        states_.assign(n_, std::vector<State>(m_));
        for (int i = 0; i < n_; ++i)
            for (int j = 0; j < m_; ++j) states_[i][j] = enter(i, j);
        State last = enter(n_, m_);
        OsbResult result;
        result.cost = last.cost;
        for (State at = last; at.row >= 0; at = states_[at.row][at.column])
            result.path.emplace_back(at.row, at.column);
        std::reverse(result.path.begin(), result.path.end());
        return result;
    }

private:
    // The best way to reach (row, column), which is the virtual end for (n, m).
    State enter(int row, int column) const {
        State best;
        best.cost = step(-1, -1, row, column);
        for (int i = 0; i < row; ++i)
            for (int j = 0; j < column; ++j) {
                const double cost = states_[i][j].cost + step(i, j, row, column);
                if (cost < best.cost) best = {cost, i, j};
            }
        return best;
    }
    double step(int i, int j, int row, int column) const {
        const double skipped = (row - i - 1) * kappa_;
        if (form_ == OsbForm::icdm2007) return skipped + (row < n_ ? costs_[row][column] : 0);
        if (row > i + 1) return skipped;
        return i >= 0 ? costs_[i][j] : 0;
    }

    const Matrix& costs_;
    OsbForm form_;
    double kappa_;
    int n_, m_;
    std::vector<std::vector<State>> states_;
};

} // namespace

OsbResult optimal_subsequence_bijection(const Matrix& costs, OsbForm form, double jump_cost) {
    if (costs.empty()) return {};
    for (const auto& row : costs)
        if (row.size() != costs.front().size())
            throw Error(ErrorKind::internal, "a cost matrix must be rectangular");
    if (costs.front().empty()) return {std::max(0.0, jump_cost) * static_cast<double>(costs.size()), {}};
    const double kappa = jump_cost >= 0 ? jump_cost : jump_cost_of(costs);
    return ShortestPath(costs, form, kappa).solve();
}

} // namespace pantin

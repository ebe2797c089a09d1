// SPDX-License-Identifier: MIT
// Minimum-cost assignment by shortest augmenting paths with potentials.
//
// H. W. Kuhn: The Hungarian method for the assignment problem, 1955; the O(n²m) form with one shortest path
// per row follows R. Jonker and A. Volgenant, 1987. A rectangular matrix needs no padding row (thesis
// Eq. 4.14; any constant above the finite costs gives the same assignment): the shorter side is assigned
// completely. Ties: rows enter in ascending order, and the path takes the lowest column among equals.
#include <limits>

#include "pantin/error.hpp"
#include "pantin/rigging.hpp"

namespace pantin {
namespace {

using Matrix = std::vector<std::vector<double>>;

Matrix transposed(const Matrix& m) {
    Matrix out(m.front().size(), std::vector<double>(m.size()));
    for (std::size_t i = 0; i < m.size(); ++i)
        for (std::size_t j = 0; j < m[i].size(); ++j) out[j][i] = m[i][j];
    return out;
}

// n ≤ m. Rows and columns count from 1; column 0 stands for "no column yet".
class Assignment {
public:
    explicit Assignment(const Matrix& costs)
        : costs_(costs), n_(static_cast<int>(costs.size())), m_(static_cast<int>(costs.front().size())),
          row_of_(m_ + 1), previous_(m_ + 1), row_potential_(n_ + 1), column_potential_(m_ + 1) {}

    std::vector<int> solve() {
        for (int row = 1; row <= n_; ++row) augment(row, shortest_path(row));
        std::vector<int> column_of(n_, -1);
        for (int column = 1; column <= m_; ++column)
            if (row_of_[column] > 0) column_of[row_of_[column] - 1] = column - 1;
        return column_of;
    }

private:
    // Dijkstra over reduced costs from `row` to the nearest free column; updates the potentials.
    int shortest_path(int row) {
        std::vector<double> distance(m_ + 1, std::numeric_limits<double>::infinity());
        std::vector<char> done(m_ + 1);
        row_of_[0] = row;
        int column = 0;
        while (row_of_[column] != 0) {
            done[column] = 1;
            const int i = row_of_[column];
            int next = 0;
            for (int j = 1; j <= m_; ++j) {
                if (done[j]) continue;
                const double reduced = costs_[i - 1][j - 1] - row_potential_[i] - column_potential_[j];
                if (reduced < distance[j]) {
                    distance[j] = reduced;
                    previous_[j] = column;
                }
                if (next == 0 || distance[j] < distance[next]) next = j;
            }
            const double step = distance[next];
            for (int j = 0; j <= m_; ++j) {
                if (done[j]) {
                    row_potential_[row_of_[j]] += step;
                    column_potential_[j] -= step;
                } else {
                    distance[j] -= step;
                }
            }
            column = next;
        }
        return column;
    }
    // Shifts the assignment along the path that ends in the free `column`.
    void augment(int row, int column) {
        while (column != 0) {
            row_of_[column] = previous_[column] == 0 ? row : row_of_[previous_[column]];
            column = previous_[column];
        }
    }

    const Matrix& costs_;
    int n_, m_;
    std::vector<int> row_of_, previous_; // [column] assigned row, previous column on the path
    std::vector<double> row_potential_, column_potential_;
};

} // namespace

std::vector<int> hungarian(const Matrix& costs) {
    if (costs.empty()) return {};
    for (const auto& row : costs) {
        if (row.size() != costs.front().size())
            throw Error(ErrorKind::internal, "a cost matrix must be rectangular");
        for (const double cost : row)
            if (!(std::abs(cost) <= 1e100))
                throw Error(ErrorKind::internal, "costs of an assignment must be finite");
    }
    if (costs.front().empty()) return std::vector<int>(costs.size(), -1);
    if (costs.size() <= costs.front().size()) return Assignment(costs).solve();
    const std::vector<int> row_of = Assignment(transposed(costs)).solve();
    std::vector<int> column_of(costs.size(), -1);
    for (std::size_t j = 0; j < row_of.size(); ++j) column_of[row_of[j]] = static_cast<int>(j);
    return column_of;
}

} // namespace pantin

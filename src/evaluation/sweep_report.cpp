// SPDX-License-Identifier: MIT
// A sweep as text and CSV.
#include <algorithm>
#include <cmath>

#include "core/csv.hpp"
#include "core/json.hpp"
#include "evaluation/cells.hpp"
#include "pantin/sweep.hpp"

namespace pantin {

namespace {

// What the overview shows of a combination.
struct Shown {
    const char *table, *group, *measure;
};
constexpr Shown overview[] = {{"detection", "all", "silhouette AP50"}, {"segmentation", "all", "mean IoU"},
                              {"identification", "all", "right"},      {"stages", "all", "rigged"},
                              {"ends", "as drawn", "parts"},           {"ends", "as pieces", "parts"}};

} // namespace

std::string sweep_to_text(const std::vector<SweptOption>& options, const std::vector<SweepResult>& results) {
    std::vector<std::vector<std::string>> table(1);
    for (const SweptOption& option : options) table[0].push_back(option.name);
    for (const Shown& shown : overview)
        table[0].push_back(shown.table == std::string("ends") ? std::string("ends ") + shown.group
                                                              : shown.measure);
    for (const SweepResult& result : results) {
        table.push_back(result.values);
        const std::vector<Measurement> rows = measurements_of(result.evaluation);
        for (const Shown& shown : overview) {
            const auto found = std::find_if(rows.begin(), rows.end(), [&](const Measurement& m) {
                return m.table == shown.table && m.group == shown.group && m.measure == shown.measure;
            });
            table.back().push_back(
                found == rows.end() || std::isnan(found->value)
                    ? "-"
                    : printed("%.3f [%.2f, %.2f]", found->value, found->interval.low, found->interval.high));
        }
    }
    std::string text;
    for (const std::vector<std::string>& row : table) {
        std::string line;
        for (std::size_t column = 0; column < row.size(); ++column) {
            std::size_t width = 0;
            for (const auto& other : table) width = std::max(width, other[column].size());
            line += (column == 0 ? "" : "  ") + row[column];
            if (column + 1 < row.size()) line += std::string(width - row[column].size(), ' ');
        }
        text += line + "\n";
    }
    return text;
}

std::string sweep_to_csv(const std::vector<SweptOption>& options, const std::vector<SweepResult>& results) {
    std::vector<std::string> heads;
    for (const SweptOption& option : options) heads.push_back(option.name);
    const auto beside = [](const std::vector<std::string>& cells, const std::string& line) {
        const std::string front = csv_line(cells);
        return front.substr(0, front.size() - 1) + "," + line + "\n";
    };
    std::string text;
    for (const SweepResult& result : results) {
        std::vector<std::string> values;
        for (const std::string& value : result.values) {
            const Json json = parse_json(value, "--sweep");
            values.push_back(json.is_string() ? json.get<std::string>() : value);
        }
        const std::string rows = measurements_to_csv(measurements_of(result.evaluation));
        for (std::size_t at = 0; at < rows.size();) {
            const std::size_t end = rows.find('\n', at);
            if (at > 0 || text.empty()) text += beside(at == 0 ? heads : values, rows.substr(at, end - at));
            at = end + 1;
        }
    }
    return text;
}

} // namespace pantin

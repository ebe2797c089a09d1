// SPDX-License-Identifier: MIT
// docs/verdicts.csv in, the last judgement of a preset's step on a drawing out.
#include "figures/verdicts.hpp"

#include <algorithm>
#include <sstream>

#include "core/file.hpp"
#include "pantin/error.hpp"

namespace pantin::figures {

Verdicts::Verdicts(const std::string& file) {
    std::istringstream text(read_text(file));
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        if (++number == 1) continue; // the header
        std::istringstream cells(line);
        std::string preset, drawing, step, verdict;
        Verdict v;
        std::getline(cells, v.date, ',');
        std::getline(cells, preset, ',');
        std::getline(cells, drawing, ',');
        std::getline(cells, step, ',');
        std::getline(cells, verdict, ',');
        std::getline(cells, v.remark); // may have commas
        if ((preset != "default" && preset != "thesis") || drawing.empty() || step.empty() ||
            (verdict != "good" && verdict != "bad"))
            throw Error(ErrorKind::input, file + ": line " + std::to_string(number) +
                                              " is not date,preset,drawing,step,verdict,remark with the "
                                              "preset default or thesis and the verdict good or bad");
        v.good = verdict == "good";
        verdicts_[{preset, drawing, step}] = v;
        if (drawing.find('#') != std::string::npos &&
            std::find(drawings_.begin(), drawings_.end(), drawing) == drawings_.end())
            drawings_.push_back(drawing);
    }
}

const Verdict* Verdicts::find(const std::string& preset, const std::string& drawing,
                              const std::string& step) const {
    const auto found = verdicts_.find({preset, drawing, step});
    return found == verdicts_.end() ? nullptr : &found->second;
}

std::string Verdicts::newest() const {
    std::string newest;
    for (const auto& [key, verdict] : verdicts_) newest = std::max(newest, verdict.date);
    return newest;
}

} // namespace pantin::figures

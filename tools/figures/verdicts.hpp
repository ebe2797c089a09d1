// SPDX-License-Identifier: MIT
// Judgements that need a person's eye, kept in a CSV file:
// date,preset,drawing,step,verdict,remark.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace pantin::figures {

struct Verdict {
    std::string date;
    bool good = false;
    std::string remark;
};

class Verdicts {
public:
    // Error(input) names the file and the line that is malformed: six columns, preset default or thesis,
    // verdict good or bad.
    explicit Verdicts(const std::string& file);

    // The last one of what a preset's step made of a drawing; null when nobody looked.
    const Verdict* find(const std::string& preset, const std::string& drawing, const std::string& step) const;
    // The drawings of testdata ("name.png#1", …) in the order of the file.
    const std::vector<std::string>& drawings() const { return drawings_; }
    std::string newest() const; // date

private:
    std::map<std::array<std::string, 3>, Verdict> verdicts_; // preset, drawing, step
    std::vector<std::string> drawings_;
};

} // namespace pantin::figures

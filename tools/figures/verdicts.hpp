// SPDX-License-Identifier: MIT
// Judgements that need a person's eye, kept in a CSV file: date,drawing,step,verdict,remark.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pantin::figures {

struct Verdict {
    std::string date;
    bool good = false;
    std::string remark;
};

class Verdicts {
public:
    // Error(input) names the file and the line that is malformed: five columns, verdict good or bad.
    explicit Verdicts(const std::string& file);

    // The last one of a drawing's step; null when nobody looked.
    const Verdict* find(const std::string& drawing, const std::string& step) const;
    // The drawings of testdata ("name.png#1", …) in the order of the file.
    const std::vector<std::string>& drawings() const { return drawings_; }
    std::string newest() const; // date

private:
    std::map<std::pair<std::string, std::string>, Verdict> verdicts_;
    std::vector<std::string> drawings_;
};

} // namespace pantin::figures

// SPDX-License-Identifier: MIT
// Axes of parts in, bars along their thin stretches out (own; for unite()).
#include "modeling/thin_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/disjoint_sets.hpp"

namespace pantin {
namespace {

// All in cells. A point is at most √5/4 from the nearest point of a body-centred cubic lattice: a part that
// is nowhere thicker may lie between its points, and one that is not much thicker comes to pieces.
constexpr double thin = 0.56;
// So far a part may be thinner without being lost: tips of all parts are cut off, and the thicker a part is
// the seldomer it is torn.
constexpr double torn = 0.75, longest_torn = 5;
constexpr double doubtful = 0.9, longest_doubtful = 12;
constexpr double bar = 0.9;     // radius of a bar
constexpr double samples = 0.5; // of an axis lie so far apart
constexpr int most_samples = 10'000;

Vec3 on(const AxisBone& bone, double t) { return bone.from + t * (bone.to - bone.from); }

// A stretch of a bone's samples.
struct Stretch {
    const AxisBone* bone;
    double from, to; // shares of the bone
    double length() const { return (to - from) * distance(bone->from, bone->to); }
    // Whether it goes on in the other one, over the joint between their bones.
    bool meets(const Stretch& other) const {
        for (const double t : {0.0, 1.0})
            for (const double u : {0.0, 1.0})
                if (ends_at(t) && other.ends_at(u) && on(*bone, t) == on(*other.bone, u)) return true;
        return false;
    }
    bool ends_at(double t) const { return t == 0 ? from == 0 : to == 1; }
};

class BarFinder {
public:
    BarFinder(const std::vector<InflatedPart>& parts, const std::vector<PartField>& fields, double cell)
        : parts_(parts), fields_(fields), cell_(cell) {}

    std::vector<ThinBar> find() {
        for (int p = 0; p < std::ssize(parts_); ++p) {
            if (!is_lost(p)) continue;
            for (const AxisBone& bone : parts_[p].axis)
                if (!bone.joins || reaches(bone)) add_bars(p, bone);
        }
        return std::move(bars_);
    }

private:
    int steps_of(const AxisBone& bone) const {
        const double steps = std::ceil(distance(bone.from, bone.to) / (samples * cell_));
        return static_cast<int>(std::clamp(steps, 1.0, 1.0 * most_samples));
    }
    double half_thickness(int part, const AxisBone& bone, double t) const {
        const bool flat = least_half_thickness(parts_[part], cell_) > 0; // which is thick enough then
        return (bone.from_radius + t * (bone.to_radius - bone.from_radius)) *
               (flat ? 1 : std::min(1.0, parts_[part].height));
    }
    // The smallest of the fields but one.
    double nearest(Vec3 p, int but) const {
        double best = std::numeric_limits<double>::infinity();
        for (int f = 0; f < std::ssize(fields_); ++f)
            if (f != but && fields_[f].box().holds(p)) best = std::min(best, fields_[f](p));
        return best;
    }
    // Stretches of a bone where the part is thinner than that and does not lie inside of another one.
    std::vector<Stretch> thinner(int part, const AxisBone& bone, double than) const {
        const int steps = steps_of(bone);
        const auto at = [&](int i) { return static_cast<double>(i) / steps; };
        const auto is_thinner = [&](int i) {
            if (half_thickness(part, bone, at(i)) >= than * cell_) return false;
            return nearest(on(bone, at(i)), part) > -2 * bar * cell_; // twice: PartField, deep inside
        };
        std::vector<Stretch> found;
        for (int i = 0; i <= steps; ++i) {
            if (!is_thinner(i)) continue;
            int last = i;
            while (last < steps && is_thinner(last + 1)) ++last;
            found.push_back({&bone, at(i), at(last)});
            i = last;
        }
        return found;
    }

    bool is_lost(int part) const {
        bool holds = parts_[part].axis.empty(); // a lattice point, wherever it lies
        for (const AxisBone& bone : parts_[part].axis)
            for (const double t : {0.0, 1.0})
                holds = holds || (!bone.joins && half_thickness(part, bone, t) >= thin * cell_);
        return longest(part, torn) > (holds ? longest_torn * cell_ : 0) ||
               longest(part, doubtful) > longest_doubtful * cell_;
    }

    // The longest way on which the part is thinner, model's units; more than 0 if it is anywhere.
    double longest(int part, double than) const {
        std::vector<Stretch> all;
        for (const AxisBone& bone : parts_[part].axis)
            if (!bone.joins)
                for (const Stretch& stretch : thinner(part, bone, than)) all.push_back(stretch);
        DisjointSets sets(all.size());
        for (int i = 0; i < std::ssize(all); ++i)
            for (int k = 0; k < i; ++k)
                if (all[i].meets(all[k])) sets.unite(i, k);
        std::vector<double> lengths(all.size() + 1, 0);
        for (int i = 0; i < std::ssize(all); ++i)
            lengths[sets.find(i)] += all[i].length() + 1e-9 * cell_; // a speck has no length
        return *std::max_element(lengths.begin(), lengths.end());
    }

    // Whether the part and the one that it hangs on are no farther apart than a bar is wide.
    bool reaches(const AxisBone& bone) const {
        const int steps = steps_of(bone);
        for (int i = 0; i <= steps; ++i) {
            const Vec3 p = on(bone, static_cast<double>(i) / steps);
            if (distance(p, bone.from) > 2 * bar * cell_ && nearest(p, -1) > 0) return false;
        }
        return true;
    }

    void add_bars(int part, const AxisBone& bone) {
        const double length = distance(bone.from, bone.to), radius = bar * cell_;
        // The round end of a bar shall not lie beyond the tip of a spike.
        const double last = bone.to_radius > 0 || length == 0 ? 1 : std::max(0.0, 1 - radius / length);
        for (const Stretch& s : thinner(part, bone, bar))
            bars_.emplace_back(on(bone, std::min(s.from, last)), on(bone, std::min(s.to, last)), radius,
                               part);
    }

    const std::vector<InflatedPart>& parts_;
    const std::vector<PartField>& fields_;
    const double cell_;
    std::vector<ThinBar> bars_;
};

} // namespace

ThinBar::ThinBar(Vec3 from, Vec3 to, double radius, int part)
    : from_(from), to_(to), radius_(radius), part_(part), box_{from, from} {
    const Vec3 reach = 3 * radius * Vec3{1, 1, 1};
    for (const Vec3 end : {from, to}) box_.include(end - reach), box_.include(end + reach);
}

double ThinBar::operator()(Vec3 p) const {
    const Vec3 along = to_ - from_;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(p - from_, along) / square, 0.0, 1.0) : 0;
    return distance(p, from_ + t * along) - radius_;
}

double least_radius(double cell) { return bar * cell; }

double least_half_thickness(const InflatedPart& part, double cell) {
    const double half_width = length(part.frame.right) * part.inflation->half_width;
    return half_width >= thin * cell && part.height * half_width < thin * cell ? bar * cell : 0;
}

std::vector<ThinBar> thin_bars(const std::vector<InflatedPart>& parts, const std::vector<PartField>& fields,
                               double cell) {
    return BarFinder(parts, fields, cell).find();
}

} // namespace pantin

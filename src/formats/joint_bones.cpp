// SPDX-License-Identifier: MIT
// Labelled joints in, labelled bones out: a human figure's as AnimatedDrawings means them (Smith et al.
// 2023), any other's by its tree.
#include "formats/joint_bones.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "formats/animated_drawings.hpp"
#include "formats/figure_tree.hpp"
#include "formats/joint_words.hpp"

namespace pantin {

namespace {

constexpr double trunk_share = 0.2; // of a limb's first bone is the trunk's, where the two meet
constexpr double inner_share = 0.4; // of a bone from inside of the trunk to a limb is the trunk's
constexpr double head_begins = 0.6, head_ends = 1.6; // of the bone to the middle of a head
constexpr int going_on = 2; // joints of a chain: the first lies where the limb begins, as a hip does
constexpr std::size_t most_pairs = 12; // beginnings of limbs between which all lines are the trunk's

Point2d between(Point2d a, Point2d b, double share) { return a + share * (b - a); }

bool is_humanoid_name(const std::string& name) {
    return std::any_of(animated_drawings_joints.begin(), animated_drawings_joints.end(),
                       [&](const AnimatedDrawingsJoint& joint) { return name == joint.name; });
}

// The trunk comes first: where a limb is no nearer, a pixel belongs to it.
std::vector<LabelledBone> humanoid_bones(const std::map<std::string, Point2d>& joints) {
    const auto at = [&](const std::string& name) { return joints.at(name); };
    std::vector<LabelledBone> all = {{Label::body, at("torso"), at("hip")},
                                     {Label::body, at("left_shoulder"), at("right_shoulder")},
                                     {Label::body, at("left_hip"), at("right_hip")}};
    for (const std::string side : {"left_", "right_"}) {
        all.push_back({Label::body, at(side + "shoulder"), at(side + "hip")});
        all.push_back({Label::limb, between(at(side + "shoulder"), at(side + "elbow"), trunk_share),
                       at(side + "elbow")});
        all.push_back({Label::limb, at(side + "elbow"), at(side + "hand")});
        all.push_back(
            {Label::limb, between(at(side + "hip"), at(side + "knee"), trunk_share), at(side + "knee")});
        all.push_back({Label::limb, at(side + "knee"), at(side + "foot")});
    }
    all.push_back({Label::head, between(at("torso"), at("neck"), head_begins),
                   between(at("torso"), at("neck"), head_ends)});
    return all;
}

class BoneMaker {
public:
    BoneMaker(const std::vector<FigureJoint>& joints, const std::vector<Label>& labels)
        : joints_(joints), labels_(labels), tree_(joints) {}

    // Of the joints that `wanted` says.
    template <class Wanted> void add(const Wanted& wanted) {
        for (const int j : tree_.parents_first())
            if (wanted(joints_[j])) add_joint(j);
    }

    bool has_trunk_and_more() const { return !trunk_.empty() && has_bone_; }

    std::vector<LabelledBone> bones() {
        const std::size_t reach = begins_.size() <= most_pairs ? begins_.size() : 1;
        for (std::size_t i = 0; i < begins_.size(); ++i)
            for (std::size_t k = i + 1; k < begins_.size() && k <= i + reach; ++k)
                trunk_.push_back({Label::body, begins_[i], begins_[k]});
        std::vector<LabelledBone> all = trunk_;
        all.insert(all.end(), others_.begin(), others_.end());
        return all;
    }

private:
    bool begins_at(int j) const {
        const Label label = labels_[j];
        return label != Label::body && label != Label::head &&
               (begins_limb(joints_[j].name) || tree_.length(j) >= going_on);
    }

    void add_joint(int j) {
        const FigureJoint& joint = joints_[j];
        const Label label = labels_[j];
        std::vector<LabelledBone>& list = label == Label::body ? trunk_ : others_;
        if (joint.parent < 0) {
            list.push_back({label, joint.place, joint.place});
            return;
        }
        const Label above = labels_[joint.parent];
        const Point2d from = joints_[joint.parent].place;
        if (label == Label::body)
            trunk_.push_back({label, from, joint.place});
        else if (above == Label::body)
            add_on_trunk(j, from);
        else
            add_bone(label, on_border(joint.parent) ? between(from, joint.place, trunk_share) : from,
                     joint.place);
    }

    // Where the parent is on the border of the trunk.
    bool on_border(int j) const {
        const int parent = joints_[j].parent;
        return (parent < 0 || labels_[parent] == Label::body) && begins_at(j);
    }

    void add_on_trunk(int j, Point2d from) {
        const FigureJoint& joint = joints_[j];
        const Label label = labels_[j];
        if (label == Label::head && is_neck(joints_[joint.parent].name)) {
            add_bone(label, between(from, joint.place, trunk_share), joint.place);
        } else if (label == Label::head) {
            const double end = tree_.children(j).empty() ? head_ends : 1;
            add_bone(label, between(from, joint.place, head_begins), between(from, joint.place, end));
        } else if (begins_at(j)) {
            trunk_.push_back({Label::body, from, joint.place});
            begins_.push_back(joint.place);
        } else {
            const Point2d middle = between(from, joint.place, inner_share);
            trunk_.push_back({Label::body, from, middle});
            add_bone(label, middle, joint.place);
        }
    }

    void add_bone(Label label, Point2d from, Point2d to) {
        others_.push_back({label, from, to});
        has_bone_ = true;
    }

    const std::vector<FigureJoint>& joints_;
    const std::vector<Label>& labels_;
    const FigureTree tree_;
    std::vector<LabelledBone> trunk_, others_;
    std::vector<Point2d> begins_; // where limbs begin
    bool has_bone_ = false;
};

} // namespace

bool has_humanoid_joints(const std::vector<FigureJoint>& joints) {
    return std::all_of(animated_drawings_joints.begin(), animated_drawings_joints.end(),
                       [&](const AnimatedDrawingsJoint& wanted) {
                           return std::any_of(joints.begin(), joints.end(),
                                              [&](const FigureJoint& j) { return j.name == wanted.name; });
                       });
}

std::vector<LabelledBone> bones_of(const std::vector<FigureJoint>& joints, const std::vector<Label>& labels) {
    if (labels.empty()) return {};
    BoneMaker maker(joints, labels);
    if (!has_humanoid_joints(joints)) {
        maker.add([](const FigureJoint&) { return true; });
        return maker.has_trunk_and_more() ? maker.bones() : std::vector<LabelledBone>{};
    }
    std::map<std::string, Point2d> places;
    for (const FigureJoint& joint : joints) places[joint.name] = joint.place;
    std::vector<LabelledBone> all = humanoid_bones(places);
    maker.add([](const FigureJoint& joint) { return !is_humanoid_name(joint.name); }); // a tail, say
    const std::vector<LabelledBone> more = maker.bones();
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace pantin

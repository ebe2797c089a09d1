// SPDX-License-Identifier: MIT
// Names and parents of joints in, their part labels and those of the silhouette out.
#include "formats/joint_labels.hpp"

#include <algorithm>
#include <limits>

#include "formats/figure_tree.hpp"
#include "formats/joint_bones.hpp"
#include "formats/joint_words.hpp"

namespace pantin {

namespace {

constexpr int least_named = 2; // joints whose names say a part
constexpr LabelSet chains{Label::limb, Label::tail, Label::wing};

class JointLabeller {
public:
    explicit JointLabeller(const std::vector<FigureJoint>& joints)
        : joints_(joints), tree_(joints), beyond_(joints.size(), 0), fin_(joints.size(), 0) {
        for (const FigureJoint& joint : joints) named_.push_back(label_of_joint_name(joint.name));
        labels_ = named_;
    }

    std::vector<Label> run() {
        const auto known = std::count_if(named_.begin(), named_.end(),
                                         [](Label label) { return label != Label::background; });
        if (known < least_named) return {};
        const std::vector<int>& order = tree_.parents_first();
        for (auto j = order.rbegin(); j != order.rend(); ++j) collect(*j);
        for (const int j : order) decide(j);
        return labels_;
    }

private:
    static unsigned bit(Label label) { return 1u << static_cast<int>(label); }

    // Which labels the names further out have.
    void collect(int j) {
        for (const int child : tree_.children(j)) {
            beyond_[j] |= beyond_[child];
            if (named_[child] != Label::background) beyond_[j] |= bit(named_[child]);
        }
    }

    void decide(int j) {
        const int parent = joints_[j].parent;
        const Label above = parent < 0 ? Label::background : labels_[parent];
        const bool on_fin = parent >= 0 && fin_[parent] && named_[j] == Label::background;
        fin_[j] = on_fin || is_fin(joints_[j].name);
        if (fin_[j]) { // a fish's tail ends in fins
            labels_[j] = chains.contains(above) || above == Label::head ? above : Label::body;
        } else if (named_[j] == Label::limb) { // a wing has an elbow
            if (above == Label::wing || above == Label::tail) labels_[j] = above;
            if (beyond_[j] & bit(Label::wing)) labels_[j] = Label::wing;
        } else if (named_[j] == Label::body && is_neck(joints_[j].name)) {
            // AnimatedDrawings' neck is the middle of the head; where a head hangs on it, it is none.
            if (!(beyond_[j] & ~bit(Label::body))) labels_[j] = Label::head;
        } else if (named_[j] == Label::background) {
            labels_[j] = chains.contains(above) || above == Label::head ? above : on_trunk(j);
        }
    }

    // Of a joint without a known name that hangs on the trunk or on nothing.
    Label on_trunk(int j) const {
        if (joints_[j].parent < 0 || tree_.children(j).size() > 1) return Label::body;
        unsigned beyond = beyond_[j];
        if (beyond & (bit(Label::wing) | bit(Label::tail))) beyond &= ~bit(Label::limb); // a wing's elbow
        for (const Label label : part_labels)
            if (beyond == bit(label)) return label;
        return beyond == 0 && !tree_.forks(j) ? Label::limb : Label::body;
    }

    const std::vector<FigureJoint>& joints_;
    const FigureTree tree_;
    std::vector<Label> named_, labels_;
    std::vector<unsigned> beyond_;
    std::vector<char> fin_; // of a fin, or unnamed on one
};

double distance_to(const LabelledBone& bone, Point2d p) {
    const Point2d d = bone.to - bone.from;
    const double n = d.x * d.x + d.y * d.y;
    const double t =
        n > 0 ? std::clamp(((p.x - bone.from.x) * d.x + (p.y - bone.from.y) * d.y) / n, 0.0, 1.0) : 0;
    return distance(p, bone.from + t * d);
}

} // namespace

std::vector<Label> labels_of_joints(const std::vector<FigureJoint>& joints) {
    return JointLabeller(joints).run();
}

LabelMap labels_from_joints(const Mask& mask, const std::vector<FigureJoint>& joints) {
    const std::vector<LabelledBone> bones = bones_of(joints, labels_of_joints(joints));
    if (bones.empty()) return {};
    LabelMap labels(mask.width(), mask.height());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            if (!mask(x, y)) continue;
            double nearest = std::numeric_limits<double>::infinity();
            for (const LabelledBone& bone : bones) {
                const double d = distance_to(bone, to_double({x, y}));
                if (d >= nearest) continue;
                nearest = d;
                labels(x, y) = static_cast<std::uint8_t>(bone.label);
            }
        }
    return labels;
}

} // namespace pantin

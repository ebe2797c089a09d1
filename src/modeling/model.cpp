// SPDX-License-Identifier: MIT
// The model as it is edited: which strokes there are, where they lie, and what follows from them.
#include <algorithm>
#include <cmath>

#include "core/plural.hpp"
#include "geometry/extent.hpp"
#include "modeling/axis_tree.hpp"
#include "modeling/frames.hpp"
#include "modeling/holes.hpp"
#include "modeling/rooted.hpp"
#include "pantin/error.hpp"
#include "pantin/model.hpp"

namespace pantin {
namespace {

[[noreturn]] void fail(const std::string& part, const std::string& what) {
    throw Error(ErrorKind::input, "part '" + part + "': " + what);
}

bool is_share(double value) { return std::isfinite(value) && value >= 0; }

// Sizes and places that later sums and products keep finite.
void check_range(const std::string& part, const Frame& frame) {
    constexpr double largest = 1e6, farthest = 1e15;
    const double size = length(frame.right);
    if (!(size >= 1 / largest && size <= largest && length(frame.origin) <= farthest))
        fail(part, "is too large, too small or too far away");
}

void check_height(const std::string& part, double height) {
    if (!(height > 0) || !std::isfinite(height)) fail(part, "its height must be positive");
}

// The point of the canvas over which a place of the model lies.
Point2d on_canvas(const Frame& frame, Vec3 p) {
    const double square = dot(frame.right, frame.right);
    return {dot(p - frame.origin, frame.right) / square, dot(p - frame.origin, frame.down) / square};
}

// Of a triangle over some of the canvas' points: how far it is in front of the canvas there at most, or
// behind it (side −1); 0 where it is over none.
double depth_above(const SolidMesh& mesh, const std::array<int, 3>& triangle, const Frame& frame,
                   const std::vector<Point2d>& points, int side) {
    std::array<Point2d, 3> corners;
    std::array<double, 3> depths{};
    for (int k = 0; k < 3; ++k) {
        const Vec3 p = mesh.vertices[triangle[k]];
        corners[k] = on_canvas(frame, p);
        depths[k] = dot(p - frame.origin, frame.out) / dot(frame.out, frame.out);
    }
    const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    double farthest = 0;
    for (const Point2d& p : points) {
        const double a = cross(corners[1] - p, corners[2] - p) / area,
                     b = cross(corners[2] - p, corners[0] - p) / area;
        if (!(a >= 0 && b >= 0 && a + b <= 1)) continue;
        const double depth = a * depths[0] + b * depths[1] + (1 - a - b) * depths[2];
        farthest = side * std::max(side * farthest, side * depth);
    }
    return farthest;
}

template <class T> T& own(std::shared_ptr<T>& shared) {
    if (shared.use_count() > 1) shared = std::make_shared<T>(*shared);
    return *shared;
}

RefinementOptions with(RefinementOptions options, const RefineSkeleton& asked) {
    options.prune = asked.prune.value_or(options.prune);
    options.merge = asked.merge.value_or(options.merge);
    options.collapse = asked.collapse.value_or(options.collapse);
    return options;
}

// The skeleton in which the joints of parts without bones are one with the joint that they hang on; a part
// that hangs on nothing keeps its bones.
JointTree without_boneless(const Connection& connection, const std::vector<ModelPart>& parts) {
    const JointTree& tree = connection.tree;
    std::vector<int> kept(tree.joints.size()), number(tree.joints.size(), -1);
    for (int j = 0; j < std::ssize(kept); ++j) {
        const int part = tree.joints[j].part;
        const Attachment& attachment = connection.attachments[part];
        kept[j] = !parts[part].stroke.bones && attachment.parent >= 0 ? attachment.parent_joint : j;
    }
    JointTree result;
    for (int j = 0; j < std::ssize(kept); ++j) {
        while (kept[j] != kept[kept[j]]) kept[j] = kept[kept[j]];
        if (kept[j] != j) continue;
        number[j] = static_cast<int>(result.joints.size());
        result.joints.push_back(tree.joints[j]);
    }
    for (const auto& [a, b] : tree.bones)
        if (kept[a] != kept[b]) result.bones.emplace_back(number[kept[a]], number[kept[b]]);
    return result;
}

// Discs of the plane in the model: balls between the width in the plane and the thickness.
std::vector<JointTree::Joint> in_space(const std::vector<SubSkeleton::Joint>& discs, const Frame& frame,
                                       double height, int part) {
    const double scale = length(frame.right) * 0.5 * (1 + height);
    std::vector<JointTree::Joint> balls;
    for (const SubSkeleton::Joint& disc : discs)
        balls.push_back({to_model(frame, disc.place), scale * disc.radius, part});
    return balls;
}

} // namespace

// What was drawn and how it was moved; all that is made of this stroke alone.
struct Model::Drawn {
    PartStroke stroke;
    Frame frame;                 // after all moves
    SubSkeletonOptions skeleton; // with what refine() asked for
    RefineSkeleton asked;        // for this part; otherwise the model's thresholds hold
    PartOutline outline;         // of skeleton and surface: the stroke without its crossings
    int holes_left_out = 0;
    std::shared_ptr<const PartAxis> axis;
    double diagonal = 0, unit = 0; // of the outline; whose shares the thresholds are
    SubSkeleton flat;
    std::shared_ptr<const Inflation> inflation; // made when it is needed
};

Model::Model(Point2d origin, const ModelOptions& options)
    : origin_(origin), options_(options), given_(options), global_(options.refinement) {}

Model::Model(const Strokes& strokes, const ModelOptions& options) : Model(strokes.origin, options) {
    for (const ModelCall& call : strokes.calls) apply(call);
}

void Model::apply(const ModelCall& call) {
    struct Caller {
        Model& model;
        void operator()(const PartStroke& c) const { model.add_part(c); }
        void operator()(const MovePart& c) const { model.move_part(c); }
        void operator()(const SetSymmetry& c) const { model.set_symmetry(c.part, c.symmetry); }
        void operator()(const RefineSkeleton& c) const { model.refine(c); }
        void operator()(const RemovePart& c) const { model.remove_part(c.part); }
        void operator()(const SetHeight& c) const { model.set_height(c.part, c.height); }
        void operator()(const RedrawPart& c) const { model.redraw_part(c); }
    };
    std::visit(Caller{*this}, call);
}

// Copies of a model share what was drawn until one of them changes it.
Model::Drawn& Model::drawn(const std::string& name) {
    for (auto& d : drawn_)
        if (d->stroke.name == name) return own(d);
    fail(name, "there is no such part");
}

void Model::check_new(const PartStroke& part) const {
    if (part.name.empty()) throw Error(ErrorKind::input, "a part has no name");
    bool has_parent = part.parent.empty();
    for (const auto& d : drawn_) {
        if (d->stroke.name == part.name) fail(part.name, "there is already a part of this name");
        has_parent = has_parent || d->stroke.name == part.parent;
    }
    if (!has_parent) fail(part.name, "its parent '" + part.parent + "' does not come before it");
    check_height(part.name, part.height);
    if (!std::isfinite(part.depth)) fail(part.name, "its depth is not a number");
}

void Model::note_repairs(const std::string& part, const SimplePolygon& outline, int holes_left_out) {
    const auto note = [&](const std::string& what) { repairs_.push_back("part '" + part + "': " + what); };
    if (outline.joined > 0)
        note("the stroke crosses itself, " + count_of(outline.joined, "lobe") + " joined by a neck");
    if (outline.cut > 0) note("the stroke crosses itself, " + count_of(outline.cut, "loop") + " cut off");
    if (outline.uncrossed > 0) note("the strip crosses itself, its sides were exchanged there");
    if (holes_left_out > 0)
        note(count_of(holes_left_out, "hole") + " left out, not inside it or too near to another border");
}

// Outline and axis of the part's stroke.
void Model::draw(Drawn& d) {
    for (const auto& old : remembered_)
        if (old->stroke.stroke == d.stroke.stroke && old->stroke.holes == d.stroke.holes) {
            d.outline = old->outline;
            d.holes_left_out = old->holes_left_out;
            d.diagonal = old->diagonal;
            d.axis = old->axis;
            d.inflation = old->inflation;
            return;
        }
    try {
        d.outline = simple_polygon(d.stroke.stroke, options_.inflation.polygon);
        d.holes_left_out = cut_holes(d.outline, d.stroke.holes, options_.inflation.polygon);
    } catch (const Error& error) {
        fail(d.stroke.name, error.what());
    }
    d.diagonal = diagonal_of(d.outline.corners);
    d.axis = std::make_shared<PartAxis>(part_axis(d.outline, options_.skeleton));
}

// How far in front of its depth a part lies for its layer: where the surfaces of lower layers are in front,
// at corners and joints of the part; behind those of higher layers for a negative one.
double Model::pushed_by_layers(const Drawn& d) {
    double push = 0;
    const int layer = d.stroke.layer, side = layer > 0 ? 1 : -1;
    std::vector<Point2d> probes = d.outline.corners;
    for (const SubSkeleton::Joint& joint : d.axis->joints) probes.push_back(joint.place);
    for (const auto& other : drawn_) {
        if (layer == 0 || (layer - other->stroke.layer) * side <= 0) continue;
        const SolidMesh mesh =
            part_surface(inflation_of(*other, options_.inflation), other->stroke.height, other->frame);
        for (const auto& triangle : mesh.triangles)
            push = side * std::max(side * push, side * depth_above(mesh, triangle, d.frame, probes, side));
    }
    return push;
}

void Model::add_part(const PartStroke& part) {
    check_new(part);
    const auto d = std::make_shared<Drawn>();
    d->stroke = part;
    d->frame = frame_of(part.view, origin_, part.depth);
    check_range(part.name, d->frame);
    d->skeleton = options_.skeleton;
    draw(*d);
    d->frame = frame_of(part.view, origin_, part.depth + pushed_by_layers(*d));
    note_repairs(part.name, d->outline, d->holes_left_out);
    drawn_.push_back(d);
    calls_.emplace_back(part);
    update();
}

void Model::redraw_part(const RedrawPart& call) {
    const auto d = std::make_shared<Drawn>(drawn(call.part));
    d->stroke.stroke = call.stroke;
    d->stroke.holes = call.holes;
    std::erase_if(d->skeleton.branch_thresholds, [](const auto& of) { return of.first >= 0; });
    d->unit = 0;
    d->inflation.reset();
    draw(*d);
    std::erase_if(repairs_,
                  [&](const std::string& line) { return line.starts_with("part '" + call.part + "': "); });
    note_repairs(call.part, d->outline, d->holes_left_out);
    for (auto& other : drawn_)
        if (other->stroke.name == call.part) other = d;
    calls_.emplace_back(call);
    update();
}

bool Model::undo() {
    if (calls_.empty()) return false;
    Model before(origin_, given_);
    before.remembered_ = drawn_;
    for (std::size_t i = 0; i + 1 < calls_.size(); ++i) before.apply(calls_[i]);
    before.remembered_.clear();
    *this = std::move(before);
    return true;
}

void Model::remove_part(const std::string& name) {
    const Drawn* gone = &drawn(name);
    std::erase_if(drawn_, [&](const auto& d) { return d.get() == gone; });
    for (auto& d : drawn_)
        if (d->stroke.parent == name) own(d).stroke.parent.clear();
    calls_.emplace_back(RemovePart{name});
    update();
}

void Model::move_part(const MovePart& move) {
    Drawn& d = drawn(move.part);
    if (!(move.scale > 0) || !std::isfinite(move.scale)) fail(move.part, "the scale must be positive");
    if (!std::isfinite(move.degrees) || !std::isfinite(dot(move.translate, move.translate)))
        fail(move.part, "a move is not a number");
    if (move.axis < 'x' || move.axis > 'z') fail(move.part, "the axis must be x, y or z");
    const Frame frame = moved(d.frame, to_model(d.frame, middle_of(d.flat.outline.corners)), move);
    check_range(move.part, frame);
    d.frame = frame;
    calls_.emplace_back(move);
    update();
}

void Model::set_symmetry(const std::string& name, Symmetry symmetry) {
    drawn(name).stroke.symmetry = symmetry;
    calls_.emplace_back(SetSymmetry{name, symmetry});
    update();
}

void Model::set_height(const std::string& name, double height) {
    Drawn& d = drawn(name);
    check_height(name, height);
    d.stroke.height = height;
    calls_.emplace_back(SetHeight{name, height});
    update();
}

void Model::refine(const RefineSkeleton& call) {
    for (const auto& value : {call.simplify, call.prune, call.merge, call.collapse})
        if (value && !is_share(*value))
            throw Error(ErrorKind::input, "refine: a threshold must be a number of at least 0");
    if (call.part.empty()) {
        if (call.branch >= 0) throw Error(ErrorKind::input, "refine: a branch without its part");
        global_ = with(global_, call);
        for (auto& d : drawn_) {
            RefineSkeleton& asked = own(d).asked;
            if (call.prune) asked.prune.reset();
            if (call.merge) asked.merge.reset();
            if (call.collapse) asked.collapse.reset();
            if (call.simplify) simplify(*d, -1, *call.simplify);
        }
        if (call.simplify) options_.skeleton.branch_thresholds = {{-1, *call.simplify}}; // of parts to come
        calls_.emplace_back(call);
        return update();
    }
    Drawn& d = drawn(call.part);
    if (call.branch >= 0) {
        if (call.prune || call.merge || call.collapse) fail(call.part, "a branch can only be simplified");
        if (call.branch >= std::ssize(d.flat.branches))
            fail(call.part, "it has no branch " + std::to_string(call.branch) + " of " +
                                std::to_string(d.flat.branches.size()));
    }
    if (call.simplify) simplify(d, call.branch, *call.simplify);
    if (call.prune) d.asked.prune = call.prune;
    if (call.merge) d.asked.merge = call.merge;
    if (call.collapse) d.asked.collapse = call.collapse;
    calls_.emplace_back(call);
    update();
}

void Model::simplify(Drawn& d, int branch, double threshold) const {
    if (branch < 0) d.skeleton.branch_thresholds.clear();
    d.skeleton.branch_thresholds[std::max(branch, -1)] = threshold;
    d.unit = 0; // simplified anew
}

double Model::diagonal() const {
    Vec3 low{}, high{};
    bool any = false;
    for (const auto& d : drawn_)
        for (const bool copy : {false, true}) {
            if (copy && d->stroke.symmetry == Symmetry::none) continue;
            const Frame frame = copy ? mirrored(d->frame, d->stroke.symmetry) : d->frame;
            for (const Point2d& corner : d->outline.corners) {
                const Vec3 p = to_model(frame, corner);
                low = any ? Vec3{std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)} : p;
                high = any ? Vec3{std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)} : p;
                any = true;
            }
        }
    return distance(low, high);
}

// Thresholds are shares of the whole model, so all parts may have to be simplified anew.
void Model::simplify_all(double whole) {
    for (auto& shared : drawn_) {
        const double unit = options_.per_part ? shared->diagonal : whole / length(shared->frame.right);
        if (shared->unit == unit) continue;
        Drawn& d = own(shared);
        d.unit = unit;
        d.flat = sub_skeleton(*d.axis, unit, d.skeleton);
    }
}

// Whether a bone between two places of a part's plane stays inside its outline.
bool Model::stays_inside(int part, Vec3 from, Vec3 to) const {
    const Frame& frame = parts_[part].frame;
    const PartOutline& outline = parts_[part].flat.outline;
    const Point2d a = on_canvas(frame, from), b = on_canvas(frame, to);
    return holds(outline, a) && !leaves(outline, a, b);
}

// Everything that follows from more than one part.
void Model::update() {
    const double whole = diagonal();
    simplify_all(whole);
    parts_.clear();
    drawn_of_.clear();
    std::vector<ParentWish> wishes;
    std::vector<JointTree> trees;
    std::vector<std::vector<JointTree::Joint>> balls;
    std::vector<RefinementOptions> limits;
    const auto part_of = [&](const std::string& name) {
        for (std::size_t p = 0; p < parts_.size(); ++p)
            if (!name.empty() && parts_[p].stroke.name == name) return static_cast<int>(p);
        return -1;
    };
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
        const Drawn& d = *drawn_[i];
        const int parent = part_of(d.stroke.parent), original = static_cast<int>(parts_.size());
        const RefinementOptions shares = with(global_, d.asked);
        for (const bool copy : {false, true}) {
            if (copy && d.stroke.symmetry == Symmetry::none) continue;
            const Frame frame = copy ? mirrored(d.frame, d.stroke.symmetry) : d.frame;
            const double unit = options_.per_part ? d.diagonal * length(frame.right) : whole;
            const int part = static_cast<int>(parts_.size());
            trees.push_back({in_space(d.flat.joints, frame, d.stroke.height, part), d.flat.bones});
            balls.push_back(in_space(d.axis->discs, frame, d.stroke.height, part));
            limits.push_back(times(shares, unit));
            limits.back().least_bone = shares.least_bone * whole;
            wishes.push_back({parent, copy ? original : -1});
            parts_.push_back({d.stroke, copy, frame, d.flat, -1});
            drawn_of_.push_back(static_cast<int>(i));
        }
    }
    connection_ = connect(trees, wishes, balls);
    for (std::size_t p = 0; p < parts_.size(); ++p) parts_[p].parent = connection_.attachments[p].parent;
    const auto inside = [this](int part, Vec3 from, Vec3 to) { return stays_inside(part, from, to); };
    skeleton_ = rooted(pantin::refine(without_boneless(connection_, parts_), limits, inside));
}

ThresholdRanges Model::ranges() const {
    ThresholdRanges ranges = threshold_ranges(without_boneless(connection_, parts_));
    const double whole = diagonal();
    for (ThresholdRange* range : {&ranges.merge, &ranges.prune, &ranges.collapse})
        if (whole > 0) *range = {range->least / whole, range->most / whole};
    return ranges;
}

const Inflation& Model::inflation_of(Drawn& drawn, const InflationOptions& options) {
    if (!drawn.inflation) drawn.inflation = std::make_shared<Inflation>(inflate(drawn.outline, options));
    return *drawn.inflation;
}

const Inflation& Model::inflation_of(int part) {
    return inflation_of(*drawn_[drawn_of_[part]], options_.inflation);
}

SolidMesh Model::surface(int part) {
    return part_surface(inflation_of(part), parts_[part].stroke.height, parts_[part].frame);
}

std::vector<InflatedPart> Model::inflated() {
    std::vector<InflatedPart> result;
    for (int p = 0; p < std::ssize(parts_); ++p)
        result.push_back({&inflation_of(p), parts_[p].stroke.height, parts_[p].frame});
    return result;
}

SolidMesh Model::united() { return unite(inflated()); }

} // namespace pantin

// SPDX-License-Identifier: MIT
// The interactive model: every call against a model that is built anew.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "modeling/solids.hpp"
#include "pantin/error.hpp"
#include "pantin/model.hpp"

using namespace pantin;

namespace {

const double nan_value = std::numeric_limits<double>::quiet_NaN(),
             infinite = std::numeric_limits<double>::infinity();

bool same(const ModelSkeleton& a, const ModelSkeleton& b) {
    return std::equal(
        a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end(), [](const auto& p, const auto& q) {
            return p.place == q.place && p.radius == q.radius && p.part == q.part && p.parent == q.parent;
        });
}
bool same(const Frame& a, const Frame& b) {
    return a.origin == b.origin && a.right == b.right && a.down == b.down && a.out == b.out;
}
bool same(const SubSkeleton& a, const SubSkeleton& b) {
    return a.outline.corners == b.outline.corners && a.bones == b.bones && a.branches == b.branches &&
           std::equal(
               a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end(),
               [](const auto& p, const auto& q) { return p.place == q.place && p.radius == q.radius; });
}
bool same(const ModelPart& a, const ModelPart& b) {
    return a.stroke == b.stroke && a.mirrored == b.mirrored && same(a.frame, b.frame) &&
           same(a.flat, b.flat) && a.parent == b.parent;
}
bool same(const Connection& a, const Connection& b) {
    return a.tree == b.tree && std::equal(a.attachments.begin(), a.attachments.end(), b.attachments.begin(),
                                          b.attachments.end(), [](const Attachment& p, const Attachment& q) {
                                              return p.parent == q.parent && p.joint == q.joint &&
                                                     p.parent_joint == q.parent_joint && p.split == q.split;
                                          });
}
bool same(const Model& a, const Model& b) {
    return same(a.skeleton(), b.skeleton()) && same(a.connection(), b.connection()) &&
           std::equal(a.parts().begin(), a.parts().end(), b.parts().begin(), b.parts().end(),
                      [](const auto& p, const auto& q) { return same(p, q); });
}

std::size_t joint_count(const Model& model) { return model.skeleton().joints.size(); }

// Keeps of every part what is left of the calls about it, and builds the model from that at once.
class Notebook {
public:
    void note(const ModelCall& call) {
        if (const auto* c = std::get_if<PartStroke>(&call)) pages_.push_back({*c, {}, {}});
        if (const auto* c = std::get_if<MovePart>(&call)) page(c->part).moves.push_back(*c);
        if (const auto* c = std::get_if<SetSymmetry>(&call)) page(c->part).stroke.symmetry = c->symmetry;
        if (const auto* c = std::get_if<RefineSkeleton>(&call)) note(*c);
        if (const auto* c = std::get_if<RemovePart>(&call)) {
            std::erase_if(pages_, [&](const Page& p) { return p.stroke.name == c->part; });
            for (Page& p : pages_)
                if (p.stroke.parent == c->part) p.stroke.parent.clear();
        }
    }
    Model built() const {
        Model model;
        for (const Page& p : pages_) model.add_part(p.stroke);
        model.refine(whole_);
        for (const Page& p : pages_) {
            for (const MovePart& move : p.moves) model.move_part(move);
            for (const RefineSkeleton& refinement : p.refinements) model.refine(refinement);
        }
        return model;
    }

private:
    struct Page {
        PartStroke stroke;
        std::vector<MovePart> moves;
        std::vector<RefineSkeleton> refinements;
    };
    Page& page(const std::string& name) {
        return *std::find_if(pages_.begin(), pages_.end(),
                             [&](const Page& p) { return p.stroke.name == name; });
    }
    // A call about the whole model undoes what was asked of its parts, as far as it says something.
    void note(const RefineSkeleton& call) {
        if (!call.part.empty()) return page(call.part).refinements.push_back(call);
        for (auto threshold : {&RefineSkeleton::simplify, &RefineSkeleton::prune, &RefineSkeleton::merge,
                               &RefineSkeleton::collapse}) {
            if (!(call.*threshold)) continue;
            whole_.*threshold = call.*threshold;
            for (Page& p : pages_)
                for (RefineSkeleton& r : p.refinements) (r.*threshold).reset();
        }
    }
    std::vector<Page> pages_;
    RefineSkeleton whole_;
};

// Calls at random, all valid. What is drawn is where other parts are, so that most of them meet.
class Sketcher {
public:
    explicit Sketcher(std::uint64_t seed) : random_(seed) {}

    ModelCall next(const Model& model) {
        std::vector<std::string> names;
        for (const ModelPart& p : model.parts())
            if (!p.mirrored) names.push_back(p.stroke.name);
        if (names.size() < 2 || (names.size() < 7 && random_.chance(0.3))) return new_part(names);
        const std::string name = random_.pick(names);
        const int what = random_.integer(0, 9);
        if (what < 3) return move(name);
        if (what < 5) return SetSymmetry{name, static_cast<Symmetry>(random_.integer(0, 3))};
        if (what < 9) return refinement(model, name);
        return RemovePart{name};
    }

private:
    PartStroke new_part(const std::vector<std::string>& names) {
        PartStroke p = test::part("part " + std::to_string(++number_),
                                  test::blob(random_, random_.integer(2, 5), 0.35, random_.uniform(20, 60)));
        const Point2d centre{random_.uniform(-60, 60), random_.uniform(-60, 60)};
        for (Point2d& q : p.stroke) q = centre + q;
        p.depth = random_.uniform(-20, 20);
        p.view = static_cast<Viewpoint>(random_.integer(0, 2));
        p.symmetry = random_.chance(0.4) ? static_cast<Symmetry>(random_.integer(1, 3)) : Symmetry::none;
        p.height = random_.uniform(0.4, 1.5);
        if (!names.empty() && random_.chance(0.5)) p.parent = random_.pick(names);
        return p;
    }
    MovePart move(const std::string& name) {
        const auto way = [&] { return random_.uniform(-10, 10); };
        return {name,
                {way(), way(), way()},
                "xyz"[random_.integer(0, 2)],
                random_.uniform(-90, 90),
                random_.uniform(0.7, 1.4)};
    }
    RefineSkeleton refinement(const Model& model, const std::string& name) {
        RefineSkeleton call;
        if (random_.chance(0.7)) call.part = name;
        if (!call.part.empty() && random_.chance(0.3)) {
            for (const ModelPart& p : model.parts())
                if (p.stroke.name == name && !p.flat.branches.empty())
                    call.branch = random_.integer(0, static_cast<int>(p.flat.branches.size()) - 1);
            call.simplify = random_.uniform(0.001, 0.05);
            return call;
        }
        if (random_.chance(0.5)) call.simplify = random_.uniform(0.001, 0.05);
        if (random_.chance(0.5)) call.prune = random_.uniform(0, 0.2);
        if (random_.chance(0.5)) call.merge = random_.uniform(0, 0.2);
        if (random_.chance(0.5)) call.collapse = random_.uniform(0, 0.1);
        return call;
    }
    Random random_;
    int number_ = 0;
};

Model two_parts() {
    Model model;
    model.add_part(test::part("body", test::capsule({-60, 0}, {60, 0}, 25)));
    model.add_part(test::part("leg", test::capsule({10, 10}, {10, 90}, 10), "body"));
    return model;
}

// Of a part alone, or of all.
std::size_t own_joints(const Model& model, const std::string& name) {
    std::size_t sum = 0;
    for (const ModelPart& part : model.parts())
        if (name.empty() || part.stroke.name == name) sum += part.flat.joints.size();
    return sum;
}

RefineSkeleton threshold(int which, double value, const std::string& part = "") {
    RefineSkeleton call;
    call.part = part;
    (which == 0 ? call.prune : which == 1 ? call.merge : which == 2 ? call.collapse : call.simplify) = value;
    return call;
}

const std::vector<double> rising = {0, 0.002, 0.006, 0.012, 0.02, 0.035, 0.05, 0.08, 0.13, 0.22, 0.4};

} // namespace

// --- editing -----------------------------------------------------------------------------------------------

TEST_CASE("a model that is edited equals one that is built at once from what is left of the calls") {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        Sketcher sketcher(seed);
        Notebook notebook;
        Strokes strokes;
        Model model;
        for (int step = 0; step < 25; ++step) {
            const ModelCall call = sketcher.next(model);
            model.apply(call);
            notebook.note(call);
            strokes.calls.push_back(call);
            if (step % 6 == 0 || step == 24) REQUIRE(same(model, notebook.built()));
        }
        CHECK(same(model, Model(strokes)));
        CHECK(same(model, Model(strokes_from_json(strokes_to_json(strokes), "strokes.json"))));
    }
}

TEST_CASE("a part that moves there and back lies where it lay") {
    Model model = two_parts();
    const Model before = model;
    for (const char axis : {'x', 'y', 'z'}) {
        model.move_part({"leg", {7, -3, 11}, axis, 35, 1.25});
        CHECK_FALSE(same(model, before));
        // Scaling and turning are about the part's centre, so they can be undone before or after the way
        // back.
        model.move_part({"leg", {}, axis, -35, 0.8});
        model.move_part({"leg", {-7, 3, -11}, axis, 0, 1});
        REQUIRE(joint_count(model) == joint_count(before));
        for (std::size_t j = 0; j < joint_count(model); ++j) {
            CHECK(distance(model.skeleton().joints[j].place, before.skeleton().joints[j].place) < 1e-9);
            CHECK(model.skeleton().joints[j].parent == before.skeleton().joints[j].parent);
        }
    }
}

TEST_CASE("moves turn about the part's own centre, scale first and translate last") {
    Model model;
    model.add_part(
        test::part("bar", test::capsule({20, -10}, {60, -10}, 5))); // its centre is (40, 10, 0) in the model
    model.move_part({"bar", {0, 0, 100}, 'z', 90, 2});
    const SolidMesh mesh = model.surface(0);
    const Vec3 low = test::lowest(mesh), high = test::highest(mesh);
    CHECK(0.5 * (low.x + high.x) == Approx(40).margin(0.1));
    CHECK(0.5 * (low.y + high.y) == Approx(10).margin(0.1));
    CHECK(0.5 * (low.z + high.z) == Approx(100).margin(0.1));
    CHECK(high.y - low.y == Approx(100).margin(0.5)); // 2 · (40 + 2 · 5), upright
    CHECK(high.x - low.x == Approx(20).margin(0.5));
    // Counter-clockwise seen from the positive end of the axis.
    Model turned;
    turned.add_part(test::part("bar", {{0, 0}, {40, 0}, {40, 4}, {0, 4}}));
    const Vec3 right = turned.parts()[0].frame.right;
    turned.move_part({"bar", {}, 'z', 90, 1});
    CHECK(right == Vec3{1, 0, 0});
    CHECK(distance(turned.parts()[0].frame.right, Vec3{0, 1, 0}) < 1e-12);
}

TEST_CASE("views, depths and mirrors lie where strokes.hpp says") {
    const auto model_point = [](Viewpoint view, double depth, Symmetry symmetry, Point2d p) {
        Model model(Point2d{100, 50});
        PartStroke stroke = test::part("p", test::disc({110, 60}, 20));
        stroke.view = view, stroke.depth = depth, stroke.symmetry = symmetry;
        model.add_part(stroke);
        return to_model(model.parts().back().frame, p);
    };
    CHECK(model_point(Viewpoint::front, 7, Symmetry::none, {103, 55}) == Vec3{3, -5, 7});
    CHECK(model_point(Viewpoint::side, 7, Symmetry::none, {103, 55}) == Vec3{7, -5, -3});
    CHECK(model_point(Viewpoint::top, 7, Symmetry::none, {103, 55}) == Vec3{3, 7, 5});
    CHECK(model_point(Viewpoint::front, 7, Symmetry::x, {103, 55}) == Vec3{-3, -5, 7});
    CHECK(model_point(Viewpoint::front, 7, Symmetry::y, {103, 55}) == Vec3{3, 5, 7});
    CHECK(model_point(Viewpoint::front, 7, Symmetry::z, {103, 55}) == Vec3{3, -5, -7});
}

TEST_CASE("invalid calls are input errors and change nothing") {
    Model model = two_parts();
    const Model before = model;
    const auto refused = [&](const std::function<void()>& call) {
        try {
            call();
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::input);
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
            CHECK(same(model, before));
            return true;
        }
        return false;
    };
    const std::vector<Point2d> round = test::disc({0, 0}, 20);
    const auto with_part = [&](const std::function<void(PartStroke&)>& change) {
        PartStroke p = test::part("new", round);
        change(p);
        return refused([&] { model.add_part(p); });
    };
    CHECK(with_part([](auto& p) { p.name.clear(); }));
    CHECK(with_part([](auto& p) { p.name = "leg"; }));
    CHECK(with_part([](auto& p) { p.parent = "new"; }));
    CHECK(with_part([](auto& p) { p.parent = "arm"; }));
    CHECK(with_part([](auto& p) { p.stroke = {{0, 0}, {1, 1}}; }));
    CHECK(with_part([](auto& p) { p.stroke = {{0, 0}, {5, 5}, {10, 10}}; }));
    CHECK(with_part([](auto& p) { p.stroke[3].x = infinite; }));
    for (const double bad : {0.0, -1.0, nan_value, infinite})
        CHECK(with_part([&](auto& p) { p.height = bad; }));
    for (const double bad : {nan_value, infinite, 1e300}) CHECK(with_part([&](auto& p) { p.depth = bad; }));
    const auto with_move = [&](const MovePart& move) { return refused([&] { model.move_part(move); }); };
    CHECK(with_move({"arm", {}, 'x', 0, 1}));
    CHECK(with_move({"leg", {nan_value, 0, 0}, 'x', 0, 1}));
    CHECK(with_move({"leg", {0, 1e300, 0}, 'x', 0, 1}));
    CHECK(with_move({"leg", {}, 'w', 0, 1}));
    for (const double bad : {infinite, nan_value, 1e300}) CHECK(with_move({"leg", {}, 'y', bad, 1}));
    for (const double bad : {0.0, -2.0, infinite, nan_value, 1e200, 1e-200})
        CHECK(with_move({"leg", {}, 'z', 0, bad}));
    CHECK(refused([&] { model.set_symmetry("arm", Symmetry::x); }));
    CHECK(refused([&] { model.remove_part("arm"); }));
    CHECK(refused([&] { model.remove_part(""); }));
    for (int which = 0; which < 4; ++which)
        for (const double bad : {-0.1, nan_value, infinite}) {
            CHECK(refused([&] { model.refine(threshold(which, bad)); }));
            CHECK(refused([&] { model.refine(threshold(which, bad, "leg")); }));
        }
    CHECK(refused([&] { model.refine(threshold(0, 0.1, "arm")); }));
    for (int which = 0; which < 3; ++which) {
        RefineSkeleton call = threshold(which, 0.1, "leg");
        call.branch = 0;
        CHECK(refused([&] { model.refine(call); }));
    }
    RefineSkeleton branch = threshold(3, 0.1);
    branch.branch = 0;
    CHECK(refused([&] { model.refine(branch); }));
    branch.part = "leg", branch.branch = 1000;
    CHECK(refused([&] { model.refine(branch); }));
    model.add_part(test::part("new", round));
    CHECK_FALSE(same(model, before));
}

TEST_CASE("numbers far out of range are refused before anything is made of them") {
    Model nowhere(Point2d{0, nan_value});
    CHECK_THROWS_AS(nowhere.add_part(test::part("p", test::disc({0, 0}, 20))), Error);
    CHECK(nowhere.parts().empty());
    // Many scalings that are fine one by one.
    Model model = two_parts();
    int refused = 0;
    for (int round = 0; round < 40; ++round) try {
            model.move_part({"leg", {}, 'x', 0, 2.5});
        } catch (const Error&) {
            ++refused;
        }
    CHECK(refused > 20);
    for (const auto& joint : model.skeleton().joints)
        CHECK(std::isfinite(length(joint.place) + joint.radius));
}

TEST_CASE("copies of a model do not change each other") {
    const Model model = two_parts();
    Model copy = model, other = model;
    copy.refine(threshold(3, 0.001));
    copy.move_part({"leg", {5, 0, 0}, 'x', 20, 1});
    copy.set_symmetry("leg", Symmetry::x);
    copy.remove_part("body");
    other.add_part(test::part("tail", test::capsule({-60, 0}, {-120, 10}, 6)));
    Model third = model;
    third.add_part(test::part("tail", test::capsule({-60, 0}, {-120, 10}, 6)));
    CHECK(same(other, third));
    CHECK(same(model, two_parts()));
}

TEST_CASE("parts of a part that is removed connect anew") {
    Model model = two_parts();
    model.add_part(test::part("shoe", test::disc({14, 92}, 12), "leg"));
    REQUIRE(model.parts()[2].parent == 1);
    model.remove_part("leg");
    REQUIRE(model.parts().size() == 2);
    CHECK(model.parts()[1].stroke.parent.empty());
    CHECK(model.parts()[1].parent == -1);
    model.add_part(test::part("leg", test::capsule({10, 10}, {10, 90}, 10)));
    CHECK(model.parts()[2].parent >= 0);
    model.remove_part("leg"), model.remove_part("shoe"), model.remove_part("body");
    CHECK(model.skeleton().joints.empty());
    CHECK(model.united().triangles.empty());
}

TEST_CASE("what was asked of a part stays until the same is asked of the whole model") {
    Model model = two_parts();
    model.refine(threshold(2, 0.3, "body"));
    const Model thinned = model;
    REQUIRE(joint_count(thinned) < joint_count(two_parts()));
    model.refine(threshold(1, RefinementOptions{}.merge)); // says nothing about collapsing
    CHECK(same(model, thinned));
    model.refine({});
    CHECK(same(model, thinned));
    model.refine(threshold(2, RefinementOptions{}.collapse));
    CHECK(same(model, two_parts()));
}

// --- refinement --------------------------------------------------------------------------------------------

TEST_CASE("larger thresholds never give more joints: whole models, parts and branches", "[needs-pugixml]") {
    const char* const operations[] = {"prune", "merge", "collapse", "simplify"};
    for (const std::string& name : test::model_names) {
        const Model drawn(test::model_strokes(name));
        const auto check_rising = [&](Model model, int which, const std::string& part, int branch,
                                      std::size_t stride) {
            std::size_t before = std::numeric_limits<std::size_t>::max(), own_before = before;
            for (std::size_t i = 0; i < rising.size(); i += stride) {
                CAPTURE(name, part, branch, operations[which], rising[i]);
                RefineSkeleton call = threshold(which, rising[i], part);
                call.branch = branch;
                model.refine(call);
                CHECK(own_joints(model, part) <= own_before);
                // Junctions that merge or hang elsewhere may make a branch too long to be pruned, on both
                // sides of a symmetric model.
                const std::size_t moved = before < 1000 ? 2 : 0;
                CHECK(joint_count(model) <= before + moved);
                CHECK(joint_count(model) > 0);
                before = joint_count(model), own_before = own_joints(model, part);
            }
        };
        for (int which = 0; which < 4; ++which) {
            check_rising(drawn, which, "", -1, 1);
            Model plain = drawn;
            plain.refine({"", -1, {}, 0.0, 0.0, 0.0});
            check_rising(plain, which, "", -1, 2);
        }
        for (const ModelPart& part : drawn.parts()) {
            if (part.mirrored) continue;
            for (int which = 0; which < 4; ++which) check_rising(drawn, which, part.stroke.name, -1, 3);
            for (int branch = 0; branch < std::ssize(part.flat.branches); branch += 4)
                check_rising(drawn, 3, part.stroke.name, branch, 3);
        }
    }
}

TEST_CASE("collapsing thins a branch of many short bones and does not shrink it to a joint") {
    Model model;
    model.add_part(test::part("bar", test::capsule({-90, 0}, {90, 0}, 12)));
    model.refine({"", -1, 1e-5, 0.0, 0.0, 0.0}); // every slice stays
    const std::size_t all = joint_count(model);
    REQUIRE(all > 60);
    model.refine(threshold(2, 0.05));
    CHECK(joint_count(model) < all / 3);
    CHECK(joint_count(model) > 8);
    double left = 0, right = 0;
    for (const auto& joint : model.skeleton().joints)
        left = std::min(left, joint.place.x), right = std::max(right, joint.place.x);
    CHECK(left < -80);
    CHECK(right > 80);
}

// SPDX-License-Identifier: MIT
// From labels to strokes, and from models to pictures, skeletons and rigs.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "modeling/solids.hpp"
#include "pantin/error.hpp"
#include "pantin/model_view.hpp"

using namespace pantin;

namespace {

void fill_ellipse(LabelMap& labels, Point2d centre, double rx, double ry, Label label) {
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) {
            const double u = (x - centre.x) / rx, v = (y - centre.y) / ry;
            if (u * u + v * v <= 1) labels(x, y) = static_cast<std::uint8_t>(label);
        }
}

// Legs and tail first, so that the body lies over their upper ends.
LabelMap animal() {
    LabelMap labels(200, 160);
    for (const double x : {60.0, 90.0, 120.0, 142.0}) fill_ellipse(labels, {x, 115}, 7, 35, Label::limb);
    fill_ellipse(labels, {30, 60}, 25, 6, Label::tail);
    fill_ellipse(labels, {100, 75}, 55, 28, Label::body);
    fill_ellipse(labels, {160, 45}, 24, 20, Label::head);
    return labels;
}

bool inside(const std::vector<Point2d>& loop, Point2d p) {
    bool in = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point2d a = loop[i], b = loop[(i + 1) % loop.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
    return in;
}

// Pixels of a label that a stroke encloses.
int enclosed(const LabelMap& labels, const std::vector<Point2d>& stroke, Label label) {
    int count = 0;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            count += labels(x, y) == static_cast<int>(label) &&
                     inside(stroke, {static_cast<double>(x), static_cast<double>(y)});
    return count;
}

std::vector<PartStroke> parts_of(const Strokes& strokes) {
    std::vector<PartStroke> parts;
    for (const ModelCall& call : strokes.calls) parts.push_back(std::get<PartStroke>(call));
    return parts;
}

double to_segment(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 v = b - a;
    const double t = dot(v, v) > 0 ? std::clamp(dot(p - a, v) / dot(v, v), 0.0, 1.0) : 0;
    return distance(p, a + t * v);
}

double to_skeleton(const ModelSkeleton& skeleton, Vec3 p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& joint : skeleton.joints) {
        const Vec3 parent = joint.parent >= 0 ? skeleton.joints[joint.parent].place : joint.place;
        nearest = std::min(nearest, to_segment(p, parent, joint.place));
    }
    return nearest;
}

// Of the rig's world (animation.hpp) back into the model.
Vec3 model_place(const ModelView& view, Point2d pixel, double depth) {
    const Point2d p = (1 / view.scale) * (pixel - view.offset);
    return {p.x, -p.y, depth * view.height / view.scale};
}

void check_graph(const SkeletonGraph& graph) {
    const int count = static_cast<int>(graph.vertices.size());
    std::vector<int> degree(graph.vertices.size()), root(graph.vertices.size());
    for (int v = 0; v < count; ++v) root[v] = v;
    const auto find = [&](int v) {
        while (root[v] != v) v = root[v];
        return v;
    };
    int wrong = 0;
    for (const SkeletonEdge& edge : graph.edges) {
        REQUIRE((edge.u >= 0 && edge.u < edge.v && edge.v < count));
        ++degree[edge.u], ++degree[edge.v];
        root[find(edge.u)] = find(edge.v);
        wrong += edge.pixels.empty() || !(edge.length >= 0);
        for (std::size_t i = 0; i < edge.pixels.size(); ++i) {
            const Point2i p = edge.pixels[i];
            wrong += p.x < 0 || p.y < 0 || p.x >= graph.width || p.y >= graph.height;
            if (i > 0)
                wrong +=
                    std::max(std::abs(p.x - edge.pixels[i - 1].x), std::abs(p.y - edge.pixels[i - 1].y)) != 1;
        }
    }
    CHECK(wrong == 0);
    int trees = 0;
    for (int v = 0; v < count; ++v) {
        trees += root[v] == v;
        CHECK(graph.vertices[v].end == (degree[v] == 1));
        CHECK(graph.vertices[v].label != Label::background);
    }
    CHECK(trees == 1);
}

} // namespace

// --- labels to strokes -------------------------------------------------------------------------------------

TEST_CASE("part labels become strokes in modelling order, pieces from left to right") {
    const std::vector<PartStroke> parts = parts_of(strokes_from_labels(animal()));
    std::vector<std::string> names;
    for (const PartStroke& part : parts) names.push_back(part.name);
    CHECK(names == std::vector<std::string>{"body", "head", "limb_1", "limb_2", "limb_3", "limb_4", "tail"});
    const Label labels[] = {Label::body, Label::head, Label::limb, Label::limb,
                            Label::limb, Label::limb, Label::tail};
    for (std::size_t p = 0; p < parts.size(); ++p) {
        CHECK(parts[p].label == labels[p]);
        CHECK(parts[p].depth == 0);
        CHECK(parts[p].view == Viewpoint::front);
    }
    for (std::size_t p = 3; p < 6; ++p) CHECK(parts[p - 1].stroke.front().x < parts[p].stroke.front().x);
}

TEST_CASE("strokes hold their own pixels and reach into the parts that come before") {
    const LabelMap labels = animal();
    const std::vector<PartStroke> parts = parts_of(strokes_from_labels(labels));
    int limbs = 0, all_limbs = 0;
    for (const PartStroke& part : parts)
        if (part.label == Label::limb) {
            limbs += enclosed(labels, part.stroke, Label::limb);
            CHECK(enclosed(labels, part.stroke, Label::body) > 30);
            CHECK(enclosed(labels, part.stroke, Label::body) < 700); // into it, not over it
            CHECK(enclosed(labels, part.stroke, Label::head) == 0);
        }
    for (const auto value : labels) all_limbs += value == static_cast<int>(Label::limb);
    CHECK(limbs > 0.85 * all_limbs);
    CHECK(enclosed(labels, parts[1].stroke, Label::body) > 30);
    CHECK(enclosed(labels, parts[0].stroke, Label::head) == 0);
    CHECK(enclosed(labels, parts[0].stroke, Label::limb) == 0);
    CHECK(enclosed(labels, parts[6].stroke, Label::body) > 10);
}

TEST_CASE("strokes from labels make one tree and one solid") {
    Model model(strokes_from_labels(animal()));
    const auto& joints = model.skeleton().joints;
    CHECK(std::count_if(joints.begin(), joints.end(), [](const auto& j) { return j.parent < 0; }) == 1);
    for (std::size_t p = 1; p < model.parts().size(); ++p) CHECK(model.parts()[p].parent == 0);
    const SolidMesh mesh = model.united();
    CHECK(test::surface_fault(mesh) == "");
    CHECK(test::components_of(mesh) == 1);
    CHECK(model.repairs().empty());
}

TEST_CASE(
    "specks are left out, borders of the picture are no trouble, and no part at all is an input error") {
    LabelMap labels = animal();
    labels(5, 5) = static_cast<std::uint8_t>(Label::wing);
    labels(100, 75) = static_cast<std::uint8_t>(Label::head);
    CHECK(parts_of(strokes_from_labels(labels)).size() == 7);
    LabelMap full(30, 20, static_cast<std::uint8_t>(Label::body));
    const std::vector<PartStroke> parts = parts_of(strokes_from_labels(full));
    REQUIRE(parts.size() == 1);
    CHECK(enclosed(full, parts[0].stroke, Label::body) >= 28 * 18 - 4);
    for (const LabelMap& nothing : {LabelMap(), LabelMap(10, 10)}) {
        try {
            strokes_from_labels(nothing);
            FAIL("no error");
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::input);
        }
    }
}

// --- a model in a picture ----------------------------------------------------------------------------------

TEST_CASE("a view shows the whole model, sheared only when it has depth", "[needs-pugixml]") {
    for (const std::string& name : test::model_names) {
        Model model(test::model_strokes(name));
        SolidMesh mesh;
        for (int p = 0; p < std::ssize(model.parts()); ++p)
            for (const Vec3& v : model.surface(p).vertices) mesh.vertices.push_back(v);
        const ModelView view = view_of(model, mesh, 300);
        CAPTURE(name);
        CHECK(std::max(view.width, view.height) >= 300);
        CHECK(std::max(view.width, view.height) <= 301);
        CHECK((view.shear == Point2d{}) == false); // all nine have depth
        for (const Vec3& v : mesh.vertices) {
            const Point2d p = project(view, v);
            REQUIRE((p.x > 1 && p.y > 1 && p.x < view.width - 1 && p.y < view.height - 1));
        }
    }
    Model flat;
    flat.add_part(test::part("bar", test::capsule({0, 0}, {100, 0}, 10)));
    const ModelView view = view_of(flat, flat.surface(0), 200);
    CHECK(view.shear == Point2d{});
    CHECK(project(view, {0, 0, 50}) == project(view, {0, 0, -50}));
    CHECK(project(view, {0, 1, 0}).y < project(view, {0, 0, 0}).y); // up is up
}

TEST_CASE("a picture shows the labels of the parts that are in front") {
    Model model;
    PartStroke body = test::part("body", test::disc({0, 0}, 50)),
               eye = test::part("eye", test::disc({10, 0}, 10), "body"), spot = eye;
    eye.depth = 40, spot.name = "wing", spot.stroke = test::disc({-15, 0}, 10), spot.depth = -40;
    for (const PartStroke& part : {body, eye, spot}) model.add_part(part);
    ModelView view = view_of(model, model.united(), 200);
    view.shear = {}; // straight from the front
    const ModelPicture picture = draw(model, view);
    CHECK(picture.labels.width() == view.width);
    CHECK(picture.drawing.width() == 2 * view.width);
    CHECK(picture.drawing.height() == 2 * view.height);
    const auto label_at = [&](Vec3 p) {
        const Point2d q = project(view, p);
        return static_cast<Label>(picture.labels(static_cast<int>(q.x + 0.5), static_cast<int>(q.y + 0.5)));
    };
    CHECK(label_at({10, 0, 0}) == Label::head);
    CHECK(label_at({-15, 0, 0}) == Label::body); // the wing is behind
    CHECK(label_at({0, 40, 0}) == Label::body);
    CHECK(label_at({44, 44, 0}) == Label::background);
}

TEST_CASE("the projected skeleton is one graph of chains of pixels", "[needs-pugixml]") {
    for (const std::string& name : test::model_names) {
        Model model(test::model_strokes(name));
        SolidMesh mesh;
        for (int p = 0; p < std::ssize(model.parts()); ++p)
            for (const Vec3& v : model.surface(p).vertices) mesh.vertices.push_back(v);
        const ModelView view = view_of(model, mesh);
        const SkeletonGraph graph = project_skeleton(model, view);
        CAPTURE(name);
        CHECK(graph.width == view.width);
        CHECK(graph.height == view.height);
        CHECK(graph.vertices.size() >= 4);
        check_graph(graph);
    }
    // Two parts that do not meet are joined all the same.
    Model apart;
    apart.add_part(test::part("body", test::capsule({-60, 0}, {60, 0}, 20)));
    apart.add_part(test::part("moon", test::capsule({-60, 200}, {60, 200}, 20)));
    const SkeletonGraph graph = project_skeleton(apart, view_of(apart, apart.united()));
    check_graph(graph);
    CHECK(graph.edges.size() == graph.vertices.size() - 1);
}

// --- rigs --------------------------------------------------------------------------------------------------

TEST_CASE("a model's own rig has a bone for every joint but the roots, on the skeleton") {
    for (const char* name : {"cat", "octopus"}) {
        Model model(test::model_strokes(name));
        const SolidMesh mesh = model.united();
        const ModelView view = view_of(model, mesh);
        const Rig rig = model_rig(model, mesh, view);
        CAPTURE(name);
        CHECK(rig.solid);
        CHECK(rig.bones.size() == model.skeleton().joints.size());
        std::set<std::string> names;
        for (std::size_t b = 0; b < rig.bones.size(); ++b) {
            const Bone& bone = rig.bones[b];
            names.insert(bone.name);
            CHECK(bone.parent < static_cast<int>(b));
            CHECK((bone.parent < 0) == (b == 0));
            for (const Vec3& end : {model_place(view, bone.head, bone.head_depth),
                                    model_place(view, bone.tail, bone.tail_depth)})
                CHECK(to_skeleton(model.skeleton(), end) < 1e-6);
        }
        CHECK(names.size() == rig.bones.size());
        // A vertex is there once for each part that meets at it.
        std::set<std::pair<int, int>> corners;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const int v : mesh.triangles[t]) corners.insert({v, mesh.triangle_parts[t]});
        REQUIRE(rig.mesh.vertices.size() == corners.size());
        REQUIRE(rig.weights.size() == corners.size());
        CHECK(corners.size() > mesh.vertices.size());
        int wrong = 0;
        std::size_t c = 0;
        for (const auto& [v, part] : corners) {
            wrong += distance(model_place(view, rig.mesh.vertices[c], rig.depth[c]), mesh.vertices[v]) > 1e-6;
            wrong +=
                rig.texture[c].x < 0 || rig.texture[c].x > 1 || rig.texture[c].y < 0 || rig.texture[c].y > 1;
            ++c;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("lifted bones lie on the model's skeleton where they are seen") {
    Random random(91);
    Model model(test::model_strokes("cat"));
    const SolidMesh mesh = model.united();
    const ModelView view = view_of(model, mesh);
    const auto& joints = model.skeleton().joints;
    Rig flat;
    for (int b = 0; b < 25; ++b) {
        const auto place = [&] { // near a point on the skeleton
            const auto& joint = random.pick(joints);
            const Vec3 parent = joints[std::max(joint.parent, 0)].place;
            const Point2d p = project(
                view, joint.parent < 0 ? joint.place : parent + random.uniform() * (joint.place - parent));
            return p + Point2d{random.uniform(-3, 3), random.uniform(-3, 3)};
        };
        Bone bone;
        bone.name = "bone " + std::to_string(b);
        bone.parent = b - 1;
        bone.head = place(), bone.tail = place();
        flat.bones.push_back(bone);
    }
    const Rig rig = lifted(flat, model, mesh, view);
    REQUIRE(rig.bones.size() == flat.bones.size());
    CHECK(rig.solid);
    for (std::size_t b = 0; b < rig.bones.size(); ++b) {
        const Bone& bone = rig.bones[b];
        CHECK(bone.name == flat.bones[b].name);
        CHECK(bone.parent == flat.bones[b].parent);
        const Vec3 head = model_place(view, bone.head, bone.head_depth),
                   tail = model_place(view, bone.tail, bone.tail_depth);
        CHECK(to_skeleton(model.skeleton(), head) < 1e-6);
        CHECK(to_skeleton(model.skeleton(), tail) < 1e-6);
        CHECK(distance(project(view, head), flat.bones[b].head) < 4.5);
        CHECK(distance(project(view, tail), flat.bones[b].tail) < 4.5);
        for (const auto& joint : joints)
            CHECK(distance(project(view, head), flat.bones[b].head) <=
                  distance(project(view, joint.place), flat.bones[b].head) + 1e-6);
    }
    for (const VertexWeights& w : rig.weights)
        REQUIRE(w.weights[0] + w.weights[1] + w.weights[2] + w.weights[3] == 1);
}

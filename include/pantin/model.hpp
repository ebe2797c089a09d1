// SPDX-License-Identifier: MIT
// Strokes to a rigged model in space (Ma et al., RealSkel, 2021): parts that are inflated, connected, refined
// and united. The model's frame and the strokes' canvas: strokes.hpp. Lengths are canvas units.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "pantin/modeling.hpp"
#include "pantin/rigging.hpp"
#include "pantin/strokes.hpp"
#include "pantin/triangulation.hpp"

namespace pantin {

// --- inflation (4.1) ---------------------------------------------------------------------------------------

// The squared half thickness over the inside of an outline, for height 1: the solution of Poisson's equation
// −Δh = 2 (options.load) with h = 0 on the outline, on linear triangles. So a long strip is round, and a disc
// of radius r is r/√2 thick on each side.
struct Inflation {
    std::vector<Point2d> points; // canvas
    // Positively oriented: interior on the left where y points down, as on the canvas.
    std::vector<std::array<int, 3>> triangles;
    std::vector<double> squared; // per point; 0 on the outline, positive inside
    std::vector<char> border;    // per point
    double half_width = 0;       // area by perimeter: half the width of a long part
};
struct InflationOptions {
    SimplePolygonOptions polygon{300, 0.0006}; // of a model: of surface and skeleton
    double longest_edge = 0.04;                // share of the diagonal; thin parts get shorter ones
    double shortest_edge = 0.002;
    double load = 2; // right side of Poisson's equation; 1: thinner by √2 (errata 28)
};
// stroke: canvas units. Error(input) as simple_polygon(). RealSkel 4.1 (errata 28).
Inflation inflate(const std::vector<Point2d>& stroke, const InflationOptions& options = {});
// The same within an outline as simple_polygon() gives it: skeleton and surface of a part share one.
Inflation inflate(const PartOutline& outline, const InflationOptions& options = {});

// --- surfaces ----------------------------------------------------------------------------------------------

struct SolidMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 3>> triangles; // counter-clockwise from outside
    // Of unite(): the part that each triangle is of, and one of those that meet at each vertex.
    std::vector<int> parts{}, triangle_parts{};
};
// Of the canvas into the model: a point (x, y) at depth d lies at origin + x · right + y · down + d · out.
// Right, down and out are orthogonal and of one length; mirrored copies have the other handedness.
struct Frame {
    Vec3 origin, right{1, 0, 0}, down{0, -1, 0}, out{0, 0, 1};
};
// The place of a point of the canvas in the model, canvas units. No error. Own.
Vec3 to_model(const Frame& frame, Point2d canvas, double depth = 0);
// Front and back of the inflated part, joined along the outline: closed; canvas units. height > 0 scales the
// thickness. No error. RealSkel 4.1.
SolidMesh part_surface(const Inflation& inflation, double height, const Frame& frame);

struct InflatedPart {
    const Inflation* inflation = nullptr;
    double height = 1;
    Frame frame;
};
// The outer surface of all parts as one mesh: closed and oriented, made of the parts' own surfaces, cut where
// they run through each other by exact arithmetic on coordinates of 38 bits. So it has no more handles than
// what was drawn, and parts are as thin as they were drawn. Parts join where they overlap; what only touches
// stays apart, or joins if the later one would overlap when moved by less than any number to the right, up
// and to the front. Canvas units. Error(input) when a part is smaller than a millionth of the model or so.
// RealSkel 4.1 (errata 29).
SolidMesh unite(const std::vector<InflatedPart>& parts);

// --- the model ---------------------------------------------------------------------------------------------

// A tree, or several when parts do not meet.
struct ModelSkeleton {
    struct Joint {
        Vec3 place;
        double radius = 0;
        int part = 0;
        int parent = -1; // comes before its children
    };
    std::vector<Joint> joints;
};
struct ModelPart {
    PartStroke stroke;
    bool mirrored = false; // the copy of a symmetric part; it comes right after it
    Frame frame;           // its canvas, after all moves
    SubSkeleton flat;      // on the canvas
    int parent = -1;       // part that it hangs on
    std::string name() const { return mirrored ? stroke.name + ".mirrored" : stroke.name; }
};
struct ModelOptions {
    SubSkeletonOptions skeleton;
    RefinementOptions refinement; // of every part, until refine() says otherwise
    // Thresholds are shares of each part's diagonal; otherwise of the whole model's, that of the box around
    // all parts' outlines, as the article's are pixels of one canvas (errata 24).
    bool per_part = false;
    InflationOptions inflation;
};

// The interactive part of the article (RealSkel 3, 4.1): every call brings the skeleton up to date. What
// depends on one part alone is made once for it; connection and refinement are made anew. Surfaces are made
// when they are asked for, and kept until their part's stroke changes. Throws Error(input) and stays as it
// was when a call is invalid (a name that is taken or unknown, a stroke without area, …).
class Model {
public:
    explicit Model(Point2d origin = {}, const ModelOptions& options = {});
    Model(const Strokes& strokes, const ModelOptions& options = {});

    // One of the calls below.
    void apply(const ModelCall& call);
    // RealSkel 3.1 and 3.2: a part, and how it hangs on the others.
    void add_part(const PartStroke& part);
    // Parts that named it as their parent connect anew.
    void remove_part(const std::string& name);
    // RealSkel 4.1, utilities; canvas units, degrees.
    void move_part(const MovePart& move);
    void set_symmetry(const std::string& name, Symmetry symmetry);
    // The thickness, after the part was drawn. RealSkel 4.1.
    void set_height(const std::string& name, double height);
    // The part drawn anew in its place: order, parent, children and moves stay, what was asked of its
    // branches does not. Own.
    void redraw_part(const RedrawPart& call);
    // RealSkel 3.3; shares of the model's diagonal.
    void refine(const RefineSkeleton& call);
    // Takes the last call back that is not taken back already; false when there is none. Own.
    bool undo();
    // Those that were played and not taken back.
    const std::vector<ModelCall>& calls() const { return calls_; }
    // What thresholds make a difference now: shares of the model's diagonal, before refinement. RealSkel 3.3.
    ThresholdRanges ranges() const;
    // Of the box around all outlines; canvas units, 0 without parts.
    double diagonal() const;

    const std::vector<ModelPart>& parts() const { return parts_; }
    const Connection& connection() const { return connection_; } // as connected, before refinement
    const ModelSkeleton& skeleton() const { return skeleton_; }
    const std::vector<std::string>& repairs() const { return repairs_; } // of strokes that cross themselves

    // Of one part (an index of parts()), of each, and of all united: canvas units, the model's frame. Errors
    // of inflate() and unite(). RealSkel 4.1.
    SolidMesh surface(int part);
    std::vector<InflatedPart> inflated();
    SolidMesh united();

private:
    struct Drawn;
    Drawn& drawn(const std::string& name);
    void check_new(const PartStroke& part) const;
    void simplify_all(double whole);
    bool stays_inside(int part, Vec3 from, Vec3 to) const;
    void note_repairs(const std::string& part, const SimplePolygon& outline, int holes_left_out);
    void simplify(Drawn& drawn, int branch, double threshold) const;
    void update();
    void draw(Drawn& drawn);
    double pushed_by_layers(const Drawn& drawn);
    static const Inflation& inflation_of(Drawn& drawn, const InflationOptions& options);
    const Inflation& inflation_of(int part);

    Point2d origin_;
    ModelOptions options_, given_; // as refine() left them, as they were given
    std::vector<ModelCall> calls_;
    std::vector<std::shared_ptr<Drawn>> remembered_; // whose outlines may come again
    RefinementOptions global_;
    std::vector<std::shared_ptr<Drawn>> drawn_; // in modelling order
    std::vector<int> drawn_of_;                 // of each part
    std::vector<ModelPart> parts_;
    Connection connection_;
    ModelSkeleton skeleton_;
    std::vector<std::string> repairs_;
};

// What is no mistake but may be none of the drawing's intentions, one line each: parts that meet no other
// part and parts that lie wholly inside others. mesh: the model's united(). No error. Own.
std::vector<std::string> oddities_of(const Model& model, const SolidMesh& mesh);

// --- skin weights ------------------------------------------------------------------------------------------

// Bone heat (Baran & Popović 2007, section 4): heat flows over the surface from the bone that is nearest to
// each place, so weights are smooth, not negative and sum to one. Chosen over bounded biharmonic weights
// because it needs one sparse factorisation of the surface alone, no volume mesh. Edge weights are clamped
// cotangents, so that the maximum principle holds on every mesh. bones: segments in the mesh's frame;
// weights[v][b] in [0, 1].
struct BoneSegment {
    Vec3 head, tail;
    double radius = 0; // of the part around it; nearness counts from there
};
// One set of weights a vertex, at most four bones, summing to 1; at least one bone. No error. RealSkel 4.1
// (errata 30).
std::vector<VertexWeights> bone_heat(const SolidMesh& mesh, const std::vector<BoneSegment>& bones);

} // namespace pantin

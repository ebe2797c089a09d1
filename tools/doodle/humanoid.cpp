// SPDX-License-Identifier: MIT
// People, and what stands and waves like them: stick people, round bodies, textbook figures, skirts, robots,
// teddy bears, monkeys, penguins. Units: about 100 from head to foot, x = 0 the middle, y down from the head.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/figure.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

// Measures of one person; lengths in units.
struct Person {
    double head_rx, head_ry, neck;    // neck: gap between head and trunk
    double trunk_width, trunk_length; // at the shoulders
    double hip_width;                 // at the lower end
    double arm, leg;                  // lengths
    double arm_radius, leg_radius;
    double shoulder_y = 0, hip_y = 0, arm_y = 0;
    bool stick_trunk = false, stick_arms = false, stick_legs = false;
    bool seated = false;
};

struct Pose {
    double upper[2], lower[2]; // arm angles from straight down, outwards; [left, right]
    double thigh[2], shin[2];
    bool in_front[2]; // the arm passes over the body
};

Pose random_pose(Builder& b, const Person& person) {
    Random& r = b.random;
    Pose pose{};
    const int arms = r.integer(0, 8);
    for (int s = 0; s < 2; ++s) {
        const bool copy = s == 1 && r.chance(b.manner.symmetry);
        double up = 0, low = 0;
        switch (copy ? arms : r.integer(0, 8)) {
        case 0:
        case 1:
            up = r.uniform(0.25, 0.7), low = up + r.uniform(-0.4, 0.2);
            break; // hanging
        case 2:
        case 3:
            up = r.uniform(1.2, 1.8), low = up + r.uniform(-0.25, 0.25);
            break; // out
        case 4:
            up = r.uniform(1.9, 2.6), low = up + r.uniform(-0.2, 0.4);
            break; // up
        case 5:
            up = r.uniform(1.1, 1.6), low = up + r.uniform(0.8, 1.5);
            break; // waving
        case 6:
            up = r.uniform(0.7, 1.1), low = -r.uniform(0.5, 0.9);
            break; // hand on the hip
        case 7:
            up = r.uniform(0.5, 0.9), low = r.uniform(1.2, 1.8);
            break; // offering
        default:
            up = r.uniform(0.6, 1.2), low = up + r.uniform(-0.1, 0.1);
            break;
        }
        if (copy) up = pose.upper[0] + r.uniform(-0.1, 0.1), low = pose.lower[0] + r.uniform(-0.1, 0.1);
        pose.upper[s] = up, pose.lower[s] = low;
        pose.in_front[s] = r.chance(0.3);
    }
    const int legs = r.integer(0, 4);
    const double spread = legs == 0 ? r.uniform(0.3, 0.55) : r.uniform(0.02, 0.25);
    for (int s = 0; s < 2; ++s) {
        pose.thigh[s] = spread + r.uniform(-0.06, 0.06);
        pose.shin[s] = pose.thigh[s] + (legs == 4 ? r.uniform(-0.5, 0.3) : r.uniform(-0.08, 0.08));
        if (person.seated) pose.thigh[s] = r.uniform(1.0, 1.4), pose.shin[s] = r.uniform(-0.1, 0.3);
    }
    return pose;
}

// From straight down, outwards on side −1 or 1.
Point2d outwards(double angle, int side) { return {side * math::sin(angle), math::cos(angle)}; }

Person random_person(Builder& b) {
    Random& r = b.random;
    Person p{};
    const bool child = r.chance(0.35); // big head, short limbs
    p.head_rx = child ? r.uniform(15, 23) : r.uniform(8.5, 14);
    p.head_ry = p.head_rx * r.uniform(0.85, 1.25);
    p.neck = r.chance(0.5) ? r.uniform(-1.5, 0.0) : r.uniform(1.0, 6.0);
    p.trunk_length = child ? r.uniform(18, 32) : r.uniform(26, 40);
    p.trunk_width = r.uniform(0.28, 0.62) * p.trunk_length;
    p.hip_width = p.trunk_width * r.uniform(0.7, 1.15);
    p.leg = child ? r.uniform(14, 28) : r.uniform(28, 46);
    p.arm = child ? r.uniform(14, 26) : r.uniform(24, 40);
    p.arm_radius = r.uniform(1.8, 4.2);
    p.leg_radius = std::min(p.arm_radius * r.uniform(1.0, 1.6), 0.45 * p.hip_width);
    p.stick_arms = r.chance(b.manner.stick_limbs);
    p.stick_legs = r.chance(b.manner.stick_limbs);
    return p;
}

int add_head(Builder& b, const Person& p) {
    Random& r = b.random;
    const Point2d centre{r.uniform(-1.0, 1.0), 0};
    const double exponent = r.chance(0.15) ? r.uniform(2.5, 6.0) : r.uniform(1.9, 2.3);
    const int head =
        b.region(Label::head, ellipse(centre, p.head_rx, p.head_ry, r.uniform(-0.06, 0.06), exponent), 1);
    const Frame frame{centre, p.head_rx, p.head_ry, r.uniform(-0.08, 0.08)};
    if (r.chance(0.85)) add_frontal_face(b, head, frame);
    if (r.chance(0.6 * b.manner.details)) add_hair(b, head, frame);
    if (r.chance(0.35 * b.manner.details)) add_hat(b, head, frame);
    if (r.chance(0.2))
        for (int side = -1; side <= 1; side += 2)
            b.attach(
                b.region(Label::head, ellipse(frame.at(side, 0), 0.2 * p.head_rx, 0.25 * p.head_ry), 0.5),
                head);
    return head;
}

// The outline of a trunk that is no stick; a dress widens the hips.
Path trunk_outline(Random& r, Person& p) {
    const double top = p.head_ry + p.neck, w = p.trunk_width / 2, h = p.hip_width / 2, l = p.trunk_length;
    switch (r.integer(0, 5)) {
    case 0:
        return ellipse({0, top + l / 2}, w * 1.3, l / 2 + 1.5);
    case 1:
        return ellipse({0, top + l / 2}, w, l / 2, 0, r.uniform(3.0, 6.0));
    case 2:
        return Path{{-w, top}, {w, top}, {h, top + l}, {-h, top + l}};
    case 3: // shoulders and a waist
        return spline({{-0.5 * w, top},
                       {-w, top + 0.06 * l},
                       {-0.75 * w, top + 0.55 * l},
                       {-h, top + l},
                       {0, top + 1.03 * l},
                       {h, top + l},
                       {0.75 * w, top + 0.55 * l},
                       {w, top + 0.06 * l},
                       {0.5 * w, top}},
                      true, 5);
    case 4: // a pear
        return spline({{-0.6 * w, top + 0.05 * l},
                       {-1.0 * w, top + 0.5 * l},
                       {-1.2 * w, top + 0.85 * l},
                       {0, top + 1.04 * l},
                       {1.2 * w, top + 0.85 * l},
                       {1.0 * w, top + 0.5 * l},
                       {0.6 * w, top + 0.05 * l},
                       {0, top - 0.03 * l}},
                      true, 5);
    default: // a dress, wide at the knees
        p.hip_width = p.trunk_width * r.uniform(1.2, 2.2);
        return Path{{-0.45 * w, top},
                    {0.45 * w, top},
                    {p.hip_width / 2, top + l},
                    {0, top + 1.05 * l},
                    {-p.hip_width / 2, top + l}};
    }
}

void add_neck(Builder& b, const Person& p, int head, int trunk) {
    Random& r = b.random;
    const double top = p.head_ry + p.neck, w = p.trunk_width / 2;
    const double neck_radius = std::min(r.uniform(0.12, 0.3) * p.head_rx, 0.7 * w);
    if (r.chance(0.3) || neck_radius < 1.2) {
        b.stick(Label::body, {{0, p.head_ry - 1}, {0, top + 1.5}}, -0.5);
    } else {
        const RibbonEnds ends{Cap::flat, Cap::flat, true, true};
        const Path line{{0, p.head_ry - 1.5}, {0, top + 2}};
        const int neck = b.limb(Label::body, line, {neck_radius}, -0.5, ends);
        b.merge(neck, trunk);
        if (r.chance(0.3)) b.merge(neck, head);
    }
}

// The trunk below the head; returns its region and sets the places where limbs begin.
int add_trunk(Builder& b, Person& p, int head) {
    Random& r = b.random;
    const double top = p.head_ry + p.neck, l = p.trunk_length;
    p.shoulder_y = top, p.hip_y = top + l, p.arm_y = top + r.uniform(0.06, 0.25) * l;
    if (p.stick_trunk) {
        const int line =
            b.stick(Label::body,
                    spline({{0, p.head_ry - 0.5}, {r.uniform(-1.5, 1.5), top + l / 2}, {0, top + l}}, false));
        b.merge(line, head);
        p.hip_width = p.trunk_width = 0;
        p.arm_y = top + r.uniform(0.1, 0.4) * l;
        return line;
    }
    const int trunk = b.region(Label::body, trunk_outline(r, p), 0);
    if (p.neck < -0.5) b.attach(head, trunk);
    if (p.neck > 0.5) add_neck(b, p, head, trunk);
    return trunk;
}

void dress_trunk(Builder& b, const Person& p, int trunk) {
    Random& r = b.random;
    const double top = p.shoulder_y, l = p.trunk_length, w = p.trunk_width / 2;
    const Frame frame{{0, top + l / 2}, w, l / 2, 0};
    switch (r.integer(0, 6)) {
    case 0: // buttons
        for (int i = 0, n = r.integer(2, 4); i < n; ++i)
            b.spot(trunk, ellipse({0, top + l * (0.25 + 0.5 * i / n)}, 0.08 * w + 0.5, 0.08 * w + 0.5));
        break;
    case 1:
        b.mark(trunk, {{-2 * w, top + 0.65 * l}, {2 * w, top + 0.65 * l + r.uniform(-1.0, 1.0)}});
        break; // belt
    case 2:
        add_pattern(b, trunk, {frame.centre, frame.ry, frame.rx, pi / 2});
        break;
    case 3:
        b.mark(trunk, {{-0.4 * w, top}, {0, top + 0.2 * l}, {0.4 * w, top}});
        break; // collar
    case 4:
        add_pattern(b, trunk, frame, "spots");
        break;
    default:
        break;
    }
}

// A hand or a foot at the end of a limb.
void add_extremity(Builder& b, int limb, Point2d end, Point2d along, double size, bool stick, double depth) {
    Random& r = b.random;
    const int kind = r.integer(0, 3);
    if (kind == 0 && !stick) return;
    if (stick && kind <= 1) { // three fingers
        if (r.chance(0.4)) return;
        const int n = r.integer(2, 5);
        for (int i = 0; i < n; ++i) {
            const double a = n == 1 ? 0 : -0.7 + 1.4 * i / (n - 1);
            b.continued(b.stick(Label::limb, {end, end + (size * 0.9) * rotated(along, a)}, depth, 2.0));
        }
        return;
    }
    const Path hand = ellipse(end + (0.5 * size) * along, 0.6 * size, 0.5 * size);
    const int index = b.continued(b.region(Label::limb, hand, depth + 0.1));
    if (r.chance(0.6)) b.merge(index, limb);
}

void add_arms(Builder& b, const Person& p, const Pose& pose, int trunk) {
    Random& r = b.random;
    for (int s = 0; s < 2; ++s) {
        const int side = s == 0 ? -1 : 1;
        const double inset =
            p.stick_trunk ? 0.0 : p.trunk_width / 2 - (p.stick_arms ? 0.4 : 0.9) * p.arm_radius;
        const Point2d shoulder{side * inset, p.arm_y + (p.stick_trunk || p.stick_arms ? 0 : p.arm_radius)};
        const double upper = p.arm * r.uniform(0.45, 0.55);
        const Point2d elbow = shoulder + upper * outwards(pose.upper[s], side);
        const Point2d lower = outwards(pose.lower[s], side);
        const Point2d hand = elbow + (p.arm - upper) * lower;
        const double depth = pose.in_front[s] ? 2.0 : -1.0;
        int arm = 0;
        if (p.stick_arms) {
            const Path bent{shoulder, elbow, hand};
            arm = b.stick(Label::limb, r.chance(0.5) ? spline(bent, false) : bent, depth);
        } else {
            const double a = p.arm_radius;
            const bool seam = !r.chance(0.5);
            const Cap wrist = r.chance(0.7) ? Cap::round : Cap::flat;
            arm = b.limb(Label::limb, {shoulder, elbow, hand},
                         {a, a * r.uniform(0.8, 1.1), a * r.uniform(0.6, 1.0)}, depth,
                         {Cap::round, wrist, seam, false});
            b.attach(arm, trunk);
        }
        add_extremity(b, arm, hand, lower, (p.stick_arms ? 3.2 : 1.4 * p.arm_radius) * r.uniform(0.8, 1.3),
                      p.stick_arms, depth);
    }
}

void add_foot(Builder& b, int leg, Point2d ankle, int side, const Person& p, double depth) {
    Random& r = b.random;
    if (p.stick_legs) {
        if (r.chance(0.7)) {
            const int foot = b.continued(
                b.stick(Label::limb,
                        {ankle, ankle + Point2d{side * r.uniform(3.0, 6.5), r.uniform(-0.6, 0.8)}}, depth));
            b.merge(foot, leg);
        }
        return;
    }
    if (r.chance(0.2)) return;
    const double size = p.leg_radius * r.uniform(1.2, 1.9);
    const int foot = b.continued(b.region(
        Label::limb,
        ellipse(ankle + Point2d{0.6 * side * size, 0}, size, 0.55 * size, 0, r.chance(0.3) ? 3.5 : 2.0),
        depth + 0.1));
    if (r.chance(0.5)) b.merge(foot, leg);
}

void add_legs(Builder& b, const Person& p, const Pose& pose, int trunk, bool same_way) {
    Random& r = b.random;
    const double depth = r.chance(0.7) ? -1.5 : 0.5;
    for (int s = 0; s < 2; ++s) {
        const int side = s == 0 ? -1 : 1;
        const double hip_x =
            p.stick_trunk ? 0.0 : std::max(0.2 * p.hip_width, p.hip_width / 2 - p.leg_radius * 1.15);
        const Point2d hip{side * std::min(hip_x, 0.4 * p.hip_width),
                          p.hip_y - (p.stick_trunk ? 0 : p.leg_radius * 0.6)};
        const double thigh = p.leg * 0.5;
        const Point2d knee = hip + thigh * outwards(pose.thigh[s], side);
        const Point2d ankle = knee + (p.leg - thigh) * outwards(pose.shin[s], side);
        int leg = 0;
        if (p.stick_legs) {
            leg = b.stick(Label::limb, {hip, knee, ankle}, depth);
        } else {
            const double a = p.leg_radius;
            const bool open = r.chance(b.manner.open_feet);
            const Cap sole = r.chance(0.4) ? Cap::round : Cap::flat;
            leg = b.limb(Label::limb, {hip, knee, ankle},
                         {a, a * r.uniform(0.85, 1.0), a * r.uniform(0.65, 1.0)}, depth,
                         {Cap::flat, sole, true, open});
            b.attach(leg, trunk);
        }
        add_foot(b, leg, ankle, same_way ? 1 : side, p, depth);
    }
}

// A skirt over hips and thighs: part of the body.
void add_skirt(Builder& b, const Person& p) {
    Random& r = b.random;
    const double w = std::max(p.hip_width, 5.0) * r.uniform(0.45, 0.6), l = p.leg * r.uniform(0.25, 0.6);
    const double flare = w * r.uniform(1.4, 2.4), y = p.hip_y - r.uniform(0.0, 0.3) * p.trunk_length;
    const int skirt =
        b.region(Label::body,
                 {{-w, y}, {w, y}, {flare, p.hip_y + l}, {0, p.hip_y + l * 1.05}, {-flare, p.hip_y + l}}, 1);
    b.part(skirt).paint = 5;
    if (r.chance(0.4))
        for (int i = -1; i <= 1; ++i) b.mark(skirt, {{0.4 * i * w, y + 1}, {0.6 * i * flare, p.hip_y + l}});
}

// Returns the trunk.
int build_person(Builder& b, Person p, bool may_skirt) {
    Random& r = b.random;
    const int head = add_head(b, p);
    const int trunk = add_trunk(b, p, head);
    const Pose pose = random_pose(b, p);
    add_legs(b, p, pose, trunk, r.chance(0.25));
    add_arms(b, p, pose, trunk);
    if (!p.stick_trunk && r.chance(b.manner.details)) dress_trunk(b, p, trunk);
    if (may_skirt && !p.seated && r.chance(0.2)) add_skirt(b, p);
    return trunk;
}

void build_stick_person(Builder& b) {
    Person p = random_person(b);
    p.neck = b.random.uniform(-0.5, 0.0);
    p.stick_trunk = p.stick_arms = p.stick_legs = true;
    p.arm *= 0.8;
    build_person(b, p, true);
}

// Teddy bear, monkey, mouse: round ears, thick limbs, perhaps a tail.
void build_toy(Builder& b, bool tail) {
    Random& r = b.random;
    Person p = random_person(b);
    p.stick_arms = p.stick_legs = false;
    p.head_rx = r.uniform(14, 22), p.head_ry = p.head_rx * r.uniform(0.8, 1.05);
    p.neck = -r.uniform(1.0, 4.0);
    p.trunk_length = r.uniform(26, 36), p.trunk_width = p.trunk_length * r.uniform(0.65, 0.9),
    p.hip_width = p.trunk_width;
    p.arm_radius = r.uniform(4, 6.5), p.leg_radius = p.arm_radius * 1.15;
    p.arm = r.uniform(18, 28), p.leg = r.uniform(14, 26);
    const int trunk = build_person(b, p, false);
    const double ear = r.uniform(0.28, 0.5) * p.head_rx,
                 angle = tail ? r.uniform(0.0, 0.4) : r.uniform(0.6, 1.0);
    for (int side = -1; side <= 1; side += 2) {
        const Point2d c{side * p.head_rx * math::cos(angle) * 1.1, -p.head_ry * math::sin(angle) * 1.1};
        const int index = b.region(Label::head, ellipse(c, ear, ear), 0.5);
        b.attach(index, 0);
        if (r.chance(0.4)) b.mark(index, ellipse(c, 0.55 * ear, 0.55 * ear), true);
    }
    if (r.chance(0.3))
        b.mark(trunk,
               ellipse({0, p.head_ry + p.neck + 0.55 * p.trunk_length}, 0.3 * p.trunk_width,
                       0.3 * p.trunk_length),
               true);
    if (!tail) return;
    const double way = r.chance(0.5) ? 0 : pi;
    const Point2d root{(way == 0 ? 0.4 : -0.4) * p.trunk_width, p.head_ry + p.neck + p.trunk_length - 4};
    const double l = r.uniform(30, 60), turns = (way == 0 ? -1 : 1) * r.uniform(0.3, 0.8);
    const Path line = curl(root, way, l, turns, r.uniform(0.0, 1.5));
    if (r.chance(0.5))
        b.stick(Label::tail, line, -2);
    else
        b.limb(Label::tail, resample(line, 6.0), {2.0, 2.0, 1.5}, -2);
}

void build_robot(Builder& b) {
    Random& r = b.random;
    Person p = random_person(b);
    p.head_rx = r.uniform(9, 15), p.head_ry = p.head_rx * r.uniform(0.7, 1.0);
    const int head =
        b.region(Label::head, ellipse({0, 0}, p.head_rx, p.head_ry, r.uniform(-0.1, 0.1), 9.0), 1);
    add_frontal_face(b, head, {{0, 0}, p.head_rx, p.head_ry, 0});
    if (r.chance(0.5)) {
        const Point2d tip{r.uniform(-3.0, 3.0), -p.head_ry - r.uniform(5.0, 10.0)};
        b.stick(Label::head, {{0, -p.head_ry}, tip}, 0, 1.2);
        b.region(Label::head, ellipse(tip, 1.6, 1.6), 1);
    }
    p.neck = std::max(p.neck, 1.0);
    const int trunk = add_trunk(b, p, head);
    const Pose pose = random_pose(b, p);
    add_legs(b, p, pose, trunk, false);
    add_arms(b, p, pose, trunk);
    dress_trunk(b, p, trunk);
}

void build_penguin(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(16, 22), l = r.uniform(26, 34);
    const int body = b.region(Label::body, ellipse({0, 0}, w, l, 0, r.uniform(2.0, 2.6)), 0);
    if (r.chance(0.6)) b.mark(body, ellipse({0, 3}, 0.62 * w, 0.75 * l), true);
    const double h = w * r.uniform(0.6, 0.85);
    const int head = b.region(Label::head, ellipse({0, -l - 0.4 * h}, h, 0.9 * h), r.chance(0.5) ? 1 : -0.5);
    b.attach(head, body);
    for (int side = -1; side <= 1; side += 2) {
        add_eye(b, head, {0.35 * side * h, -l - 0.6 * h}, 0.14 * h);
        const Path flipper{{0.8 * side * w, -0.5 * l},
                           {side * w * 1.25, -0.1 * l},
                           {side * w * r.uniform(1.2, 1.5), r.uniform(0.1, 0.45) * l}};
        const int wing = b.limb(Label::wing, flipper, {1.5, 0.22 * w, 0.5}, r.chance(0.5) ? 1 : -1);
        b.attach(wing, body);
        const int foot = b.region(Label::limb, ellipse({0.45 * side * w, l}, 0.35 * w, 0.16 * w), -1);
        b.attach(foot, body);
    }
    b.mark(head, {{-0.2 * h, -l - 0.35 * h}, {0, -l - 0.05 * h}, {0.2 * h, -l - 0.35 * h}}, true);
}

} // namespace

std::vector<std::string> humanoid_species() {
    return {"person", "stick person", "seated person", "teddy", "monkey", "robot", "penguin"};
}

Figure build_humanoid(Random& random, const std::string& species) {
    Builder b(random, "humanoid", species);
    if (species == "stick person") {
        build_stick_person(b);
    } else if (species == "teddy" || species == "monkey") {
        build_toy(b, species == "monkey");
    } else if (species == "robot") {
        build_robot(b);
    } else if (species == "penguin") {
        build_penguin(b);
    } else {
        Person p = random_person(b);
        p.seated = species == "seated person";
        build_person(b, p, true);
    }
    b.figure.heading = 0.5 * pi;
    return std::move(b.figure);
}

} // namespace pantin::doodle

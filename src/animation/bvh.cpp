// SPDX-License-Identifier: MIT
// Biovision hierarchy files, read and written.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "animation/vector.hpp"
#include "core/decimal.hpp"
#include "core/math.hpp"
#include "core/plural.hpp"
#include "pantin/error.hpp"
#include "pantin/motion.hpp"

namespace pantin {
namespace {

constexpr std::size_t most_joints = 2000, most_frames = 1'000'000;
constexpr double written_height = 100; // of the character in a file

struct ChannelName {
    std::string_view name;
    Channel channel;
};
constexpr std::array<ChannelName, 6> channel_names = {{{"Xposition", Channel::x_position},
                                                       {"Yposition", Channel::y_position},
                                                       {"Zposition", Channel::z_position},
                                                       {"Xrotation", Channel::x_rotation},
                                                       {"Yrotation", Channel::y_rotation},
                                                       {"Zrotation", Channel::z_rotation}}};

bool same_letters(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

class Parser {
public:
    Parser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    Motion parse() {
        expect("HIERARCHY");
        expect("ROOT");
        joint(-1, next("the name of the root"));
        expect("MOTION");
        expect("Frames:");
        const double frames = number("the number of frames");
        if (!(frames >= 1) || frames > most_frames || frames != std::floor(frames))
            fail("there must be 1 to " + std::to_string(most_frames) + " frames");
        expect("Frame");
        expect("Time:");
        motion_.frame_time = number("the time of a frame");
        if (!(motion_.frame_time > 1e-4 && motion_.frame_time <= 10))
            fail("a frame must take 0.0001 to 10 seconds");
        if (motion_.channels == 0) fail("no joint has a channel");
        const auto count = static_cast<std::size_t>(frames) * motion_.channels;
        if (count > text_.size()) fail("the file is too short for its frames");
        motion_.values.reserve(count);
        while (motion_.values.size() < count) motion_.values.push_back(number("a value of the motion"));
        if (!peek().empty())
            fail("more values than those of " + count_of(static_cast<long>(motion_.frames()), "frame"));
        return std::move(motion_);
    }

private:
    [[noreturn]] void fail(const std::string& fact) const {
        const auto line =
            1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(begin_), '\n');
        throw Error(ErrorKind::input, file_ + ": line " + std::to_string(line) + ": " + fact);
    }

    // The next word, without taking it; "" at the end.
    std::string_view peek() {
        while (begin_ < text_.size() && static_cast<unsigned char>(text_[begin_]) <= ' ') ++begin_;
        std::size_t end = begin_;
        while (end < text_.size() && static_cast<unsigned char>(text_[end]) > ' ') ++end;
        return text_.substr(begin_, end - begin_);
    }
    std::string next(const std::string& what) {
        const std::string_view word = peek();
        if (word.empty()) fail("the file ends before " + what);
        begin_ += word.size();
        return std::string(word);
    }
    void expect(std::string_view wanted) {
        const std::string_view word = peek();
        if (!same_letters(word, wanted))
            fail("'" + std::string(wanted) + "' is expected, not '" + std::string(word.substr(0, 40)) + "'");
        begin_ += word.size();
    }
    double number(const std::string& what) {
        const std::string_view word = peek();
        double value = 0;
        const char *first = word.data(), *last = first + word.size();
        if (!word.empty() && *first == '+') ++first;
        const auto result = std::from_chars(first, last, value);
        if (word.empty() || result.ec != std::errc() || result.ptr != last || !std::isfinite(value) ||
            std::abs(value) > 1e9)
            fail(what + " is expected, not '" + std::string(word.substr(0, 40)) + "'");
        begin_ += word.size();
        return value;
    }

    // Braces are counted on a stack of our own: a file may nest as deep as it likes.
    void joint(int parent, const std::string& name) {
        open(parent, name);
        std::vector<int> path = {0};
        while (!path.empty()) {
            const std::string word = next("the closing brace of '" + motion_.joints[path.back()].name + "'");
            if (word == "}") {
                path.pop_back();
            } else if (same_letters(word, "JOINT")) {
                open(path.back(), next("the name of a joint"));
                path.push_back(static_cast<int>(motion_.joints.size()) - 1);
            } else if (same_letters(word, "End")) {
                expect("Site");
                open(path.back(), "");
                expect("}");
            } else {
                fail("JOINT, End Site or } is expected, not '" + word.substr(0, 40) + "'");
            }
        }
    }

    // From the opening brace to the channels.
    void open(int parent, const std::string& name) {
        if (motion_.joints.size() >= most_joints)
            fail("more than " + std::to_string(most_joints) + " joints");
        expect("{");
        MotionJoint joint;
        joint.name = name;
        joint.parent = parent;
        joint.first_channel = motion_.channels;
        expect("OFFSET");
        joint.offset.x = number("an offset");
        joint.offset.y = number("an offset");
        joint.offset.z = number("an offset");
        if (same_letters(peek(), "CHANNELS")) channels(joint);
        motion_.channels += joint.channels.size();
        motion_.joints.push_back(std::move(joint));
    }
    void channels(MotionJoint& joint) {
        expect("CHANNELS");
        const double count = number("the number of channels");
        if (!(count >= 0 && count <= 6) || count != std::floor(count)) fail("a joint has 0 to 6 channels");
        for (int i = 0; i < static_cast<int>(count); ++i) {
            const std::string word = next("a channel");
            const auto found = std::find_if(channel_names.begin(), channel_names.end(),
                                            [&](const ChannelName& c) { return same_letters(c.name, word); });
            if (found == channel_names.end()) fail("'" + word.substr(0, 40) + "' is no channel");
            joint.channels.push_back(found->channel);
        }
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t begin_ = 0;
    Motion motion_;
};

Quaternion turn(Channel axis, double degrees) {
    const double half = degrees * (math::pi / 360), s = math::sin(half), c = math::cos(half);
    if (axis == Channel::x_rotation) return {s, 0, 0, c};
    if (axis == Channel::y_rotation) return {0, s, 0, c};
    return {0, 0, s, c};
}

double degrees(double radians) { return radians * (180 / math::pi); }

// Angles of R = Rz · Rx · Ry.
Vec3 zxy_angles(const Matrix3& m) {
    const double sine = std::clamp(m.rows[2].y, -1.0, 1.0),
                 cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
    const double x = math::atan2(sine, cosine);
    if (cosine < 1e-9) return {degrees(x), 0, degrees(math::atan2(m.rows[1].x, m.rows[0].x))};
    return {degrees(x), degrees(math::atan2(-m.rows[2].x, m.rows[2].z)),
            degrees(math::atan2(-m.rows[0].y, m.rows[1].y))};
}

class Writer {
public:
    Writer(const Rig& rig, const BoneAnimation& animation)
        : rig_(rig), animation_(animation), children_(rig.bones.size()) {
        for (std::size_t b = 1; b < rig.bones.size(); ++b)
            children_[static_cast<std::size_t>(rig.bones[b].parent)].push_back(static_cast<int>(b));
    }
    std::string write() {
        text_ = "HIERARCHY\n";
        bone(0, 0);
        const std::size_t frames =
            std::max<std::size_t>(1, animation_.times.size() - 1); // the last pose is the first
        const double time = animation_.duration / static_cast<double>(frames);
        text_ += "MOTION\nFrames: " + std::to_string(frames) + "\nFrame Time: " + to_decimal(time) + "\n";
        for (std::size_t i = 0; i < frames; ++i) frame(i);
        return std::move(text_);
    }

private:
    Vec3 place(Point2d p) const { return written_height * to_world(p, rig_.width, rig_.height); }
    std::string triple(Vec3 v) const {
        return to_decimal(v.x) + " " + to_decimal(v.y) + " " + to_decimal(v.z);
    }

    void bone(int index, int depth) {
        const Bone& b = rig_.bones[static_cast<std::size_t>(index)];
        const std::string tabs(static_cast<std::size_t>(depth), '\t');
        const Vec3 head = place(b.head),
                   from = b.parent < 0 ? Vec3{} : place(rig_.bones[static_cast<std::size_t>(b.parent)].head);
        text_ += tabs + (depth == 0 ? "ROOT " : "JOINT ") + b.name + "\n" + tabs + "{\n";
        text_ += tabs + "\tOFFSET " + triple(head - from) + "\n" + tabs + "\tCHANNELS ";
        text_ += depth == 0 ? "6 Xposition Yposition Zposition " : "3 ";
        text_ += "Zrotation Xrotation Yrotation\n";
        order_.push_back(index);
        const auto& children = children_[static_cast<std::size_t>(index)];
        for (const int child : children) bone(child, depth + 1);
        if (children.empty())
            text_ += tabs + "\tEnd Site\n" + tabs + "\t{\n" + tabs + "\t\tOFFSET " +
                     triple(place(b.tail) - head) + "\n" + tabs + "\t}\n";
        text_ += tabs + "}\n";
    }
    void frame(std::size_t i) {
        text_ += triple(place(rig_.bones[0].head) + written_height * animation_.root_translation[i]);
        for (const int b : order_) {
            const Vec3 angles = zxy_angles(matrix_of(animation_.rotations[static_cast<std::size_t>(b)][i]));
            text_ += " " + triple({angles.z, angles.x, angles.y});
        }
        text_ += "\n";
    }

    const Rig& rig_;
    const BoneAnimation& animation_;
    std::vector<std::vector<int>> children_;
    std::vector<int> order_; // of the joints in the file
    std::string text_;
};

} // namespace

Motion parse_bvh(std::string_view text, const std::string& file) { return Parser(text, file).parse(); }

std::vector<Vec3> joint_positions(const Motion& motion, std::size_t frame) {
    std::vector<Vec3> places(motion.joints.size());
    std::vector<Quaternion> turns(motion.joints.size());
    for (std::size_t j = 0; j < motion.joints.size(); ++j) {
        const MotionJoint& joint = motion.joints[j];
        Vec3 offset = joint.offset;
        Quaternion local;
        for (std::size_t c = 0; c < joint.channels.size(); ++c) {
            const double value = motion.values[frame * motion.channels + joint.first_channel + c];
            switch (joint.channels[c]) {
            case Channel::x_position:
                offset.x = value;
                break;
            case Channel::y_position:
                offset.y = value;
                break;
            case Channel::z_position:
                offset.z = value;
                break;
            default:
                local = local * turn(joint.channels[c], value);
            }
        }
        if (joint.parent < 0) {
            places[j] = offset;
            turns[j] = local;
        } else {
            const auto parent = static_cast<std::size_t>(joint.parent);
            places[j] = places[parent] + matrix_of(turns[parent]) * offset;
            turns[j] = normalised(turns[parent] * local);
        }
    }
    return places;
}

std::string to_bvh(const Rig& rig, const BoneAnimation& animation) { return Writer(rig, animation).write(); }

} // namespace pantin

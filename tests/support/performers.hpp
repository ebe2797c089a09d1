// SPDX-License-Identifier: MIT
// Recorded motions made by the tests: a performer of one height whose joints have the names of one program or
// another.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pantin::test {

// Names of the joints of one side ('<' stands for its letter or word), and of hips, neck and head.
struct JointNames {
    std::string left, right, hips, neck, head, upper_arm, forearm, hand, thigh, shin, foot;
};
inline const JointNames mixamo = {"Left",
                                  "Right",
                                  "mixamorig:Hips",
                                  "mixamorig:Neck",
                                  "mixamorig:Head",
                                  "mixamorig:<Arm",
                                  "mixamorig:<ForeArm",
                                  "mixamorig:<Hand",
                                  "mixamorig:<UpLeg",
                                  "mixamorig:<Leg",
                                  "mixamorig:<Foot"};

// Three angles (about z, x, y, in degrees) of a joint at a time in seconds; the joint by its plain English
// name.
using Posture = std::function<std::vector<double>(const std::string& joint, double time)>;

// Facing +z, y up, legs of 80 units, arms of 50 held out to the sides at rest; the root at (10 · time, 85, 40
// · time).
inline std::string performer(const JointNames& names, const Posture& posture, int frames = 31,
                             double frame_time = 1.0 / 30) {
    std::string order, hierarchy;
    std::vector<std::string> joints;
    const auto side = [&](const std::string& name, bool left) {
        const std::size_t at = name.find('<');
        return at == std::string::npos
                   ? name
                   : name.substr(0, at) + (left ? names.left : names.right) + name.substr(at + 1);
    };
    const auto triple = [](double x, double y, double z) {
        return std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z);
    };
    const auto open = [&](const std::string& plain, const std::string& name, const std::string& offset) {
        joints.push_back(plain);
        hierarchy +=
            (joints.size() == 1 ? "ROOT " : "JOINT ") + name + "\n{\nOFFSET " + offset + "\nCHANNELS ";
        hierarchy += joints.size() == 1 ? "6 Xposition Yposition Zposition " : "3 ";
        hierarchy += "Zrotation Xrotation Yrotation\n";
    };
    const auto end = [&](const std::string& offset) {
        hierarchy += "End Site\n{\nOFFSET " + offset + "\n}\n";
    };
    const auto close = [&](int count) {
        while (count-- > 0) hierarchy += "}\n";
    };
    hierarchy = "HIERARCHY\n";
    open("hips", names.hips, "0 0 0");
    for (const bool left : {true, false}) {
        const double s = left ? 1 : -1;
        const std::string word = left ? "left " : "right ";
        open(word + "thigh", side(names.thigh, left), triple(9 * s, -5, 0));
        open(word + "shin", side(names.shin, left), "0 -40 0");
        open(word + "foot", side(names.foot, left), "0 -40 0");
        end("0 -5 12");
        close(3);
        open(word + "upper arm", side(names.upper_arm, left), triple(17 * s, 45, 0));
        open(word + "forearm", side(names.forearm, left), triple(26 * s, 0, 0));
        open(word + "hand", side(names.hand, left), triple(24 * s, 0, 0));
        end(triple(8 * s, 0, 0));
        close(3);
    }
    open("neck", names.neck, "0 50 0");
    open("head", names.head, "0 8 0");
    end("0 20 0");
    close(3);
    std::string values;
    for (int i = 0; i < frames; ++i) {
        const double time = i * frame_time;
        values += triple(10 * time, 85, 40 * time);
        for (const std::string& joint : joints)
            for (const double angle : posture(joint, time)) values += " " + std::to_string(angle);
        values += "\n";
    }
    return hierarchy + "MOTION\nFrames: " + std::to_string(frames) +
           "\nFrame Time: " + std::to_string(frame_time) + "\n" + values;
}

// Arms up and down at the sides, legs apart and together: all in the frontal plane.
inline std::vector<double> jumping_jack(const std::string& joint, double time) {
    const double open = 0.5 - 0.5 * std::cos(2 * 3.14159265358979 * time);
    if (joint == "left upper arm") return {-70 + 140 * open, 0, 0};
    if (joint == "right upper arm") return {70 - 140 * open, 0, 0};
    if (joint == "left thigh") return {25 * open, 0, 0};
    if (joint == "right thigh") return {-25 * open, 0, 0};
    if (joint == "left forearm") return {20 * open, 0, 0};
    return {0, 0, 0};
}

// Legs that swing forwards and backwards, the arms at the sides: a walk.
inline std::vector<double> walking(const std::string& joint, double time) {
    const double swing = 30 * std::sin(2 * 3.14159265358979 * time);
    if (joint == "left upper arm") return {-80, 0, 0};
    if (joint == "right upper arm") return {80, 0, 0};
    if (joint == "left thigh") return {0, -swing, 0};
    if (joint == "right thigh") return {0, swing, 0};
    return {0, 0, 0};
}

} // namespace pantin::test

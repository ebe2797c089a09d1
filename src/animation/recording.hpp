// SPDX-License-Identifier: MIT
// A recorded motion as the figure itself sees it: sampled evenly, turned so that it faces the viewer.
#pragma once

#include <vector>

#include "pantin/motion.hpp"

namespace pantin {

inline constexpr double key_rate = 30; // key poses per second

struct RecordedPose {
    // Places in the figure's own directions: x to its left (the right of the picture), y up, z forwards; the
    // hips are the origin. The file's units.
    std::vector<Vec3> joints;
    double way = 0;    // of the hips from the start, to the right of the picture
    double height = 0; // of the hips above the ground
    // Cosine between forwards and the right of the picture: 1, except for a figure that goes a long way with
    // turns, which is seen by a camera that stands. Then a view from the side shows forwards to the left
    // where it is negative.
    double forwards = 1;
};

class Recording {
public:
    Recording(const Motion& motion, const MotionJoints& joints, const FollowOptions& options);

    const std::vector<RecordedPose>& poses() const { return poses_; }
    // The hierarchy's own pose in the same directions, where it is that of a standing figure; else empty.
    const std::vector<Vec3>& rest() const { return rest_; }
    double leg_length() const { return leg_length_; }
    double standing_height() const { return standing_height_; } // of the hips above the ankles, legs straight

private:
    using Frame = std::vector<Vec3>;
    Vec3 at(std::size_t frame, int joint) const { return frames_[frame][static_cast<std::size_t>(joint)]; }
    Vec3 heading_vote(const Frame& frame) const;
    void find_headings();
    void smooth_headings(const std::vector<Vec3>& raw);
    double angle_between(Vec3 from, Vec3 to) const;
    Vec3 turned(Vec3 horizontal, double angle) const;
    void find_legs();
    void find_rest(const Motion& motion);
    void find_way(bool in_place);
    Vec3 principal_axis() const;
    bool goes_forwards() const;
    Vec3 in_own_directions(Vec3 v, Vec3 heading) const;

    const MotionJoints& joints_;
    Vec3 up_{0, 1, 0};
    std::vector<Frame> frames_;
    bool stood_ = true;          // of find_headings(), in the pose before
    std::vector<Vec3> headings_; // horizontal unit vectors
    std::vector<RecordedPose> poses_;
    Frame rest_;
    double leg_length_ = 1, standing_height_ = 1;
};

} // namespace pantin

// SPDX-License-Identifier: MIT
// Test-time augmentation of any segmentation network: the input's square is tilted and mirrored, the answers
// are brought back and averaged. Ours; thesis 4.3 passes the drawing once.
#include "segmentation/views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math.hpp"
#include "pantin/segmentation.hpp"

namespace pantin::segmentation {
namespace {

constexpr float ink_level = 0.25f; // darker pixels are ink
constexpr double filled = 0.955;   // of the square's side by the tilted ink

struct View {
    Tilt tilt;
    bool is_tilted = false, is_mirrored = false;
    std::unique_ptr<EncodedInput> encoded;
    Tensor router, type, pose, parts; // of the drawing, not of the view
    int expert = 0;                   // that pose and parts are of
    double confidence = 0, weight = 1;
};

// Directions of a mirrored drawing as those of the drawing: E and W exchange, N and S stay.
Tensor mirrored_pose(const Tensor& pose) {
    Tensor result = pose;
    for (std::size_t i = 0; i < pose_names.size(); ++i) {
        std::string name = pose_names[i];
        for (char& c : name) c = c == 'E' ? 'W' : c == 'W' ? 'E' : c;
        const auto other = std::find(pose_names.begin(), pose_names.end(), name) - pose_names.begin();
        result.begin()[other] = pose.begin()[i];
    }
    return result;
}

// Where (x, y) lies between four pixels of a square.
struct Place {
    int column = 0, row = 0; // of the upper left one
    double u = 0, v = 0;     // to the right of it, below it
    bool reaches = false;    // whether one of the four is in the square
    bool is_inside = false;  // whether all of them are
};
Place place_of(double x, double y, int side) {
    const double left = std::floor(x), top = std::floor(y);
    if (left < -1 || top < -1 || left >= side || top >= side) return {};
    const int column = static_cast<int>(left), row = static_cast<int>(top);
    return {column,  row,  x - left,
            y - top, true, column >= 0 && row >= 0 && column + 1 < side && row + 1 < side};
}

// The bilinear value of a plane there, whose surroundings are `outside`.
float sample(const float* plane, int side, const Place& place, float outside) {
    if (!place.reaches) return outside;
    const auto bilinear = [&](double a, double b, double c, double d) {
        return static_cast<float>((1 - place.v) * ((1 - place.u) * a + place.u * b) +
                                  place.v * ((1 - place.u) * c + place.u * d));
    };
    const auto at = [&](int column, int row) {
        return column >= 0 && row >= 0 && column < side && row < side
                   ? plane[static_cast<std::size_t>(row) * side + column]
                   : outside;
    };
    if (place.is_inside) {
        const float* first = plane + static_cast<std::size_t>(place.row) * side + place.column;
        return bilinear(first[0], first[1], first[side], first[side + 1]);
    }
    return bilinear(at(place.column, place.row), at(place.column + 1, place.row),
                    at(place.column, place.row + 1), at(place.column + 1, place.row + 1));
}

// Asks that expert about the view and brings its answer back to the drawing.
void ask(View& view, int expert, const Runtime& runtime) {
    auto [pose, parts] = view.encoded->decode(expert, runtime);
    if (view.is_mirrored) {
        pose = mirrored_pose(pose);
        parts = network::mirrored(parts);
    }
    view.expert = expert;
    view.pose = std::move(pose);
    view.parts = view.is_tilted ? straightened(parts, view.tilt) : std::move(parts);
}

// The drawing tilted and mirrored, through the network, with the expert of this view.
View make_view(const SegmentationNetwork& net, const Tensor& ink, double degrees, bool mirror,
               const Runtime& runtime) {
    View view;
    view.is_mirrored = mirror;
    view.is_tilted = degrees != 0;
    Tensor seen = ink;
    if (view.is_tilted) {
        view.tilt = tilt_of(ink, degrees);
        seen = tilted(ink, view.tilt);
    }
    if (mirror) seen = network::mirrored(seen);
    view.encoded = net.encode(seen, runtime);
    view.router = std::move(view.encoded->router);
    view.type = std::move(view.encoded->type);
    ask(view, most_probable(view.router), runtime);
    view.confidence = confidence_of(view.parts);
    return view;
}

Tensor weighted_mean(const std::vector<View>& views, Tensor View::*answer) {
    Tensor mean = views.front().*answer;
    std::fill(mean.begin(), mean.end(), 0.0f);
    double total = 0;
    for (const View& view : views) total += view.weight;
    for (const View& view : views) {
        const auto share = static_cast<float>(view.weight / total);
        const Tensor& values = view.*answer;
        std::transform(mean.begin(), mean.end(), values.begin(), mean.begin(),
                       [share](float sum, float value) { return sum + share * value; });
    }
    return mean;
}

} // namespace

double confidence_of(const Tensor& parts) {
    double probable = 0, all = 0;
    for (std::size_t i = 0; i < parts.plane_size(); ++i) {
        float most = 0;
        for (int c = 1; c < parts.channels(); ++c) most = std::max(most, parts.plane(0, c)[i]);
        const double foreground = 1.0 - parts.plane(0, 0)[i];
        probable += foreground * most;
        all += foreground;
    }
    return all > 0 ? probable / all : 0;
}

Tilt tilt_of(const Tensor& ink, double degrees) {
    constexpr double radians = math::pi / 180;
    const double c = math::cos(degrees * radians), s = math::sin(degrees * radians);
    double left = std::numeric_limits<double>::infinity(), top = left, right = -left, bottom = -left;
    for (int y = 0; y < ink.height(); ++y)
        for (int x = 0; x < ink.width(); ++x) {
            if (ink(0, 0, y, x) <= ink_level) continue;
            const double u = c * x - s * y, v = s * x + c * y;
            left = std::min(left, u), right = std::max(right, u);
            top = std::min(top, v), bottom = std::max(bottom, v);
        }
    if (left > right) return {};
    const double scale = filled * ink.width() / (std::max(right - left, bottom - top) + 1);
    const double middle = 0.5 * (ink.width() - 1);
    return {scale * c, scale * s, middle - scale * 0.5 * (left + right),
            middle - scale * 0.5 * (top + bottom)};
}

Tensor tilted(const Tensor& ink, const Tilt& tilt) {
    const int side = ink.width();
    const double squared = tilt.cosine * tilt.cosine + tilt.sine * tilt.sine;
    Tensor view = Tensor::uninitialised(1, 1, side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double u = x - tilt.shift_x, v = y - tilt.shift_y;
            const Place place = place_of((tilt.cosine * u + tilt.sine * v) / squared,
                                         (tilt.cosine * v - tilt.sine * u) / squared, side);
            view(0, 0, y, x) = sample(ink.plane(0, 0), side, place, 0);
        }
    return view;
}

Tensor straightened(const Tensor& parts, const Tilt& tilt) {
    const int side = parts.width();
    Tensor result = Tensor::uninitialised(1, parts.channels(), side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Place place = place_of(tilt.cosine * x - tilt.sine * y + tilt.shift_x,
                                         tilt.sine * x + tilt.cosine * y + tilt.shift_y, side);
            for (int c = 0; c < parts.channels(); ++c)
                result(0, c, y, x) = sample(parts.plane(0, c), side, place, c == 0 ? 1.0f : 0.0f);
        }
    return result;
}

NetworkResult segment_views(const SegmentationNetwork& net, const Tensor& ink, const ViewOptions& options,
                            const Runtime& runtime) {
    std::vector<View> views;
    views.push_back(make_view(net, ink, 0, false, runtime));
    if (views.front().confidence < options.sufficient_confidence) {
        if (options.mirror) views.push_back(make_view(net, ink, 0, true, runtime));
        for (const double degrees : {options.tilt, -options.tilt}) {
            if (degrees == 0) continue;
            views.push_back(make_view(net, ink, degrees, false, runtime));
            if (options.mirror) views.push_back(make_view(net, ink, degrees, true, runtime));
        }
    }
    double largest = 0;
    for (const View& view : views) largest = std::max(largest, view.confidence);
    for (View& view : views)
        view.weight = math::exp(options.inverse_temperature * (view.confidence - largest));

    NetworkResult result;
    result.confidence = largest;
    result.router = weighted_mean(views, &View::router);
    result.expert = most_probable(result.router);
    for (View& view : views)
        if (view.expert != result.expert) ask(view, result.expert, runtime);
    result.type = weighted_mean(views, &View::type);
    result.pose = weighted_mean(views, &View::pose);
    result.parts = weighted_mean(views, &View::parts);
    return result;
}

} // namespace pantin::segmentation

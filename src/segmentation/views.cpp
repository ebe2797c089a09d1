// SPDX-License-Identifier: MIT
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
    Features features;
    Tensor router, pose, parts; // of the drawing, not of the view
    int expert = 0;
    double weight = 1;
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

// The bilinear value of a plane at (x, y), whose surroundings are `outside`.
float sample(const float* plane, int side, double x, double y, float outside) {
    const double left = std::floor(x), top = std::floor(y);
    if (left < -1 || top < -1 || left >= side || top >= side) return outside;
    const int x0 = static_cast<int>(left), y0 = static_cast<int>(top);
    const auto at = [&](int column, int row) {
        return column >= 0 && row >= 0 && column < side && row < side
                   ? static_cast<double>(plane[static_cast<std::size_t>(row) * side + column])
                   : static_cast<double>(outside);
    };
    const double u = x - left, v = y - top;
    return static_cast<float>((1 - v) * ((1 - u) * at(x0, y0) + u * at(x0 + 1, y0)) +
                              v * ((1 - u) * at(x0, y0 + 1) + u * at(x0 + 1, y0 + 1)));
}

// Mean probability of the most probable part, weighted by the foreground.
double sureness(const Tensor& parts) {
    double sure = 0, all = 0;
    for (std::size_t i = 0; i < parts.plane_size(); ++i) {
        float most = 0;
        for (int c = 1; c < parts.channels(); ++c) most = std::max(most, parts.plane(0, c)[i]);
        const double foreground = 1.0 - parts.plane(0, 0)[i];
        sure += foreground * most;
        all += foreground;
    }
    return all > 0 ? sure / all : 0;
}

// The answer of that expert on the view, brought back to the drawing.
Tensor parts_of(const Network& net, const View& view, int expert, const Runtime& runtime) {
    Tensor parts = net.experts[static_cast<std::size_t>(expert)].forward(view.features, runtime);
    if (view.is_mirrored) parts = network::mirrored(parts);
    return view.is_tilted ? straightened(parts, view.tilt) : parts;
}

View look_once(const Network& net, const Tensor& ink, double degrees, bool mirror, const Runtime& runtime) {
    View view;
    view.is_mirrored = mirror;
    view.is_tilted = degrees != 0;
    Tensor seen = ink;
    if (view.is_tilted) {
        view.tilt = tilt_of(ink, degrees);
        seen = tilted(ink, view.tilt);
    }
    if (mirror) seen = network::mirrored(seen);
    view.features = net.stem.forward(seen, runtime);
    view.router = net.router->forward(view.features, runtime);
    view.pose = net.pose->forward(view.features, runtime);
    if (mirror) view.pose = mirrored_pose(view.pose);
    view.expert = most_probable(view.router);
    view.parts = parts_of(net, view, view.expert, runtime);
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
            view(0, 0, y, x) = sample(ink.plane(0, 0), side, (tilt.cosine * u + tilt.sine * v) / squared,
                                      (tilt.cosine * v - tilt.sine * u) / squared, 0);
        }
    return view;
}

Tensor straightened(const Tensor& parts, const Tilt& tilt) {
    const int side = parts.width();
    Tensor result = Tensor::uninitialised(1, parts.channels(), side, side);
    for (int c = 0; c < parts.channels(); ++c)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                result(0, c, y, x) =
                    sample(parts.plane(0, c), side, tilt.cosine * x - tilt.sine * y + tilt.shift_x,
                           tilt.sine * x + tilt.cosine * y + tilt.shift_y, c == 0 ? 1.0f : 0.0f);
    return result;
}

NetworkResult look(const Network& net, const Tensor& ink, const Looks& looks, const Runtime& runtime) {
    std::vector<View> views = {look_once(net, ink, 0, false, runtime)};
    std::vector<double> sure = {sureness(views.front().parts)};
    const auto look_also = [&](double degrees, bool mirror) {
        views.push_back(look_once(net, ink, degrees, mirror, runtime));
        sure.push_back(sureness(views.back().parts));
    };
    if (sure.front() < looks.sure_enough) {
        if (looks.mirror) look_also(0, true);
        for (const double degrees : {looks.tilt, -looks.tilt}) {
            if (degrees == 0) continue;
            look_also(degrees, false);
            if (looks.mirror) look_also(degrees, true);
        }
    }
    const double surest = *std::max_element(sure.begin(), sure.end());
    for (std::size_t i = 0; i < views.size(); ++i)
        views[i].weight = math::exp(looks.sharpness * (sure[i] - surest));

    NetworkResult result;
    result.sureness = surest;
    result.router = weighted_mean(views, &View::router);
    result.pose = weighted_mean(views, &View::pose);
    result.expert = most_probable(result.router);
    for (View& view : views)
        if (view.expert != result.expert) view.parts = parts_of(net, view, result.expert, runtime);
    result.parts = weighted_mean(views, &View::parts);
    return result;
}

} // namespace pantin::segmentation

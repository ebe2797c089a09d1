// SPDX-License-Identifier: MIT
// In come labels and distance transform; out go the pieces of parts with the pixel where each hangs on the
// others and a path from there to its farthest pixel. Our own: the thesis (4.6) knows end-effectors alone.
#include "rigging/part_components.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "image/label_map.hpp"
#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

// The border pixels towards other parts, and the share of the border that meets the background.
std::vector<Point2i> contacts(PartComponent& part, const std::vector<Point2i>& pixels, const LabelMap& labels,
                              const Grid<float>& depth) {
    std::vector<Point2i> contact;
    int free = 0;
    for (const Point2i& p : pixels) {
        bool meets_part = false, meets_outside = false;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            if (depth.value_or(p.x + dx, p.y + dy, 0) <= 0)
                meets_outside = true;
            else
                meets_part |= labels(p.x + dx, p.y + dy) != static_cast<std::uint8_t>(part.label);
        }
        free += meets_outside;
        if (meets_part) contact.push_back(p);
    }
    const double all = free + static_cast<double>(contact.size());
    part.free_share = all > 0 ? free / all : 0;
    return contact;
}

Point2i middle_of(const std::vector<Point2i>& points) {
    Point2d mean{};
    for (const Point2i& p : points) mean = mean + (1.0 / static_cast<double>(points.size())) * to_double(p);
    Point2i best = points.front();
    for (const Point2i& p : points)
        if (distance(to_double(p), mean) < distance(to_double(best), mean)) best = p;
    return best;
}

// Settles the pixels of the part in ascending order of their way from the start, a step costing 1 in the
// part's middle and up to 3 at its border (Dijkstra over pixels; ties by the pixel's index). `from`: per
// pixel of the crop the one before it, −1 at the start. Returns the last one, the farthest.
int settle(const Mask& part, const Grid<float>& depth, Point2i corner, int start, Grid<int>& from) {
    float deepest = 1;
    for (int y = 0; y < part.height(); ++y)
        for (int x = 0; x < part.width(); ++x)
            if (part(x, y)) deepest = std::max(deepest, depth(corner.x + x, corner.y + y));
    Grid<double> cost(part.width(), part.height(), -1);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    cost.data()[start] = 0;
    queue.emplace(0.0, start);
    int last = start;
    while (!queue.empty()) {
        const auto [c, i] = queue.top();
        queue.pop();
        if (c > cost.data()[i]) continue;
        last = i;
        for (const Point2i d : neighbour_offsets) {
            const int x = i % part.width() + d.x, y = i / part.width() + d.y;
            if (!part.value_or(x, y, 0)) continue;
            const double step = d.x != 0 && d.y != 0 ? 1.4142135623730951 : 1;
            const double next = c + step * (3 - 2.0 * depth(corner.x + x, corner.y + y) / deepest);
            if (cost(x, y) >= 0 && cost(x, y) <= next) continue;
            cost(x, y) = next;
            from(x, y) = i;
            queue.emplace(next, y * part.width() + x);
        }
    }
    return last;
}

// Inside the part, from the attachment to the pixel farthest from it.
std::vector<Point2d> longest_path(const LabelPiece& piece, Point2i attachment, const Grid<float>& depth) {
    const Mask part = cropped_mask(piece);
    const Point2i corner{piece.box.x, piece.box.y};
    Grid<int> from(part.width(), part.height(), -1);
    const int start = (attachment.y - corner.y) * part.width() + attachment.x - corner.x;
    std::vector<Point2d> path;
    for (int i = settle(part, depth, corner, start, from); i >= 0; i = from.data()[i])
        path.push_back(to_double({corner.x + i % part.width(), corner.y + i / part.width()}));
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace

std::vector<PartComponent> part_components(const LabelMap& labels, const Grid<float>& depth, int min_area) {
    std::vector<PartComponent> parts;
    for (const Label label : part_labels) {
        if (role_of(label) == PartRole::trunk) continue;
        Mask mask = part_mask(labels, {label});
        for (std::size_t i = 0; i < mask.size(); ++i) mask.data()[i] &= depth.data()[i] > 0;
        for (LabelPiece& piece : pieces_of(mask, min_area)) {
            PartComponent part;
            part.label = label;
            const std::vector<Point2i> contact = contacts(part, piece.pixels, labels, depth);
            if (contact.empty()) continue;
            part.attachment = middle_of(contact);
            part.path = longest_path(piece, part.attachment, depth);
            part.pixels = std::move(piece.pixels);
            parts.push_back(std::move(part));
        }
    }
    return parts;
}

} // namespace pantin

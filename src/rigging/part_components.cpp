// SPDX-License-Identifier: MIT
#include "rigging/part_components.hpp"

#include <algorithm>
#include <queue>

#include "pantin/image.hpp"

namespace pantin {
namespace {

// The border pixels towards other parts, and the share of the border that meets the background.
std::vector<Point2i> contacts(PartComponent& part, const LabelMap& labels, const Grid<float>& depth) {
    std::vector<Point2i> contact;
    int free = 0;
    for (const Point2i& p : part.pixels) {
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

// Dijkstra from the attachment; a step costs 1 in the part's middle and up to 3 at its border.
std::vector<Point2d> longest_path(const PartComponent& part, const Grid<int>& ids, int id,
                                  const Grid<float>& depth) {
    float deepest = 1;
    for (const Point2i& p : part.pixels) deepest = std::max(deepest, depth(p.x, p.y));
    const int width = ids.width();
    Grid<double> cost(width, ids.height(), -1);
    Grid<int> from(width, ids.height(), -1);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const int start = part.attachment.y * width + part.attachment.x;
    cost.data()[start] = 0;
    queue.emplace(0.0, start);
    int last = start;
    while (!queue.empty()) {
        const auto [c, i] = queue.top();
        queue.pop();
        if (c > cost.data()[i]) continue;
        last = i; // settled in ascending order: the last one is the farthest
        const int x = i % width, y = i / width;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int nx = x + dx, ny = y + dy;
                if (!ids.contains(nx, ny) || ids(nx, ny) != id) continue;
                const double step = dx != 0 && dy != 0 ? 1.4142135623730951 : 1;
                const double next = c + step * (3 - 2.0 * depth(nx, ny) / deepest);
                if (cost(nx, ny) >= 0 && cost(nx, ny) <= next) continue;
                cost(nx, ny) = next;
                from(nx, ny) = i;
                queue.emplace(next, ny * width + nx);
            }
    }
    std::vector<Point2d> path;
    for (int i = last; i >= 0; i = from.data()[i])
        path.push_back({static_cast<double>(i % width), static_cast<double>(i / width)});
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace

std::vector<PartComponent> part_components(const LabelMap& labels, const Grid<float>& depth, int min_area) {
    std::vector<PartComponent> parts;
    for (const Label label : part_labels) {
        if (role_of(label) == PartRole::trunk) continue;
        Mask mask(labels.width(), labels.height());
        for (std::size_t i = 0; i < mask.size(); ++i)
            mask.data()[i] = depth.data()[i] > 0 && labels.data()[i] == static_cast<std::uint8_t>(label);
        const Components components = connected_components(mask);
        for (const Component& component : components.list) {
            if (component.area < min_area) continue;
            PartComponent part;
            part.label = label;
            const Box& box = component.box;
            for (int y = box.y; y < box.y + box.height; ++y)
                for (int x = box.x; x < box.x + box.width; ++x)
                    if (components.ids(x, y) == component.id) part.pixels.push_back({x, y});
            const std::vector<Point2i> contact = contacts(part, labels, depth);
            if (contact.empty()) continue;
            part.attachment = middle_of(contact);
            part.path = longest_path(part, components.ids, component.id, depth);
            parts.push_back(std::move(part));
        }
    }
    return parts;
}

} // namespace pantin

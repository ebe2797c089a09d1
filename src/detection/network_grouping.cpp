// SPDX-License-Identifier: MIT
// Detections of the network and ink of the page to one group of ink for each character (thesis 4.2). The
// rules (network_grouping.hpp) are ours: the thesis takes the mask itself.
#include "detection/network_grouping.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "pantin/image.hpp"

namespace pantin {

namespace {

// Whether `part` is a part of `whole` rather than a character of its own (DetectionOptions::contained_share).
bool is_part(const CharacterFinder::Found& part, const CharacterFinder::Found& whole,
             const DetectionOptions& options) {
    const auto area = [](const CharacterFinder::Found& f) { return (f.right - f.left) * (f.bottom - f.top); };
    if (&part == &whole || area(whole) <= area(part) || whole.score < part.score) return false;
    int own = 0, shared = 0;
    for (int row = 0; row < part.mask.height(); ++row)
        for (int column = 0; column < part.mask.width(); ++column) {
            if (part.mask(column, row) < 0.5f) continue;
            ++own;
            shared += whole.probability(
                          part.left + (column + 0.5) * (part.right - part.left) / part.mask.width(),
                          part.top + (row + 0.5) * (part.bottom - part.top) / part.mask.height()) >= 0.5;
        }
    return shared >= options.contained_share * own;
}

// Per piece of ink: detection → number of its pixels that the detection claims.
std::vector<std::map<int, int>> count_claims(const Components& pieces, const Grid<int>& owner) {
    std::vector<std::map<int, int>> claims(pieces.list.size());
    for (std::size_t i = 0; i < owner.size(); ++i)
        if (pieces.ids.data()[i] && owner.data()[i])
            ++claims[static_cast<std::size_t>(pieces.ids.data()[i]) - 1][owner.data()[i]];
    return claims;
}

// The owner of a whole piece; 0 when nobody claims it, −1 when it is to be divided.
int owner_of(const std::map<int, int>& claims, double shared_claim) {
    int total = 0, best = 0, most = 0;
    for (const auto& [owner, pixels] : claims) {
        total += pixels;
        if (pixels > most) best = owner, most = pixels;
    }
    return total - most >= shared_claim * total && total > 0 ? -1 : best;
}

// Boxes of the groups' pixels; empty boxes for those without.
std::vector<Box> boxes_of(const Grid<int>& groups, int count) {
    std::vector<Point2i> low(static_cast<std::size_t>(count), {groups.width(), groups.height()}),
        high(static_cast<std::size_t>(count), {-1, -1});
    for (int y = 0; y < groups.height(); ++y)
        for (int x = 0; x < groups.width(); ++x) {
            if (groups(x, y) == 0) continue;
            const auto g = static_cast<std::size_t>(groups(x, y)) - 1;
            low[g] = {std::min(low[g].x, x), std::min(low[g].y, y)};
            high[g] = {std::max(high[g].x, x), std::max(high[g].y, y)};
        }
    std::vector<Box> boxes;
    for (std::size_t g = 0; g < low.size(); ++g)
        boxes.push_back(high[g].x < 0
                            ? Box{}
                            : Box{low[g].x, low[g].y, high[g].x - low[g].x + 1, high[g].y - low[g].y + 1});
    return boxes;
}

Mask where_positive(const Grid<int>& values) {
    Mask mask(values.width(), values.height());
    std::transform(values.begin(), values.end(), mask.begin(), [](int v) -> std::uint8_t { return v > 0; });
    return mask;
}

// Takes from a group the connected ink away from its claims that goes on too far for a tail.
void drop_distant(Grid<int>& groups, const Grid<int>& owner, const DetectionOptions& options) {
    const int count = *std::max_element(owner.begin(), owner.end());
    const std::vector<Box> boxes = boxes_of(owner, count);
    for (int g = 1; g <= count; ++g) {
        const Box& box = boxes[static_cast<std::size_t>(g) - 1];
        const double diagonal =
            length(Point2d{static_cast<double>(box.width), static_cast<double>(box.height)});
        Mask claimed(owner.width(), owner.height()), beyond = claimed;
        for (std::size_t i = 0; i < owner.size(); ++i) claimed.data()[i] = owner.data()[i] == g;
        const Mask near = dilate_disc(claimed, options.claimed_reach * diagonal),
                   possible = dilate_disc(claimed, options.claimed_extent * diagonal);
        for (std::size_t i = 0; i < owner.size(); ++i)
            beyond.data()[i] = groups.data()[i] == g && !near.data()[i];
        const Components pieces = connected_components(beyond);
        std::vector<char> endless(pieces.list.size() + 1, 0);
        for (std::size_t i = 0; i < owner.size(); ++i)
            if (beyond.data()[i] && !possible.data()[i])
                endless[static_cast<std::size_t>(pieces.ids.data()[i])] = 1;
        for (std::size_t i = 0; i < owner.size(); ++i)
            if (endless[static_cast<std::size_t>(pieces.ids.data()[i])]) groups.data()[i] = 0;
    }
}

// Rule 1.
Grid<int> give_claimed(const Components& pieces, const Claims& claims, const DetectionOptions& options) {
    std::vector<int> owners;
    for (const std::map<int, int>& counts : count_claims(pieces, claims.owner))
        owners.push_back(owner_of(counts, options.shared_claim));
    Grid<int> groups(pieces.ids.width(), pieces.ids.height(), 0);
    const Grid<int> nearest = nearest_seed(where_positive(claims.owner));
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const int piece = pieces.ids.data()[i];
        if (piece == 0) continue;
        const int owner = owners[static_cast<std::size_t>(piece) - 1];
        groups.data()[i] =
            owner >= 0 ? owner : claims.owner.data()[static_cast<std::size_t>(nearest.data()[i])];
    }
    drop_distant(groups, claims.owner, options);
    return groups;
}

// Rule 2.
void give_unclaimed(Grid<int>& groups, const Components& pieces, const std::vector<Box>& boxes,
                    const DetectionOptions& options) {
    const Grid<int> nearest = nearest_seed(where_positive(groups));
    struct Way {
        long squared = -1, longest = 0; // the longest: of all its pixels
        int group = 0;
    };
    std::vector<Way> ways(pieces.list.size()); // the shortest from the piece to a group
    for (int y = 0; y < groups.height(); ++y)
        for (int x = 0; x < groups.width(); ++x) {
            const int seed = nearest(x, y);
            if (pieces.ids(x, y) == 0 || groups(x, y) != 0 || seed < 0) continue;
            Way& way = ways[static_cast<std::size_t>(pieces.ids(x, y)) - 1];
            const long dx = x - seed % groups.width(), dy = y - seed / groups.width();
            const long squared = dx * dx + dy * dy;
            way.longest = std::max(way.longest, squared);
            if (way.squared >= 0 && squared >= way.squared) continue;
            way.squared = squared;
            way.group = groups.data()[static_cast<std::size_t>(seed)];
        }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const int piece = pieces.ids.data()[i];
        if (piece == 0 || groups.data()[i] != 0) continue;
        const Way& way = ways[static_cast<std::size_t>(piece) - 1];
        if (way.squared < 0) continue;
        const Box& box = boxes[static_cast<std::size_t>(way.group) - 1];
        const double diagonal =
            length(Point2d{static_cast<double>(box.width), static_cast<double>(box.height)});
        const double nearest_end = options.unclaimed_reach * diagonal,
                     farthest_end = options.unclaimed_extent * diagonal;
        if (static_cast<double>(way.squared) <= nearest_end * nearest_end &&
            static_cast<double>(way.longest) <= farthest_end * farthest_end)
            groups.data()[i] = way.group;
    }
}

} // namespace

std::vector<CharacterFinder::Found> whole_characters(std::vector<CharacterFinder::Found> found,
                                                     const DetectionOptions& options) {
    std::erase_if(found, [&](const auto& f) { return f.score < options.network_score; });
    std::vector<CharacterFinder::Found> whole;
    for (const CharacterFinder::Found& f : found)
        if (std::none_of(found.begin(), found.end(),
                         [&](const auto& other) { return is_part(f, other, options); }))
            whole.push_back(f);
    return whole;
}

Grouping group_by_claims(const Mask& ink, const Claims& claims, const DetectionOptions& options) {
    const Components pieces = connected_components(ink);
    Grid<int> groups = give_claimed(pieces, claims, options);
    const int count = static_cast<int>(claims.scores.size());
    if (count == 0) return {std::move(groups), {}, {}, {}};
    give_unclaimed(groups, pieces, boxes_of(groups, count), options);

    // Detections without ink of their own disappear; the others are numbered anew.
    Grouping result;
    std::vector<int> number(claims.scores.size() + 1, 0);
    const std::vector<Box> boxes = boxes_of(groups, count);
    for (std::size_t g = 0; g < boxes.size(); ++g) {
        if (boxes[g].width == 0) continue;
        result.boxes.push_back(boxes[g]);
        result.scores.push_back(claims.scores[g]);
        result.detections.push_back(static_cast<int>(g));
        number[g + 1] = static_cast<int>(result.boxes.size());
    }
    for (int& group : groups) group = number[static_cast<std::size_t>(group)];
    result.groups = std::move(groups);
    return result;
}

} // namespace pantin

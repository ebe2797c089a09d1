// SPDX-License-Identifier: MIT
// Step 1 of the pipeline (thesis 4.2): ink, its grouping to characters by contours or by Mask R-CNN,
// silhouettes. Based on: S. Suzuki, K. Abe: Topological structural analysis of digitized binary images by
// border following. CVGIP 30, 1985. The page is thresholded against its local mean, pieces of ink are grouped
// to characters (grouping.cpp), and each character's open outline is closed (enclosed_regions.cpp,
// ink_silhouette.cpp).
#include "pantin/detection.hpp"

#include <algorithm>
#include <cmath>

#include "detection/grouping.hpp"
#include "detection/ink_silhouette.hpp"
#include "detection/joining.hpp"
#include "detection/network_grouping.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

// Strokes: darker than the local mean by `ink_contrast` and not near-white; filled areas: at least half as
// dark as the darkest strokes, or found as such.
Mask find_ink(const PageInk& page, const DetectionOptions& options) {
    if (page.cut_out) return page.fills;
    const Grid<float>& darkness = page.darkness;
    GreyImage even(darkness.width(), darkness.height());
    for (std::size_t i = 0; i < even.size(); ++i)
        even.data()[i] = static_cast<std::uint8_t>(255 - static_cast<int>(255 * darkness.data()[i] + 0.5f));
    const int radius = std::max(8, std::max(even.width(), even.height()) / options.threshold_windows);
    Mask ink = adaptive_threshold(even, radius, static_cast<int>(255 * options.ink_contrast));
    const int lightest = 255 - static_cast<int>(255 * options.lightest_stroke);
    const int filled = 255 - static_cast<int>(255 * options.filled_darkness);
    for (std::size_t i = 0; i < ink.size(); ++i) {
        const int value = even.data()[i];
        ink.data()[i] = value < filled || (ink.data()[i] && value < lightest) || page.fills.data()[i];
    }
    return ink;
}

// One pixel per block of `factor`² pixels, ink where any of them is: thin lines survive.
Mask reduce(const Mask& ink, int factor) {
    if (factor == 1) return ink;
    Mask small((ink.width() + factor - 1) / factor, (ink.height() + factor - 1) / factor);
    for (int y = 0; y < ink.height(); ++y)
        for (int x = 0; x < ink.width(); ++x) small(x / factor, y / factor) |= ink(x, y);
    return small;
}

// The group's box in page pixels with its margin, cut at the page's border.
Box page_box(const Box& box, int factor, const RgbImage& page) {
    const int longer = factor * std::max(box.width, box.height);
    const int margin = std::max(4, (longer + 25) / 50);
    const int left = std::max(0, factor * box.x - margin), top = std::max(0, factor * box.y - margin);
    const int right = std::min(page.width(), factor * (box.x + box.width) + margin);
    const int bottom = std::min(page.height(), factor * (box.y + box.height) + margin);
    return {left, top, right - left, bottom - top};
}

int working_side(int pixels, double scale) {
    return std::max(1, static_cast<int>(std::floor(pixels * scale + 0.5)));
}

double working_scale(const Box& box, const DetectionOptions& options) {
    return std::min(1.0, static_cast<double>(options.working_size) / std::max(box.width, box.height));
}

// The ink of one group inside its box, page pixels.
Mask own_ink(const Mask& ink, const Grouping& grouping, int group, int factor, const Box& box) {
    Mask own(box.width, box.height);
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x)
            own(x, y) = ink(box.x + x, box.y + y) &&
                        grouping.groups((box.x + x) / factor, (box.y + y) / factor) == group;
    return own;
}

// A working pixel belongs to the mask when so much of it does: a third of a stroke, half of a silhouette.
Mask at_working_size(const Mask& mask, double scale, float least) {
    if (scale == 1) return mask;
    Grid<float> cover(mask.width(), mask.height());
    std::copy(mask.begin(), mask.end(), cover.begin());
    cover = resize(cover, working_side(mask.width(), scale), working_side(mask.height(), scale));
    Mask small(cover.width(), cover.height());
    for (std::size_t i = 0; i < small.size(); ++i) small.data()[i] = cover.data()[i] >= least;
    return small;
}

// Without the ink of others: darkness is the character's where its own ink is the nearest.
Grid<float> own_darkness(Grid<float> darkness, const Mask& own, const Mask& ink) {
    if (own == ink) return darkness;
    const Grid<int> nearest = nearest_seed(ink);
    for (std::size_t i = 0; i < darkness.size(); ++i)
        if (nearest.data()[i] < 0 || !own.data()[nearest.data()[i]]) darkness.data()[i] = 0;
    return darkness;
}

long area_of(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1); }

// Opaque pixels that are no strokes.
Mask filled_part(const Mask& opaque) {
    constexpr double widest_stroke = 0.02; // half of it, of the longer side
    const double radius = std::max(3.0, widest_stroke * std::max(opaque.width(), opaque.height()));
    return dilate_disc(open_disc(opaque, radius), 1.5);
}

// What lines close in is filled, a hole in a filled area is none of it: the border decides.
void fill_between_lines(Mask& cut_out, const Mask& closed, const Mask& filled) {
    constexpr double stroke_share = 0.3;
    Mask inside = closed;
    for (std::size_t i = 0; i < inside.size(); ++i) inside.data()[i] = closed.data()[i] && !cut_out.data()[i];
    const Components regions = connected_components(inside);
    std::vector<long> border(regions.list.size() + 1, 0), strokes = border;
    constexpr int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
    for (int y = 0; y < inside.height(); ++y)
        for (int x = 0; x < inside.width(); ++x) {
            if (!inside(x, y)) continue;
            const auto id = static_cast<std::size_t>(regions.ids(x, y));
            for (int k = 0; k < 4; ++k) {
                const int u = x + dx[k], v = y + dy[k];
                if (!cut_out.value_or(u, v, 0)) continue;
                ++border[id];
                strokes[id] += !filled(u, v);
            }
        }
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const auto id = static_cast<std::size_t>(regions.ids.data()[i]);
        if (id != 0 && static_cast<double>(strokes[id]) >= stroke_share * static_cast<double>(border[id]))
            cut_out.data()[i] = 1;
    }
}

// A figure that is largely filled with opaque pixels is its own silhouette; one of lines is a drawing without
// paper.
void keep_cut_out(DetectedCharacter& character, const Mask& opaque) {
    constexpr double filled_share = 0.3;
    Mask cut_out = at_working_size(opaque, character.scale, 0.5f);
    const Mask filled = filled_part(cut_out);
    if (static_cast<double>(area_of(filled)) < filled_share * static_cast<double>(area_of(character.mask)))
        return;
    fill_between_lines(cut_out, character.mask, filled);
    character.mask = std::move(cut_out);
    character.exact_mask = true;
}

// Share of the silhouette's border that lies within two pen widths of ink.
double inked_share(const Mask& silhouette, const Mask& ink) {
    const Mask near = dilate_disc(ink, 2 * pen_width(ink));
    int border = 0, inked = 0;
    for (int y = 0; y < silhouette.height(); ++y) {
        for (int x = 0; x < silhouette.width(); ++x) {
            if (!on_border(silhouette, x, y)) continue;
            ++border;
            inked += near(x, y);
        }
    }
    return border == 0 ? 0 : static_cast<double>(inked) / border;
}

// Left to right, then top to bottom, by box centre.
bool reads_before(const DetectedCharacter& a, const DetectedCharacter& b) {
    const int ax = 2 * a.box.x + a.box.width, bx = 2 * b.box.x + b.box.width;
    const int ay = 2 * a.box.y + a.box.height, by = 2 * b.box.y + b.box.height;
    return ax != bx ? ax < bx : ay < by;
}

// The groups to keep, largest boxes first.
std::vector<int> largest_groups(const Grouping& grouping, int count) {
    std::vector<int> order(grouping.boxes.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return grouping.boxes[a].area() > grouping.boxes[b].area(); });
    if (order.size() > static_cast<std::size_t>(count)) order.resize(static_cast<std::size_t>(count));
    return order;
}

// What the network finds on the page; nothing without one.
std::vector<CharacterFinder::Found> find_by_network(const RgbImage& page, const PageInk& page_ink,
                                                    const DetectionOptions& options,
                                                    const CharacterFinder* finder) {
    if (!finder) return {};
    const RgbImage inverse = page_ink.light_on_dark ? inverted(page) : RgbImage();
    return whole_characters(
        finder->find(page_ink.light_on_dark ? inverse : page, page_ink.darkness, options.threads), options);
}

Grouping group(const std::vector<CharacterFinder::Found>& found, const PageInk& page_ink, const Mask& ink,
               int factor, const DetectionOptions& options) {
    if (found.empty()) return group_ink(ink, options);
    Claims claims{CharacterFinder::claims(found, ink.width(), ink.height(), factor), {}};
    for (const CharacterFinder::Found& f : found) claims.scores.push_back(f.score);
    DetectionOptions rules = options;
    if (page_ink.cut_out) rules.shared_claim = 2; // cut out in one piece: one character
    return join_pieces(group_by_claims(ink, claims, rules), options);
}

// The network's box in page pixels, at least one a side, cut at the page's border.
Box box_of(const CharacterFinder::Found& found, const RgbImage& page) {
    const int left = std::clamp(static_cast<int>(std::floor(found.left)), 0, page.width() - 1);
    const int top = std::clamp(static_cast<int>(std::floor(found.top)), 0, page.height() - 1);
    const int right = std::clamp(static_cast<int>(std::ceil(found.right)), left + 1, page.width());
    const int bottom = std::clamp(static_cast<int>(std::ceil(found.bottom)), top + 1, page.height());
    return {left, top, right - left, bottom - top};
}

// The network's mask at working size: one half and more at the middle of the pixel (thesis 4.2, Fig. 4.7).
Mask network_mask(const CharacterFinder::Found& found, const Box& box, int width, int height) {
    Mask mask(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            mask(x, y) = found.probability(box.x + (x + 0.5) / width * box.width,
                                           box.y + (y + 0.5) / height * box.height) >= 0.5;
    return mask;
}

bool is_blank(const Mask& mask) { return area_of(mask) == 0; }

// One group of ink as a character, by its box, and the network's where it found it. Its mask may be blank.
DetectedCharacter make_character(const PageInk& page_ink, const Mask& own, const Box& box,
                                 const CharacterFinder::Found* found, const DetectionOptions& options) {
    DetectedCharacter character;
    character.box = box;
    character.scale = working_scale(box, options);
    const Mask ink = at_working_size(own, character.scale, 1.0f / 3);
    character.ink_mask = silhouette_of(ink);
    if (found) character.network_mask = network_mask(*found, box, ink.width(), ink.height());
    character.mask = character.ink_mask;
    if (options.mask == MaskSource::network && !is_blank(character.network_mask))
        character.mask = character.network_mask;
    else if (page_ink.cut_out)
        keep_cut_out(character, own);
    character.score = found ? found->score : inked_share(character.mask, ink);
    return character;
}

// Share of a character's silhouette that lies inside of another's.
double share_inside(const DetectedCharacter& part, const DetectedCharacter& whole) {
    long own = 0, inside = 0;
    for (int y = 0; y < part.mask.height(); ++y)
        for (int x = 0; x < part.mask.width(); ++x) {
            if (!part.mask(x, y)) continue;
            ++own;
            const double u = part.box.x + (x + 0.5) / part.mask.width() * part.box.width - whole.box.x,
                         v = part.box.y + (y + 0.5) / part.mask.height() * part.box.height - whole.box.y;
            inside += whole.mask.value_or(
                static_cast<int>(std::floor(u / whole.box.width * whole.mask.width())),
                static_cast<int>(std::floor(v / whole.box.height * whole.mask.height())), 0);
        }
    return own == 0 ? 0 : static_cast<double>(inside) / static_cast<double>(own);
}

// The ink of a silhouette that is known. The paper is what lies around it, whatever else the picture shows,
// and nothing outside of it is drawn.
Grid<float> darkness_near(const RgbImage& page, const PageInk& page_ink, const Mask& silhouette,
                          const Box& box) {
    constexpr double surroundings = 0.1; // of the box's longer side
    const int more = static_cast<int>(surroundings * std::max(box.width, box.height));
    const int left = std::max(0, box.x - more), top = std::max(0, box.y - more);
    const Box around{left, top, std::min(page.width(), box.x + box.width + more) - left,
                     std::min(page.height(), box.y + box.height + more) - top};
    const Box inner{box.x - left, box.y - top, box.width, box.height};
    Grid<float> darkness =
        page_ink.cut_out ? crop(page_ink.darkness, box) : crop(ink_darkness(crop(page, around)), inner);
    const Mask near =
        dilate_disc(crop(silhouette, box), std::max(2.0, 0.01 * std::max(box.width, box.height)));
    for (std::size_t i = 0; i < darkness.size(); ++i)
        if (!near.data()[i]) darkness.data()[i] = 0;
    return darkness;
}

// Eyes, buttons, a child's face: what lies inside a larger character is a part of it.
void drop_inside(std::vector<DetectedCharacter>& characters, double inside_share) {
    std::vector<char> inside(characters.size(), 0);
    for (std::size_t i = 0; i < characters.size(); ++i)
        inside[i] = std::any_of(characters.begin(), characters.end(), [&](const DetectedCharacter& whole) {
            return whole.box.area() > characters[i].box.area() &&
                   share_inside(characters[i], whole) >= inside_share;
        });
    std::vector<DetectedCharacter> kept;
    for (std::size_t i = 0; i < characters.size(); ++i)
        if (!inside[i]) kept.push_back(std::move(characters[i]));
    characters = std::move(kept);
}

} // namespace

Detection detect(const RgbImage& page, const PageInk& page_ink, const DetectionOptions& options,
                 const CharacterFinder* finder) {
    Detection result;
    result.width = page.width();
    result.height = page.height();
    result.ink = find_ink(page_ink, options);
    const int factor =
        (std::max(page.width(), page.height()) + options.grouping_size - 1) / options.grouping_size;
    const std::vector<CharacterFinder::Found> found = find_by_network(page, page_ink, options, finder);
    const Grouping grouping = group(found, page_ink, reduce(result.ink, factor), factor, options);
    for (int index : largest_groups(grouping, options.max_characters)) {
        const CharacterFinder::Found* by = grouping.detections.empty()
                                               ? nullptr
                                               : &found[static_cast<std::size_t>(grouping.detections[index])];
        const Box box = by && options.mask == MaskSource::network
                            ? page_box(box_of(*by, page), 1, page)
                            : page_box(grouping.boxes[index], factor, page);
        if (std::max(box.width, box.height) < options.min_side) continue;
        const Mask own = own_ink(result.ink, grouping, index + 1, factor, box);
        DetectedCharacter character = make_character(page_ink, own, box, by, options);
        if (is_blank(character.mask)) continue;
        character.drawing = crop(page, character.box);
        character.ink = ink_of_crop(
            own_darkness(crop(page_ink.darkness, character.box), own, crop(result.ink, character.box)));
        result.characters.push_back(std::move(character));
    }
    drop_inside(result.characters, options.inside_share);
    if (result.characters.empty()) throw Error(ErrorKind::no_character, "no character found on the page");
    std::stable_sort(result.characters.begin(), result.characters.end(), reads_before);
    return result;
}

Detection detect(const RgbImage& page, const DetectionOptions& options, const CharacterFinder* finder) {
    return detect(page, find_page_ink(page), options, finder);
}

DetectedCharacter character_of(const RgbImage& page, const PageInk& page_ink, const Mask& silhouette,
                               const DetectionOptions& options) {
    int left = page.width(), top = page.height(), right = 0, bottom = 0;
    for (int y = 0; y < silhouette.height(); ++y)
        for (int x = 0; x < silhouette.width(); ++x) {
            if (!silhouette(x, y)) continue;
            left = std::min(left, x), right = std::max(right, x + 1);
            top = std::min(top, y), bottom = std::max(bottom, y + 1);
        }
    if (left >= right) throw Error(ErrorKind::internal, "a silhouette without a pixel");
    DetectedCharacter character;
    character.box = page_box({left, top, right - left, bottom - top}, 1, page);
    character.scale = working_scale(character.box, options);
    character.score = 1;
    character.drawing = crop(page, character.box);
    character.ink = ink_of_crop(darkness_near(page, page_ink, silhouette, character.box));
    character.mask = at_working_size(crop(silhouette, character.box), character.scale, 0.5f);
    character.exact_mask = true;
    return character;
}

} // namespace pantin

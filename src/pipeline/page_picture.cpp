// SPDX-License-Identifier: MIT
// What of a picture's alpha is the figure, what is the paper, and which ground it stands on.
#include "pipeline/page_picture.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace pantin {

namespace {

constexpr Rgb8 light_ground{255, 255, 255};
constexpr int faintest_alpha = 8; // a picture that is nowhere more opaque is empty

constexpr double sheet_size = 0.3;      // of the picture is opaque when it is a sheet,
constexpr double sheet_solidity = 0.97; // its outline is convex,
constexpr double sheet_paper = 0.5;     // and most of it has one brightness
constexpr int paper_range = 10;         // levels to either side

// A picture that is half transparent everywhere is no less a picture: its largest alpha becomes 255.
RgbaImage with_full_alpha(RgbaImage image) {
    int most = 0;
    for (const Rgba8& p : image) most = std::max<int>(most, p.a);
    if (most == 255 || most < faintest_alpha) return image;
    for (Rgba8& p : image) p.a = static_cast<std::uint8_t>((p.a * 255 + most / 2) / most);
    return image;
}

RgbImage colours_of(const RgbaImage& picture) {
    RgbImage colours(picture.width(), picture.height());
    std::transform(picture.begin(), picture.end(), colours.begin(), [](Rgba8 p) {
        return Rgb8{p.r, p.g, p.b};
    });
    return colours;
}

// A transparent ground: most of the picture's border is.
bool has_transparent_border(const Mask& opaque) { return share_of_frame(opaque) < 0.5; }

// The luma that most opaque pixels have about them.
int commonest_luma(const GreyImage& luma, const Mask& opaque, double& share) {
    std::array<long, 256> histogram{};
    long all = 0;
    for (std::size_t i = 0; i < luma.size(); ++i)
        if (opaque.data()[i]) ++histogram[luma.data()[i]], ++all;
    long most = 0;
    int commonest = 255;
    for (int v = 0; v < 256; ++v) {
        long near = 0;
        for (int k = std::max(0, v - paper_range); k <= std::min(255, v + paper_range); ++k)
            near += histogram[static_cast<std::size_t>(k)];
        if (near > most) most = near, commonest = v;
    }
    share = all == 0 ? 0 : static_cast<double>(most) / static_cast<double>(all);
    return commonest;
}

// Pixels of the convex hull's rows and columns: between the first and the last opaque pixel of both.
bool is_solid(const Mask& opaque) {
    long area = 0, spanned = 0;
    for (int y = 0; y < opaque.height(); ++y) {
        int first = -1, last = -1;
        for (int x = 0; x < opaque.width(); ++x)
            if (opaque(x, y)) first = first < 0 ? x : first, last = x, ++area;
        if (first >= 0) spanned += last - first + 1;
    }
    if (static_cast<double>(area) < sheet_solidity * static_cast<double>(spanned)) return false;
    spanned = 0;
    for (int x = 0; x < opaque.width(); ++x) {
        int first = -1, last = -1;
        for (int y = 0; y < opaque.height(); ++y)
            if (opaque(x, y)) first = first < 0 ? y : first, last = y;
        if (first >= 0) spanned += last - first + 1;
    }
    return static_cast<double>(area) >= sheet_solidity * static_cast<double>(spanned) &&
           static_cast<double>(area) >= sheet_size * static_cast<double>(opaque.size());
}

// The mean colour of the opaque pixels that are about as bright as most.
Rgb8 paper_of(const RgbaImage& picture, const GreyImage& luma, const Mask& opaque, int commonest) {
    std::array<long, 3> sum{};
    long count = 0;
    for (std::size_t i = 0; i < luma.size(); ++i) {
        if (!opaque.data()[i] || std::abs(luma.data()[i] - commonest) > paper_range) continue;
        const Rgba8 p = picture.data()[i];
        sum[0] += p.r, sum[1] += p.g, sum[2] += p.b, ++count;
    }
    const auto mean = [&](long s) {
        return static_cast<std::uint8_t>((s + count / 2) / std::max(1L, count));
    };
    return {mean(sum[0]), mean(sum[1]), mean(sum[2])};
}

RgbImage on_ground(const RgbaImage& picture, const Mask& opaque, Rgb8 ground) {
    RgbImage image(picture.width(), picture.height(), ground);
    for (std::size_t i = 0; i < image.size(); ++i)
        if (const Rgba8 p = picture.data()[i]; opaque.data()[i]) image.data()[i] = {p.r, p.g, p.b};
    return image;
}

PagePicture on_paper(RgbImage picture, int rotate, bool flattens) {
    PagePicture page;
    if (flattens) page.sheet = find_sheet(picture);
    if (page.sheet) picture = flattened(picture, *page.sheet);
    page.picture = turned(std::move(picture), rotate);
    page.ink = find_page_ink(page.picture);
    return page;
}

} // namespace

PagePicture load_page_picture(const std::filesystem::path& file, int rotate, bool flattens) {
    RgbaImage loaded = with_full_alpha(load_rgba(file, min_image_side));
    Mask opaque = opaque_pixels(loaded);
    if (!has_transparent_border(opaque)) {
        RgbImage picture = composite_on_white(loaded);
        loaded = {}, opaque = {}; // 60 MB of a photograph
        return on_paper(std::move(picture), rotate, flattens);
    }

    const GreyImage luma = greyscale(colours_of(loaded));
    double share = 0;
    const int commonest = commonest_luma(luma, opaque, share);
    if (share >= sheet_paper && is_solid(opaque))
        return on_paper(on_ground(loaded, opaque, paper_of(loaded, luma, opaque, commonest)), rotate, false);

    return cut_out_picture(turned(loaded, rotate));
}

PagePicture cut_out_picture(const RgbaImage& figure) {
    const Mask opaque = opaque_pixels(figure);
    const GreyImage luma = greyscale(colours_of(figure));
    long pale_pixels = 0, all = 0;
    for (std::size_t i = 0; i < luma.size(); ++i)
        if (opaque.data()[i]) ++all, pale_pixels += luma.data()[i] >= pale;
    // Nine in ten: a pale figure with a dark outline shows on white.
    const Rgb8 ground = 10 * pale_pixels > 9 * all ? dark_ground : light_ground;
    PagePicture page;
    page.picture = on_ground(figure, opaque, ground);
    page.ink = find_cut_out_ink(figure);
    return page;
}

} // namespace pantin

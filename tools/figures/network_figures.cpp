// SPDX-License-Identifier: MIT
// Convolution and max pooling, computed by the layers that the networks are made of (thesis 3.1).
#include <algorithm>
#include <cmath>

#include "figures/figures.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "pantin/image.hpp"
#include "pantin/network.hpp"

namespace pantin::figures {
namespace {

using network::Tensor;

constexpr double cell = 34;

Tensor tensor_of(int height, int width, const std::vector<float>& values) {
    Tensor tensor(1, 1, height, width);
    std::copy(values.begin(), values.end(), tensor.begin());
    return tensor;
}

Tensor convolve(const Tensor& input, const std::vector<float>& weights) {
    const network::Convolution layer({1, 1, 3, 3, weights, {0}}, {});
    return layer.forward(input, network::Runtime());
}

// A window of cells in one colour.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;
    Rgb8 colour;
};

// A matrix as a table; returns its right side.
double draw_matrix(Svg& svg, Point2d at, const Tensor& matrix, const std::vector<Window>& windows) {
    for (const Window& w : windows)
        svg.rectangle({at.x + cell * w.x, at.y + cell * w.y, cell * w.width, cell * w.height},
                      filled(pale(w.colour)));
    for (int y = 0; y < matrix.height(); ++y)
        for (int x = 0; x < matrix.width(); ++x) {
            const Point2d corner{at.x + cell * x, at.y + cell * y};
            svg.rectangle({corner.x, corner.y, cell, cell}, stroked(muted, 0.8));
            svg.text({corner.x + cell / 2, corner.y + cell / 2 + 5}, shown(matrix(0, 0, y, x)));
        }
    for (const Window& w : windows)
        svg.rectangle({at.x + cell * w.x, at.y + cell * w.y, cell * w.width, cell * w.height},
                      stroked(w.colour, 2.5));
    return at.x + cell * matrix.width();
}

// input ∗ filter = output, with the window of output element (x, y).
void draw_step(Svg& svg, Point2d at, const Tensor& input, const Tensor& filter, const Tensor& output, int x,
               int y) {
    const double middle = at.y + cell * input.height() / 2;
    const auto beside = [&](double left, const Tensor& t) {
        return Point2d{left, middle - cell * t.height() / 2};
    };
    double right = draw_matrix(svg, at, input, {{x, y, 3, 3, second}});
    svg.text({right + 16, middle + 6}, "∗", {.size = 18});
    right = draw_matrix(svg, beside(right + 32, filter), filter, {});
    svg.text({right + 16, middle + 6}, "=", {.size = 18});
    draw_matrix(svg, beside(right + 32, output), output, {{x, y, 1, 1, accent}});
    // The sum that gives the element.
    std::string sum;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const float w = filter(0, 0, row, column), v = input(0, 0, y + row, x + column);
            if (w == 0) continue;
            sum += (w < 0         ? " − "
                    : sum.empty() ? ""
                                  : " + ") +
                   (std::abs(w) == 1 ? "" : shown(std::abs(w)) + "·") + shown(v);
        }
    svg.text({at.x, at.y + cell * input.height() + 20}, sum + " = " + shown(output(0, 0, y, x)),
             {.anchor = Anchor::start});
}

// Values as grey: 0 white, the largest absolute value black.
RgbImage response_picture(const Tensor& response) {
    float largest = 0;
    for (const float v : response) largest = std::max(largest, std::abs(v));
    RgbImage image(response.width(), response.height());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const float v = response(0, 0, y, x) / largest;
            image(x, y) = mixed(paper, v > 0 ? second : accent, std::min(1.0f, std::abs(v)));
        }
    return image;
}

Figure convolution_figure(Gallery& gallery) {
    const Tensor input =
        tensor_of(5, 5, {3, 3, 2, 1, 0, 0, 0, 1, 3, 1, 3, 1, 2, 2, 3, 2, 0, 0, 2, 2, 2, 0, 0, 0, 1});
    const std::vector<float> sobel_x = {1, 0, -1, 2, 0, -2, 1, 0, -1},
                             sobel_y = {1, 2, 1, 0, 0, 0, -1, -2, -1};
    const Tensor output = convolve(input, sobel_x);

    const RgbImage& page = gallery.page("humanoid.png");
    const Box box = gallery.detection("humanoid.png").characters.front().box;
    const Grid<float> whole = ink_darkness(page);
    const Grid<float> darkness = resize(crop(whole, box), box.width / 2, box.height / 2);
    const Tensor drawing = tensor_of(darkness.height(), darkness.width(), {darkness.begin(), darkness.end()});

    const double width = 940, top = 40, picture = 270;
    Svg svg(width, top + 5 * cell + 52 + picture + 40);
    svg.text({margin, 24},
             "(a) A filter of 3×3 (here the Sobel operator S_x, Eq. 3.6) slides over the input: first and "
             "last step",
             {.size = 14, .anchor = Anchor::start});
    draw_step(svg, {margin, top}, input, tensor_of(3, 3, sobel_x), output, 0, 0);
    draw_step(svg, {margin + 478, top}, input, tensor_of(3, 3, sobel_x), output, 2, 2);

    const double below = top + 5 * cell + 46;
    const auto show = [&](int column, const RgbImage& image, const std::string& caption) {
        Panel panel(svg, {margin + column * 312, below, 292, picture}, image.width(), image.height());
        panel.picture(image, image.width(), image.height());
        panel.border();
        panel.caption(caption);
    };
    RgbImage grey(darkness.width(), darkness.height());
    for (std::size_t i = 0; i < grey.size(); ++i) grey.data()[i] = mixed(paper, ink, darkness.data()[i]);
    show(0, grey, "(b) input: ink of a drawing");
    show(1, response_picture(convolve(drawing, sobel_x)), "(c) S_x answers to upright edges (blue +, red −)");
    show(2, response_picture(convolve(drawing, sobel_y)), "(d) S_y answers to level edges");
    return {"fig-3.2-convolution.svg", svg.document("Convolution: a filter slides over its input")};
}

Figure pooling_figure() {
    const Tensor input = tensor_of(4, 4, {1, 3, 2, 1, 4, 6, 5, 0, 3, 1, 9, 8, 2, 0, 7, 4});
    const Tensor output = network::max_pool(input, 2, 2);
    const Rgb8 colours[2][2] = {{second, accent}, {third, fourth}};
    std::vector<Window> in, out;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
            in.push_back({2 * x, 2 * y, 2, 2, colours[y][x]});
            out.push_back({x, y, 1, 1, colours[y][x]});
        }
    Svg svg(360, 206);
    const double right = draw_matrix(svg, {30, 24}, input, in);
    svg.arrow({right + 16, 24 + 2 * cell}, {right + 62, 24 + 2 * cell}, stroked(ink, 1.5));
    draw_matrix(svg, {right + 80, 24 + cell}, output, out);
    svg.text({180, 190}, "the largest value of every window of 2×2, stride 2");
    return {"fig-3.3-max-pooling.svg", svg.document("Max pooling with a window of 2 by 2 and stride 2")};
}

} // namespace

std::vector<Figure> network_figures(Gallery& gallery) {
    return {convolution_figure(gallery), pooling_figure()};
}

} // namespace pantin::figures

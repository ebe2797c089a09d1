// SPDX-License-Identifier: MIT
// Options that several subcommands take, to the settings of a run; exceptions to one line on stderr and an
// exit code.
#include "cli/command.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <thread>

#include <unistd.h>

#include "core/suggestion.hpp"
#include "export/film_formats.hpp"

namespace pantin::cli {

namespace {

bool bar_shown = false;

int hex_byte(const std::string& text, std::size_t at) {
    int value = -1;
    const char* begin = text.data() + at;
    const auto result = std::from_chars(begin, begin + 2, value, 16);
    return result.ptr == begin + 2 ? value : -1;
}

// transparent, white, black, #rrggbb or #rrggbbaa.
Rgba8 parse_colour(const std::string& text) {
    if (text == "transparent") return {0, 0, 0, 0};
    if (text == "white") return {255, 255, 255, 255};
    if (text == "black") return {0, 0, 0, 255};
    std::array<int, 4> values{0, 0, 0, 255};
    const bool shape = text.size() == 7 || text.size() == 9;
    bool valid = shape && text[0] == '#';
    for (std::size_t i = 0; valid && 1 + 2 * i < text.size(); ++i) {
        values[i] = hex_byte(text, 1 + 2 * i);
        valid = values[i] >= 0;
    }
    if (!valid)
        throw Error(ErrorKind::usage,
                    "--background: '" + text + "' is not transparent, white, black, #rrggbb or #rrggbbaa");
    return {static_cast<std::uint8_t>(values[0]), static_cast<std::uint8_t>(values[1]),
            static_cast<std::uint8_t>(values[2]), static_cast<std::uint8_t>(values[3])};
}

// 0 to 100, or lossless: none.
std::optional<int> parse_quality(const std::string& text) {
    if (text == "lossless") return std::nullopt;
    int value = -1;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data(), end, value).ptr != end || value < 0 || value > 100)
        throw Error(ErrorKind::usage, "--quality: '" + text +
                                          "' is neither lossless nor a number from 0 to 100" +
                                          did_you_mean(text, {"lossless"}));
    return value;
}

void check_formats(const std::vector<std::string>& formats) {
    std::vector<std::string> names;
    for (const FilmFormat& format : film_formats()) names.emplace_back(format.name);
    for (const std::string& name : formats) {
        const FilmFormat* format = film_format(name);
        if (!format)
            throw Error(ErrorKind::usage, "--format: '" + name + "' is not " + film_format_names(" or ") +
                                              did_you_mean(name, names));
        if (!is_available(*format))
            throw Error(ErrorKind::usage, "--format " + name + ": " + std::string(format->missing));
    }
}

} // namespace

void add_common_options(Command command, CommonOptions& options) {
    command
        .option("--preset", options.preset,
                "default (best results) or thesis (with its errata; differs in 15 places)")
        .show_default();
    command.option("--config", options.config, "JSON file that sets any option by its name");
    command
        .option("--weights", options.weights,
                "folder with the networks' weights (default: those compiled in)")
        .environment("PANTIN_WEIGHTS");
    command.option("--references", options.references, "folder with more reference skeletons");
    command
        .option("--threads", options.threads,
                "number of threads (default: all cores); results do not depend on it")
        .range(1, 256);
    command.flag("--trace", options.trace, "write intermediate products, too");
    command.flag("--quiet", options.quiet, "print errors only");
}

void add_detector_option(Command command, CommonOptions& options) {
    command.option("--detector", options.detector, "mask-rcnn (default) or contour")
        .one_of({"contour", "mask-rcnn"});
}

void add_rotate_option(Command command, CommonOptions& options) {
    command
        .option("--rotate", options.rotate,
                "turn the page clockwise first: 0, 90, 180 or 270; auto: as the drawing seems to be meant")
        .show_default()
        .one_of({"auto", "0", "90", "180", "270"});
}

void add_only_option(Command command, CommonOptions& options) {
    command
        .option("--only", options.only,
                "numbers of the characters to animate, as in page.png, e.g. 1,3 (default: all)")
        .separated_by(',');
}

void add_motion_options(Command command, CommonOptions& options) {
    command.flag("--blend", options.blend, "between two types: the clips of both, mixed by their confidence");
    command.option(
        "--motion", options.motion,
        "BVH file: people follow it as one more clip, of the file's name; quadrupeds and birds that "
        "of an animal of their kind");
    command.option(
        "--motion-map", options.motion_map,
        "JSON file that names the joints of --motion by hand: {\"left upper arm\": \"Bone7\", ...}");
    command.flag("--in-place", options.in_place, "the motion is followed in one place");
    command.flag("--follow", options.follow,
                 "the film goes along with the motion's way (what it does by itself with a long one)");
}

void add_animated_drawings_option(Command command, CommonOptions& options) {
    command.flag("--animated-drawings", options.animated_drawings,
                 "write humanoids as AnimatedDrawings character folders, too");
}

void add_override_options(Command command, Overrides& overrides) {
    command.option("--mask", overrides.mask,
                   "PNG of the page's size, white where the one character is: no detection");
    command.option("--labels", overrides.labels,
                   "PNG of the page's size with part labels 0 to " + std::to_string(label_count - 1) +
                       ": no segmentation");
    command.option("--reference", overrides.reference,
                   "what every character moves like, whatever identification says");
}

void add_render_options(Command command, RenderFlags& flags) {
    command.option("--clip", flags.clip, "a clip of the reference, or all").show_default();
    command.option("--fps", flags.fps, "frames per second, 1 to 100").show_default();
    command.option("--size", flags.size, "longer side of the frames in pixels")
        .range(16, 4096)
        .show_default();
    command
        .option("--format", flags.formats,
                film_format_names() + " (default: webp, and gif of the first clip)")
        .separated_by(',');
    command
        .option(
            "--quality", flags.quality,
            "of WebP films: lossless, or 0 (small) to 100 (nearly as drawn); transparency is kept as it is")
        .show_default();
    command.option("--background", flags.background, "transparent, white, black, #rrggbb or #rrggbbaa")
        .show_default();
    command.flag("--perspective", flags.perspective, "perspective camera instead of an orthographic one");
}

Settings make_settings(const CommonOptions& options, const RenderFlags& flags) {
    Settings settings;
    settings.options = make_preset(options.preset);
    if (!options.config.empty()) apply_config(settings.options, options.config);
    if (!options.config_text.empty()) apply_config_text(settings.options, options.config_text, "config");
    if (!options.detector.empty())
        settings.options.detection.detector =
            options.detector == "contour" ? Detector::contour : Detector::mask_rcnn;
    settings.weights = options.weights;
    settings.references = options.references;
    settings.motion = options.motion;
    settings.motion_map = options.motion_map;
    if (options.in_place && options.follow) throw Error(ErrorKind::usage, "--in-place excludes --follow");
    if (options.motion.empty() && !options.motion_map.empty())
        throw Error(ErrorKind::usage, "--motion-map goes with --motion");
    if (options.motion.empty() && (options.in_place || options.follow))
        throw Error(ErrorKind::usage, "--in-place and --follow go with --motion");
    if (options.in_place) settings.options.animation.motion_way = Way::in_place;
    if (options.follow) settings.options.animation.motion_way = Way::follow;
    settings.blend = options.blend;
    if (options.rotate != "auto") settings.rotate = std::stoi(options.rotate);
    settings.only = options.only;
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    settings.threads = options.threads > 0 ? options.threads : static_cast<int>(std::min(cores, 256u));
    settings.trace = options.trace;
    settings.animated_drawings = options.animated_drawings;
    check_formats(flags.formats);
    if (!(flags.fps >= 1 && flags.fps <= 100))
        throw Error(ErrorKind::usage, "--fps: must lie between 1 and 100");
    settings.render.clip = flags.clip;
    settings.render.fps = flags.fps;
    settings.render.formats = flags.formats;
    settings.render.quality = parse_quality(flags.quality);
    settings.render.scene = flags.scene;
    settings.render.picture.size = flags.size;
    settings.render.picture.perspective = flags.perspective;
    settings.render.picture.background = parse_colour(flags.background);
    if (!options.quiet && isatty(STDERR_FILENO)) settings.progress = show_progress;
    settings.notice = [options](const std::string& line) { print_result(options, line); };
    if (!options.quiet) settings.warning = print_warning;
    if (!options.quiet && !ilp_available() &&
        settings.options.identification.solver != GgdSolver::branch_and_bound)
        print_warning("this program was built without GLPK: branch and bound finds the graph distances");
    return settings;
}

void show_progress(const std::string& what, double share) {
    constexpr int width = 30;
    const int full = static_cast<int>(std::floor(std::max(0.0, share) * width));
    const std::string bar = std::string(static_cast<std::size_t>(full), '#') +
                            std::string(static_cast<std::size_t>(width - full), '.');
    if (share < 0)
        std::fprintf(stderr, "\r\033[K%s", what.c_str());
    else
        std::fprintf(stderr, "\r\033[K[%s] %3.0f %% %s", bar.c_str(), 100 * share, what.c_str());
    std::fflush(stderr);
    bar_shown = true;
}

void clear_progress() {
    if (bar_shown) std::fprintf(stderr, "\r\033[K");
    bar_shown = false;
}

void print_warning(const std::string& message) { print_error("warning: " + message); }

void print_error(const std::string& message) {
    clear_progress();
    std::string line = message;
    // File names and broken files may bring line feeds and control characters along.
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
    while (!line.empty() && line.back() == ' ') line.pop_back();
    std::fprintf(stderr, "pantin: %s\n", line.c_str());
}

void print_result(const CommonOptions& options, const std::string& line) {
    clear_progress();
    if (!options.quiet) std::printf("%s\n", line.c_str());
}

} // namespace pantin::cli

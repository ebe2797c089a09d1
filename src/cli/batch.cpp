// SPDX-License-Identifier: MIT
// pantin batch [-o DIR]: pages as lines of standard input, results as lines of standard output
// (docs/batch.md)
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

#include "cli/command.hpp"
#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "core/lines.hpp"
#include "core/suggestion.hpp"
#include "pipeline/batch.hpp"
#include "pipeline/context.hpp"

namespace pantin::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_line = 1 << 20; // bytes; a configuration with every option has 3000

// What a line may set, and the command line before it for all lines.
struct PageOptions {
    CommonOptions common;
    RenderFlags render;
    Overrides overrides;
    std::string image, out;
};

struct Arguments {
    PageOptions page; // `out` is the folder for pages that name none
    bool skip_done = false, seconds = false;
};

// --- a line ------------------------------------------------------------------------------------------------

// File names end at a zero byte, wherever the text does.
std::string text_of(const JsonReader& value) {
    const std::string text = value.text();
    if (text.find('\0') != std::string::npos) value.fail("holds a zero byte");
    return text;
}

std::string name_of(const JsonReader& value) {
    const std::string text = text_of(value);
    if (text.empty()) value.fail("must not be empty");
    return text;
}

std::string detector_of(const JsonReader& value) {
    const std::string text = value.text();
    if (text != "contour" && text != "mask-rcnn") value.fail("must be contour or mask-rcnn");
    return text;
}

std::string rotation_of(const JsonReader& value) {
    const long degrees = value.integer(0, 270);
    if (degrees % 90 != 0) value.fail("must be 0, 90, 180 or 270");
    return std::to_string(degrees);
}

std::vector<std::string> formats_of(const JsonReader& value) {
    std::vector<std::string> formats;
    for (const JsonReader& format : value.elements(1)) formats.push_back(format.text());
    return formats;
}

std::string quality_of(const JsonReader& value) {
    return value.value().is_string() ? value.text() : std::to_string(value.integer(0, 100));
}

// A file's name, or the configuration itself.
void set_config(CommonOptions& options, const JsonReader& value) {
    const bool inline_object = value.value().is_object();
    options.config = inline_object ? "" : text_of(value);
    options.config_text = inline_object ? to_compact_json_text(value.value()) : "";
}

using Set = void (*)(PageOptions&, const JsonReader&);

// The keys are the long options of `animate`, with _ for -; `formats` is a list.
std::vector<int> numbers_of(const JsonReader& reader) {
    std::vector<int> numbers;
    for (const JsonReader& number : reader.elements())
        numbers.push_back(static_cast<int>(number.integer(1, 64)));
    return numbers;
}

const std::map<std::string, Set>& keys() {
    static const std::map<std::string, Set> all = {
        {"image", [](PageOptions& o, const JsonReader& v) { o.image = name_of(v); }},
        {"out", [](PageOptions& o, const JsonReader& v) { o.out = name_of(v); }},
        {"mask", [](PageOptions& o, const JsonReader& v) { o.overrides.mask = text_of(v); }},
        {"labels", [](PageOptions& o, const JsonReader& v) { o.overrides.labels = text_of(v); }},
        {"reference", [](PageOptions& o, const JsonReader& v) { o.overrides.reference = text_of(v); }},
        {"preset", [](PageOptions& o, const JsonReader& v) { o.common.preset = text_of(v); }},
        {"config", [](PageOptions& o, const JsonReader& v) { set_config(o.common, v); }},
        {"detector", [](PageOptions& o, const JsonReader& v) { o.common.detector = detector_of(v); }},
        {"references", [](PageOptions& o, const JsonReader& v) { o.common.references = text_of(v); }},
        {"motion", [](PageOptions& o, const JsonReader& v) { o.common.motion = text_of(v); }},
        {"motion_map", [](PageOptions& o, const JsonReader& v) { o.common.motion_map = text_of(v); }},
        {"in_place", [](PageOptions& o, const JsonReader& v) { o.common.in_place = v.boolean(); }},
        {"follow", [](PageOptions& o, const JsonReader& v) { o.common.follow = v.boolean(); }},
        {"blend", [](PageOptions& o, const JsonReader& v) { o.common.blend = v.boolean(); }},
        {"rotate", [](PageOptions& o, const JsonReader& v) { o.common.rotate = rotation_of(v); }},
        {"only", [](PageOptions& o, const JsonReader& v) { o.common.only = numbers_of(v); }},
        {"trace", [](PageOptions& o, const JsonReader& v) { o.common.trace = v.boolean(); }},
        {"animated_drawings",
         [](PageOptions& o, const JsonReader& v) { o.common.animated_drawings = v.boolean(); }},
        {"clip", [](PageOptions& o, const JsonReader& v) { o.render.clip = text_of(v); }},
        {"fps", [](PageOptions& o, const JsonReader& v) { o.render.fps = v.number(1, 100); }},
        {"size",
         [](PageOptions& o, const JsonReader& v) { o.render.size = static_cast<int>(v.integer(16, 4096)); }},
        {"formats", [](PageOptions& o, const JsonReader& v) { o.render.formats = formats_of(v); }},
        {"quality", [](PageOptions& o, const JsonReader& v) { o.render.quality = quality_of(v); }},
        {"background", [](PageOptions& o, const JsonReader& v) { o.render.background = text_of(v); }},
        {"perspective", [](PageOptions& o, const JsonReader& v) { o.render.perspective = v.boolean(); }},
        {"scene", [](PageOptions& o, const JsonReader& v) { o.render.scene = v.boolean(); }},
    };
    return all;
}

std::string suggestion_for(const std::string& key) {
    std::vector<std::string> names;
    for (const auto& [name, set] : keys()) names.push_back(name);
    return did_you_mean(key, names);
}

void set_options(PageOptions& options, const JsonReader& line) {
    for (const auto& [key, value] : line.entries()) {
        const auto known = keys().find(key);
        if (known == keys().end()) value.fail("there is no such option" + suggestion_for(key));
        known->second(options, value);
    }
    if (options.image.empty()) line.fail("misses \"image\"");
}

void check_text(const Line& line) {
    if (line.too_long)
        throw Error(ErrorKind::input, "the line has more than " + std::to_string(longest_line) + " bytes");
    if (line.text.find('\0') != std::string::npos)
        throw Error(ErrorKind::input, "the line holds a zero byte");
    if (!is_utf8(line.text)) throw Error(ErrorKind::input, "the line is not UTF-8");
}

// A name, or an object with options. What the line does not say is as it was in `options`.
void read_line(PageOptions& options, const std::string& text) {
    if (text[text.find_first_not_of(" \t")] != '{') {
        options.image = text;
        return;
    }
    Json json;
    try {
        json = parse_json(text, "line");
    } catch (const Error&) {
        throw Error(ErrorKind::input, "the line is not valid JSON");
    }
    // So that a bad line can be told by its names, too.
    const auto name = [&](const char* key) {
        return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
    };
    options.image = name("image");
    options.out = name("out");
    try {
        set_options(options, JsonReader(json, "line"));
    } catch (const Error& error) {
        throw Error(ErrorKind::usage, error.what()); // as on a command line
    }
}

// --- all lines ---------------------------------------------------------------------------------------------

class Lines {
public:
    Lines(const Arguments& arguments, Networks& networks)
        : arguments_(arguments), networks_(networks), reader_(STDIN_FILENO, longest_line) {
        struct stat state {};
        const off_t at = ::lseek(STDIN_FILENO, 0, SEEK_CUR);
        if (at >= 0 && fstat(STDIN_FILENO, &state) == 0 && S_ISREG(state.st_mode) && state.st_size > at)
            size_ = static_cast<double>(state.st_size - at);
    }

    // The next page, or the failure of a line that is none; empty when there are no more lines.
    BatchTask next() {
        while (std::optional<Line> line = reader_.next()) {
            if (first_ && line->text.starts_with("\xEF\xBB\xBF"))
                line->text.erase(0, 3); // what Windows puts first
            first_ = false;
            if (line->text.find_first_not_of(" \t") != std::string::npos) return task_of(*line);
        }
        return {};
    }

private:
    BatchTask task_of(const Line& line) {
        PageOptions options = arguments_.page;
        options.out.clear();
        BatchResult result;
        result.share = size_ > 0 ? std::min(1.0, static_cast<double>(reader_.bytes()) / size_) : -1;
        try {
            check_text(line);
            const Settings settings = settings_of(options, line.text, result);
            return [this, options, settings, result]() mutable {
                run_batch_page(options.image, options.out, settings, arguments_.skip_done, networks_, result);
                return std::move(result);
            };
        } catch (...) {
            set_failure(result);
            return [result] { return result; };
        }
    }

    Settings settings_of(PageOptions& options, const std::string& text, BatchResult& result) {
        const auto name = [&] {
            if (!options.image.empty()) result.image = options.image;
            if (!options.out.empty()) result.out = options.out;
        };
        try {
            read_line(options, text);
        } catch (...) {
            name();
            throw;
        }
        if (options.out.empty()) options.out = folder_for(options.image);
        name();
        Settings settings = make_settings(options.common, options.render);
        settings.overrides = options.overrides;
        settings.threads = 1; // threads share out the pages
        settings.progress = nullptr;
        settings.notice = nullptr;
        settings.warning = nullptr;
        claim(options.out);
        return settings;
    }

    // As `animate` names them: the second picture of a name gets -2.
    std::string folder_for(const fs::path& image) {
        if (arguments_.page.out.empty())
            throw Error(ErrorKind::usage, "where to? The line has no \"out\", and there is no --output");
        // AnimatedDrawings folders may end with a slash.
        const std::string stem = (image.has_filename() ? image : image.parent_path()).stem().string();
        const int count = ++stems_[stem];
        return (fs::path(arguments_.page.out) / (count == 1 ? stem : stem + "-" + std::to_string(count)))
            .string();
    }

    // Two pages into one folder would mix, and the second would throw the first away.
    void claim(const std::string& out) {
        std::error_code error;
        fs::path whole = fs::weakly_canonical(fs::absolute(out), error);
        if (error) whole = fs::absolute(out).lexically_normal();
        if (!whole.has_filename()) whole = whole.parent_path();
        if (!claimed_.insert(whole.string()).second)
            throw Error(ErrorKind::usage, out + ": is the folder of an earlier line");
    }

    const Arguments& arguments_;
    Networks& networks_;
    LineReader reader_;
    double size_ = 0; // of the input in bytes; 0: unknown
    bool first_ = true;
    std::map<std::string, int> stems_; // how often
    std::set<std::string> claimed_;    // the folders so far
};

class Output {
public:
    Output(bool seconds, bool bar, bool quiet) : seconds_(seconds), bar_(bar), quiet_(quiet) {}

    // False when the reader has gone away.
    bool write(const BatchResult& result) {
        ++lines_;
        if (result.code != 0 && failed_++ == 0) {
            first_code_ = result.code;
            const std::string image = result.image.value_or("no image");
            first_failure_ = "number " + std::to_string(lines_) + " (" + image + "): " + result.status;
        }
        for (const BatchCharacter& character : result.characters) count(character);
        clear_progress();
        gone_ = !print(batch_line(result, seconds_) + "\n");
        if (gone_) return false;
        if (bar_) show_progress(counts(), result.share);
        return true;
    }

    // What the run ends with.
    int finish() const {
        clear_progress();
        if (marked_ > 0 && !gone_ && !quiet_) print_warning(warnings());
        if (failed_ > 0 && !gone_) print_error(counts() + ", first " + first_failure_);
        return first_code_;
    }

private:
    std::string counts() const {
        return std::to_string(lines_ - failed_) + " done" +
               (failed_ > 0 ? ", " + std::to_string(failed_) + " failed" : "");
    }
    void count(const BatchCharacter& character) {
        ++characters_;
        marked_ += !character.warnings.empty();
        for (const Warning& warning : character.warnings) ++warnings_[static_cast<std::size_t>(warning.kind)];
    }
    // "2 of 40 characters: lost_ink 1, unsure_type 1"
    std::string warnings() const {
        std::string text = std::to_string(marked_) + " of " + std::to_string(characters_) + " characters";
        const char* before = ": ";
        for (const WarningRow& row : warning_table) {
            const std::size_t n = warnings_[static_cast<std::size_t>(row.kind)];
            if (n > 0) text += std::exchange(before, ", ") + std::string(row.name) + " " + std::to_string(n);
        }
        return text;
    }
    bool print(const std::string& text) {
        errno = 0;
        const bool written =
            std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
        if (!written && errno != EPIPE) throw Error(ErrorKind::output, "standard output: cannot be written");
        return written;
    }

    bool seconds_, bar_, quiet_, gone_ = false;
    std::size_t lines_ = 0, failed_ = 0;
    std::size_t characters_ = 0, marked_ = 0; // with a warning
    std::array<std::size_t, warning_count> warnings_{};
    int first_code_ = 0;
    std::string first_failure_;
};

int run_batch(const Arguments& arguments) {
    // What is wrong for all lines is said once, before the first.
    Settings settings = make_settings(arguments.page.common, arguments.page.render);
    settings.overrides = arguments.page.overrides;
    settings.notice = nullptr;
    settings.warning = nullptr;
    Networks networks(settings.weights);
    Context(settings, networks).prepare();

    Lines lines(arguments, networks);
    Output output(arguments.seconds, static_cast<bool>(settings.progress), arguments.page.common.quiet);
    run_in_order(
        settings.threads, [&] { return lines.next(); },
        [&](const BatchResult& result) { return output.write(result); });
    return output.finish();
}

} // namespace

void add_batch(Command app) {
    const auto arguments = std::make_shared<Arguments>();
    PageOptions& page = arguments->page;
    Command command = app.subcommand(
        "batch",
        "many pages: file names or JSON Lines on standard input, one JSON line each on standard output");
    command.option("-o,--output", page.out,
                   "folder for the pages that name none: DIR/<name of the picture>/");
    command.flag("--skip-done", arguments->skip_done, "leave pages alone that a former run has finished");
    command.flag("--seconds", arguments->seconds, "add to each line how long it took");
    add_render_options(command, page.render);
    command.flag("--scene", page.render.scene, "the whole page comes alive, too");
    command.option("--reference", page.overrides.reference,
                   "what every character moves like, whatever identification says");
    add_motion_options(command, page.common);
    add_animated_drawings_option(command, page.common);
    add_rotate_option(command, page.common);
    add_detector_option(command, page.common);
    add_common_options(command, page.common);
    command.run([arguments] { return run_batch(*arguments); });
}

} // namespace pantin::cli

// SPDX-License-Identifier: MIT
// The walkthrough as one HTML file: chapters in the order of the steps, around the pictures of this run.
#include <array>
#include <vector>

#include "core/file.hpp"
#include "explain/chapters.hpp"
#include "explain/palette.hpp"
#include "explain/picture_size.hpp"
#include "explain/svg.hpp"
#include "formats/file_names.hpp"
#include "pantin/explain.hpp"
#include "pantin/version.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

struct Chapter {
    const char* name; // of its template, its widget and its place on the page
    const char* title;
    Values (*values)(const ChapterInput&);
    bool (*reached)(const Character&);
};

bool has_mask(const Character&) { return true; }
bool has_labels(const Character& c) { return c.reached >= Step::segment; }
bool has_skeleton(const Character& c) { return c.reached >= Step::skeletonize; }
bool has_voronoi(const Character& c) { return has_skeleton(c) && !c.skeletonization.voronoi.empty(); }
bool has_identification(const Character& c) { return c.reached >= Step::identify; }
bool has_rig(const Character& c) { return c.reached >= Step::rig; }

constexpr std::array<Chapter, 13> chapters = {
    {{"silhouette", "The silhouette", silhouette_chapter, has_mask},
     {"segment", "The parts", segment_chapter, has_labels},
     {"contour", "The border", contour_chapter, has_skeleton},
     {"voronoi", "The Voronoi diagram", voronoi_chapter, has_voronoi},
     {"thinning", "Thinning", thinning_chapter, has_skeleton},
     {"graph", "The skeleton graph", graph_chapter, has_skeleton},
     {"identify", "What it moves like", identify_chapter, has_identification},
     {"paths", "Paths between ends", paths_chapter, has_rig},
     {"assignment", "Which end is which", assignment_chapter, has_rig},
     {"mesh", "The mesh", mesh_chapter, has_rig},
     {"weights", "Bones and weights", weights_chapter, has_rig},
     {"motion", "The animation", motion_chapter, has_rig},
     {"solid", "Inflated to a solid", solid_chapter, has_rig}}};

// {{option x.y}}: the option and the value that this run took.
void add_options(Values& values, const Options& options) {
    for (const auto& [name, value] : list_options(options))
        values["option " + name] = "<code>" + name + " = " + escaped(value) + "</code>";
}

constexpr std::size_t most_solids =
    6; // a page with more characters has no solids: their meshes are the heaviest part of it

struct Text {
    std::string chapters, contents;
    bool solids = true;
};

void add_chapter(Text& text, const Chapter& chapter, const ChapterInput& input) {
    const std::string id = input.element(chapter.name);
    Values values;
    try {
        values = chapter.values(input);
    } catch (const Error& error) { // a solid that cannot be built, say: the other chapters do not need it
        text.chapters += "<article class=\"chapter\" id=\"" + id + "\"><h3>" + chapter.title +
                         "</h3><p>Not for this character: " + escaped(error.what()) + ".</p></article>";
        return;
    }
    add_options(values, input.context.options());
    values["id"] = id;
    values["folder"] = input.id;
    const auto data = values.find("data");
    text.contents += "<li><a href=\"#" + id + "\">" + chapter.title + "</a></li>";
    text.chapters += "<article class=\"chapter\" id=\"" + id + "\" data-widget=\"" + chapter.name +
                     "\" aria-labelledby=\"" + id + "-title\"><h3 id=\"" + id + "-title\">" + chapter.title +
                     "</h3>" + filled(asset("chapters/" + std::string(chapter.name) + ".html"), values) +
                     (data == values.end() ? ""
                                           : "<script type=\"application/json\" class=\"data\">" +
                                                 data->second + "</script>") +
                     "</article>\n";
}

// The drawing once, for all pictures over it.
std::string drawing_element(const ChapterInput& input) {
    return "<svg class=\"store\" aria-hidden=\"true\"><defs><image id=\"" + input.drawing() + "\" href=\"" +
           picture_uri(small_drawing(input.character)) + "\" x=\"-0.5\" y=\"-0.5\" width=\"" +
           std::to_string(input.width()) + "\" height=\"" + std::to_string(input.height()) +
           "\" preserveAspectRatio=\"none\"/></defs></svg>";
}

void add_character(Text& text, const ChapterInput& input) {
    const bool done = input.entry.status == "ok";
    text.contents += "<li><details" + std::string(text.chapters.empty() ? " open" : "") +
                     "><summary><a href=\"#" + input.id + "\">" + input.id + "</a></summary><ol>";
    text.chapters += "<section class=\"character\" id=\"" + input.id + "\"><h2>" + input.id + "</h2>" +
                     drawing_element(input) +
                     (done ? ""
                           : "<p class=\"stopped\">This character could not go on. " +
                                 escaped(input.entry.status) + ".</p>");
    for (const Chapter& chapter : chapters) {
        if (!chapter.reached(input.character) || (chapter.values == solid_chapter && !text.solids)) continue;
        input.context.progress(input.id + ": " + chapter.name);
        add_chapter(text, chapter, input);
    }
    if (!text.solids)
        text.chapters +=
            "<p>The page has many characters, so their solids are left out: <code>pantin model DIR/" +
            input.id + " --animate</code> makes this one's.</p>";
    text.contents += "</ol></details></li>";
    text.chapters += "</section>\n";
}

std::string scripts() {
    std::string text;
    for (const char* name : {"core", "voronoi", "thinning", "segment", "paths", "weights", "viewer", "start"})
        text += asset("js/" + std::string(name) + ".js");
    return "(() => {\n\"use strict\";\n" + text + "})();\n";
}

std::string page_text(const AnimatedPage& animated, Context& context) {
    Text text;
    text.solids = animated.characters.size() <= most_solids;
    Values page = page_chapter(animated);
    add_options(page, context.options());
    for (std::size_t i = 0; i < animated.characters.size(); ++i)
        add_character(text, {animated.page.characters[i].folder, animated.page.characters[i],
                             animated.characters[i], context});
    return filled(asset("page.html"), {{"source", escaped(animated.page.source)},
                                       {"style", label_styles() + std::string(asset("page.css"))},
                                       {"contents", text.contents},
                                       {"page", filled(asset("chapters/page.html"), page)},
                                       {"chapters", text.chapters},
                                       {"version", PANTIN_VERSION},
                                       {"three", std::string(asset("three.min.js"))},
                                       {"script", scripts()}});
}

} // namespace

Page explain(const fs::path& image, const fs::path& out, const Settings& wanted) {
    const Settings settings = settings_for(image, wanted);
    Networks networks(settings.weights);
    Context context(settings, networks);
    context.prepare();
    AnimatedPage animated = animate_page(image, out, context, true);
    write_file(out / file_names::walkthrough, page_text(animated, context));
    require_animated(image, animated.page);
    return std::move(animated.page);
}

} // namespace pantin

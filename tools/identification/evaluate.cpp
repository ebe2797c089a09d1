// SPDX-License-Identifier: MIT
// evaluate_identification [--references DIR] FOLDER...: steps 3 and 4 on the label maps FOLDER/label/<id>.png
// listed in FOLDER/index.csv (columns id, class, type; quality when there is one), and the end-effector
// mapping of what was found. Prints one line of tab-separated values per drawing, with a header line: what
// each form of the score decides, the divided distances, the traits, the evidence; fit_evidence.py fits and
// judges from it.
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <sstream>

#include "identification/traits.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "pantin/rigging.hpp"

namespace {

using namespace pantin;

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) {
        while (!cell.empty() && (cell.back() == '\r' || cell.back() == ' ')) cell.pop_back();
        cells.push_back(cell);
    }
    return cells;
}

std::vector<std::map<std::string, std::string>> read_index(const std::string& file) {
    std::ifstream stream(file);
    if (!stream) throw Error(ErrorKind::input, file + ": cannot be read");
    std::vector<std::map<std::string, std::string>> rows;
    std::vector<std::string> header;
    for (std::string line; std::getline(stream, line);) {
        const auto cells = split(line);
        if (header.empty()) {
            header = cells;
            continue;
        }
        rows.emplace_back();
        for (std::size_t i = 0; i < std::min(header.size(), cells.size()); ++i)
            rows.back()[header[i]] = cells[i];
    }
    return rows;
}

void print_areas(const LabelMap& labels) {
    for (int l = 1; l < label_count; ++l) {
        long area = 0;
        for (const auto v : labels) area += v == l;
        std::printf("\t%ld", area);
    }
}

// ends, pairs, pairs of one label, tail ends, tail ends on the tail; crossed pairs of limbs.
void print_mapping(const SkeletonGraph& graph, const Mapping& mapping, const ReferenceSkeleton& reference) {
    int same = 0, tails = 0, tails_met = 0;
    for (const EndPair& p : mapping.pairs) {
        const Label drawn = graph.vertices[p.end].label, model = reference.nodes[p.reference_end].label;
        same += drawn == model;
        tails += drawn == Label::tail;
        tails_met += drawn == Label::tail && model == Label::tail;
    }
    std::printf("\t%zu\t%zu\t%d\t%d\t%d", mapping.ends.size(), mapping.pairs.size(), same, tails, tails_met);
}

const ReferenceSkeleton& find(const std::vector<ReferenceSkeleton>& references, const std::string& name) {
    for (const ReferenceSkeleton& r : references)
        if (r.name == name) return r;
    throw Error(ErrorKind::internal, "no reference " + name);
}

double divided(const Identification& found, const std::string& reference) {
    for (const Candidate& c : found.candidates)
        if (c.reference == reference) return c.score;
    return 0;
}

void evaluate(const LabelMap& labels, const std::vector<ReferenceSkeleton>& references) {
    SkeletonizationOptions arc;
    arc.residual = Residual::arc;
    arc.recover_parts_share = 0;
    arc.cut_cycles = false;
    IdentificationOptions literal, plain;
    literal.thesis_score = true;
    literal.k_n_replaces = KnReading::k_v;
    literal.mirrored = Mirroring::none;
    plain.use_evidence = false;
    const Skeletonization skeleton = skeletonize(labels);
    const Identification found = identify(skeleton.graph, labels, references);
    const Identification thesis = identify(skeletonize(labels, arc).graph, labels, references, literal);
    const Identification ratio = identify(skeleton.graph, labels, references, plain);
    std::printf("\t%s\t%s\t%s\t%s\t%.4f", thesis.reference.c_str(), ratio.reference.c_str(),
                found.type.c_str(), found.reference.c_str(), found.confidence);
    for (const char* type : {"humanoid", "quadruped", "flying"}) std::printf("\t%.6f", divided(ratio, type));
    for (const double t : measure_traits(skeleton.graph, labels)) std::printf("\t%.6f", t);
    const ReferenceSkeleton& best = find(references, found.reference);
    for (const bool aware : {false, true}) {
        MappingOptions options;
        options.label_aware = aware;
        options.length_in_pixels = !aware;
        print_mapping(skeleton.graph,
                      map_end_effectors(skeleton.graph, labels, best, found.candidates[0], options), best);
    }
}

void print_header() {
    std::printf("folder\tid\tclass\ttype\tquality");
    for (const Label part : part_labels) std::printf("\t%s", std::string(name_of(part)).c_str());
    std::printf("\tstatus\tthesis\tratio\tfound"
                "\treference\tconfidence"
                "\tggd_humanoid\tggd_quadruped\tggd_flying");
    for (const auto name : trait_names) std::printf("\t%s", std::string(name).c_str());
    for (const char* form : {"plain", "aware"})
        std::printf("\t%s_ends\t%s_pairs\t%s_same\t%s_tails\t%s_tails_met", form, form, form, form, form);
    std::printf("\n");
}

void evaluate_folder(const std::string& folder, const std::vector<ReferenceSkeleton>& references) {
    for (auto& row : read_index(folder + "/index.csv")) {
        LabelMap labels;
        try {
            labels = load_grey(folder + "/label/" + row["id"] + ".png");
        } catch (const Error&) {
            continue; // no honest silhouette
        }
        std::printf("%s\t%s\t%s\t%s\t%s", folder.c_str(), row["id"].c_str(), row["class"].c_str(),
                    row["type"].c_str(), row.count("quality") ? row["quality"].c_str() : "3");
        print_areas(labels);
        try {
            std::printf("\tok");
            evaluate(labels, references);
        } catch (const CharacterRejected& rejected) {
            std::printf("!%s: %s", rejected.step().c_str(), rejected.what());
        }
        std::printf("\n");
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        const bool own = argc > 2 && std::string(argv[1]) == "--references";
        const auto references = load_references(own ? argv[2] : "");
        print_header();
        for (int i = own ? 3 : 1; i < argc; ++i) evaluate_folder(argv[i], references);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "evaluate_identification: %s\n", error.what());
        return 1;
    }
}

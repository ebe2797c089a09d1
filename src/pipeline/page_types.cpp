// SPDX-License-Identifier: MIT
// An identification in, the entry of page.json out: what the character moves like, how sure that is, and what
// it could be else (thesis 4.5).
#include "pipeline/page_types.hpp"

#include <algorithm>

#include "core/math.hpp"
#include "formats/file_names.hpp"
#include "formats/page_file.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// The candidates that stand on their own, from best to worst: their confidences add up to 1.
std::vector<Candidate> independent_candidates(const Identification& identification,
                                              const std::vector<ReferenceSkeleton>& references) {
    std::vector<Candidate> independent;
    std::copy_if(identification.candidates.begin(), identification.candidates.end(),
                 std::back_inserter(independent), [&](const Candidate& candidate) {
                     return find_reference(references, candidate.reference).like.empty();
                 });
    return independent;
}

// The best candidate of another type than the chosen one.
std::optional<TypeGuess> second_choice(const Identification& identification,
                                       const std::vector<ReferenceSkeleton>& references) {
    const std::vector<Candidate> independent = independent_candidates(identification, references);
    const ReferenceSkeleton& chosen = find_reference(references, identification.reference);
    std::string own = chosen.like.empty() ? chosen.name : chosen.like;
    if (own == "any" && !independent.empty()) own = independent.front().reference;
    const auto second = std::find_if(independent.begin(), independent.end(),
                                     [&](const Candidate& c) { return c.reference != own; });
    if (second == independent.end()) return std::nullopt;
    double sum = 0;
    for (const Candidate& c : independent) sum += math::exp(second->score - c.score);
    return TypeGuess{second->reference, 1 / sum};
}

} // namespace

void set_type(PageCharacter& entry, const Identification& identification,
              const std::vector<ReferenceSkeleton>& references) {
    entry.found = TypeGuess{identification.reference, identification.confidence};
    entry.second = second_choice(identification, references);
}

void update_type(const fs::path& folder, const Identification& identification,
                 const std::vector<ReferenceSkeleton>& references) {
    std::error_code error;
    const fs::path whole = fs::canonical(folder, error), file = whole.parent_path() / file_names::page;
    if (error || !fs::exists(file, error)) return;
    Page page = read_page(file);
    for (PageCharacter& entry : page.characters)
        if (entry.folder == whole.filename()) set_type(entry, identification, references);
    write_page(whole.parent_path(), page);
}

} // namespace pantin

// SPDX-License-Identifier: MIT
// Names in, bytes of compiled-in files out; the table is made by tools/embed.sh (own).
#include "core/resources.hpp"

extern "C" {
struct PantinResource {
    const char* name;
    const unsigned char* begin;
    const unsigned char* end;
};
extern const PantinResource pantin_resources[]; // closed by a null name
}

namespace pantin {

std::vector<Resource> resources() {
    std::vector<Resource> all;
    for (const PantinResource* r = pantin_resources; r->name; ++r)
        all.push_back({r->name, {r->begin, r->end}});
    return all;
}

std::span<const unsigned char> find_resource(std::string_view name) {
    for (const PantinResource* r = pantin_resources; r->name; ++r)
        if (name == r->name) return {r->begin, r->end};
    return {};
}

} // namespace pantin

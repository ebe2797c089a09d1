// SPDX-License-Identifier: MIT
// In come the mesh, the owner of every pixel and the limbs; out goes the mesh, cut where parts touch that are
// far apart along the skeleton (thesis 6.3, Fig. 6.9, names the problem; ERRATA 22). The cut is our own.
#include "rigging/cut.hpp"

#include <algorithm>
#include <map>

#include "image/nearest_pixel.hpp"

namespace pantin {
namespace {

constexpr double welded = 0.4; // a limb with this contact share lies on its parent all along

// Up to this position a limb is one piece with its surroundings: the region around the attachment, where the
// border of the labels may run aslant. Broad parts (wings) have a long one.
double attachment_region(const Limb& limb, double cell) {
    const double by_width = 0.75 * limb.width + 2 * cell;
    return limb.label == Label::wing ? std::max(by_width, 0.5 * limb.length()) : by_width;
}

// Heads, and limbs drawn onto their parent, stay in one piece with it.
bool beyond_attachment(const Owner& owner, const Limb& limb, double cell) {
    return limb.label != Label::head && limb.contact < welded &&
           owner.position > attachment_region(limb, cell);
}

Mesh without_unused(Mesh mesh, std::vector<Owner>& owners) {
    std::vector<int> place(mesh.vertices.size(), -1);
    Mesh result;
    std::vector<Owner> kept;
    for (const std::vector<int>& face : mesh.faces)
        for (int v : face) place[v] = 0;
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (place[v] < 0) continue;
        place[v] = static_cast<int>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[v]);
        kept.push_back(owners[v]);
    }
    for (std::vector<int>& face : mesh.faces)
        for (int& v : face) v = place[v];
    result.faces = std::move(mesh.faces);
    result.cases = std::move(mesh.cases);
    owners = std::move(kept);
    return result;
}

} // namespace

std::vector<Owner> vertex_owners(const Mesh& mesh, const Grid<Owner>& pixels) {
    std::vector<Owner> owners;
    for (const Point2d& p : mesh.vertices) owners.push_back(at_nearest(pixels, p));
    return owners;
}

bool far_apart(const Owner& a, const Owner& b, const Limbs& limbs, double cell) {
    if (a.limb == b.limb) return false;
    if (a.limb < 0) return far_apart(b, a, limbs, cell);
    const Limb& limb = limbs.limbs[a.limb];
    if (b.limb < 0) return beyond_attachment(a, limb, cell); // the body
    const Limb& other = limbs.limbs[b.limb];
    if (limb.parent == b.limb) return beyond_attachment(a, limb, cell);
    if (other.parent == a.limb) return beyond_attachment(b, other, cell);
    if (limb.label == Label::head)
        return beyond_attachment(b, other, cell); // the head is as rigid as the body
    if (other.label == Label::head) return beyond_attachment(a, limb, cell);
    return a.position + b.position > std::max(attachment_region(limb, cell), attachment_region(other, cell));
}

int cut_touching_parts(Mesh& mesh, std::vector<Owner>& owners, const Grid<Owner>& pixels, const Limbs& limbs,
                       double cell) {
    int changed = 0;
    std::map<std::pair<int, int>, int> doubles; // (vertex, limb) → its copy on that limb's side
    for (std::vector<int>& face : mesh.faces) {
        bool conflict = false;
        Point2d middle{};
        for (std::size_t i = 0; i < face.size(); ++i) {
            middle = middle + (1.0 / static_cast<double>(face.size())) * mesh.vertices[face[i]];
            for (std::size_t j = 0; j < i; ++j)
                conflict |= far_apart(owners[face[i]], owners[face[j]], limbs, cell);
        }
        if (!conflict) continue;
        ++changed;
        const Owner side = at_nearest(pixels, middle);
        for (int& v : face) {
            if (!far_apart(owners[v], side, limbs, cell)) continue;
            const auto [it, is_new] =
                doubles.try_emplace({v, side.limb}, static_cast<int>(mesh.vertices.size()));
            if (is_new) {
                mesh.vertices.push_back(Point2d(mesh.vertices[v]));
                owners.push_back(side);
            }
            v = it->second;
        }
    }
    if (changed > 0) mesh = without_unused(std::move(mesh), owners);
    return changed;
}

} // namespace pantin

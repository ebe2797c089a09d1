// SPDX-License-Identifier: MIT
// What holds for each of the nine models of testdata/models.
#include <catch2/catch.hpp>

#include "modeling/solids.hpp"
#include "pantin/model_view.hpp"

using namespace pantin;

TEST_CASE("each of the nine models is one closed, oriented surface that does not cut itself",
          "[needs-pugixml]") {
    for (const std::string& name : test::model_names) {
        CAPTURE(name);
        Model model(test::model_strokes(name));
        const SolidMesh mesh = model.united();
        CHECK(test::surface_fault(mesh) == "");
        CHECK(test::components_of(mesh) == 1);
        CHECK(test::self_cuts(mesh) == 0);
        double sum = 0;
        for (int p = 0; p < std::ssize(model.parts()); ++p) sum += test::volume_of(model.surface(p));
        CHECK(test::volume_of(mesh) > 0);
        CHECK(test::volume_of(mesh) < sum);
        REQUIRE(mesh.parts.size() == mesh.vertices.size());
        for (const int part : mesh.parts) REQUIRE((part >= 0 && part < std::ssize(model.parts())));
    }
}

TEST_CASE("each of the nine models is one tree inside its solid", "[needs-pugixml]") {
    for (const std::string& name : test::model_names) {
        CAPTURE(name);
        Model model(test::model_strokes(name));
        const auto& joints = model.skeleton().joints;
        REQUIRE(!joints.empty());
        for (std::size_t j = 0; j < joints.size(); ++j) {
            CHECK((joints[j].parent < 0) == (j == 0));
            CHECK(joints[j].parent < static_cast<int>(j));
            CHECK(joints[j].radius > 0);
        }
        for (std::size_t p = 0; p < model.parts().size(); ++p) {
            CHECK(model.parts()[p].parent < static_cast<int>(p));
            CHECK((model.parts()[p].parent < 0) == (p == 0));
            CHECK(
                (model.parts()[p].mirrored ? model.parts()[p - 1].stroke.symmetry != Symmetry::none : true));
        }
        const SolidMesh mesh = model.united();
        std::vector<SolidMesh> own;
        for (int p = 0; p < std::ssize(model.parts()); ++p) own.push_back(model.surface(p));
        int outside = 0, outside_own = 0;
        for (const auto& joint : joints) {
            outside_own += !test::holds(own[joint.part], joint.place);
            outside += !test::holds(mesh, joint.place);
        }
        CHECK(outside_own == 0);
        CHECK(outside == 0);
    }
}

TEST_CASE("each of the nine models has weights of known bones, from 0 to 1, that sum to 1",
          "[needs-pugixml]") {
    for (const std::string& name : test::model_names) {
        CAPTURE(name);
        Model model(test::model_strokes(name));
        const SolidMesh mesh = model.united();
        const Rig rig = model_rig(model, mesh, view_of(model, mesh));
        REQUIRE(rig.weights.size() == rig.mesh.vertices.size());
        int wrong = 0;
        for (const VertexWeights& w : rig.weights) {
            double sum = 0;
            for (int k = 0; k < 4; ++k) {
                wrong += !(w.weights[k] >= 0 && w.weights[k] <= 1);
                wrong += w.bones[k] < 0 || w.bones[k] >= std::ssize(rig.bones);
                sum += w.weights[k];
            }
            wrong += sum != 1;
        }
        CHECK(wrong == 0);
    }
}

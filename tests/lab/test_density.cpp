#include "lab/density.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "cloth/model.h"

using namespace drape;

TEST_CASE("a graded strip is one sheet without cracks", "[lab]") {
    const Mesh mesh = graded_strip(4);
    const Topology topology = build_topology(mesh.faces, mesh.vertices());
    CHECK(topology.components == 1);
    CHECK(topology.boundary_loops.size() == 1);
    CHECK(topology.non_manifold_edges == 0);
    // 4 x 4 coarse squares of which 4 are cut in three, and 8 x 8 fine ones
    CHECK(mesh.triangles() == 3 * 4 * 2 + 4 * 3 + 8 * 8 * 2);
    // all the same way up
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Vec3 a = mesh.rest.col(mesh.faces(0, f));
        const Vec3 up =
            (mesh.rest.col(mesh.faces(1, f)) - a).cross(Vec3(mesh.rest.col(mesh.faces(2, f)) - a));
        CHECK(up.y() > 0);
    }
}

TEST_CASE("with one force per strain the finer half is twice as strong", "[lab]") {
    const StripPull pull = pull_strip(density_laws()[0], 16);
    REQUIRE(pull.law == "force_per_strain");
    CHECK(pull.ratio() == Approx(2).epsilon(0.05));
}

TEST_CASE("a modulus makes both halves as strong within a twentieth", "[lab]") {
    for (const Law& law : density_laws()) {
        if (law.fabric.stretch_model != StretchModel::membrane) continue;
        for (const int rows : {8, 16}) {
            CAPTURE(law.name, rows);
            CHECK(pull_strip(law, rows).ratio() == Approx(1).epsilon(0.05));
        }
    }
}

TEST_CASE("both halves together strain as the strip does", "[lab]") {
    for (const Law& law : density_laws()) {
        const StripPull pull = pull_strip(law, 8);
        double sum = 0;
        for (const double strain : pull.strain) sum += strain;
        CAPTURE(law.name);
        CHECK(sum / static_cast<double>(pull.strain.size()) == Approx(1).epsilon(1e-6));
    }
}

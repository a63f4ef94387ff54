// Where an earlier run was curved: from a mesh file alone, and with a cache of its positions.
#include "scene/curved_places.h"

#include <catch2/catch.hpp>

#include "io/cache_writer.h"
#include "io/write_mesh.h"
#include "mesh/pattern.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;

TEST_CASE("a pattern is finer where a run's cache or mesh was ever curved", "[scene]") {
    const TemporaryFolder folder;
    const std::string flat = folder.file("flat.obj"), bent = folder.file("bent.obj"),
                      cache = folder.file("run.pc2");
    const Mesh sheet = make_pattern("alternating", {1, 1, 20, 20});
    Mesh curved = sheet;
    // a roll of 5 cm along the sheet's left end
    for (int v = 0; v < curved.vertices(); ++v) {
        const double x = sheet.rest(0, v) + 0.3, radius = 0.1;
        if (x < 0)
            curved.rest.col(v) = Vec3(-0.3 + radius * std::sin(x / radius),
                                      radius * (1 - std::cos(x / radius)), sheet.rest(2, v));
    }
    write_mesh(flat, sheet);
    write_mesh(bent, curved);
    {
        const auto writer = make_cache_writer(cache, sheet, 30, 3);
        for (const Points& x : {sheet.rest, curved.rest, sheet.rest}) writer->add(x);
        writer->finish();
    }
    for (const auto& [mesh, positions] : {std::pair{bent, std::string()}, {flat, cache}, {flat, bent}}) {
        CAPTURE(mesh, positions);
        PatternSize size{1, 1, 20, 20};
        size.finer.curved = curved_places(mesh, positions);
        REQUIRE(size.finer.curved.size() == 441);
        size.finer.finest = 0.01;
        const SizeField edge = finer_field(size.finer, 0.05, {-0.5, -0.5}, {0.5, 0.5});
        CHECK(edge({-0.4, 0}) == Approx(0.1 * size.finer.turn).epsilon(0.2));
        CHECK(edge({0.3, 0}) == Approx(0.05));
        CHECK(make_pattern("adaptive", size).vertices() > 600);
    }
    CHECK(error_of([&] { curved_places(flat, folder.file("none.pc2")); }).find("none.pc2") !=
          std::string::npos);
    const Mesh other = make_pattern("alternating", {1, 1, 3, 3});
    write_mesh(folder.file("other.obj"), other);
    CHECK_THAT(error_of([&] { curved_places(flat, folder.file("other.obj")); }),
               Catch::Contains("has 16 vertices") && Catch::Contains("has 441"));
    Mesh bare = sheet;
    bare.drawn.uv.resize(2, 0);
    write_mesh(folder.file("bare.obj"), bare);
    CHECK_THAT(error_of([&] { curved_places(folder.file("bare.obj"), ""); }), Catch::Contains("has no UVs"));
}

#include "io/write_mesh.h"

#include <catch2/catch.hpp>

#include "io/load_mesh.h"
#include "mesh/pattern.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;

TEST_CASE("an OBJ reads as one: vertices, UVs, triangles counted from 1", "[io]") {
    Mesh mesh = two_triangles();
    CHECK(mesh_file("a.obj", mesh, mesh.rest) ==
          "# written by drape; metres, y up\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    mesh.drawn.uv.resize(2, 4);
    mesh.drawn.uv << 0, 1, 1, 0, 0, 0, 1, 0.25F;
    const std::string text = mesh_file("a.OBJ", mesh, mesh.rest);
    CHECK(text.find("vt 0 0.25\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n") != std::string::npos);
}

TEST_CASE("a generated mesh comes back from an OBJ with every bit of its positions and UVs", "[io]") {
    const TemporaryFolder folder;
    const Mesh mesh = make_pattern("alternating", {1, 0.7, 13, 7});
    write_mesh(folder.file("a.obj"), mesh);
    const Mesh back = load_mesh(folder.file("a.obj")).mesh;
    CHECK(in_file_order(back, back.rest) == mesh.rest);
    REQUIRE(back.drawn.uv.cols() == mesh.drawn.uv.cols());
    for (int i = 0; i < mesh.vertices(); ++i)
        CHECK((back.drawn.uv.col(back.file_vertex[static_cast<size_t>(i)]) - mesh.drawn.uv.col(i)).norm() <
              1e-6F);
}

TEST_CASE("a mesh can be written as OBJ and PLY only", "[io]") {
    const Mesh mesh = two_triangles();
    CHECK(error_of([&] { write_mesh("a.fbx", mesh); }) ==
          "a.fbx: cannot write a mesh as \".fbx\" (known: .obj, .ply)");
}

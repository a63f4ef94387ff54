#include "io/load_mesh.h"

#include <catch2/catch.hpp>
#include <cstdint>

#include "io/write_mesh.h"
#include "mesh/quality.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;

namespace {

const std::string meshes = DRAPE_SOURCE_DIR "/assets/meshes/";

Vec3 size_of(const Mesh& mesh) {
    return mesh.rest.rowwise().maxCoeff() - mesh.rest.rowwise().minCoeff();
}

// The Error for a file with these bytes, without the folder's name.
std::string refusal(const std::string& name, const std::string& bytes) {
    const TemporaryFolder folder;
    const std::string path = folder.file(name, bytes), message = error_of([&] { load_mesh(path); });
    INFO(message);
    REQUIRE(message.starts_with(path));
    CHECK(message.find('\n') == std::string::npos);
    return message.substr(path.size());
}

LoadedMesh load_text(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    return load_mesh(folder.file(name, text));
}

const std::string triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string ply_with(const std::string& vertices, const std::string& face) {
    return triangle_ply + vertices + face;
}

}  // namespace

TEST_CASE("the four meshes in assets load whole, in metres, y up", "[io]") {
    struct Expected {
        const char* file;
        int file_vertices, vertices, triangles, pieces, borders;
        Vec3 size;
    };
    const Expected expected[] = {
        {"tablecloth_round.obj", 3840, 3840, 7582, 1, 1, {1.6, 0, 1.6}},
        {"skirt_cm_zup.fbx", 7320, 7320, 14400, 1, 2, {1.0, 0.6, 1.0}},
        {"two_panels.glb", 5602, 4802, 9216, 2, 2, {2.1, 1.2, 0}},
        {"cape.ply", 4131, 4131, 8000, 1, 1, {2.015, 0, 1.001}},
    };
    for (const Expected& e : expected) {
        CAPTURE(e.file);
        const LoadedMesh loaded = load_mesh(meshes + e.file);
        const Mesh& mesh = loaded.mesh;
        CHECK(static_cast<int>(mesh.file_vertex.size()) == e.file_vertices);
        CHECK(mesh.vertices() == e.vertices);
        CHECK(mesh.triangles() == e.triangles);
        CHECK(loaded.dropped_zero_area == 0);
        CHECK(loaded.unused_vertices == 0);
        CHECK((size_of(mesh) - e.size).norm() < 1e-3);
        const MeshQuality quality = measure_quality(mesh, build_topology(mesh.faces, mesh.vertices()));
        CHECK(quality.components == e.pieces);
        CHECK(quality.boundary_loops == e.borders);
        CHECK(quality.non_manifold_edges == 0);
    }
}

TEST_CASE("the skirt hangs: its narrow waist is above its wide hem, and its seam keeps two UVs", "[io]") {
    const LoadedMesh loaded = load_mesh(meshes + "skirt_cm_zup.fbx");
    const Mesh& mesh = loaded.mesh;
    CHECK(mesh.rest.row(1).minCoeff() == Approx(0.4).margin(1e-3));
    CHECK(mesh.rest.row(1).maxCoeff() == Approx(1.0).margin(1e-3));
    const Vec3 axis(0.1, 0, 0);
    for (int v = 0; v < mesh.vertices(); ++v) {
        const double out = std::hypot(mesh.rest(0, v) - axis.x(), mesh.rest(2, v));
        if (mesh.rest(1, v) > 0.999) CHECK(out < 0.17);
        if (mesh.rest(1, v) < 0.401) CHECK(out > 0.45);
    }
    CHECK(mesh.drawn.uv.cols() > mesh.vertices());
    CHECK(loaded.notes.size() == 2);
}

TEST_CASE("a mesh at two nodes is there twice, each with its node's transform", "[io]") {
    const Mesh mesh = load_mesh(meshes + "two_panels.glb").mesh;
    int left = 0;
    for (int v = 0; v < mesh.vertices(); ++v) left += mesh.rest(0, v) < 0;
    CHECK(left == mesh.vertices() / 2);
    CHECK(mesh.rest.row(0).minCoeff() == Approx(-1.1).margin(1e-6));
    CHECK(mesh.rest.row(0).maxCoeff() == Approx(1.0).margin(1e-6));
}

TEST_CASE("an OBJ's vertices keep their order, their digits and their strange spellings", "[io]") {
    const LoadedMesh loaded =
        load_text("strange.OBJ",
                  "# a comment\r\nv .5 1 0\r\nv +1.5 1e0 -.25 # here\r\nv 9 9 9\r\n"
                  "v 0.1234567890123 \\\r\n 2. 0\r\nvt 0 0\r\nl 1 2\r\nf -4/1 -3//7 4/1/1\r\n");
    const Points file = in_file_order(loaded.mesh, loaded.mesh.rest);
    CHECK(file == points_of({{0.5, 1, 0}, {1.5, 1, -0.25}, {9, 9, 9}, {0.1234567890123, 2, 0}}));
    CHECK(loaded.mesh.file_vertex[2] == -1);
    CHECK(loaded.unused_vertices == 1);
    CHECK(loaded.dropped_points_lines == 1);
    CHECK(loaded.mesh.triangles() == 1);
}

TEST_CASE("polygons are cut into triangles that cover them, also where they are not convex", "[io]") {
    const Mesh arrow = load_text("arrow.obj", "v 0 0 0\nv 2 -1 0\nv 0 2 0\nv -2 -1 0\nf 1 2 3 4\n").mesh;
    CHECK(arrow.triangles() == 2);
    const MeshQuality quality = measure_quality(arrow, build_topology(arrow.faces, arrow.vertices()));
    CHECK(quality.area == Approx(4));
}

TEST_CASE("a mirrored node still shows the front of its triangles", "[io]") {
    const Mesh plain = load_mesh(TEST_DATA "/triangle.gltf").mesh,
               mirrored = load_mesh(TEST_DATA "/mirrored.gltf").mesh;
    const auto normal = [](const Mesh& mesh) {
        const auto corner = [&](int c) { return Vec3(mesh.rest.col(mesh.faces(c, 0))); };
        return Vec3((corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized());
    };
    CHECK(plain.rest.row(0).maxCoeff() == 1);
    CHECK(mirrored.rest.row(0).minCoeff() == -1);
    CHECK((normal(plain) - Vec3::UnitZ()).norm() < 1e-12);
    CHECK((normal(mirrored) - Vec3::UnitZ()).norm() < 1e-12);
}

TEST_CASE("what is not a mesh file is refused: missing, a folder, empty, too large, an unknown ending",
          "[io]") {
    const TemporaryFolder folder;
    CHECK(error_of([&] { load_mesh(folder.file("none.obj")); }) ==
          folder.file("none.obj") + ": no such file");
    CHECK(error_of([&] { load_mesh(folder.path()); }).find("is a folder") != std::string::npos);
    CHECK(refusal("empty.obj", "") == ": is empty");
    CHECK(refusal("empty.fbx", "") == ": is empty");
    CHECK(refusal("cloth.docx", "hello").starts_with(": unknown mesh ending \".docx\""));
    CHECK(refusal("cloth", "hello").starts_with(": unknown mesh ending \"\""));
    const std::string large = folder.file("large.stl", "x");
    std::filesystem::resize_file(large, (1ULL << 30) + 1);  // sparse: takes no room
    CHECK(error_of([&] { load_mesh(large); }).find("is too large (at most 1073741824)") != std::string::npos);
}

TEST_CASE("garbage and texts under a mesh's name are refused", "[io]") {
    std::string garbage;
    for (unsigned i = 0, random = 1; i < 5000; ++i, random = random * 1664525 + 1013904223)
        garbage += static_cast<char>(random >> 24);
    for (const char* ending : {"obj", "ply", "glb", "gltf", "fbx", "stl", "dae", "off"}) {
        CAPTURE(ending);
        CHECK_FALSE(refusal(cat("garbage.", ending), garbage).empty());
        CHECK_FALSE(refusal(cat("text.", ending), "Dear reader,\nthis is a letter.\n").empty());
    }
}

TEST_CASE("what is wrong in an OBJ is named with its line", "[io]") {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
    CHECK(refusal("a.obj", "v 0 0 0\nv nan 0 0\nv 1 1 0\nf 1 2 3\n") == ":2: nan is not a finite number");
    CHECK(refusal("a.obj", "v 0 0 0\nv 0 -inf 0\nv 1 1 0\nf 1 2 3\n") == ":2: -inf is not a finite number");
    CHECK(refusal("a.obj", "v 0 0 0\nv 1e999 0 0\nv 1 1 0\nf 1 2 3\n").starts_with(":2: 1e999"));
    CHECK(refusal("a.obj", "v 0 0 0\nv 1 two 0\n") == ":2: \"two\" is not a number");
    CHECK(refusal("a.obj", "v 0 0\n") == ":1: a vertex needs three coordinates, got 2");
    CHECK(refusal("a.obj", square + "f 1 2 4\n") == ":4: vertex 4 of 3 (1 to 3)");
    CHECK(refusal("a.obj", square + "f 1 2 -4\n").starts_with(":4: index -4"));
    CHECK(refusal("a.obj", square + "f 0 1 2\n").starts_with(":4: index 0"));
    CHECK(refusal("a.obj", square + "f 1/1 2/1 3/1\n") == ":4: texture coordinate 1 of 0 (1 to 0)");
    CHECK(refusal("a.obj", square + "f 1 2\n") == ":4: a face of 2 corners (3 to 4096)");
    CHECK(refusal("a.obj", square + "f 1 2 x\n") == ":4: \"x\" is not a vertex number");
    CHECK(refusal("a.obj", square).starts_with(": has no faces"));
    CHECK(refusal("a.obj", "# nothing\n").starts_with(": has no vertices"));
    CHECK(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\n") ==
          ": all of its 2 triangles have no area");
    CHECK(
        refusal("a.obj", "v 0 0 0\nv 1e9 0 0\nv 2 1 0\nf 1 2 3\n").starts_with(": vertex 2 of 3 is 1e+09 m"));
}

TEST_CASE("what is wrong in a PLY is named, and nothing hangs or allocates", "[io]") {
    const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
    CHECK(load_text("good.ply", ply_with(three, "3 0 1 2\n")).mesh.triangles() == 1);
    // cut anywhere in its header
    for (size_t size = 1; size < triangle_ply.size(); ++size)
        CHECK_FALSE(refusal("cut.ply", triangle_ply.substr(0, size)).empty());
    CHECK(refusal("a.ply", ply_with("0 0 0\n1 0 0\n", "")).starts_with(":12: ends inside vertex 3 of 3"));
    CHECK(refusal("a.ply", ply_with("0 0 0\nnan 0 0\n0 1 0\n", "3 0 1 2\n")) ==
          ":11: vertex 2 of 3: x is not a finite number");
    CHECK(refusal("a.ply", ply_with(three, "3 0 1 3\n")) == ":13: face 1 of 1: vertex 3 (0 to 2)");
    CHECK(refusal("a.ply", ply_with(three, "3 0 -1 2\n")) == ":13: face 1 of 1: vertex -1 (0 to 2)");
    CHECK(refusal("a.ply", ply_with(three, "2 0 1\n")) ==
          ":13: face 1 of 1: a face of 2 corners (3 to 4096)");
    CHECK(refusal("a.ply", ply_with(three, "3 0 1 two\n")) == ":13: \"two\" is not a number");

    std::string many = ply_with(three, "3 0 1 2\n");
    many.replace(many.find("vertex 3"), 8, "vertex 2000000000");
    CHECK(refusal("many.ply", many).find("declares 2000000000 of element vertex") != std::string::npos);
    many.replace(many.find("2000000000"), 10, "99999999999999999999");
    CHECK(refusal("many.ply", many).find("is not a count") != std::string::npos);
    std::string typo = ply_with(three, "3 0 1 2\n");
    typo.replace(typo.find("float"), 5, "flaot");
    CHECK(refusal("typo.ply", typo).find("did you mean \"float\"") != std::string::npos);
}

TEST_CASE("a file that makes assimp ask for more memory than the file can mean is refused", "[io]") {
    // said in other words where the address sanitizer, which aborts on it, sees the request first
    CHECK_FALSE(refusal("many.off", "OFF\n2000000000 1 0\n0 0 0\n").empty());
}

TEST_CASE("a GLB cut anywhere is refused", "[io]") {
    const std::string whole = bytes_of(meshes + "two_panels.glb");
    for (const size_t size : {3U, 12U, 19U, 20U, 200U, 1000U, 60000U, 118000U}) {
        CAPTURE(size);
        CHECK_FALSE(refusal("cut.glb", whole.substr(0, size)).empty());
    }
}

TEST_CASE("every mesh that is written loads again with the same vertices in the same order", "[io]") {
    for (const char* name : {"tablecloth_round.obj", "skirt_cm_zup.fbx", "two_panels.glb", "cape.ply"}) {
        for (const char* ending : {".obj", ".ply"}) {
            CAPTURE(name, ending);
            const Mesh mesh = load_mesh(meshes + name).mesh;
            const TemporaryFolder folder;
            write_mesh(folder.file(cat("again", ending)), mesh);
            const Mesh again = load_mesh(folder.file(cat("again", ending))).mesh;
            REQUIRE(again.file_vertex.size() == mesh.file_vertex.size());
            CHECK(again.triangles() == mesh.triangles());
            const double off =
                (in_file_order(again, again.rest) - in_file_order(mesh, mesh.rest)).cwiseAbs().maxCoeff();
            // the text keeps every digit; assimp reads a PLY in single precision
            CHECK(off <= (ending == std::string(".obj") ? 0 : 1e-6));
            CHECK((again.drawn.uv.cols() > 0) == (mesh.drawn.uv.cols() > 0));
            if (ending == std::string(".obj")) CHECK(again.drawn.uv.cols() == mesh.drawn.uv.cols());
        }
    }
}

TEST_CASE("a pose's positions come in the file's order, on one place or without area too", "[io]") {
    const TemporaryFolder folder;
    for (const std::string third : {"1 0 0", "0.5 0 0"}) {
        const std::string obj = folder.file("pose.obj", "v 0 0 0\nv 1 0 0\nv " + third + "\nf 1 2 3\n");
        const std::string ply =
            folder.file("pose.ply", ply_with("0 0 0\n1 0 0\n" + third + "\n", "3 0 1 2\n"));
        for (const std::string& path : {obj, ply}) {
            CAPTURE(path, third);
            const Points x = load_positions(path).x;
            REQUIRE(x.cols() == 3);
            CHECK(x.col(1) == Vec3(1, 0, 0));
            CHECK(x.col(2) == (third == "1 0 0" ? Vec3(1, 0, 0) : Vec3(0.5, 0, 0)));
            CHECK_THROWS_AS(load_mesh(path), Error);
        }
    }
    CHECK_THROWS_AS(load_positions(folder.file("none.obj")), Error);
}

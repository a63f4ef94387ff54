#include "io/cache_writer.h"

#include <map>

#include <catch2/catch.hpp>

#include "io/cache_reader.h"
#include "io/load_mesh.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;

namespace {

// Two triangles welded from six file vertices and an unused seventh: file order and simulation order differ.
Mesh seamed() {
    const TemporaryFolder folder;
    return load_mesh(folder.file("a.obj",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 5\n"
                                 "f 6 4 5\nf 1 2 3\n"))
        .mesh;
}

std::string text_of(const std::vector<int>& bytes) {
    return {bytes.begin(), bytes.end()};
}

}  // namespace

TEST_CASE("a PC2's header is what its format says, byte by byte", "[io]") {
    const TemporaryFolder folder;
    const Mesh mesh = seamed();
    const auto writer = make_cache_writer(folder.file("a.pc2"), mesh, 30, 2);
    writer->add(mesh.rest);
    writer->add(mesh.rest);
    writer->finish();
    const std::string bytes = bytes_of(folder.file("a.pc2"));
    REQUIRE(bytes.size() == 32 + 2 * 7 * 12);
    CHECK(bytes.substr(0, 32) == std::string("POINTCACHE2\0", 12) + text_of({1, 0, 0, 0}) +
                                     text_of({7, 0, 0, 0}) + text_of({0, 0, 0, 0}) +
                                     text_of({0, 0, -128, 63}) + text_of({2, 0, 0, 0}));
    // file vertex 2 (counted from 1) is at x = 1: 0x3f800000
    CHECK(bytes.substr(32 + 12, 4) == text_of({0, 0, -128, 63}));
}

TEST_CASE("an MDD's header is what its format says, byte by byte", "[io]") {
    const TemporaryFolder folder;
    const Mesh mesh = seamed();
    const auto writer = make_cache_writer(folder.file("a.mdd"), mesh, 2, 3);
    for (int k = 0; k < 3; ++k) writer->add(mesh.rest);
    writer->finish();
    const std::string bytes = bytes_of(folder.file("a.mdd"));
    REQUIRE(bytes.size() == 8 + 3 * 4 + 3 * 7 * 12);
    // times 0, 0.5 and 1 s
    CHECK(bytes.substr(0, 20) == text_of({0, 0, 0, 3}) + text_of({0, 0, 0, 7}) + text_of({0, 0, 0, 0}) +
                                     text_of({63, 0, 0, 0}) + text_of({63, -128, 0, 0}));
}

TEST_CASE("a cache holds every sample in the file's vertex order, also of a run that ended early", "[io]") {
    const Mesh mesh = seamed();
    for (const char* ending : {".pc2", ".mdd"}) {
        for (const int promised : {3, 2000}) {
            CAPTURE(ending, promised);
            const TemporaryFolder folder;
            const std::string path = folder.file(cat("a", ending));
            const auto writer = make_cache_writer(path, mesh, 25, promised);
            for (int k = 0; k < 3; ++k) writer->add(mesh.rest.array() + k);
            writer->finish();
            const Cache cache = read_cache(path);
            REQUIRE(cache.samples.size() == 3);
            for (int k = 0; k < 3; ++k) {
                const Points moved = mesh.rest.array() + k;
                CHECK(cache.samples[static_cast<size_t>(k)] == in_file_order(mesh, moved));
                CHECK(cache.times[static_cast<size_t>(k)] ==
                      Approx(ending == std::string(".mdd") ? k / 25.0 : k));
            }
        }
    }
}

TEST_CASE("a sequence of mesh files has one per sample, numbered, each a mesh in file order", "[io]") {
    const Mesh mesh = seamed();
    for (const char* ending : {".obj", ".ply"}) {
        CAPTURE(ending);
        const TemporaryFolder folder;
        const auto writer = make_cache_writer(folder.file(cat("drop", ending)), mesh, 30, 2);
        writer->add(mesh.rest);
        writer->add(mesh.rest.array() + 1);
        writer->finish();
        CHECK(folder.files() == 2);
        const Mesh second = load_mesh(folder.file(cat("drop_0001", ending))).mesh;
        const Points moved = mesh.rest.array() + 1;
        CHECK(in_file_order(second, second.rest) == in_file_order(mesh, moved));
    }
}

TEST_CASE("every cache that is not finished leaves nothing behind", "[io]") {
    const Mesh mesh = seamed();
    for (const CacheKind& kind : cache_kinds()) {
        CAPTURE(kind.ending);
        const TemporaryFolder folder;
        {
            const auto writer = make_cache_writer(folder.file(cat("a", kind.ending)), mesh, 30, 5);
            writer->add(mesh.rest);
            CHECK(folder.files() == 1);
        }
        CHECK(folder.files() == 0);
    }
}

TEST_CASE("a cache nobody can write is refused before the first sample", "[io]") {
    const Mesh mesh = seamed();
    const TemporaryFolder folder;
    for (const CacheKind& kind : cache_kinds()) {
        const std::string path = folder.file(cat("no/folder/a", kind.ending));
        CHECK(error_of([&] { make_cache_writer(path, mesh, 30, 5); }).find("cannot write") !=
              std::string::npos);
    }
    const std::string unknown = error_of([&] { make_cache_writer(folder.file("a.abc"), mesh, 30, 5); });
    CHECK(unknown.find("(known: .pc2, .mdd, .obj, .ply, .glb)") != std::string::npos);
}

TEST_CASE("a cache that is cut, lies about its size or is none is refused", "[io]") {
    const Mesh mesh = seamed();
    const TemporaryFolder folder;
    for (const char* ending : {".pc2", ".mdd", ".glb"}) {
        CAPTURE(ending);
        const std::string path = folder.file(cat("a", ending));
        const auto writer = make_cache_writer(path, mesh, 30, 1);
        writer->add(mesh.rest);
        writer->finish();
        const std::string whole = bytes_of(path);
        for (size_t size = 1; size < whole.size(); size += 7) {
            const std::string cut = folder.file(cat("cut", ending), whole.substr(0, size));
            CHECK(error_of([&] { read_cache(cut); }).starts_with(cut));
        }
        std::string huge = whole;
        const std::map<std::string, size_t> size_at{{".pc2", 28}, {".mdd", 0}, {".glb", 8}};
        huge.replace(size_at.at(ending), 4, "\x7f\x7f\x7f\x7f");
        const std::string lie = folder.file(cat("lie", ending), huge);
        CHECK(error_of([&] { read_cache(lie); }).starts_with(lie));
    }
    CHECK_FALSE(error_of([&] { read_cache(folder.file("a.abc", "x")); }).empty());
}

// glTF caches, read by the words of the glTF 2.0 specification, by assimp, and by our own reader.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <bit>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "io/bytes.h"
#include "io/cache_reader.h"
#include "io/cache_writer.h"
#include "io/load_mesh.h"
#include "mesh/pattern.h"
#include "support/glb_bytes.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;
using Json = nlohmann::json;

namespace {

constexpr auto little = std::endian::little;
constexpr int samples = 4;
constexpr double frame_rate = 25;

// Two triangles with a UV seam between them.
Mesh seamed() {
    const TemporaryFolder folder;
    return load_mesh(folder.file("a.obj",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                 "vt 0 0\nvt 0.25 0\nvt 0.25 0.5\nvt 0.75 0\nvt 1 1\nvt 0.75 0.5\n"
                                 "f 1/1 2/2 3/3\nf 1/4 3/5 4/6\n"))
        .mesh;
}

// Where the mesh is in a sample: turned, moved and bent, in numbers that floats round.
Points moved(const Mesh& mesh, int sample) {
    Points x = mesh.rest;
    for (int v = 0; v < x.cols(); ++v)
        x.col(v) += Vec3(0.3, -0.1 * sample, std::sin(v + 0.7 * sample)) * sample / 3;
    return x;
}

void write(const std::string& path, const Mesh& mesh, int promised = samples) {
    const auto writer = make_cache_writer(path, mesh, frame_rate, promised, Colour{0.5F, 0.25F, 1});
    for (int k = 0; k < samples; ++k) writer->add(moved(mesh, k));
    writer->finish();
}

// A glTF binary taken apart as its specification has it; every rule of it that can be checked is.
struct Parsed {
    Json json;
    std::string binary;

    explicit Parsed(const std::string& bytes) {
        const auto word = [&](size_t at) { return number_at<std::uint32_t>(bytes.data() + at, little); };
        REQUIRE(bytes.size() > 28);
        CHECK(bytes.substr(0, 4) == "glTF");
        CHECK(word(4) == 2);
        CHECK(word(8) == bytes.size());
        const size_t size = word(12), second = 20 + size;
        CHECK(bytes.substr(16, 4) == "JSON");
        CHECK(size % 4 == 0);
        json = Json::parse(bytes.substr(20, size));  // spaces may follow
        CHECK(bytes.substr(second + 4, 4) == std::string("BIN\0", 4));
        CHECK(word(second) % 4 == 0);
        binary = bytes.substr(second + 8);
        CHECK(binary.size() == word(second));
        CHECK(json["buffers"][0]["byteLength"] == binary.size());
        CHECK(json["asset"]["version"] == "2.0");
    }

    const Json& view_of(int accessor) const {
        return json["bufferViews"][json["accessors"][size_t(accessor)]["bufferView"].get<size_t>()];
    }

    template <class Number>
    std::vector<Number> numbers(int index, int component, const std::string& type, int target) const {
        const Json& accessor = json["accessors"][size_t(index)];
        const Json& view = view_of(index);
        const auto offset = view["byteOffset"].get<size_t>(), length = view["byteLength"].get<size_t>();
        const size_t width = type == "VEC3" ? 3 : type == "VEC2" ? 2 : 1;
        CHECK(accessor["componentType"] == component);
        CHECK(accessor["type"] == type);
        CHECK(view.value("target", 0) == target);
        CHECK(offset % 4 == 0);
        CHECK(offset + length <= binary.size());
        CHECK(accessor["count"].get<size_t>() * width * sizeof(Number) == length);
        std::vector<Number> all;
        for (size_t i = 0; i < length; i += sizeof(Number))
            all.push_back(number_at<Number>(binary.data() + offset + i, little));
        return all;
    }

    // Vectors of an attribute, whose bounds, where told, are the very least and most.
    Points vectors(const Json& index) const {
        const int i = index.get<int>();
        const std::vector<float> all = numbers<float>(i, 5126, "VEC3", 34962);
        const Eigen::Matrix3Xf each =
            Eigen::Map<const Eigen::Matrix3Xf>(all.data(), 3, Eigen::Index(all.size() / 3));
        const Json& accessor = json["accessors"][size_t(i)];
        for (int c = 0; c < 3 && accessor.contains("min"); ++c) {
            CHECK(accessor["min"][size_t(c)].get<double>() == double(each.row(c).minCoeff()));
            CHECK(accessor["max"][size_t(c)].get<double>() == double(each.row(c).maxCoeff()));
        }
        return each.cast<double>();
    }
};

}  // namespace

TEST_CASE("a glTF cache keeps every rule of its specification and blends to every frame", "[io]") {
    const TemporaryFolder folder;
    const Mesh mesh = seamed();
    const int promised = GENERATE(samples, 3 * samples);  // the second: a run that ended early
    write(folder.file("a cloth.glb"), mesh, promised);
    const Parsed glb(bytes_of(folder.file("a cloth.glb")));
    const Json& primitive = glb.json["meshes"][0]["primitives"][0];
    CHECK(primitive["mode"] == 4);
    CHECK(glb.json["nodes"][glb.json["scenes"][0]["nodes"][0].get<size_t>()]["name"] == "a cloth");

    // six drawn vertices, in the order of the file's
    const auto corners = glb.numbers<std::uint32_t>(primitive["indices"], 5125, "SCALAR", 34963);
    CHECK(corners.size() == 6);
    CHECK(std::set<std::uint32_t>(corners.begin(), corners.end()).size() == 6);
    const Points base = glb.vectors(primitive["attributes"]["POSITION"]);
    const Points normals = glb.vectors(primitive["attributes"]["NORMAL"]);
    REQUIRE(base.cols() == 6);
    CHECK(normals.colwise().norm().isApproxToConstant(1, 1e-6));
    CHECK(base.col(0) == base.col(1));
    CHECK(base.col(0) == Vec3(0, 0, 0));
    const auto uv = glb.numbers<float>(primitive["attributes"]["TEXCOORD_0"], 5126, "VEC2", 34962);
    for (int f = 0; f < mesh.triangles(); ++f)
        for (int c = 0; c < 3; ++c) {
            const Eigen::Vector2f wanted = mesh.drawn.uv.col(mesh.drawn.faces(c, f));
            const size_t i = corners[size_t(3 * f + c)];
            CHECK(uv[2 * i] == wanted[0]);
            CHECK(uv[2 * i + 1] == 1 - wanted[1]);  // v runs down
        }

    // sample k is the mesh where the weights of keyframe k put it, and in between lies what is between
    const Json& animation = glb.json["animations"][0];
    CHECK(animation["channels"][0]["target"] == Json{{"node", 0}, {"path", "weights"}});
    CHECK(animation["samplers"][0]["interpolation"] == "LINEAR");
    const auto times = glb.numbers<float>(animation["samplers"][0]["input"], 5126, "SCALAR", 0);
    const auto weights = glb.numbers<float>(animation["samplers"][0]["output"], 5126, "SCALAR", 0);
    REQUIRE(times.size() == samples);
    REQUIRE(primitive["targets"].size() == samples - 1);
    REQUIRE(weights.size() == samples * (samples - 1));
    CHECK(glb.json["accessors"][animation["samplers"][0]["input"].get<size_t>()]["max"][0].get<double>() ==
          double(times.back()));
    for (int k = 0; k < samples; ++k) {
        CHECK(times[size_t(k)] == float(k / frame_rate));
        Points blended = base, blended_normals = normals;
        for (size_t t = 0; t + 1 < samples; ++t) {
            const double weight = double(weights[size_t(k) * (samples - 1) + t]);
            blended += weight * glb.vectors(primitive["targets"][t]["POSITION"]);
            blended_normals += weight * glb.vectors(primitive["targets"][t]["NORMAL"]);
        }
        const Points x = moved(mesh, k);
        for (int f = 0; f < mesh.triangles(); ++f)
            for (int c = 0; c < 3; ++c)
                CHECK((blended.col(corners[size_t(3 * f + c)]) - x.col(mesh.faces(c, f))).norm() < 2e-7);
        CHECK(blended_normals.colwise().norm().isApproxToConstant(1, 1e-6));
    }

    const Json& material = glb.json["materials"][primitive["material"].get<size_t>()];
    CHECK(material["doubleSided"] == true);
    const Json& colour = material["pbrMetallicRoughness"]["baseColorFactor"];  // linear
    CHECK(colour[0].get<double>() == Approx(0.2140).margin(1e-4));
    CHECK(colour[1].get<double>() == Approx(0.0509).margin(1e-4));
    CHECK(colour[2].get<double>() == Approx(1));
}

TEST_CASE("assimp finds mesh and morph targets and their times in a glTF cache", "[io]") {
    const TemporaryFolder folder;
    const Mesh mesh = make_pattern("alternating", {.width = 1, .depth = 1, .columns = 3, .rows = 3});
    const std::string path = folder.file("a.glb");
    write(path, mesh);

    const Mesh back = load_mesh(path).mesh;
    CHECK((in_file_order(back, back.rest) - in_file_order(mesh, mesh.rest)).cwiseAbs().maxCoeff() < 1e-7);
    CHECK(back.triangles() == mesh.triangles());
    for (size_t i = 0; i < mesh.file_vertex.size(); ++i)
        CHECK((back.drawn.uv.col(back.file_vertex[i]) - mesh.drawn.uv.col(mesh.file_vertex[i])).norm() <
              1e-6F);

    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path, 0);
    REQUIRE(scene != nullptr);
    REQUIRE(scene->mNumMeshes == 1);
    const aiMesh& found = *scene->mMeshes[0];
    REQUIRE(found.mNumAnimMeshes == samples - 1);
    const Points last = in_file_order(mesh, moved(mesh, samples - 1));
    REQUIRE(found.mNumVertices == unsigned(last.cols()));
    for (unsigned v = 0; v < found.mNumVertices; ++v) {
        const aiVector3D& x = found.mAnimMeshes[samples - 2]->mVertices[v];
        CHECK((Eigen::Vector3f(x.x, x.y, x.z).cast<double>() - last.col(int(v))).norm() < 3e-7);
    }
    REQUIRE(scene->mNumAnimations == 1);
    REQUIRE(scene->mAnimations[0]->mNumMorphMeshChannels == 1);
    const aiMeshMorphAnim& channel = *scene->mAnimations[0]->mMorphMeshChannels[0];
    REQUIRE(channel.mNumKeys == samples);
    for (unsigned k = 0; k < samples; ++k) {
        CHECK(channel.mKeys[k].mTime == Approx(1000.0 * k / frame_rate));
        for (unsigned t = 0; t + 1 < samples; ++t)
            CHECK(channel.mKeys[k].mWeights[t] == (t + 1 == k ? 1 : 0));
    }
}

TEST_CASE("a glTF cache is read back for comparisons to a float of every sample", "[io]") {
    const TemporaryFolder folder;
    const Mesh mesh = make_pattern("one_way", {.width = 1, .depth = 1, .columns = 2, .rows = 2});
    write(folder.file("a.glb"), mesh, 50);
    const Cache cache = read_cache(folder.file("a.glb"));
    REQUIRE(cache.samples.size() == samples);
    for (int k = 0; k < samples; ++k) {
        CHECK((cache.samples[size_t(k)] - in_file_order(mesh, moved(mesh, k))).cwiseAbs().maxCoeff() < 1e-7);
        CHECK(cache.times[size_t(k)] == Approx(k / frame_rate));
    }
    // the start alone has nothing to move to
    const auto writer = make_cache_writer(folder.file("b.glb"), mesh, frame_rate, 50);
    writer->add(mesh.rest);
    writer->finish();
    CHECK(read_cache(folder.file("b.glb")).samples.size() == 1);
    CHECK_FALSE(Parsed(bytes_of(folder.file("b.glb"))).json.contains("animations"));
}

TEST_CASE("a glTF cache beyond 4 GiB is refused before the run and a foreign one is not misread", "[io]") {
    const TemporaryFolder folder;
    const Mesh mesh = seamed();
    const std::string large =
        error_of([&] { make_cache_writer(folder.file("a.glb"), mesh, 30, 2000000000); });
    CHECK(large.find("and a glTF binary holds 4.29 (take .pc2 or .mdd") != std::string::npos);
    CHECK(folder.files() == 0);
    write(folder.file("a.glb"), mesh);
    std::string other = bytes_of(folder.file("a.glb"));
    other.replace(other.find("\"VEC3\""), 6, "\"VEC4\"");
    CHECK(error_of([&] { read_cache(folder.file("b.glb", other)); }).find("b.glb: holds its positions") !=
          std::string::npos);
    other.replace(other.find("\"meshes\""), 8, "\"mashes\"");
    CHECK(error_of([&] {
              read_cache(folder.file("c.glb", other));
          }).find("c.glb: is not a glTF of one mesh") != std::string::npos);
}

TEST_CASE("a glTF cache that says more than its bytes hold is refused", "[io]") {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& targets, const std::string& view) {
        const std::string json =
            R"({"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "targets": [)" + targets +
            R"(]}]}], "bufferViews": [{)" + view +
            R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "VEC3"}]})";
        return error_of([&] { read_cache(folder.file("a.glb", test::glb_bytes(json, std::string(24, 0)))); });
    };
    const std::string target = R"({"POSITION": 0})";
    CHECK(refusal(target, "").find("more morph targets than its 24 bytes can hold") != std::string::npos);
    CHECK(refusal(target, R"("byteOffset": 25)").find("beyond its 24 bytes") != std::string::npos);
    CHECK(refusal(target, R"("byteOffset": 18446744073709551612)").find("beyond its 24") !=
          std::string::npos);
    CHECK(refusal(target, R"("byteOffset": -4)").find("has a number where a whole number") !=
          std::string::npos);
    CHECK(refusal(target, R"("byteOffset": "4")").find("has a string where") != std::string::npos);
}

#include "io/assimp_import.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "io/endings.h"
#include "io/isolated.h"

namespace drape {

namespace {

constexpr long long most_vertices = 50'000'000;  // over all instances
// PreTransformVertices loses the nodes, FindDegenerates and JoinIdenticalVertices the file's vertices
constexpr unsigned flags = aiProcess_Triangulate | aiProcess_ValidateDataStructure;

Eigen::Affine3d transform_of(const aiMatrix4x4& m) {
    Eigen::Affine3d t;
    t.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3,
        m.d4;
    return t;
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find_first_of("\r\n"));
}

// Puts one mesh after another into a soup.
class Gatherer {
public:
    Gatherer(const std::string& path, bool keep_vertices) : path_(path), keep_vertices_(keep_vertices) {}

    void walk(const aiScene& scene, const aiNode& node, const Eigen::Affine3d& parent) {
        const Eigen::Affine3d here = parent * transform_of(node.mTransformation);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene.mMeshes[node.mMeshes[i]], here);
        for (unsigned i = 0; i < node.mNumChildren; ++i) walk(scene, *node.mChildren[i], here);
    }

    ImportedScene finish() {
        ImportedScene imported;
        imported.points_lines = points_lines_;
        imported.soup.positions =
            Eigen::Map<const Points>(xyz_.data(), 3, static_cast<Eigen::Index>(xyz_.size() / 3));
        imported.soup.faces =
            Eigen::Map<const Faces>(corners_.data(), 3, static_cast<Eigen::Index>(corners_.size() / 3));
        if (any_uv_)
            imported.soup.corner_uv =
                Eigen::Map<const Eigen::Matrix2Xf>(uv_.data(), 2, static_cast<Eigen::Index>(uv_.size() / 2));
        if (any_mark_) imported.mark = std::move(mark_);
        return imported;
    }

private:
    void add(const aiMesh& mesh, const Eigen::Affine3d& to_world) {
        const int begin = static_cast<int>(xyz_.size() / 3);
        if (begin + static_cast<long long>(mesh.mNumVertices) > most_vertices)
            throw Error(cat(path_, ": has too many vertices (at most ", most_vertices, ")"));
        const std::vector<int> vertex = add_vertices(mesh, to_world, begin);

        // a mirrored node turns the front to the back
        const bool mirrored = to_world.linear().determinant() < 0;
        any_uv_ |= mesh.HasTextureCoords(0);
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) {
                ++points_lines_;
                continue;
            }
            for (const unsigned c : mirrored ? std::array{0U, 2U, 1U} : std::array{0U, 1U, 2U}) {
                const unsigned index = face.mIndices[c];
                if (index >= mesh.mNumVertices)
                    throw Error(
                        cat(path_, ": triangle ", f + 1, " names vertex ", index, " of ", mesh.mNumVertices));
                corners_.push_back(vertex[index]);
                const aiVector3D uv = mesh.HasTextureCoords(0) ? mesh.mTextureCoords[0][index] : aiVector3D();
                uv_.insert(uv_.end(), {uv.x, uv.y});
            }
        }
    }

    // Adds the vertices that count as the file's; returns which one each of the mesh's is.
    std::vector<int> add_vertices(const aiMesh& mesh, const Eigen::Affine3d& to_world, int begin) {
        Points local(3, mesh.mNumVertices);
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D& p = mesh.mVertices[i];
            local.col(i) << static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z);
        }
        std::vector<int> vertex(mesh.mNumVertices), first;
        if (!keep_vertices_) first = first_in_place(local);
        any_mark_ |= mesh.HasVertexColors(0);
        for (int i = 0, next = begin; i < local.cols(); ++i) {
            const auto slot = static_cast<size_t>(i);
            if (!keep_vertices_ && first[slot] != i) {
                vertex[slot] = vertex[static_cast<size_t>(first[slot])];
                continue;
            }
            vertex[slot] = next++;
            const Vec3 p = to_world * Vec3(local.col(i));
            xyz_.insert(xyz_.end(), {p.x(), p.y(), p.z()});
            const aiColor4D colour = mesh.HasVertexColors(0) ? mesh.mColors[0][i] : aiColor4D();
            const bool is_mark =
                colour.r >= 0 && colour.r < mark_base && colour.g >= 0 && 2 * colour.g < mark_base;
            mark_.push_back(is_mark ? static_cast<int>(colour.r) + mark_base * static_cast<int>(colour.g)
                                    : -1);
        }
        return vertex;
    }

    std::string path_;
    bool keep_vertices_, any_uv_ = false, any_mark_ = false;
    std::vector<double> xyz_;
    std::vector<int> corners_, mark_;
    std::vector<float> uv_;
    int points_lines_ = 0;
};

std::optional<double> number_in(const aiMetadata& data, const char* key) {
    float single = 0;
    double number = 0;
    std::int32_t integer = 0;
    if (data.Get(key, number)) return number;
    if (data.Get(key, single)) return static_cast<double>(single);
    if (data.Get(key, integer)) return integer;
    return std::nullopt;
}

// FBX says in its settings how long its unit is (in cm) and which axis is up; assimp 5.2.5 passes both on and
// applies neither. (A version that does turns the root node, which 5.2.5 leaves alone.)
Eigen::Affine3d fbx_to_metres_y_up(const aiScene& scene, std::vector<std::string>& notes) {
    Eigen::Affine3d settings = Eigen::Affine3d::Identity();
    if (!scene.mMetaData) return settings;
    const aiMetadata& data = *scene.mMetaData;

    const double unit = number_in(data, "UnitScaleFactor").value_or(1);
    const bool usable = std::isfinite(unit) && unit > 0;
    const double metres = usable ? unit / 100 : 0.01;
    if (!usable) notes.push_back(cat("unit ", unit, " cm makes no sense: taken as 1 cm"));
    notes.push_back(cat("unit ", metres * 100, " cm: scaled by ", metres));

    // row by row: which of the file's axes points right, up, to the front
    Mat3 turn = Mat3::Zero();
    const std::array<std::array<const char*, 2>, 3> keys{
        {{"CoordAxis", "CoordAxisSign"}, {"UpAxis", "UpAxisSign"}, {"FrontAxis", "FrontAxisSign"}}};
    for (int row = 0; row < 3; ++row) {
        const auto& [axis_key, sign_key] = keys[static_cast<size_t>(row)];
        const double axis = number_in(data, axis_key).value_or(row);
        if (axis >= 0 && axis < 3)
            turn(row, static_cast<int>(axis)) = number_in(data, sign_key).value_or(1) < 0 ? -1 : 1;
    }
    const bool is_turn = std::abs(std::abs(turn.determinant()) - 1) < 0.5;
    const bool already_turned = !scene.mRootNode->mTransformation.IsIdentity();
    if (is_turn && !already_turned && turn != Mat3::Identity()) {
        notes.push_back(cat("up is ", "xyz"[static_cast<int>(number_in(data, "UpAxis").value_or(1))],
                            ": turned to y up"));
    } else {
        turn.setIdentity();
    }
    settings.linear() = metres * turn;
    return settings;
}

// An imported scene as bytes, to pass from one process to another on the same machine.
template <class Number>
void pack_array(std::string& bytes, const Number* data, Eigen::Index size) {
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes.append(reinterpret_cast<const char*>(data), static_cast<size_t>(size) * sizeof(Number));
}

std::string pack(const ImportedScene& scene) {
    std::string bytes;
    pack_array(bytes, scene.soup.positions.data(), scene.soup.positions.size());
    pack_array(bytes, scene.soup.faces.data(), scene.soup.faces.size());
    pack_array(bytes, scene.soup.corner_uv.data(), scene.soup.corner_uv.size());
    pack_array(bytes, scene.mark.data(), static_cast<Eigen::Index>(scene.mark.size()));
    pack_array(bytes, &scene.points_lines, 1);
    for (const std::string& note : scene.notes)
        pack_array(bytes, note.data(), static_cast<Eigen::Index>(note.size()));
    return bytes;
}

template <class Number>
std::vector<Number> unpack_array(std::string_view& bytes) {
    Eigen::Index size = 0;
    std::memcpy(&size, bytes.data(), sizeof size);
    std::vector<Number> array(static_cast<size_t>(size));
    if (size > 0) std::memcpy(array.data(), bytes.data() + sizeof size, array.size() * sizeof(Number));
    bytes.remove_prefix(sizeof size + array.size() * sizeof(Number));
    return array;
}

template <class Matrix>
Matrix unpack_columns(std::string_view& bytes) {
    const auto numbers = unpack_array<typename Matrix::Scalar>(bytes);
    constexpr int rows = Matrix::RowsAtCompileTime;
    return Eigen::Map<const Matrix>(numbers.data(), rows, static_cast<Eigen::Index>(numbers.size()) / rows);
}

ImportedScene unpack(std::string_view bytes) {
    ImportedScene scene;
    scene.soup.positions = unpack_columns<Points>(bytes);
    scene.soup.faces = unpack_columns<Faces>(bytes);
    scene.soup.corner_uv = unpack_columns<Eigen::Matrix2Xf>(bytes);
    scene.mark = unpack_array<int>(bytes);
    scene.points_lines = unpack_array<int>(bytes).front();
    while (!bytes.empty()) {
        const std::vector<char> note = unpack_array<char>(bytes);
        scene.notes.emplace_back(note.begin(), note.end());
    }
    return scene;
}

ImportedScene gather(const std::string& path, const Assimp::Importer& importer, const aiScene* scene,
                     bool keep_vertices, bool is_fbx) {
    if (!scene || !scene->mRootNode)
        throw Error(cat(path, ": cannot read: ", first_line(importer.GetErrorString())));
    std::vector<std::string> notes;
    const Eigen::Affine3d settings = is_fbx ? fbx_to_metres_y_up(*scene, notes) : Eigen::Affine3d::Identity();
    Gatherer gatherer(path, keep_vertices);
    gatherer.walk(*scene, *scene->mRootNode, settings);
    ImportedScene imported = gatherer.finish();
    imported.notes = std::move(notes);
    return imported;
}

// What a sound file of this size needs, with plenty to spare (measured: 8 MB and 0.1 s per MB of OBJ).
Limits limits_for(std::uint64_t file_bytes) {
    const std::uint64_t megabytes = file_bytes >> 20;
    return {(1024 + 64 * megabytes) << 20, static_cast<int>(30 + 2 * megabytes)};
}

// assimp 5.2.5 has more ways to fail than the checks before it can know, so it works in a process of its own.
ImportedScene isolated(const std::string& path, std::uint64_t file_bytes,
                       const std::function<ImportedScene()>& import) {
    try {
        return unpack(run_isolated(limits_for(file_bytes), [&] { return pack(import()); }));
    } catch (const Error& error) {
        const std::string what = error.what();
        throw Error(what.starts_with(path) ? what : cat(path, ": ", what));
    }
}

}  // namespace

ImportedScene import_file(const std::string& path) {
    const std::string ending = ending_of(path);
    if (ending.empty() || !Assimp::Importer().IsExtensionSupported(ending))
        throw Error(cat(path, ": unknown mesh ending \"", ending,
                        "\" (known: .obj, .ply, .glb, .gltf, .fbx, .stl, ...)"));
    const bool keep_vertices = ending == ".ply" || ending == ".glb" || ending == ".gltf";
    return isolated(path, std::filesystem::file_size(path), [&] {
        Assimp::Importer importer;
        return gather(path, importer, importer.ReadFile(path, flags), keep_vertices, ending == ".fbx");
    });
}

ImportedScene import_obj(const std::string& path, const std::string& text) {
    return isolated(path, text.size(), [&] {
        Assimp::Importer importer;
        return gather(path, importer, importer.ReadFileFromMemory(text.data(), text.size(), flags, "obj"),
                      true, false);
    });
}

}  // namespace drape

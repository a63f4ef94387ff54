#include "io/write_mesh.h"

#include <charconv>
#include <string_view>

#include "base/error.h"
#include "io/bytes.h"
#include "io/endings.h"
#include "io/write_file.h"

namespace drape {

namespace {

// The shortest decimals that read back as the same number.
template <class Number>
void put_text(std::string& text, Number value) {
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

// For each simulated vertex the first vertex of the file that stands for it.
std::vector<int> first_file_vertex(const Mesh& mesh) {
    std::vector<int> first(static_cast<size_t>(mesh.vertices()), -1);
    for (size_t i = mesh.file_vertex.size(); i-- > 0;)
        if (mesh.file_vertex[i] >= 0) first[static_cast<size_t>(mesh.file_vertex[i])] = static_cast<int>(i);
    return first;
}

std::string obj_file(const Mesh& mesh, In positions) {
    const Points points = in_file_order(mesh, positions);
    const std::vector<int> file_vertex = first_file_vertex(mesh);
    std::string text = "# written by drape; metres, y up\n";
    text.reserve(static_cast<size_t>(60 * points.cols() + 40 * mesh.faces.cols()));
    const auto put_line = [&](std::string_view keyword, const auto& numbers) {
        text += keyword;
        for (const auto number : numbers) {
            text += ' ';
            put_text(text, number);
        }
        text += '\n';
    };
    for (const auto& p : points.colwise()) put_line("v", p);
    for (const auto& uv : mesh.drawn.uv.colwise()) put_line("vt", uv);
    for (int f = 0; f < mesh.triangles(); ++f) {
        text += 'f';
        for (int c = 0; c < 3; ++c) {
            text += ' ';
            put_text(text, file_vertex[static_cast<size_t>(mesh.faces(c, f))] + 1);
            if (mesh.drawn.uv.cols() == 0) continue;
            text += '/';
            put_text(text, mesh.drawn.faces(c, f) + 1);
        }
        text += '\n';
    }
    return text;
}

// A PLY has one vertex per vertex of the mesh's file. Without seams its UV stands beside it (s, t), which
// most programs read; with seams the corners of each face carry theirs (texcoord).
std::string ply_file(const Mesh& mesh, In positions) {
    constexpr auto little = std::endian::little;
    const Points points = in_file_order(mesh, positions);
    const std::vector<int> file_vertex = first_file_vertex(mesh);
    const bool has_uv = mesh.drawn.uv.cols() > 0;
    const bool has_seams = has_uv && mesh.drawn.uv.cols() != mesh.rest.cols();

    std::string text = "ply\nformat binary_little_endian 1.0\ncomment written by drape; metres, y up\n";
    text +=
        cat("element vertex ", points.cols(), "\nproperty double x\nproperty double y\nproperty double z\n");
    if (has_uv && !has_seams) text += "property float s\nproperty float t\n";
    text += cat("element face ", mesh.triangles(), "\nproperty list uchar int vertex_indices\n");
    if (has_seams) text += "property list uchar float texcoord\n";
    text += "end_header\n";

    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        for (const double coordinate : points.col(i)) put<little>(bytes, coordinate);
        if (!has_uv || has_seams) continue;
        // without seams the drawn vertices are the simulated ones; a vertex that is not simulated has no UV
        const int vertex = mesh.file_vertex[static_cast<size_t>(i)];
        const Eigen::Vector2f uv =
            vertex >= 0 ? Eigen::Vector2f(mesh.drawn.uv.col(vertex)) : Eigen::Vector2f(0, 0);
        for (const float number : uv) put<little>(bytes, number);
    }
    for (int f = 0; f < mesh.triangles(); ++f) {
        put<little>(bytes, std::uint8_t{3});
        for (const int corner : mesh.faces.col(f))
            put<little>(bytes, file_vertex[static_cast<size_t>(corner)]);
        if (!has_seams) continue;
        put<little>(bytes, std::uint8_t{6});
        for (const int corner : mesh.drawn.faces.col(f))
            for (const float number : mesh.drawn.uv.col(corner)) put<little>(bytes, number);
    }
    return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string mesh_file(const std::string& path, const Mesh& mesh, In positions) {
    const std::string ending = ending_of(path);
    if (ending == ".obj") return obj_file(mesh, positions);
    if (ending == ".ply") return ply_file(mesh, positions);
    throw Error(cat(path, ": cannot write a mesh as \"", ending, "\" (known: .obj, .ply)"));
}

void write_mesh(const std::string& path, const Mesh& mesh) {
    write_file(path, std::string_view(mesh_file(path, mesh, mesh.rest)));
}

}  // namespace drape

#include "mesh/mesh.h"

#include <numeric>

#include "base/assert.h"

namespace drape {

Mesh plain_mesh(Points rest, Faces faces, Eigen::Matrix2Xf uv) {
    DRAPE_ASSERT(uv.cols() == 0 || uv.cols() == rest.cols());
    Mesh mesh;
    mesh.drawn.vertex.resize(static_cast<size_t>(rest.cols()));
    std::iota(mesh.drawn.vertex.begin(), mesh.drawn.vertex.end(), 0);
    mesh.file_vertex = mesh.drawn.vertex;
    mesh.drawn.uv = std::move(uv);
    mesh.drawn.faces = faces;
    mesh.rest = std::move(rest);
    mesh.faces = std::move(faces);
    return mesh;
}

Points in_file_order(const Mesh& mesh, In positions) {
    DRAPE_ASSERT(positions.cols() == mesh.rest.cols());
    Points points(3, static_cast<Eigen::Index>(mesh.file_vertex.size()));
    Eigen::Index column = 0, unused = 0;
    for (const int vertex : mesh.file_vertex)
        points.col(column++) = vertex >= 0 ? Vec3(positions.col(vertex)) : Vec3(mesh.unused.col(unused++));
    return points;
}

}  // namespace drape

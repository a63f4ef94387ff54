#include "scene/curved_places.h"

#include <algorithm>

#include "base/error.h"
#include "io/cache_reader.h"
#include "io/load_mesh.h"
#include "mesh/curvature.h"

namespace drape {

namespace {

// Poses of a mesh, a column per simulated vertex.
std::vector<Points> poses_of(const Mesh& mesh, const std::string& mesh_path, const std::string& path) {
    if (path.empty()) return {mesh.rest};
    std::vector<Points> samples =
        is_readable_cache(path) ? read_cache(path).samples : std::vector{load_positions(path).x};
    std::vector<Points> poses;
    for (const Points& sample : samples) {
        if (static_cast<size_t>(sample.cols()) != mesh.file_vertex.size())
            throw Error(cat(path, " has ", sample.cols(), " vertices, ", mesh_path, " has ",
                            mesh.file_vertex.size(), " (they must be the same, in the same order)"));
        Points pose = mesh.rest;
        for (size_t i = 0; i < mesh.file_vertex.size(); ++i)
            if (mesh.file_vertex[i] >= 0)
                pose.col(mesh.file_vertex[i]) = sample.col(static_cast<Eigen::Index>(i));
        if (!pose.allFinite()) throw Error(cat(path, ": a position is not finite"));
        poses.push_back(std::move(pose));
    }
    return poses;
}

}  // namespace

std::vector<CurvedPlace> curved_places(const std::string& mesh_path, const std::string& positions) {
    const Mesh mesh = load_mesh(mesh_path).mesh;
    if (mesh.drawn.uv.cols() == 0)
        throw Error(cat(mesh_path, ": has no UVs, which say where on the pattern a vertex is"));
    const Topology topology = build_topology(mesh.faces, mesh.vertices());
    std::vector<CurvedPlace> places(static_cast<size_t>(mesh.vertices()));
    const Eigen::Vector2d low = mesh.drawn.uv.rowwise().minCoeff().cast<double>();
    const Eigen::Vector2d extent = mesh.drawn.uv.rowwise().maxCoeff().cast<double>() - low;
    if (!(extent.minCoeff() > 0)) throw Error(cat(mesh_path, ": its UVs lie on a line"));
    for (size_t d = 0; d < mesh.drawn.vertex.size(); ++d)
        places[static_cast<size_t>(mesh.drawn.vertex[d])].uv =
            (mesh.drawn.uv.col(static_cast<Eigen::Index>(d)).cast<double>() - low).cwiseQuotient(extent);
    for (const Points& pose : poses_of(mesh, mesh_path, positions)) {
        const std::vector<Mat3> tensors = curvature_tensors(topology, mesh.faces, mesh.rest, pose);
        for (size_t v = 0; v < places.size(); ++v)
            places[v].curvature = std::max(places[v].curvature, sharpest(tensors[v]));
    }
    return places;
}

}  // namespace drape

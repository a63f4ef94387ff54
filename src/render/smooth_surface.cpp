#include "render/smooth_surface.h"

#include <algorithm>
#include <map>

#include "base/assert.h"
#include "mesh/normals.h"
#include "mesh/topology.h"

namespace drape {

namespace {

// Corner triangles first, then the middle one; middle[c] lies opposite corner c.
void split(Faces& into, int f, const Eigen::Vector3i& corner, const Eigen::Vector3i& middle) {
    for (int c = 0; c < 3; ++c) into.col(4 * f + c) << corner[c], middle[(c + 2) % 3], middle[(c + 1) % 3];
    into.col(4 * f + 3) = middle;
}

// Splits the drawn triangles like the simulated ones; a seam's twin edges get twin middles.
DrawnMesh split_drawn(const DrawnMesh& drawn, const Eigen::Matrix3Xi& middle_vertex) {
    DrawnMesh fine;
    fine.vertex = drawn.vertex;
    fine.faces.resize(3, drawn.faces.cols() * 4);
    std::vector<Eigen::Vector2f> uv;
    for (int i = 0; i < drawn.uv.cols(); ++i) uv.emplace_back(drawn.uv.col(i));
    std::map<std::pair<int, int>, int> made;
    for (int f = 0; f < drawn.faces.cols(); ++f) {
        Eigen::Vector3i middle;
        for (int c = 0; c < 3; ++c) {
            const auto ends = std::minmax(drawn.faces((c + 1) % 3, f), drawn.faces((c + 2) % 3, f));
            const auto [place, is_new] = made.try_emplace(ends, static_cast<int>(fine.vertex.size()));
            middle[c] = place->second;
            if (!is_new) continue;
            fine.vertex.push_back(middle_vertex(c, f));
            if (!uv.empty())
                uv.push_back(0.5f *
                             (uv[static_cast<size_t>(ends.first)] + uv[static_cast<size_t>(ends.second)]));
        }
        split(fine.faces, f, drawn.faces.col(f), middle);
    }
    fine.uv.resize(2, static_cast<Eigen::Index>(uv.size()));
    for (size_t i = 0; i < uv.size(); ++i) fine.uv.col(static_cast<Eigen::Index>(i)) = uv[i];
    return fine;
}

// For each border vertex that is no corner, its two neighbours along the border.
std::map<int, std::array<int, 2>> border_neighbours(const Topology& topology, const Points& rest) {
    std::map<int, std::vector<int>> beside;
    for (const Edge& edge : topology.edges) {
        if (edge.face_count != 1) continue;
        beside[edge.vertex[0]].push_back(edge.vertex[1]);
        beside[edge.vertex[1]].push_back(edge.vertex[0]);
    }
    constexpr double corner_cosine = 0.77;  // borders that turn by more than 40 degrees are corners
    std::map<int, std::array<int, 2>> smooth;
    for (const auto& [v, others] : beside) {
        if (others.size() != 2) continue;
        const Vec3 in = rest.col(v) - rest.col(others[0]), out = rest.col(others[1]) - rest.col(v);
        if (in.normalized().dot(out.normalized()) > corner_cosine) smooth[v] = {others[0], others[1]};
    }
    return smooth;
}

}  // namespace

int smoothing_levels(int triangles) {
    return triangles >= 20000 ? 0 : triangles >= 5000 ? 1 : 2;
}

SmoothSurface::SmoothSurface(const Mesh& mesh, const DrawnMesh& drawn, int levels)
    : faces_{mesh.faces}, drawn_(drawn), rest_(mesh.rest) {
    for (const Edge& edge : build_topology(mesh.faces, mesh.vertices()).edges)
        simulated_edges_.push_back(edge.vertex);
    for (int level = 0; level < levels; ++level) refine();
}

void SmoothSurface::refine() {
    const Faces& coarse = faces_.back();
    const int old_vertices = static_cast<int>(rest_.cols());
    const Topology topology = build_topology(coarse, old_vertices);
    const auto edge_count = static_cast<int>(topology.edges.size());

    const auto neighbours = border_neighbours(topology, rest_);
    const auto beyond = [&](int vertex, int other) {
        const auto found = neighbours.find(vertex);
        if (found == neighbours.end()) return -1;
        return found->second[0] == other ? found->second[1] : found->second[0];
    };
    std::vector<Middle> middles;
    std::map<std::array<int, 2>, int> middle_of;
    rest_.conservativeResize(3, old_vertices + edge_count);
    for (int e = 0; e < edge_count; ++e) {
        const Edge& edge = topology.edges[static_cast<size_t>(e)];
        const auto& ends = edge.vertex;
        Middle middle{ends[0], ends[1]};
        if (edge.face_count == 1)
            middle = {ends[0], ends[1], true, beyond(ends[0], ends[1]), beyond(ends[1], ends[0])};
        middles.push_back(middle);
        middle_of[ends] = old_vertices + e;
        rest_.col(old_vertices + e) = 0.5 * (rest_.col(ends[0]) + rest_.col(ends[1]));
    }
    const Eigen::Matrix3Xi middle_vertex = topology.face_edges.array() + old_vertices;
    Faces fine(3, coarse.cols() * 4);
    for (int f = 0; f < coarse.cols(); ++f) split(fine, f, coarse.col(f), middle_vertex.col(f));
    drawn_ = split_drawn(drawn_, middle_vertex);

    std::vector<std::array<int, 2>> halves;
    for (const auto& ends : simulated_edges_) {
        const int middle = middle_of.at({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
        halves.push_back({ends[0], middle});
        halves.push_back({middle, ends[1]});
    }
    simulated_edges_ = std::move(halves);
    faces_.push_back(std::move(fine));
    middles_.push_back(std::move(middles));
}

Points SmoothSurface::positions(In simulated, const Eigen::VectorXd& room) const {
    constexpr double room_share = 0.2;
    DRAPE_ASSERT(middles_.empty() ||
                 simulated.cols() + static_cast<Eigen::Index>(middles_[0].size()) <= rest_.cols());
    DRAPE_ASSERT(room.size() == 0 || room.size() == simulated.cols());
    Points x = simulated;
    Eigen::VectorXd left = room;
    for (size_t level = 0; level < middles_.size(); ++level) {
        const Points normals = vertex_normals(x, faces_[level]);
        const Eigen::Index old_vertices = x.cols();
        x.conservativeResize(3, old_vertices + static_cast<Eigen::Index>(middles_[level].size()));
        if (left.size() > 0) left.conservativeResize(x.cols());
        Eigen::Index next = old_vertices;
        for (const Middle& middle : middles_[level]) {
            const auto a = x.col(middle.a), b = x.col(middle.b);
            const Vec3 d = b - a;
            Vec3 leaves = d, arrives = d;  // tangents at a and b
            if (!middle.border) {
                leaves -= d.dot(normals.col(middle.a)) * normals.col(middle.a);
                arrives -= d.dot(normals.col(middle.b)) * normals.col(middle.b);
            }
            if (middle.before >= 0) leaves = 0.5 * (b - x.col(middle.before));
            if (middle.after >= 0) arrives = 0.5 * (x.col(middle.after) - a);
            Vec3 swell = (leaves - arrives) / 8;
            if (left.size() > 0) {
                left[next] = std::min(left[middle.a], left[middle.b]);
                const double most = room_share * left[next], length = swell.norm();
                if (length > most) swell *= most / length;
            }
            x.col(next++) = 0.5 * (a + b) + swell;
        }
    }
    return x;
}

Eigen::VectorXf SmoothSurface::spread(const Eigen::VectorXf& simulated) const {
    Eigen::VectorXf value = simulated;
    for (const auto& middles : middles_) {
        Eigen::Index next = value.size();
        value.conservativeResize(next + static_cast<Eigen::Index>(middles.size()));
        for (const Middle& middle : middles) value[next++] = 0.5f * (value[middle.a] + value[middle.b]);
    }
    return value;
}

}  // namespace drape

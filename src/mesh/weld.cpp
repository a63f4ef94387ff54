#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "base/assert.h"
#include "base/hash.h"

namespace drape {

namespace {

// A triangle thinner than this share of its longest side is a line: single precision, which most mesh files
// hold, cannot tell the two apart.
constexpr double thinnest = 1e-6;

size_t at(int index) {
    return static_cast<size_t>(index);
}

struct ByBytes {
    std::size_t operator()(const std::array<double, 3>& p) const { return hash_bytes(p.data(), sizeof p); }
};

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double longest =
        std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    return ((b - a) / longest).cross((c - a) / longest).norm() > thinnest;
}

// Neighbours of every vertex along the sides of triangles, as one array with a start per vertex.
struct Neighbours {
    std::vector<int> start, list;

    Neighbours(const Faces& faces, int vertices) : start(at(vertices) + 1, 0) {
        for (int f = 0; f < faces.cols(); ++f)
            for (int c = 0; c < 3; ++c) start[at(faces(c, f)) + 1] += 2;
        std::partial_sum(start.begin(), start.end(), start.begin());
        list.resize(at(start.back()));
        std::vector<int> next(start.begin(), start.end() - 1);
        for (int f = 0; f < faces.cols(); ++f)
            for (int c = 0; c < 3; ++c)
                for (int d = 1; d < 3; ++d) list[at(next[at(faces(c, f))]++)] = faces((c + d) % 3, f);
    }
};

// Appends to `order` the piece that holds `seed`, breadth first; `visited` gets `mark` along the way.
void walk(const Neighbours& neighbours, int seed, int mark, std::vector<int>& visited,
          std::vector<int>& order) {
    size_t next = order.size();
    order.push_back(seed);
    visited[at(seed)] = mark;
    for (; next < order.size(); ++next) {
        const int v = order[next];
        for (int i = neighbours.start[at(v)]; i < neighbours.start[at(v) + 1]; ++i) {
            const int w = neighbours.list[at(i)];
            if (visited[at(w)] == mark) continue;
            visited[at(w)] = mark;
            order.push_back(w);
        }
    }
}

// The used vertices in their new order. The first walk over a piece ends at its far end; the second starts
// there, so that the front stays as short as the piece is narrow.
std::vector<int> local_order(const Faces& faces, int vertices) {
    const Neighbours neighbours(faces, vertices);
    std::vector<int> visited(at(vertices), 0), order;
    for (int v = 0; v < vertices; ++v) {
        if (visited[at(v)] || neighbours.start[at(v)] == neighbours.start[at(v) + 1]) continue;
        const size_t begin = order.size();
        walk(neighbours, v, 1, visited, order);
        const int far_end = order.back();
        order.resize(begin);
        walk(neighbours, far_end, 2, visited, order);
    }
    return order;
}

// The drawn vertices of each simulated one are its distinct UVs, in the order its triangles ask for them.
DrawnMesh draw_with(const Eigen::Matrix2Xf& corner_uv, const std::vector<int>& file_face, const Faces& faces,
                    int vertices) {
    DrawnMesh drawn;
    drawn.faces = faces;
    std::vector<std::vector<Eigen::Vector2f>> uvs(at(vertices));
    if (corner_uv.cols() == 0) {
        drawn.vertex.resize(at(vertices));
        std::iota(drawn.vertex.begin(), drawn.vertex.end(), 0);
        return drawn;
    }
    // first which of its vertex's UVs each corner has, then where that vertex's drawn ones begin
    for (int f = 0; f < faces.cols(); ++f) {
        for (int c = 0; c < 3; ++c) {
            auto& here = uvs[at(faces(c, f))];
            const Eigen::Vector2f uv = corner_uv.col(3 * file_face[at(f)] + c);
            const auto found = std::find(here.begin(), here.end(), uv);
            drawn.faces(c, f) = static_cast<int>(found - here.begin());
            if (found == here.end()) here.push_back(uv);
        }
    }
    std::vector<int> begin(at(vertices));
    for (int v = 0; v < vertices; ++v) {
        begin[at(v)] = static_cast<int>(drawn.vertex.size());
        drawn.vertex.insert(drawn.vertex.end(), uvs[at(v)].size(), v);
    }
    drawn.uv.resize(2, static_cast<Eigen::Index>(drawn.vertex.size()));
    Eigen::Index column = 0;
    for (const auto& here : uvs)
        for (const Eigen::Vector2f& uv : here) drawn.uv.col(column++) = uv;
    for (int f = 0; f < faces.cols(); ++f)
        for (int c = 0; c < 3; ++c) drawn.faces(c, f) += begin[at(faces(c, f))];
    return drawn;
}

}  // namespace

std::vector<int> first_in_place(In points) {
    std::unordered_map<std::array<double, 3>, int, ByBytes> first;
    first.reserve(at(static_cast<int>(points.cols())));
    std::vector<int> place(at(static_cast<int>(points.cols())));
    for (int i = 0; i < points.cols(); ++i) {
        const Vec3 p = points.col(i).array() + 0.0;  // -0 becomes 0: equal numbers need equal bytes
        place[at(i)] = first.try_emplace({p.x(), p.y(), p.z()}, i).first->second;
    }
    return place;
}

WeldResult weld(const TriangleSoup& soup) {
    DRAPE_ASSERT(soup.corner_uv.cols() == 0 || soup.corner_uv.cols() == 3 * soup.faces.cols());
    const int file_vertices = static_cast<int>(soup.positions.cols());
    const std::vector<int> place = first_in_place(soup.positions);

    // keep the triangles that have an area, on their welded corners
    WeldResult result;
    Faces kept(3, soup.faces.cols());
    std::vector<int> file_face;
    for (int f = 0; f < soup.faces.cols(); ++f) {
        const int a = place[at(soup.faces(0, f))], b = place[at(soup.faces(1, f))],
                  c = place[at(soup.faces(2, f))];
        const auto& x = soup.positions;
        if (a == b || b == c || c == a || !has_area(x.col(a), x.col(b), x.col(c))) continue;
        kept.col(static_cast<Eigen::Index>(file_face.size())) = Eigen::Vector3i(a, b, c);
        file_face.push_back(f);
    }
    const auto triangles = static_cast<Eigen::Index>(file_face.size());
    kept.conservativeResize(3, triangles);
    result.dropped_zero_area = static_cast<int>(soup.faces.cols() - triangles);

    // number the vertices along the surface
    Mesh& mesh = result.mesh;
    const std::vector<int> order = local_order(kept, file_vertices);
    std::vector<int> number(at(file_vertices), -1);
    mesh.rest.resize(3, static_cast<Eigen::Index>(order.size()));
    for (int v = 0; v < mesh.vertices(); ++v) {
        number[at(order[at(v)])] = v;
        mesh.rest.col(v) = soup.positions.col(order[at(v)]);
    }
    for (int i = 0; i < file_vertices; ++i) mesh.file_vertex.push_back(number[at(place[at(i)])]);
    result.unused_vertices =
        static_cast<int>(std::count(mesh.file_vertex.begin(), mesh.file_vertex.end(), -1));
    mesh.unused.resize(3, result.unused_vertices);
    for (int i = 0, unused = 0; i < file_vertices; ++i)
        if (mesh.file_vertex[at(i)] < 0) mesh.unused.col(unused++) = soup.positions.col(i);

    // triangles in the order of their first vertex
    for (int& corner : kept.reshaped()) corner = number[at(corner)];
    std::vector<int> turn(file_face.size());
    std::iota(turn.begin(), turn.end(), 0);
    std::stable_sort(turn.begin(), turn.end(),
                     [&](int f, int g) { return kept.col(f).minCoeff() < kept.col(g).minCoeff(); });
    mesh.faces.resize(3, triangles);
    std::vector<int> face_in_file(file_face.size());
    for (Eigen::Index f = 0; f < triangles; ++f) {
        mesh.faces.col(f) = kept.col(turn[static_cast<size_t>(f)]);
        face_in_file[static_cast<size_t>(f)] = file_face[at(turn[static_cast<size_t>(f)])];
    }
    mesh.drawn = draw_with(soup.corner_uv, face_in_file, mesh.faces, mesh.vertices());
    return result;
}

}  // namespace drape

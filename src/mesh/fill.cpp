#include "mesh/fill.h"

#include <array>
#include <cmath>
#include <set>

#include "base/error.h"
#include "mesh/irregular_mesh.h"
#include "mesh/topology.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr int most_rounds = 8;
constexpr double area_rounding = 1e-9;  // of an area

using Pair = std::array<double, 4>;  // two places

Pair in_order(const Vec2& a, const Vec2& b) {
    const bool swap = a.x() != b.x() ? b.x() < a.x() : b.y() < a.y();
    const Vec2 &p = swap ? b : a, &q = swap ? a : b;
    return {p.x(), p.y(), q.x(), q.y()};
}

struct Border {
    std::set<Pair> edges;
    double area = 0;  // of the mesh
};

Border border_of(const Mesh& mesh) {
    Border border;
    const auto place = [&](int v) { return Vec2(mesh.rest(0, v), mesh.rest(2, v)); };
    for (const Edge& edge : build_topology(mesh.faces, mesh.vertices()).edges)
        if (edge.face_count == 1) border.edges.insert(in_order(place(edge.vertex[0]), place(edge.vertex[1])));
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Vec3 a = mesh.rest.col(mesh.faces(0, f));
        border.area +=
            (mesh.rest.col(mesh.faces(1, f)) - a).cross(mesh.rest.col(mesh.faces(2, f)) - a).norm() / 2;
    }
    return border;
}

}  // namespace

Mesh fill(const Outline& outline, const SizeField& edge_length,
          const std::function<Mesh(const std::vector<Loop>&)>& make) {
    std::vector<Loop> loops = border_points(outline, edge_length);
    for (int round = 0; round < most_rounds; ++round) {
        Mesh mesh;
        try {
            mesh = make(loops);
        } catch (const Error&) {
            break;  // points so near to a line of others that they cannot be joined
        }
        const Border border = border_of(mesh);
        size_t sides = 0, unjoined = 0;
        for (size_t k = 0; k < loops.size(); ++k) {
            sides += loops[k].size();
            for (size_t i = loops[k].size(); i-- > 0;) {
                const Vec2 a = loops[k][i], b = loops[k][(i + 1) % loops[k].size()];
                if (border.edges.count(in_order(a, b)) > 0) continue;
                split(outline.curves[k], loops[k], i);
                ++unjoined;
            }
        }
        const double area = area_between(loops);
        if (unjoined == 0 && border.edges.size() == sides &&
            std::abs(border.area - area) <= area_rounding * area)
            return mesh;
        if (unjoined == 0) break;
    }
    const Vec2 middle = (outline.low() + outline.high()) / 2;
    throw Error(cat("the outline is too narrow or too sharp for edges of ", edge_length(middle),
                    " m (more divisions make them shorter)"));
}

Mesh irregular_within(const Outline& outline, const SizeField& edge_length, std::uint64_t seed) {
    return fill(outline, edge_length, [&](const std::vector<Loop>& loops) {
        std::vector<Vec2> fixed;
        for (const Loop& loop : loops) fixed.insert(fixed.end(), loop.begin(), loop.end());
        const Inside inside(loops);
        return irregular_mesh(
            fixed, [&](const Vec2& p) { return inside(p); }, edge_length, seed);
    });
}

}  // namespace drape

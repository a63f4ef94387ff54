#include "force/unfolding.h"

namespace drape {

namespace {

struct Apex {
    double along, away;  // of the edge's first vertex and of its line [m]
};

Apex apex_over(const Mesh& mesh, int i, int j, int apex) {
    const Vec3 edge = mesh.rest.col(j) - mesh.rest.col(i), leg = mesh.rest.col(apex) - mesh.rest.col(i);
    return {leg.dot(edge) / edge.norm(), edge.cross(leg).norm() / edge.norm()};
}

}  // namespace

Unfolding::Unfolding(const Mesh& mesh, const Topology& topology, const Edge& edge)
    : mesh_(mesh),
      topology_(topology),
      front_{edge.face[0], edge.face[1]},
      seen_{edge.face[0], edge.face[1]} {
    const auto [i, j] = edge.vertex;
    const double half = (mesh.rest.col(j) - mesh.rest.col(i)).norm() / 2;
    const Apex below = apex_over(mesh, i, j, edge.opposite[0]),
               above = apex_over(mesh, i, j, edge.opposite[1]);
    points_ = {{i, {-half, 0}},
               {j, {half, 0}},
               {edge.opposite[0], {below.along - half, -below.away}},
               {edge.opposite[1], {above.along - half, above.away}}};
}

bool Unfolding::grow() {
    std::vector<int> next;
    for (const int f : front_) {
        for (int c = 0; c < 3; ++c) {
            const int across = neighbour_across(topology_, f, c);
            if (across < 0 || contains(across)) continue;
            seen_.push_back(across);
            next.push_back(across);
            place_far_corner(f, c, across);
        }
    }
    front_ = std::move(next);
    return !front_.empty();
}

bool Unfolding::contains(int triangle) const {
    for (const int t : seen_)
        if (t == triangle) return true;
    return false;
}

const Unfolding::Placed* Unfolding::find(int vertex) const {
    for (const Placed& p : points_)
        if (p.vertex == vertex) return &p;
    return nullptr;
}

// The corner of `across` that is not on the shared edge goes to the far side of it, at its rest distances.
void Unfolding::place_far_corner(int face, int corner, int across) {
    const int i = mesh_.faces((corner + 1) % 3, face), j = mesh_.faces((corner + 2) % 3, face);
    int far = -1;
    for (int k = 0; k < 3; ++k)
        if (mesh_.faces(k, across) != i && mesh_.faces(k, across) != j) far = mesh_.faces(k, across);
    if (far < 0 || find(far)) return;  // reached another way round already
    const Placed *p = find(i), *q = find(j), *inner = find(mesh_.faces(corner, face));
    if (!p || !q || !inner) return;
    const Apex apex = apex_over(mesh_, i, j, far);
    const Eigen::Vector2d edge = (q->at - p->at).normalized();
    Eigen::Vector2d side(-edge.y(), edge.x());
    if (side.dot(inner->at - p->at) > 0) side = -side;
    points_.push_back({far, p->at + apex.along * edge + apex.away * side});
}

}  // namespace drape

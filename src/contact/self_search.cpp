#include "contact/self_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape {

namespace {

constexpr double same_place = 2;     // times the thickness: nearer pieces at rest are one place
constexpr double full_angle = 0.01;  // square of the sine from which edges have their whole potential
constexpr double triangle_share =
    0.25;                            // of a vertex's area: both sides' vertices and edges make up the whole
constexpr double edge_share = 0.25;  // of two edges' area, some two of which lie across each
constexpr double mesh_share = 0.5;   // of a vertex's area against a mesh, which may have no vertices nearby
constexpr size_t most_candidates = 4096;                       // that wait to be looked at
constexpr double most_cells = 1 << 20, most_cells_a_box = 64;  // of the grid and of a box, along a side

std::uint64_t mixed(std::uint64_t cell) {
    cell ^= cell >> 31;
    cell *= 0x9e3779b97f4a7c15u;
    return cell ^ (cell >> 29);
}

bool shares(const int* vertex, int v) {
    return vertex[0] == v || vertex[1] == v || vertex[2] == v;
}

}  // namespace

SelfSearch::SelfSearch(const Model& model, std::vector<double> thickness, int meshes)
    : rest_(3, model.vertices()),
      cloth_(static_cast<size_t>(model.vertices())),
      part_(static_cast<size_t>(model.vertices())),
      area_(model.vertices()),
      inverse_mass_(model.inverse_mass),
      thickness_(std::move(thickness)),
      cloths_(static_cast<int>(model.cloths.size())),
      first_mesh_(cloths_ - meshes) {
    number_faces(model);
}

void SelfSearch::number_faces(const Model& model) {
    int parts = 0;
    double length = 0;
    size_t edges_of_cloth = 0;
    for (int c = 0; c < cloths_; ++c) {
        const Cloth& cloth = model.cloths[static_cast<size_t>(c)];
        rest_.middleCols(cloth.first, cloth.vertices()) = cloth.mesh.rest;
        area_.segment(cloth.first, cloth.vertices()) = cloth.area;
        for (int v = 0; v < cloth.vertices(); ++v) {
            cloth_[static_cast<size_t>(cloth.first + v)] = c;
            part_[static_cast<size_t>(cloth.first + v)] =
                parts + cloth.topology.component[static_cast<size_t>(v)];
        }
        parts += cloth.topology.components;
        if (!cloth.self_contact) continue;

        std::vector<bool> vertex_owned(static_cast<size_t>(cloth.vertices()));
        std::vector<std::vector<int>> edges_of(static_cast<size_t>(cloth.mesh.triangles()));
        const std::vector<Edge>& edges = cloth.topology.edges;
        for (size_t e = 0; e < edges.size(); ++e)
            edges_of[static_cast<size_t>(edges[e].face[0])].push_back(int(e));
        for (int f = 0; f < cloth.mesh.triangles(); ++f) {
            Face face{{}, static_cast<int>(owned_edges_.size()), 0, 0, c};
            for (int k = 0; k < 3; ++k) {
                const int v = cloth.mesh.faces(k, f);
                face.vertex[k] = cloth.first + v;
                if (!vertex_owned[static_cast<size_t>(v)]) face.owned |= 1 << k;
                vertex_owned[static_cast<size_t>(v)] = true;
            }
            for (const int e : edges_of[static_cast<size_t>(f)]) {
                const Edge& edge = edges[static_cast<size_t>(e)];
                double area = 0;  // a third of each triangle's goes to each of its edges
                for (int side = 0; side < 2; ++side) {
                    if (edge.face[static_cast<size_t>(side)] < 0) continue;
                    const auto corner = cloth.mesh.faces.col(edge.face[static_cast<size_t>(side)]);
                    const Vec3 a = cloth.mesh.rest.col(corner[0]);
                    area += (cloth.mesh.rest.col(corner[1]) - a)
                                .cross(cloth.mesh.rest.col(corner[2]) - a)
                                .norm() /
                            6;
                }
                const int from = cloth.first + edge.vertex[0], to = cloth.first + edge.vertex[1];
                owned_edges_.push_back({from, to});
                edge_area_.push_back(area);
                if (c < first_mesh_) {
                    length += (rest_.col(to) - rest_.col(from)).norm();
                    ++edges_of_cloth;
                }
            }
            face.edges = static_cast<int>(owned_edges_.size()) - face.first_edge;
            faces_.push_back(face);
        }
    }
    if (edges_of_cloth > 0) mean_edge_ = length / static_cast<double>(edges_of_cloth);
}

bool SelfSearch::make_boxes(In x, double margin) {
    boxes_.resize(faces_.size());
    double sum = 0, longest = 0, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    std::fill_n(origin_, 3, INFINITY);
    for (size_t f = 0; f < faces_.size(); ++f) {
        const int* vertex = faces_[f].vertex;
        Box& box = boxes_[f];
        double extent = 0;
        for (int k = 0; k < 3; ++k) {
            const double a = x(k, vertex[0]), b = x(k, vertex[1]), c = x(k, vertex[2]);
            box.low[k] = std::min(a, std::min(b, c)) - margin;
            box.high[k] = std::max(a, std::max(b, c)) + margin;
            extent = std::max(extent, box.high[k] - box.low[k]);
            origin_[k] = std::min(origin_[k], box.low[k]);
            high[k] = std::max(high[k], box.high[k]);
        }
        sum += extent;
        longest = std::max(longest, extent);
    }
    // a box meets few cells and a cell few boxes
    double room = 0;
    for (int k = 0; k < 3; ++k) room = std::max(room, high[k] - origin_[k]);
    cell_ =
        std::max({sum / static_cast<double>(faces_.size()), longest / most_cells_a_box, room / most_cells});
    return std::isfinite(sum) && std::isfinite(room);
}

std::uint64_t SelfSearch::cell_of(const double* at) const {
    std::uint64_t cell = 0;
    for (int k = 0; k < 3; ++k) cell = cell << 21 | static_cast<std::uint64_t>((at[k] - origin_[k]) / cell_);
    return cell;
}

template <class Visit>
void SelfSearch::each_cell(const Box& box, Visit visit) const {
    std::uint64_t low[3], high[3];
    for (int k = 0; k < 3; ++k) {
        low[k] = static_cast<std::uint64_t>((box.low[k] - origin_[k]) / cell_);
        high[k] = static_cast<std::uint64_t>((box.high[k] - origin_[k]) / cell_);
    }
    for (std::uint64_t i = low[0]; i <= high[0]; ++i)
        for (std::uint64_t j = low[1]; j <= high[1]; ++j)
            for (std::uint64_t k = low[2]; k <= high[2]; ++k) visit(i << 42 | j << 21 | k);
}

void SelfSearch::fill_grid() {
    size_t buckets = 1;
    while (buckets < 4 * faces_.size()) buckets *= 2;
    first_.assign(buckets + 1, 0);
    for (const Box& box : boxes_)
        each_cell(box, [&](std::uint64_t cell) { ++first_[mixed(cell) & (buckets - 1)]; });
    // from counts to where each bucket ends; filling backwards leaves where it begins
    for (size_t b = 1; b <= buckets; ++b) first_[b] += first_[b - 1];
    entries_.resize(first_[buckets]);
    for (size_t f = faces_.size(); f-- > 0;)
        each_cell(boxes_[f], [&](std::uint64_t cell) {
            entries_[--first_[mixed(cell) & (buckets - 1)]] = {cell, static_cast<int>(f)};
        });
}

void SelfSearch::find(In x, double reach, std::vector<SelfPair>& pairs) {
    pairs.clear();
    if (faces_.empty()) return;
    if (!x.allFinite() || !make_boxes(x, reach / 2)) return;  // motion that ran away
    fill_grid();
    edge_candidates_.clear();
    vertex_candidates_.clear();
    for (size_t b = 0; b + 1 < first_.size(); ++b) {
        if (first_[b + 1] - first_[b] < 2) continue;
        look_into(b);
        if (edge_candidates_.size() + vertex_candidates_.size() > most_candidates) sift(x, reach, pairs);
    }
    sift(x, reach, pairs);
    std::sort(pairs.begin(), pairs.end(), [](const SelfPair& a, const SelfPair& b) {
        return std::lexicographical_compare(a.vertex, a.vertex + 4, b.vertex, b.vertex + 4) ||
               (std::equal(a.vertex, a.vertex + 4, b.vertex) && a.edges < b.edges);
    });
}

void SelfSearch::look_into(size_t bucket) {
    const Entry* entries = &entries_[first_[bucket]];
    bucket_boxes_.clear();
    for (std::uint32_t i = 0; i < first_[bucket + 1] - first_[bucket]; ++i) {
        const Box& box = boxes_[static_cast<size_t>(entries[i].face)];
        bucket_boxes_.add(box.low, box.high);
    }
    meeting_.clear();
    bucket_boxes_.add_meeting(meeting_);
    for (const auto& [i, j] : meeting_) {
        const Entry &entry = entries[i], &other = entries[j];
        if (other.cell != entry.cell) continue;
        const Box &box = boxes_[static_cast<size_t>(entry.face)],
                  &beside = boxes_[static_cast<size_t>(other.face)];
        const double corner[3] = {std::max(box.low[0], beside.low[0]), std::max(box.low[1], beside.low[1]),
                                  std::max(box.low[2], beside.low[2])};
        if (cell_of(corner) != entry.cell) continue;
        const Face &one = faces_[static_cast<size_t>(entry.face)],
                   &two = faces_[static_cast<size_t>(other.face)];
        if (!meet(one.cloth, two.cloth)) continue;
        add_vertices(one, two);
        add_vertices(two, one);
        add_edges(one, two);
    }
}

void SelfSearch::add_vertices(const Face& face, const Face& other) {
    for (int k = 0; k < 3; ++k) {
        const int v = face.vertex[k];
        if (!(face.owned & 1 << k) || shares(other.vertex, v)) continue;
        vertex_candidates_.push_back({{v, other.vertex[0], other.vertex[1], other.vertex[2]}, 0, 0});
    }
}

void SelfSearch::add_edges(const Face& face, const Face& other) {
    for (int i = face.first_edge; i < face.first_edge + face.edges; ++i) {
        for (int j = other.first_edge; j < other.first_edge + other.edges; ++j) {
            const auto &u = owned_edges_[static_cast<size_t>(i)], &v = owned_edges_[static_cast<size_t>(j)];
            if (u[0] == v[0] || u[0] == v[1] || u[1] == v[0] || u[1] == v[1]) continue;
            if (u < v)
                edge_candidates_.push_back({{u[0], u[1], v[0], v[1]}, i, j});
            else
                edge_candidates_.push_back({{v[0], v[1], u[0], u[1]}, j, i});
        }
    }
}

void SelfSearch::sift(In x, double reach, std::vector<SelfPair>& pairs) {
    const auto layers_at = [&](int v, int beside) {
        return layers_of(cloth_[static_cast<size_t>(v)], cloth_[static_cast<size_t>(beside)], cloths_);
    };
    vertex_candidates_.resize(sift_triangles(x.data(), reach, vertex_candidates_));
    for (const Candidate& near : vertex_candidates_) {
        const int* v = near.vertex;
        SelfPair pair{{v[0], v[1], v[2], v[3]}, layers_at(v[0], v[1]), false, vertex_area(v), 0};
        std::sort(pair.vertex + 1, pair.vertex + 4);
        keep_if_near(x, pair, reach, pairs);
    }
    edge_candidates_.resize(sift_edges(x.data(), reach, edge_candidates_));
    for (const Candidate& near : edge_candidates_) {
        const int* v = near.vertex;
        keep_if_near(x, {{v[0], v[1], v[2], v[3]}, layers_at(v[0], v[2]), true, edges_area(near), 0}, reach,
                     pairs);
    }
    vertex_candidates_.clear();
    edge_candidates_.clear();
}

// A mesh's pieces may be far larger than the cloth's: no pair stands for more than the cloth has there.
double SelfSearch::vertex_area(const int* vertex) const {
    if (is_mesh(vertex[1])) return mesh_share * area_[vertex[0]];
    if (!is_mesh(vertex[0])) return triangle_share * area_[vertex[0]];
    const double beside = (area_[vertex[1]] + area_[vertex[2]] + area_[vertex[3]]) / 3;
    return triangle_share * std::min(area_[vertex[0]], beside);
}

double SelfSearch::edges_area(const Candidate& edges) const {
    const double one = edge_area_[static_cast<size_t>(edges.first)],
                 two = edge_area_[static_cast<size_t>(edges.second)];
    if (is_mesh(edges.vertex[0]) || is_mesh(edges.vertex[2])) return edge_share * std::min(one, two);
    return edge_share * (one + two) / 2;
}

void SelfSearch::keep_if_near(In x, SelfPair pair, double reach, std::vector<SelfPair>& pairs) const {
    const Nearest nearest = nearest_of(pair, points_of(pair, x.data()));
    if (!(nearest.distance < reach)) return;
    pair.apart = nearest.normal;
    bool moves = false;
    for (const int v : pair.vertex) moves = moves || inverse_mass_[v] > 0;
    if (!moves) return;
    const PairPoints rest = points_of(pair, rest_.data());
    const auto part = [&](int i) { return part_[static_cast<size_t>(pair.vertex[i])]; };
    if (part(0) == part(3) &&
        nearest_of(pair, rest).distance < same_place * thickness_[static_cast<size_t>(pair.layers)])
        return;
    if (pair.edges)
        pair.fading = full_angle * (rest.col(1) - rest.col(0)).squaredNorm() *
                      (rest.col(3) - rest.col(2)).squaredNorm();
    pairs.push_back(pair);
}

}  // namespace drape

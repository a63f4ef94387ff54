#include "mesh/cut_pattern.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "mesh/delaunay.h"
#include "mesh/fill.h"
#include "mesh/irregular_mesh.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

// Vertices of the grid keep off points on the outline by this share of an edge: over sqrt(1/2), so that none
// comes between two neighbours there.
constexpr double clearance = 0.72;

// Points in square bins.
class Bins {
public:
    Bins(const std::vector<Loop>& loops, double side) : side_(side) {
        for (const Loop& loop : loops)
            for (const Vec2& p : loop) bins_[key(column(p.x()), column(p.y()))].push_back(p);
    }
    bool any_within(const Vec2& p, double distance) const {
        for (long i = column(p.x() - distance); i <= column(p.x() + distance); ++i)
            for (long j = column(p.y() - distance); j <= column(p.y() + distance); ++j)
                if (const auto bin = bins_.find(key(i, j)); bin != bins_.end())
                    for (const Vec2& q : bin->second)
                        if ((p - q).squaredNorm() <= distance * distance) return true;
        return false;
    }

private:
    long column(double x) const { return static_cast<long>(std::floor(x / side_)); }
    static std::uint64_t key(long i, long j) {
        return (static_cast<std::uint64_t>(i) << 32) ^ (static_cast<std::uint64_t>(j) & 0xffffffffU);
    }
    double side_;
    std::unordered_map<std::uint64_t, std::vector<Vec2>> bins_;
};

Vec2 in_plane(const Mesh& grid, int v) {
    return {grid.rest(0, v), grid.rest(2, v)};
}

// The sides of a cell: edges that one of its triangles has alone.
std::vector<std::array<int, 2>> sides_of(const Mesh& grid, int first, int cell) {
    std::vector<std::array<int, 2>> sides;
    for (int f = first; f < first + cell; ++f) {
        for (int c = 0; c < 3; ++c) {
            const std::array side{grid.faces(c, f), grid.faces((c + 1) % 3, f)};
            const auto twin = std::find(sides.begin(), sides.end(), std::array{side[1], side[0]});
            if (twin == sides.end())
                sides.push_back(side);
            else
                sides.erase(twin);
        }
    }
    return sides;
}

// What of the grid is used.
struct Core {
    std::vector<int> faces;                  // of whole cells
    std::vector<std::pair<Vec2, Vec2>> rim;  // the sides that one of them has alone
    std::vector<int> loose;                  // vertices on the rim, and those in no whole cell
};

Core find_core(const Mesh& grid, int cell, const std::vector<Loop>& loops, double edge) {
    const Inside inside(loops);
    const Bins border(loops, edge);
    std::vector<char> kept(static_cast<size_t>(grid.vertices()));
    for (int v = 0; v < grid.vertices(); ++v) {
        const Vec2 p = in_plane(grid, v);
        kept[static_cast<size_t>(v)] = inside(p) && !border.any_within(p, clearance * edge);
    }
    Core core;
    std::map<std::array<int, 2>, bool> rim;  // sides of whole cells that have no other beside them
    std::vector<char> corner(kept.size(), 0), whole(kept.size(), 0);
    for (int first = 0; first < grid.triangles(); first += cell) {
        const auto sides = sides_of(grid, first, cell);
        bool fits = true;
        for (int f = first; f < first + cell; ++f)
            for (int c = 0; c < 3; ++c) fits = fits && kept[static_cast<size_t>(grid.faces(c, f))];
        // an edge whose circle holds no other point is one of the Delaunay triangulation
        for (const auto& [a, b] : sides) {
            corner[static_cast<size_t>(a)] = 1;
            const Vec2 p = in_plane(grid, a), q = in_plane(grid, b);
            fits = fits && !border.any_within((p + q) / 2, (p - q).norm() / 2);
        }
        if (!fits) continue;
        for (int f = first; f < first + cell; ++f) {
            core.faces.push_back(f);
            for (int c = 0; c < 3; ++c) whole[static_cast<size_t>(grid.faces(c, f))] = 1;
        }
        for (const auto& [a, b] : sides)
            if (const auto twin = rim.find({b, a}); twin != rim.end())
                rim.erase(twin);
            else
                rim[{a, b}] = true;
    }
    std::vector<char> on_rim(kept.size(), 0);
    for (const auto& [side, alone] : rim) {
        core.rim.emplace_back(in_plane(grid, side[0]), in_plane(grid, side[1]));
        for (const int v : side) on_rim[static_cast<size_t>(v)] = 1;
    }
    for (int v = 0; v < grid.vertices(); ++v) {
        const auto i = static_cast<size_t>(v);
        if (on_rim[i] || (kept[i] && corner[i] && !whole[i])) core.loose.push_back(v);
    }
    return core;
}

Mesh join(const Mesh& grid, const Core& core, const std::vector<Loop>& loops, double edge) {
    // points of the seam: the outline's, then the grid's
    std::vector<Vec2> points;
    for (const Loop& loop : loops) points.insert(points.end(), loop.begin(), loop.end());
    std::vector<int> place(static_cast<size_t>(grid.vertices()), -1);
    for (const int v : core.loose) {
        place[static_cast<size_t>(v)] = static_cast<int>(points.size());
        points.push_back(in_plane(grid, v));
    }
    const Eigen::Matrix2Xd seam = columns_of(points);
    const Faces between = delaunay(seam);
    const Inside inside(loops), in_core(core.rim);
    std::vector<Eigen::Vector3i> faces;
    for (Eigen::Index f = 0; f < between.cols(); ++f) {
        const Vec2 centre = (seam.col(between(0, f)) + seam.col(between(1, f)) + seam.col(between(2, f))) / 3;
        if (inside(centre) && !in_core(centre)) faces.emplace_back(between.col(f));
    }
    for (const int f : core.faces) {
        Eigen::Vector3i face;
        for (int c = 0; c < 3; ++c) {
            int& at = place[static_cast<size_t>(grid.faces(c, f))];
            if (at < 0) {
                at = static_cast<int>(points.size());
                points.push_back(in_plane(grid, grid.faces(c, f)));
            }
            face[c] = at;
        }
        // seen from above, z points down the page
        std::swap(face[1], face[2]);
        faces.push_back(face);
    }
    Faces all(3, static_cast<Eigen::Index>(faces.size()));
    for (size_t f = 0; f < faces.size(); ++f) all.col(static_cast<Eigen::Index>(f)) = faces[f];
    return flat_sheet(columns_of(points), all, edge);
}

}  // namespace

Mesh cut_pattern(const Mesh& grid, int cell, const Outline& outline, double edge) {
    return fill(
        outline, [edge](const Vec2&) { return edge; },
        [&](const std::vector<Loop>& loops) {
            return join(grid, find_core(grid, cell, loops, edge), loops, edge);
        });
}

}  // namespace drape

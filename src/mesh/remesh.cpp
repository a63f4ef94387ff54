#include "mesh/remesh.h"

#include <algorithm>
#include <cmath>

#include "mesh/flatten.h"
#include "mesh/quality.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

// Finds the triangle that a place of the plane lies in.
class Finder {
public:
    Finder(const Faces& faces, const Eigen::Matrix2Xd& place)
        : faces_(faces), place_(place), low_(place.rowwise().minCoeff()) {
        const Vec2 extent = place.rowwise().maxCoeff() - low_;
        cell_ = std::sqrt(extent.prod() / static_cast<double>(faces.cols()));
        columns_ = static_cast<int>(extent.x() / cell_) + 1;
        rows_ = static_cast<int>(extent.y() / cell_) + 1;
        bins_.resize(static_cast<size_t>(columns_) * static_cast<size_t>(rows_));
        for (Eigen::Index f = 0; f < faces.cols(); ++f) {
            const Eigen::Matrix<double, 2, 3> corner = place(Eigen::all, faces.col(f));
            const Vec2 from = corner.rowwise().minCoeff(), to = corner.rowwise().maxCoeff();
            for (int j = row(from); j <= row(to); ++j)
                for (int i = column(from); i <= column(to); ++i) bin(i, j).push_back(f);
        }
    }

    struct Found {
        Eigen::Index face = 0;
        Vec3 share = Vec3::Zero();  // of its corners
    };

    // that in which the place lies deepest, or least outside
    Found operator()(const Vec2& p) {
        Found found;
        double depth = -INFINITY;
        for (int around = 1; depth == -INFINITY; around *= 2)
            for (int j = std::max(row(p) - around, 0); j <= std::min(row(p) + around, rows_ - 1); ++j)
                for (int i = std::max(column(p) - around, 0); i <= std::min(column(p) + around, columns_ - 1);
                     ++i)
                    for (const Eigen::Index f : bin(i, j))
                        if (const Vec3 share = shares(f, p); share.minCoeff() > depth) {
                            depth = share.minCoeff();
                            found = {f, share};
                        }
        return found;
    }

private:
    Vec3 shares(Eigen::Index f, const Vec2& p) const {
        const Vec2 a = place_.col(faces_(0, f)), b = place_.col(faces_(1, f)), c = place_.col(faces_(2, f));
        const auto left = [](const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); };
        const double all = left(b - a, c - a);
        const double second = left(p - a, c - a) / all, third = left(b - a, p - a) / all;
        return {1 - second - third, second, third};
    }
    int column(const Vec2& p) const {
        return std::clamp(static_cast<int>((p.x() - low_.x()) / cell_), 0, columns_ - 1);
    }
    int row(const Vec2& p) const {
        return std::clamp(static_cast<int>((p.y() - low_.y()) / cell_), 0, rows_ - 1);
    }
    std::vector<Eigen::Index>& bin(int i, int j) {
        return bins_[static_cast<size_t>(j) * static_cast<size_t>(columns_) + static_cast<size_t>(i)];
    }

    const Faces& faces_;
    const Eigen::Matrix2Xd& place_;
    Vec2 low_;
    double cell_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::vector<Eigen::Index>> bins_;
};

// Corners of the old mesh by drawn vertex or by simulated one, in their shares.
template <class Columns>
auto between(const Columns& columns, const Faces& faces, const Finder::Found& found) {
    using Column = Eigen::Matrix<double, Columns::RowsAtCompileTime, 1>;
    Column sum = Column::Zero();
    for (int c = 0; c < 3; ++c)
        sum += found.share[c] * columns.col(faces(c, found.face)).template cast<double>();
    return sum;
}

}  // namespace

Mesh remesh(const Mesh& mesh, std::string_view pattern, PatternSize size) {
    const FlatMesh laid = flatten(mesh);
    if (size.columns == 0 && size.rows == 0) {
        const double edge = measure_quality(mesh, build_topology(mesh.faces, mesh.vertices())).mean_edge;
        const Vec2 extent = laid.outline.high() - laid.outline.low();
        size.columns = std::max(1, static_cast<int>(std::lround(extent.x() / edge)));
        size.rows = std::max(1, static_cast<int>(std::lround(extent.y() / edge)));
    }
    size.over = "rectangle";  // what it covers is the outline
    Mesh made = make_pattern(pattern, size, laid.outline);
    Finder find(mesh.faces, laid.place);
    Eigen::Matrix2Xf uv(2, mesh.drawn.uv.cols() > 0 ? made.vertices() : 0);
    for (int v = 0; v < made.vertices(); ++v) {
        const Vec2 at(made.rest(0, v), made.rest(2, v));
        const Finder::Found found = find(at);
        made.rest.col(v) = laid.level ? Vec3(laid.origin + at.x() * laid.across + at.y() * laid.down)
                                      : between(mesh.rest, mesh.faces, found);
        if (uv.cols() > 0) uv.col(v) = between(mesh.drawn.uv, mesh.drawn.faces, found).cast<float>();
    }
    return plain_mesh(std::move(made.rest), std::move(made.faces), std::move(uv));
}

}  // namespace drape

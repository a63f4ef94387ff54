#include "mesh/delaunay.h"

#include <array>
#include <cstdio>
#include <memory>
#include <vector>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "base/error.h"

namespace drape {

namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

// Qhull's working memory, given back whatever happens.
class Hull {
public:
    // its own words go nowhere: drape says what went wrong
    Hull() : silence_(std::fopen("/dev/null", "w")) { qh_zero(&hull_, silence_.get()); }
    ~Hull() {
        int kept = 0, bytes = 0;
        qh_freeqhull(&hull_, !qh_ALL);
        qh_memfreeshort(&hull_, &kept, &bytes);
    }
    Hull(const Hull&) = delete;
    Hull& operator=(const Hull&) = delete;

    // d: Delaunay; Qt: triangles only; Qbb: coordinates scaled alike; Qz: a point at infinity, for points
    // that all lie on one circle
    bool build(Eigen::Matrix2Xd& points) {
        std::array<char, 32> command{"qhull d Qt Qbb Qc Qz"};
        return qh_new_qhull(&hull_, 2, static_cast<int>(points.cols()), points.data(), False, command.data(),
                            nullptr, silence_.get()) == 0;
    }
    qhT* get() { return &hull_; }

private:
    std::unique_ptr<std::FILE, Close> silence_;
    qhT hull_{};
};

// A triangle thinner than this, height over longest side, is rounding on a straight border.
constexpr double thinnest = 1e-9;

}  // namespace

Eigen::Matrix3Xi delaunay(const Eigen::Matrix2Xd& points) {
    Eigen::Matrix2Xd copy = points;
    Hull hull;
    if (copy.cols() < 3 || !hull.build(copy))
        throw Error(cat("cannot triangulate ", points.cols(), " points (they must span a plane)"));
    qhT* qh = hull.get();
    std::vector<Eigen::Vector3i> triangles;
    std::vector<bool> used(static_cast<size_t>(points.cols()), false);
    facetT* facet = nullptr;
    FORALLfacets {
        if (facet->upperdelaunay) continue;
        Eigen::Vector3i corner;
        int count = 0;
        vertexT *vertex = nullptr, **vertexp = nullptr;
        FOREACHvertex_(facet->vertices) {
            if (count < 3) corner[count] = qh_pointid(qh, vertex->point);
            ++count;
        }
        if (count != 3 || corner.maxCoeff() >= points.cols()) continue;
        const Eigen::Vector2d a = points.col(corner[0]), b = points.col(corner[1]), c = points.col(corner[2]);
        const double doubled_area = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
        const double longest =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        if (std::abs(doubled_area) <= thinnest * longest) continue;
        if (doubled_area < 0) std::swap(corner[1], corner[2]);
        for (int k = 0; k < 3; ++k) used[static_cast<size_t>(corner[k])] = true;
        triangles.push_back(corner);
    }
    for (size_t i = 0; i < used.size(); ++i)
        if (!used[i])
            throw Error(cat("cannot triangulate ", points.cols(), " points: number ", i, " is lost"));
    Eigen::Matrix3Xi faces(3, static_cast<Eigen::Index>(triangles.size()));
    for (size_t f = 0; f < triangles.size(); ++f) faces.col(static_cast<Eigen::Index>(f)) = triangles[f];
    return faces;
}

}  // namespace drape

#include "mesh/curvature.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace drape {

std::vector<Mat3> curvature_tensors(const Topology& topology, const Faces& faces, In rest, In x) {
    std::vector<Mat3> tensor(static_cast<size_t>(rest.cols()), Mat3::Zero());
    std::vector<double> area(tensor.size(), 0);
    const auto doubled_area = [&](In at, Eigen::Index f) {
        const Vec3 a = at.col(faces(0, f));
        return Vec3((at.col(faces(1, f)) - a).cross(at.col(faces(2, f)) - a));
    };
    for (Eigen::Index f = 0; f < faces.cols(); ++f)
        for (int c = 0; c < 3; ++c)
            area[static_cast<size_t>(faces(c, f))] += doubled_area(rest, f).norm() / 6;
    for (const Edge& edge : topology.edges) {
        if (edge.face_count != 2) continue;
        const Vec3 one = doubled_area(x, edge.face[0]), other = doubled_area(x, edge.face[1]);
        const double fold = std::atan2(one.cross(other).norm(), one.dot(other));
        // the other triangle's corner lies below the plane of the first on a ridge
        const Vec3 corner = x.col(edge.opposite[1]) - x.col(edge.vertex[0]);
        const double theta = one.dot(corner) < 0 ? fold : -fold;
        const Vec3 along = rest.col(edge.vertex[1]) - rest.col(edge.vertex[0]);
        const Mat3 part = theta / (2 * along.norm()) * along * along.transpose();
        for (const int v : edge.vertex) tensor[static_cast<size_t>(v)] += part;
    }
    for (size_t v = 0; v < tensor.size(); ++v)
        if (area[v] > 0) tensor[v] /= area[v];
    return tensor;
}

double sharpest(const Mat3& tensor) {
    return Eigen::SelfAdjointEigenSolver<Mat3>(tensor, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .cwiseAbs()
        .maxCoeff();
}

}  // namespace drape

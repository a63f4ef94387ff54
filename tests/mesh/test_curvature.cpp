#include "mesh/curvature.h"

#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>

#include "mesh/pattern.h"

using namespace drape;

TEST_CASE("a rolled sheet has its cylinder's curvature along the cylinder on every pattern", "[mesh]") {
    constexpr double radius = 0.4;
    for (const PatternKind& kind : pattern_kinds()) {
        CAPTURE(kind.name);
        const Mesh mesh = make_pattern(kind.name, {1, 1, 40, 40});
        const Topology topology = build_topology(mesh.faces, mesh.vertices());
        Points x = mesh.rest;
        for (int v = 0; v < mesh.vertices(); ++v)
            x.col(v) =
                Vec3(radius * std::sin(x(0, v) / radius), radius * (std::cos(x(0, v) / radius) - 1), x(2, v));
        std::vector<double> areas(static_cast<size_t>(mesh.vertices()), 0);
        for (const auto& face : mesh.faces.colwise()) {
            const Vec3 a = mesh.rest.col(face[0]);
            for (const int v : face)
                areas[static_cast<size_t>(v)] +=
                    Vec3(mesh.rest.col(face[1]) - a).cross(Vec3(mesh.rest.col(face[2]) - a)).norm() / 6;
        }
        const std::vector<Mat3> tensors = curvature_tensors(topology, mesh.faces, mesh.rest, x);
        double sum = 0, turned = 0, area = 0;
        for (int v = 0; v < mesh.vertices(); ++v) {
            const Mat3& tensor = tensors[static_cast<size_t>(v)];
            if (mesh.rest.col(v).cwiseAbs().maxCoeff() > 0.45) continue;
            const Eigen::SelfAdjointEigenSolver<Mat3> axes(tensor);
            CHECK(axes.eigenvalues()[2] == Approx(sharpest(tensor)));  // a ridge is positive
            const double own = areas[static_cast<size_t>(v)];
            sum += own * sharpest(tensor);
            turned += own * std::abs(axes.eigenvectors().col(2).x());
            area += own;
        }
        // measured: 1.00 on grids; 1.2 on irregular meshes, whose edges measure less evenly
        CHECK(sum / area == Approx(1 / radius).epsilon(0.25));
        CHECK(turned / area < 0.3);
    }
}

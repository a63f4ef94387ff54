#include "lab/hanging.h"

#include <cmath>
#include <map>

#include <Eigen/Eigenvalues>

#include "lab/elastic.h"
#include "lab/equilibrium.h"
#include "mesh/pattern.h"

namespace drape {

namespace {

struct Hung {
    Model free;
    Points x;
};

Hung hang(const Mesh& sheet, const Fabric& fabric, double gravity) {
    Hung hung{free_cloth(sheet, fabric), {}};
    Model held = hung.free;
    std::vector<int> top;
    const double highest = sheet.rest.row(1).maxCoeff();
    for (int v = 0; v < sheet.vertices(); ++v)
        if (sheet.rest(1, v) > highest - 1e-9) top.push_back(v);
    hold_at_rest(held, top);
    hung.x = come_to_rest(held, {0, -gravity, 0}, sheet.rest, 1e-9).x;
    return hung;
}

// Vertices by the height they rest at, from the top; to a millionth of a metre.
std::vector<std::vector<int>> rows_of(const Mesh& sheet) {
    std::map<long, std::vector<int>> rows;
    for (int v = 0; v < sheet.vertices(); ++v) rows[std::lround(-1e6 * sheet.rest(1, v))].push_back(v);
    std::vector<std::vector<int>> in_order;
    for (auto& [height, row] : rows) in_order.push_back(std::move(row));
    return in_order;
}

}  // namespace

Mesh hanging_sheet(double width, double length, int columns, int rows) {
    Mesh mesh = make_pattern("alternating", {width, length, columns, rows});
    for (int v = 0; v < mesh.vertices(); ++v)
        mesh.rest.col(v) = Vec3(mesh.rest(0, v), mesh.rest(2, v) - length / 2, 0);
    return mesh;
}

double hanging_stretch(const Mesh& sheet, const Fabric& fabric, double gravity) {
    const Points x = hang(sheet, fabric, gravity).x;
    const double lowest = sheet.rest.row(1).minCoeff();
    double sum = 0;
    int count = 0;
    for (int v = 0; v < sheet.vertices(); ++v) {
        if (sheet.rest(1, v) > lowest + 1e-9) continue;
        sum += sheet.rest(1, v) - x(1, v);
        ++count;
    }
    return sum / count;
}

// K u = w^2 M u, with the stiffness where the sheet hangs; the top row is held.
std::vector<double> swing_frequencies(const Mesh& sheet, const Fabric& fabric, double gravity) {
    const Hung hung = hang(sheet, fabric, gravity);
    const BlockMatrix stiffness = stiffness_of(hung.free, hung.x);
    const std::vector<std::vector<int>> rows = rows_of(sheet);
    const auto count = static_cast<Eigen::Index>(rows.size()) - 1;
    Eigen::MatrixXd k(count, count);
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(count);
    for (Eigen::Index j = 0; j < count; ++j) {
        Points move = Points::Zero(3, sheet.vertices());
        for (const int v : rows[static_cast<size_t>(j) + 1]) {
            move(2, v) = 1;
            mass[j] += hung.free.mass[v];
        }
        const Points force = stiffness.multiply(move);
        for (Eigen::Index i = 0; i < count; ++i) {
            k(i, j) = 0;
            for (const int v : rows[static_cast<size_t>(i) + 1]) k(i, j) += force(2, v);
        }
    }
    const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scale.asDiagonal() * k * scale.asDiagonal());
    std::vector<double> frequencies;
    for (const double square : modes.eigenvalues()) frequencies.push_back(std::sqrt(std::max(0.0, square)));
    return frequencies;
}

}  // namespace drape

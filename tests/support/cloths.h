// Small cloths for tests.
#pragma once

#include <random>

#include "cloth/model.h"
#include "mesh/pattern.h"

namespace drape::test {

// The bare spring system of the lecture notes: springs of `stiffness` N/m along edges, nothing else.
inline Fabric bare_springs(double stiffness, double density = 0.2) {
    Fabric fabric;
    fabric.density = density;
    fabric.stretch_model = StretchModel::spring_constant;
    fabric.stretch = stiffness;
    return fabric;
}

inline Mesh square(int divisions, std::string_view pattern = "alternating", double side = 1) {
    return make_pattern(pattern, {side, side, divisions, divisions});
}

// The same sheet with its inner vertices shifted in its plane by up to `amount` of the spacing.
inline Mesh jittered_square(int divisions, std::string_view pattern, double amount) {
    Mesh mesh = square(divisions, pattern);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-amount / divisions, amount / divisions);
    for (int j = 1; j < divisions; ++j)
        for (int i = 1; i < divisions; ++i)
            mesh.rest.col(j * (divisions + 1) + i) += Vec3(shift(random), 0, shift(random));
    return mesh;
}

// One equilateral triangle of side 1 in the x-z plane.
inline Mesh equilateral_triangle() {
    Points rest(3, 3);
    rest << 0, 0.5, 1, 0, 0, 0, 0, 0.86602540378443865, 0;
    Faces faces(3, 1);
    faces << 0, 1, 2;
    return plain_mesh(rest, faces);
}

inline Points random_points(Eigen::Index count, double amount, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-amount, amount);
    return Points::NullaryExpr(3, count, [&] { return value(random); });
}

inline Model model_of(Mesh mesh, const Fabric& fabric) {
    Model model;
    add_cloth(model, make_cloth(std::move(mesh), fabric));
    return model;
}

}  // namespace drape::test

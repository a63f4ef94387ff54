#include "support/cloths.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace drape::test {

Fabric bare_springs(double stiffness, double density) {
    Fabric fabric;
    fabric.density = density;
    fabric.stretch_model = StretchModel::spring_constant;
    fabric.stretch = stiffness;
    return fabric;
}

Mesh square(int divisions, std::string_view pattern, double side) {
    return make_pattern(pattern, {side, side, divisions, divisions});
}

Mesh jittered_square(int divisions, std::string_view pattern, double amount) {
    Mesh mesh = square(divisions, pattern);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-amount / divisions, amount / divisions);
    for (int v = 0; v < mesh.vertices(); ++v)
        if (std::max(std::abs(mesh.rest(0, v)), std::abs(mesh.rest(2, v))) < 0.5)
            mesh.rest.col(v) += Vec3(shift(random), 0, shift(random));
    return mesh;
}

Mesh equilateral_triangle() {
    Points rest(3, 3);
    rest << 0, 0.5, 1, 0, 0, 0, 0, 0.86602540378443865, 0;
    Faces faces(3, 1);
    faces << 0, 1, 2;
    return plain_mesh(rest, faces);
}

Points random_points(Eigen::Index count, double amount, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-amount, amount);
    return Points::NullaryExpr(3, count, [&] { return value(random); });
}

Model model_of(Mesh mesh, const Fabric& fabric) {
    Model model;
    add_cloth(model, make_cloth(std::move(mesh), fabric));
    return model;
}

}  // namespace drape::test

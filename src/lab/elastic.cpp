#include "lab/elastic.h"

#include "base/names.h"
#include "force/kinds.h"
#include "mesh/pattern.h"

namespace drape {

Mesh lone_triangle(double base, double along, double above) {
    Points rest(3, 3);
    rest << -base / 2, base / 2, (along - 0.5) * base, 0, 0, 0, 0, 0, -above * base;
    Faces face(3, 1);
    face << 0, 1, 2;
    return plain_mesh(rest, face);
}

std::vector<std::string> even_patterns() {
    std::vector<std::string> even = names_of(pattern_kinds());
    std::erase(even, "adaptive");
    return even;
}

std::vector<std::unique_ptr<Force>> elastic_forces(const Cloth& cloth) {
    std::vector<std::unique_ptr<Force>> forces;
    for (const auto make : {make_edge_springs, make_altitude_springs, make_membrane, make_bending})
        if (MadeForce made = make(cloth, {}); made.force) forces.push_back(std::move(made.force));
    return forces;
}

double energy_of(const std::vector<std::unique_ptr<Force>>& forces, In x) {
    double energy = 0;
    for (const auto& force : forces) energy += force->energy(x);
    return energy;
}

Points forces_of(const std::vector<std::unique_ptr<Force>>& forces, In x) {
    Points sum = Points::Zero(3, x.cols());
    for (const auto& force : forces) force->add_conservative(x, sum);
    return sum;
}

BlockMatrix stiffness_of(const Model& model, In x) {
    const auto forces = elastic_forces(model.cloths.front());
    Couplings couplings;
    for (const auto& force : forces) force->add_couplings(couplings);
    BlockMatrix matrix(model, couplings);
    for (const auto& force : forces) force->add_stiffness(x, matrix);
    return matrix;
}

Model free_cloth(Mesh mesh, const Fabric& fabric) {
    Model model;
    add_cloth(model, make_cloth(std::move(mesh), fabric));
    return model;
}

void hold_at_rest(Model& model, const std::vector<int>& vertices) {
    PinGroup pins;
    pins.vertices = vertices;
    pins.anchors = model.cloths.front().mesh.rest(Eigen::all, vertices);
    add_pins(model, std::move(pins));
}

}  // namespace drape

#include "study/stability_cloth.h"

#include <array>
#include <cmath>
#include <random>

#include "base/error.h"
#include "base/names.h"
#include "mesh/pattern.h"
#include "simulate/stable_step.h"

namespace drape {

namespace {

constexpr int divisions = 4, across = divisions + 1;
constexpr double small_strain = 0.1;
constexpr double spacing = 1.0 / divisions;  // [m]

Mesh regular() {
    return make_pattern("alternating", {1, 1, divisions, divisions});
}

// Inner vertices shifted in the plane, always the same.
Mesh shuffled() {
    constexpr double most = 0.3 * spacing;
    Mesh mesh = regular();
    std::mt19937 random(5);
    const auto shift = [&] { return most * (2.0 * double(random()) / double(std::mt19937::max()) - 1); };
    for (int j = 1; j < divisions; ++j) {
        for (int i = 1; i < divisions; ++i) {
            const double along = shift(), aside = shift();
            mesh.rest.col(j * across + i) += Vec3(along, 0, aside);
        }
    }
    return mesh;
}

// The middle row moved up to its neighbour: triangles 33 times as long as high.
Mesh with_slivers() {
    constexpr double height = 0.03 * spacing;
    Mesh mesh = regular();
    for (int i = 0; i < across; ++i) mesh.rest(2, 2 * across + i) = mesh.rest(2, across + i) + height;
    return mesh;
}

struct BuiltInMesh {
    const char* name;
    Mesh (*make)();
};
constexpr std::array meshes{BuiltInMesh{"alternating", regular}, BuiltInMesh{"random", shuffled},
                            BuiltInMesh{"slivers", with_slivers}};

struct Option {
    const char* name;
    void (*add)(Fabric&);
};
constexpr std::array options{
    Option{"altitude", [](Fabric& fabric) { fabric.altitude = AltitudeMode::blend; }},
    Option{"bending",
           [](Fabric& fabric) {
               fabric.bending_kind = BendingKind::plate;
               fabric.bending = 1e-3;  // for 1 N/m; both are scaled
           }},
    Option{"damping", [](Fabric& fabric) { fabric.damping = 0.05; }},
};

constexpr unsigned combinations = 1U << options.size();

Setup held_at_two_corners(const Mesh& mesh, const Fabric& fabric) {
    Setup setup;
    setup.start.x = mesh.rest;
    setup.start.v = Points::Zero(3, mesh.rest.cols());
    add_cloth(setup.model, make_cloth(mesh, fabric));
    PinGroup corners;
    corners.vertices = {0, divisions * across};
    corners.anchors = mesh.rest(Eigen::all, corners.vertices);
    add_pins(setup.model, std::move(corners));
    return setup;
}

double mean_spring_constant(const Model& model) {
    return mean_over_springs(model, &Spring::stiffness);
}

}  // namespace

std::vector<StabilityCloth> built_in_cloths() {
    std::vector<StabilityCloth> cloths;
    for (const BuiltInMesh& mesh : meshes) {
        for (unsigned chosen = 0; chosen < combinations; ++chosen) {
            Fabric fabric;
            fabric.density = 0.2;
            fabric.stretch_model = StretchModel::spring_constant;
            fabric.stretch = 1;
            StabilityCloth cloth{.mesh = mesh.name, .options = {}, .file = mesh.name, .setup = {}};
            std::vector<std::string> names;
            for (size_t i = 0; i < options.size(); ++i) {
                if ((chosen >> i & 1U) == 0) continue;
                options[i].add(fabric);
                names.emplace_back(options[i].name);
                cloth.file += cat("_", options[i].name);
            }
            cloth.options = names.empty() ? "bare springs" : joined(names);
            cloth.setup = held_at_two_corners(mesh.make(), fabric);
            cloths.push_back(std::move(cloth));
        }
    }
    return cloths;
}

double mean_over_springs(const Model& model, double Spring::*value) {
    double sum = 0;
    size_t count = 0;
    for (const Cloth& cloth : model.cloths) {
        for (const Spring& spring : cloth.network.edges) sum += spring.*value;
        count += cloth.network.edges.size();
    }
    return sum / static_cast<double>(count);
}

StabilityCloth cloth_of_scene(const std::string& name, const Setup& setup) {
    StabilityCloth cloth{.mesh = name, .options = "as in the scene", .file = scene_file, .setup = {}};
    cloth.setup.model = setup.model;
    cloth.setup.start = setup.start;
    cloth.setup.world.gravity = setup.world.gravity;
    if (!(mean_spring_constant(setup.model) > 0))
        throw Error(cat(name, ": its springs have no stiffness to scale"));
    return cloth;
}

Setup with_spring_constant(const Setup& setup, double stiffness) {
    const double factor = stiffness / mean_spring_constant(setup.model);
    Setup scaled;
    scaled.start = setup.start;
    scaled.world = setup.world;
    for (const Cloth& cloth : setup.model.cloths) {
        Fabric fabric = cloth.fabric;
        fabric.stretch *= factor;
        // of bend springs it is a share of the stretch stiffness, which has it already
        if (fabric.bending_kind != BendingKind::spring) fabric.bending *= factor;
        add_cloth(scaled.model, make_cloth(cloth.mesh, fabric));
    }
    for (const PinGroup& group : setup.model.pins) add_pins(scaled.model, group);
    return scaled;
}

double SmallMotion::limit(const Method& method) const {
    if (method.controls_step) return INFINITY;
    return method.longest_step(method.projects_springs ? unprojected : all);
}

SmallMotion small_motion(const Setup& setup) {
    Setup any = setup;
    any.method = "verlet";
    Simulation simulation(std::move(any));
    const auto spectrum = [&](ForceShare share) {
        const Points& x = simulation.state().x;
        return Spectrum{measured_omega(simulation.dynamics(), x, share),
                        measured_gamma(simulation.dynamics(), x, share)};
    };
    const double weight = setup.model.mass.sum() * setup.world.gravity.norm();
    const double stretched = weight / mean_spring_constant(setup.model);
    return {spectrum(ForceShare::all), spectrum(ForceShare::unprojected),
            stretched < small_strain * mean_over_springs(setup.model, &Spring::rest_length)};
}

}  // namespace drape

#include "simulate/predicted_cost.h"

#include <algorithm>
#include <cmath>

namespace drape {

namespace {

// Nanoseconds of one core, rough values set by hand: ranks scenes, and is good to a factor of about two.
// Contact is not counted.
constexpr double per_vertex = 12;        // kick, drift, mass
constexpr double per_spring = 7;         // edge or bend
constexpr double per_triangle_one = 14;  // one altitude or the blend
constexpr double per_triangle_all = 90;
constexpr double per_triangle_membrane = 9;
constexpr double per_plate_entry = 2.4;  // of the bending matrix, some 21 a vertex of a grid
constexpr double per_hinge = 90;
constexpr double per_wind_triangle = 25;
constexpr double plate_entries = 21;
constexpr double per_projection = 10;           // of a spring
constexpr double per_triangle_projection = 30;  // of altitudes
constexpr double per_membrane_projection = 130;
// A factorisation of the step matrix grows faster than its n vertices: measured in sweeps 129 to 174 at 33 x
// 33 vertices, 333 to 611 at 65 x 65.
constexpr double factorisation_growth = 0.75;
constexpr double factorisations_a_solve = 3;

double sweep_nanoseconds(const Cloth& cloth, bool windy) {
    const auto triangles = static_cast<double>(cloth.mesh.triangles());
    const auto edges = static_cast<double>(cloth.network.edges.size());
    double sum = per_vertex * cloth.vertices();
    if (cloth.fabric.membrane == MembraneKind::none) sum += per_spring * edges;
    if (cloth.fabric.membrane != MembraneKind::none)
        sum += per_triangle_membrane * triangles;
    else if (cloth.fabric.altitude == AltitudeMode::blend)
        sum += per_triangle_one * triangles;
    else if (cloth.fabric.altitude != AltitudeMode::none)
        sum += per_triangle_all * triangles;
    if (cloth.fabric.bending_kind == BendingKind::plate)
        sum += per_plate_entry * plate_entries * cloth.vertices();
    if (cloth.fabric.bending_kind == BendingKind::hinge) sum += per_hinge * edges;
    sum += per_spring * static_cast<double>(cloth.network.bends.size());
    if (windy) sum += per_wind_triangle * triangles;
    return sum;
}

double projection_nanoseconds(const Cloth& cloth) {
    const auto triangles = static_cast<double>(cloth.mesh.triangles());
    double sum = per_projection * static_cast<double>(cloth.network.bends.size());
    if (cloth.fabric.membrane != MembraneKind::none) return sum + per_membrane_projection * triangles;
    sum += per_projection * static_cast<double>(cloth.network.edges.size());
    if (cloth.fabric.altitude != AltitudeMode::none) sum += per_triangle_projection * triangles;
    return sum;
}

double step_nanoseconds(const Simulation& simulation, const Method& method, double sweep) {
    if (method.is_implicit()) {
        const double solves = method.sweeps / 2.0;
        return solves * factorisations_a_solve * sweep *
               std::pow(simulation.model().vertices(), factorisation_growth);
    }
    double step = method.sweeps * sweep;
    if (method.projects_springs)
        for (const Cloth& cloth : simulation.model().cloths) step += projection_nanoseconds(cloth);
    return step;
}

}  // namespace

PredictedCost predicted_cost(const Simulation& simulation) {
    return predicted_cost(simulation, simulation.method(), simulation.step());
}

PredictedCost predicted_cost(const Simulation& simulation, const Method& method, double step) {
    // with several cloths each has its stage, "wind (cloth 1)"; the air is the same for all
    const std::vector<Stage>& stages = simulation.plan().stages;
    const bool windy = std::any_of(stages.begin(), stages.end(), [](const Stage& stage) {
        return stage.used && stage.name.starts_with("wind");
    });
    double sweep = 0;
    for (const Cloth& cloth : simulation.model().cloths) sweep += sweep_nanoseconds(cloth, windy);
    PredictedCost cost;
    cost.steps = std::ceil(1 / simulation.frame_rate() / step * (1 - 1e-9)) * simulation.frames();
    cost.seconds = cost.steps * step_nanoseconds(simulation, method, sweep) * 1e-9;
    return cost;
}

}  // namespace drape

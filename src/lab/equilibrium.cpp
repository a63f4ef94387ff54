#include "lab/equilibrium.h"

#include <algorithm>

#include "integrate/method.h"

namespace drape {

namespace {

constexpr double first_step = 0.01, longest_step = 20, shortest_step = 1e-6;  // [s]
constexpr double growth = 1.3;                                                // of the step, each time
constexpr int most_steps = 400;

std::vector<ActiveForce> all_forces(const Model& model, const Vec3& gravity) {
    std::vector<ActiveForce> forces;
    for (const ForceKind& kind : force_kinds())
        for (const Cloth& cloth : model.cloths)
            if (MadeForce made = kind.make(cloth, {gravity, {}}); made.force)
                forces.push_back({std::string(kind.name), std::move(made.force), 0});
    return forces;
}

}  // namespace

Equilibrium come_to_rest(const Model& model, const Vec3& gravity, Points start, double still) {
    Dynamics dynamics(model, all_forces(model, gravity), nullptr);
    const auto integrator = method_named("backward_euler").make();
    State state{std::move(start), Points::Zero(3, model.vertices()), 0};
    Equilibrium result;
    double h = first_step;
    for (int i = 0; i < most_steps && !result.found && h > shortest_step; ++i) {
        const State before = state;
        integrator->begin(dynamics, state, h);
        if (!integrator->step(dynamics, state, h)) {
            state = before;
            h /= 4;
            continue;
        }
        result.moved = (state.x - before.x).colwise().norm().maxCoeff() / std::max(1.0, h);
        result.found = h >= 1 && result.moved < still;
        h = std::min(growth * h, longest_step);
    }
    result.x = state.x;
    result.iterations = integrator->work().iterations;
    return result;
}

}  // namespace drape

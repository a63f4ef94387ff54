#include "support/motion.h"

#include "base/error.h"
#include "force/edge_spring.h"

namespace drape::test {

namespace {

Model pinned_pair() {
    Model model;
    model.mass = model.inverse_mass = Eigen::VectorXd::Ones(2);
    hold(model, {0}, Points::Zero(3, 1));
    return model;
}

std::vector<ActiveForce> spring(const Spectrum& mode, double rest_length) {
    const Spring one{0, 1, rest_length, mode.omega * mode.omega, mode.gamma};
    std::vector<ActiveForce> forces;
    forces.push_back({"spring", std::make_unique<EdgeSprings>(std::vector{one}, 0), 0});
    return forces;
}

}  // namespace

Oscillator::Oscillator(const Spectrum& mode, double rest_length)
    : model_(pinned_pair()), dynamics_(model_, spring(mode, rest_length), nullptr) {}

State Oscillator::at(const Vec3& x, const Vec3& v) {
    State state{Points::Zero(3, 2), Points::Zero(3, 2), 0};
    state.x.col(1) = x;
    state.v.col(1) = v;
    return state;
}

double Oscillator::energy(const State& state) const {
    return dynamics_.kinetic_energy(state.v) + dynamics_.potential_energy(state.x, state.time);
}

std::vector<ActiveForce> forces_of(const Model& model, const Surroundings& world) {
    std::vector<ActiveForce> forces;
    for (const ForceKind& kind : force_kinds())
        for (const Cloth& cloth : model.cloths)
            if (MadeForce made = kind.make(cloth, world); made.force)
                forces.push_back({std::string(kind.name), std::move(made.force), 0});
    return forces;
}

State integrated(const Method& method, Dynamics& dynamics, State state, double end, int steps) {
    const double h = (end - state.time) / steps;
    const auto integrator = method.make();
    integrator->begin(dynamics, state, h);
    for (int i = 0; i < steps; ++i)
        if (!integrator->step(dynamics, state, h)) throw Error(cat(method.name, ": a step failed"));
    integrator->end(dynamics, state, h);
    return state;
}

}  // namespace drape::test

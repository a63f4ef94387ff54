#include "simulate/guard.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"

namespace drape {

namespace {

// Steps of an explicit method near its limit swing above the energy they keep on average, and power is booked
// by the step: the check after a step is for what runs away.
constexpr double slack = 4;
constexpr double least_energy_of_a_kilogram = 1e-9;  // [J/kg], speeds of 45 um/s: below it all is round-off

// sum of weight times value squared, in a fixed order at any vector width
DRAPE_WIDE double weighted_squares(const double* weight, const double* value, Eigen::Index count) {
    constexpr int lanes = 8;
    double sum[lanes] = {};
    Eigen::Index i = 0;
    for (; i + lanes <= count; i += lanes)
        for (int k = 0; k < lanes; ++k) sum[k] += weight[i + k] * value[i + k] * value[i + k];
    for (; i < count; ++i) sum[0] += weight[i] * value[i] * value[i];
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

}  // namespace

Guard::Guard(const Dynamics& dynamics, const Vec3& gravity, Books books)
    : dynamics_(dynamics), gravity_(gravity), books_(books) {
    const Model& model = dynamics.model();
    half_mass_.resize(3 * model.vertices());
    for (int i = 0; i < model.vertices(); ++i) {
        const bool free = model.inverse_mass[i] > 0;
        half_mass_.segment<3>(3 * i).setConstant(free ? model.mass[i] / 2 : 0);
        if (free) mass_ += model.mass[i];
    }
}

double Guard::kinetic_energy(In v) const {
    return weighted_squares(half_mass_.data(), v.data(), half_mass_.size());
}

double Guard::weight_energy(In x) const {
    return -gravity_.dot(x * dynamics_.model().mass);
}

Guard::Stock Guard::stock_of(const State& state) const {
    return {kinetic_energy(state.v), dynamics_.potential_energy(state.x, state.time), weight_energy(state.x)};
}

// The centre of mass moves with at most V: M V^2 / 2 is at most the energy there was plus M g times the way,
// V T at most, hence V <= g T + sqrt(g^2 T^2 + 2 E / M).
void Guard::begin_frame(const State& state, double duration, bool known) {
    start_ = known && last_ ? *last_ : stock_of(state);
    flow_ = dynamics_.flow();
    const double stored = start_.kinetic + std::max(start_.potential - start_.weight, 0.0);
    const double gained = gravity_.norm() * duration;
    const double speed = mass_ > 0 ? gained + std::sqrt(gained * gained + 2 * stored / mass_) : 0;
    available_ = stored + mass_ * gained * speed + least_energy_of_a_kilogram * mass_;
}

bool Guard::step_holds(In v) const {
    const double kinetic = kinetic_energy(v);
    if (!books_.drive) return std::isfinite(kinetic);
    return kinetic <= slack * (available_ + std::max(dynamics_.flow().driven - flow_.driven, 0.0));
}

double Guard::gain(const State& state) {
    if (!books_.drive || !books_.springs || mass_ == 0) return 0;  // where nothing is free, nothing gains
    last_ = stock_of(state);
    const auto& [kinetic, potential, weight] = *last_;
    const double driven = dynamics_.flow().driven - flow_.driven;
    const double dissipated = dynamics_.flow().dissipated - flow_.dissipated;
    const double gained = kinetic + potential - start_.kinetic - start_.potential - driven + dissipated;
    const double at_play = kinetic + start_.kinetic + std::abs(potential - weight) +
                           std::abs(start_.potential - start_.weight) + std::abs(weight - start_.weight) +
                           std::abs(driven) + std::abs(dissipated) + least_energy_of_a_kilogram * mass_;
    return gained / at_play;
}

}  // namespace drape

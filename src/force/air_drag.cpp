// Air drag: f = -d A (v - wind), linear; d [kg/(s m^2)], A the vertex's area. It has no energy: it only turns
// motion relative to the air into heat.
#include "base/wide.h"
#include "force/kinds.h"
#include "force/padded_force.h"

namespace drape {

namespace {

// f += rate (wind - v) for every vertex; returns the power it puts in
DRAPE_WIDE double push(const Eigen::VectorXd& rate, const Vec3& wind, const double* v, double* f) {
    const Lanes flow = {wind.x(), wind.y(), wind.z(), 0};
    Lanes power = {};
    for (Eigen::Index i = 0; i < rate.size(); ++i) {
        Lanes velocity, sum;
        load(velocity, v + 4 * i);
        load(sum, f + 4 * i);
        const Lanes force = rate[i] * (flow - velocity);
        store(sum + force, f + 4 * i);
        power += force * velocity;
    }
    return lane_sum(power);
}

class AirDrag final : public PaddedForce {
public:
    AirDrag(const Cloth& cloth, const AirDescription& air)
        : first_(cloth.first), rate_(air.drag * cloth.area), wind_(air.wind) {}

    double energy(In) const override { return 0; }
    void add_padded_conservative(const PaddedPoints&, PaddedPoints&) const override {}
    bool is_conservative() const override { return false; }

    Power add_padded(const PaddedPoints&, const PaddedPoints& v, PaddedPoints& f) const override {
        const double power = push(rate_, wind_, v.col(first_).data(), f.col(first_).data());
        return power < 0 ? Power{.dissipated = -power} : Power{.driven = power};
    }
    void add_bound(In, StepBound& bound) const override {
        bound.damping.segment(first_, rate_.size()) += rate_;
    }
    void add_damping(In, In, double, BlockMatrix& b) const override {
        for (int i = 0; i < rate_.size(); ++i) b.add_isotropic(first_ + i, first_ + i, rate_[i]);
    }
    void add_damping_majorant(Majorant& b) const override {
        for (int i = 0; i < rate_.size(); ++i) b.add_diagonal(first_ + i, rate_[i]);
    }

private:
    int first_;
    Eigen::VectorXd rate_;  // d A per vertex [kg/s]
    Vec3 wind_;
};

}  // namespace

MadeForce make_air_drag(const Cloth& cloth, const Surroundings& world) {
    if (world.air.drag == 0) return {nullptr, "no air.drag in the scene"};
    return {std::make_unique<AirDrag>(cloth, world.air), "air.drag is set"};
}

}  // namespace drape

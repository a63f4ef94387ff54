// Air drag: f = -d A (v - wind), linear; d [kg/(s m^2)], A the vertex's area. It has no energy: it only turns
// motion relative to the air into heat.
#include "force/kinds.h"

namespace drape {

namespace {

class AirDrag final : public Force {
public:
    AirDrag(const Cloth& cloth, const AirDescription& air)
        : first_(cloth.first), rate_(air.drag * cloth.area), wind_(air.wind) {}

    double energy(In) const override { return 0; }
    void add_conservative(In, Out) const override {}
    bool is_conservative() const override { return false; }

    Power add_all(In, In v, double, Out f) const override {
        double power = 0;
        for (Eigen::Index i = 0; i < rate_.size(); ++i) {
            const Vec3 velocity = v.col(first_ + i);
            const Vec3 force = rate_[i] * (wind_ - velocity);
            f.col(first_ + i) += force;
            power += force.dot(velocity);
        }
        return power < 0 ? Power{-power, 0} : Power{0, power};
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

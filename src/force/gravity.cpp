// Gravity: E = -sum m g . x, f = m g.
#include "force/kinds.h"
#include "force/padded_force.h"

namespace drape {

namespace {

class Gravity final : public PaddedForce {
public:
    Gravity(const Cloth& cloth, const Vec3& g) : first_(cloth.first), mass_(cloth.mass), g_(g) {
        pad(g * cloth.mass.transpose(), weight_);
    }

    double energy(In x) const override { return -g_.dot(x.middleCols(first_, mass_.size()) * mass_); }
    void add_padded_conservative(const PaddedPoints&, PaddedPoints& f) const override {
        f.middleCols(first_, mass_.size()) += weight_;
    }
    // conservative: never asked
    Power add_padded(const PaddedPoints&, const PaddedPoints&, PaddedPoints&) const override { return {}; }
    void add_bound(In, StepBound&) const override {}  // constant force, no stiffness

private:
    int first_;
    Eigen::VectorXd mass_;
    Vec3 g_;
    PaddedPoints weight_;  // m g of every vertex [N]
};

}  // namespace

MadeForce make_gravity(const Cloth& cloth, const Surroundings& world) {
    if (world.gravity == Vec3::Zero()) return {nullptr, "gravity is zero"};
    return {std::make_unique<Gravity>(cloth, world.gravity), "gravity is not zero"};
}

}  // namespace drape

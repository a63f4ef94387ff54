// Gravity: E = -sum m g . x, f = m g. Not a padded force, so it is added after those: what springs and plates
// leave over where they cancel is then lost in the weight's last bit, and all vertices fall alike.
#include "force/kinds.h"

namespace drape {

namespace {

class Gravity final : public Force {
public:
    Gravity(const Cloth& cloth, const Vec3& g)
        : first_(cloth.first), mass_(cloth.mass), g_(g), weight_(g * cloth.mass.transpose()) {}

    double energy(In x) const override { return -g_.dot(x.middleCols(first_, mass_.size()) * mass_); }
    void add_conservative(In, Out f) const override { f.middleCols(first_, mass_.size()) += weight_; }
    void add_bound(In, StepBound&) const override {}  // constant force, no stiffness

private:
    int first_;
    Eigen::VectorXd mass_;
    Vec3 g_;
    Points weight_;  // m g of every vertex [N]
};

}  // namespace

MadeForce make_gravity(const Cloth& cloth, const Surroundings& world) {
    if (world.gravity == Vec3::Zero()) return {nullptr, "gravity is zero"};
    return {std::make_unique<Gravity>(cloth, world.gravity), "gravity is not zero"};
}

}  // namespace drape

// Wind on every triangle, with u = wind - velocity of the triangle, n its normal, A its area, un = u . n:
//   drag  1/2 rho A |un| u                           along the flow, by the area the flow sees
//   lift  1/2 rho A C (|u| un n - un^2 u / |u|)      across the flow, towards the side it pushes
// (flat-plate theory in its simplest form: both vanish when the sheet lies along the flow). Each corner gets
// a third. The force follows the air, not a position, so it has no energy. Gusts scale the wind by 1 +
// strength g(t), g a sum of four sines with seeded phases, |g| <= 1.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "force/kinds.h"

namespace drape {

namespace {

class Gusts {
public:
    explicit Gusts(const AirDescription& air) : strength_(air.gust_strength), period_(air.gust_period) {
        std::mt19937_64 random(air.seed);
        for (double& phase : phase_)
            phase = 2 * std::numbers::pi * static_cast<double>(random() >> 11) * 0x1p-53;
    }
    double factor(double time) const {
        if (strength_ == 0) return 1;
        double g = 0;
        for (size_t i = 0; i < phase_.size(); ++i)
            g += weight[i] * std::sin(2 * std::numbers::pi * pace[i] * time / period_ + phase_[i]);
        return 1 + strength_ * g;
    }

private:
    static constexpr std::array<double, 4> weight{0.4, 0.3, 0.2, 0.1};  // sum 1
    static constexpr std::array<double, 4> pace{1, 1.73, 3.1, 5.3};     // no common period
    double strength_, period_;
    std::array<double, 4> phase_{};
};

class Wind final : public Force {
public:
    Wind(const Cloth& cloth, const AirDescription& air)
        : first_(cloth.first),
          area_(cloth.area),
          faces_(cloth.mesh.faces.array() + cloth.first),
          air_(air),
          gusts_(air),
          foreseen_(fastest() / cloth.fabric.density),
          per_mass_(cloth.mesh.triangles()) {
        for (int t = 0; t < cloth.mesh.triangles(); ++t) {
            const double area = side_of(cloth.mesh.rest, cloth.mesh.faces.col(t)).twice_area / 2;
            per_mass_[t] = area > 0 ? 1 / (cloth.fabric.density * area) : 0;
        }
    }

    double energy(In) const override { return 0; }
    void add_conservative(In, Out) const override {}
    bool is_conservative() const override { return false; }
    bool is_linear_in_velocity() const override { return false; }

    Power add_all(In x, In v, double time, Out f) const override {
        const Vec3 wind = gusts_.factor(time) * air_.wind;
        const double half_density = air_.density / 2;
        Power power;
        double most = 0;  // |u| A / m of any triangle
        for (Eigen::Index t = 0; t < faces_.cols(); ++t) {
            const int a = faces_(0, t), b = faces_(1, t), c = faces_(2, t);
            const Vec3 velocity = (v.col(a) + v.col(b) + v.col(c)) / 3;
            const Vec3 u = wind - velocity;
            const double speed = u.norm();
            const auto [twice_area, n] = side_of(x, faces_.col(t));
            if (twice_area == 0 || speed == 0) continue;  // no side to push on, or no flow
            const double un = u.dot(n);
            const Vec3 force = (half_density * twice_area / 2) *
                               (std::abs(un) * u + air_.lift * (speed * un * n - (un * un / speed) * u));
            const Vec3 third = force / 3;
            f.col(a) += third;
            f.col(b) += third;
            f.col(c) += third;
            power.driven += force.dot(velocity);
            most = std::max(most, speed * twice_area / 2 * per_mass_[t]);
        }
        power.beyond_bound = air_.density * (1 + air_.lift) * std::max(most - foreseen_, 0.0);
        return power;
    }

    // d|force| / dv <= rho A |u| (1 + lift) for the flow that is foreseen; the vertex rows share it by area.
    // A vertex weighs a third of its triangles: the worst of these tells, at every step, of flow beyond that.
    void add_bound(In x, StepBound& bound) const override {
        for (Eigen::Index t = 0; t < faces_.cols(); ++t) {
            const Vec3 a = x.col(faces_(0, t)), b = x.col(faces_(1, t)), c = x.col(faces_(2, t));
            const double rate =
                air_.density * (b - a).cross(c - a).norm() / 2 * fastest() * (1 + air_.lift) / 3;
            for (int k = 0; k < 3; ++k) bound.damping[faces_(k, t)] += rate;
        }
    }

    void add_couplings(Couplings& couplings) const override {
        for (Eigen::Index t = 0; t < faces_.cols(); ++t)
            couplings.couple(std::array{faces_(0, t), faces_(1, t), faces_(2, t)});
    }

    // With s the sign of un and u^ = u / |u|, the force over 1/2 rho A has the derivative by u
    //   |un| I + s u n' + C ( un n u^' + |u| n n' - 2 un u^ n' + un^2 / |u| (u^ u^' - I) )
    // of which the symmetric part is taken, without what it has of negative eigenvalues: an approximation
    // that keeps an implicit step's matrix definite. How the force changes as the triangle turns is left out
    // (it is no gradient).
    void add_damping(In x, In v, double time, BlockMatrix& matrix) const override {
        const Vec3 wind = gusts_.factor(time) * air_.wind;
        for (Eigen::Index t = 0; t < faces_.cols(); ++t) {
            const int a = faces_(0, t), b = faces_(1, t), c = faces_(2, t);
            const Vec3 u = wind - (v.col(a) + v.col(b) + v.col(c)) / 3;
            const double speed = u.norm();
            const auto [twice_area, n] = side_of(x, faces_.col(t));
            if (twice_area == 0 || speed == 0) continue;
            const Vec3 flow = u / speed;
            const double un = u.dot(n);
            const Mat3 drag = std::abs(un) * Mat3::Identity() + std::copysign(1.0, un) * u * n.transpose();
            const Mat3 lift = un * n * flow.transpose() + speed * n * n.transpose() -
                              2 * un * flow * n.transpose() +
                              un * un / speed * (flow * flow.transpose() - Mat3::Identity());
            const Mat3 rate = air_.density * twice_area / 4 * (drag + air_.lift * lift);
            const Eigen::SelfAdjointEigenSolver<Mat3> modes((rate + rate.transpose()) / 2);
            // a third of the force to each corner, from a velocity that is a third of each corner's
            matrix.add_point(std::array{a, b, c}, std::array{1.0 / 3, 1.0 / 3, 1.0 / 3},
                             modes.eigenvectors() * modes.eigenvalues().cwiseMax(0.0).asDiagonal() *
                                 modes.eigenvectors().transpose());
        }
    }

    // Of the derivative above drag has no eigenvalue beyond 2 |u|, lift none beyond 9/4 |u|; what a
    // triangle's mean velocity feels, corners that each feel a third of it do not exceed. Holds for triangles
    // of their rest area in the flow that add_bound allows for.
    void add_damping_majorant(Majorant& b) const override {
        const double rate = air_.density / 2 * fastest() * (2 + 2.25 * air_.lift);
        for (int i = 0; i < area_.size(); ++i) b.add_diagonal(first_ + i, rate * area_[i]);
    }

private:
    double fastest() const { return (1 + air_.gust_strength) * air_.wind.norm() + flutter_speed; }

    struct Side {
        double twice_area;  // [m^2]
        Vec3 normal;        // unit; none without area
    };
    static Side side_of(In x, const Eigen::Vector3i& face) {
        const Vec3 a = x.col(face[0]), b = x.col(face[1]), c = x.col(face[2]);
        const Vec3 normal = (b - a).cross(c - a);
        const double twice_area = normal.norm();
        return {twice_area, twice_area > 0 ? Vec3(normal / twice_area) : Vec3::Zero()};
    }

    static constexpr double flutter_speed = 20;  // foreseen for the cloth's own speed [m/s]
    int first_;
    Eigen::VectorXd area_;  // per vertex, at rest [m^2]
    Faces faces_;
    AirDescription air_;
    Gusts gusts_;
    double foreseen_;           // |u| A / m that the bound allows for [m^3/(s kg)]
    Eigen::VectorXd per_mass_;  // 1 / m per triangle [1/kg]
};

}  // namespace

MadeForce make_wind(const Cloth& cloth, const Surroundings& world) {
    if (!world.air.aerodynamic) return {nullptr, "no air.wind in the scene"};
    return {std::make_unique<Wind>(cloth, world.air), "air.wind is set"};
}

}  // namespace drape

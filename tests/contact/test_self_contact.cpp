#include "contact/self_contact.h"

#include <catch2/catch.hpp>

#include "support/gradient.h"
#include "support/matrices.h"
#include "support/meshes.h"
#include "support/touching.h"

using namespace drape;
using namespace drape::test;

namespace {

Fabric layered(double thickness) {
    Fabric fabric = full_fabric();
    fabric.thickness = thickness;
    return fabric;
}

// Two sheets, the second of another mesh, `gap` above the first.
Setup two_sheets(int divisions, double gap, double thickness, std::vector<Obstacle> obstacles = {},
                 double height = 1) {
    Setup setup = setup_of(raised(square(divisions, "alternating", 0.3), height), layered(thickness),
                           std::move(obstacles), 20, 10);
    const Mesh above = raised(square(divisions + 1, "one_way", 0.27), height + gap);
    add_cloth(setup.model, make_cloth(above, layered(thickness)));
    const Eigen::Index first = setup.start.x.cols(), all = first + above.vertices();
    setup.start.x.conservativeResize(3, all);
    setup.start.x.rightCols(above.vertices()) = above.rest;
    setup.start.v = Points::Zero(3, all);
    for (Cloth& cloth : setup.model.cloths) cloth.self_contact = true;
    return setup;
}

// Two sheets pressed into each other's barrier, each vertex moving anyhow.
struct Pressed {
    Setup setup = two_sheets(3, 0.006, 0.01);
    Points x = setup.start.x + random_points(x_columns(), 0.004, 5), v = random_points(x_columns(), 0.1, 6);
    std::unique_ptr<SelfContact> contact =
        SelfContact::make(setup.model, {}, Vec3(0, -9.81, 0), setup.start, 1);

    Eigen::Index x_columns() const { return setup.start.x.cols(); }
    Points force(In at, In moving) {
        Points f = Points::Zero(3, x_columns());
        contact->add_all(at, moving, 0, f);
        return f;
    }
    double kinetic_energy() const {
        return 0.5 * v.colwise().squaredNorm().dot(setup.model.mass.transpose());
    }
};

// Frames of which none goes wrong or has a crossing; the largest speed at the last.
double run_apart(Simulation& simulation) {
    FrameReport report;
    while (simulation.frame() < simulation.frames()) {
        report = simulation.advance();
        REQUIRE(report.trouble == "");
        REQUIRE(report.crossings == 0);
    }
    return report.fastest;
}

}  // namespace

TEST_CASE("contact of cloth with cloth pushes by the slope of its energy and keeps both momenta",
          "[contact]") {
    Pressed t;
    const Points still = Points::Zero(3, t.x.cols());
    const Points f = t.force(t.x, still);
    REQUIRE(f.norm() > 0);
    const Points expected = minus_gradient([&](In x) { return t.contact->energy(x, 0); }, t.x, 1e-6);
    CHECK((f - expected).norm() < 1e-5 * f.norm());
    Points conservative = still;
    t.contact->add_conservative(t.x, 0, conservative);
    CHECK((conservative - f).norm() < 1e-14 * f.norm());
    const Points damped = t.force(t.x, t.v);
    CHECK(net_force(damped).norm() < 1e-13 * damped.norm());
    CHECK(net_torque(t.x, damped).norm() < 1e-13 * damped.norm());
}

TEST_CASE("damping and friction between layers take the energy that is booked as heat", "[contact]") {
    Pressed t;
    Points f = Points::Zero(3, t.x.cols()), conservative = f;
    const ObstacleContact::Result result = t.contact->add_all(t.x, t.v, 0, f);
    t.contact->add_conservative(t.x, 0, conservative);
    CHECK(result.contacts > 0);
    CHECK(result.dissipated > 0);
    CHECK(result.dissipated == Approx(-(f - conservative).cwiseProduct(t.v).sum()));
    const double before = t.kinetic_energy();
    const Points v = t.v;
    const ContactWork work = t.contact->rub(t.v, 1e-3);
    CHECK(work.dissipated > 0);
    CHECK(work.dissipated == Approx(before - t.kinetic_energy()));
    const Points impulse = (t.v - v) * t.setup.model.mass.asDiagonal();
    CHECK(net_force(impulse).norm() < 1e-13 * impulse.norm());
}

TEST_CASE("impulses between layers book what pins take that move", "[contact]") {
    Pressed t;
    for (const int pinned : {2, 5, 20}) t.setup.model.inverse_mass[pinned] = 0;
    const auto free_energy = [&] {
        double energy = 0;
        for (int i = 0; i < t.v.cols(); ++i)
            if (t.setup.model.inverse_mass[i] > 0)
                energy += t.setup.model.mass[i] * t.v.col(i).squaredNorm() / 2;
        return energy;
    };
    Points f = Points::Zero(3, t.x.cols());
    t.contact->add_all(t.x, t.v, 0, f, NormalDamping::impulse);
    const double before = free_energy();
    const ContactWork work = t.contact->rub(t.v, 1e-3);
    CHECK(work.driven != 0);
    CHECK(free_energy() - before == Approx(work.driven - work.dissipated));
}

TEST_CASE("contact of cloth with cloth gives implicit methods the slopes of its force", "[contact]") {
    Pressed t;
    const Points still = Points::Zero(3, t.x.cols());
    t.contact->couplings_version(t.x, 0);
    Couplings couplings;
    t.contact->add_couplings(couplings);
    BlockMatrix k(t.setup.model, couplings), b(t.setup.model, couplings);
    t.contact->add_stiffness(t.x, still, 0, k);
    t.contact->add_damping(t.x, still, 0, b);
    const Eigen::MatrixXd by_x =
        minus_jacobian([&](In x) { return t.force(x, still); }, t.x, 1e-7, t.setup.model);
    CHECK((dense(k, t.x.cols()) - by_x).norm() < 1e-4 * by_x.norm());
    const Eigen::MatrixXd by_v =
        minus_jacobian([&](In v) { return t.force(t.x, v); }, still, 1e-6, t.setup.model);
    CHECK((dense(b, t.x.cols()) - by_v).norm() < 1e-6 * by_v.norm());
}

TEST_CASE("two sheets come to rest a thickness apart", "[contact]") {
    constexpr double thickness = 0.004;
    Setup setup = two_sheets(5, 0.005, thickness, {obstacle_of("plane", {}, 0.5)}, 0.017);
    setup.frames = 40;
    Simulation simulation(std::move(setup));
    CHECK(run_apart(simulation) < 1e-3);
    const Cloth& above = simulation.model().cloths[1];
    const Points& x = simulation.state().x;
    const double gap = x.row(1).tail(above.vertices()).mean() - x.row(1).head(above.first).mean();
    CHECK(gap > 0.85 * thickness);
    CHECK(gap < 1.02 * thickness);
}

TEST_CASE("two sheets that meet head-on at 50 m/s do not pass", "[contact]") {
    for (const char* method : {"verlet", "rk4"}) {
        CAPTURE(method);
        Setup setup = two_sheets(4, 0.2, 0.002);
        setup.method = method;
        setup.world.gravity.setZero();
        const Eigen::Index below = setup.model.cloths[0].vertices();
        setup.start.v.row(1).head(below).setConstant(25);
        setup.start.v.row(1).tail(setup.start.v.cols() - below).setConstant(-25);
        setup.frame_rate = 1000;
        setup.frames = 12;
        Simulation simulation(std::move(setup));
        const double start = simulation.energies().total();
        run_apart(simulation);
        const Points& x = simulation.state().x;
        CHECK(x.row(1).head(below).mean() < x.row(1).tail(x.cols() - below).mean());
        CHECK(drift(simulation, start) < 0.05 * start);  // measured 0.031 and 0.023: steps as long as may be
    }
}

// Wind is no speed that anything starts with: the barrier is as weak as the weight asks.
TEST_CASE("a sheet that a storm throws at another does not pass, though nothing foresaw it", "[contact]") {
    Setup setup = two_sheets(4, 0.2, 0.0003);
    setup.world.air.aerodynamic = true;
    setup.world.air.wind = Vec3(0, -60, 0);
    PinGroup held;
    for (int i = 0; i < setup.model.cloths[0].vertices(); ++i) held.vertices.push_back(i);
    held.anchors = setup.start.x.leftCols(setup.model.cloths[0].vertices());
    add_pins(setup.model, held);
    setup.frame_rate = 1000;
    setup.frames = 30;
    Simulation simulation(std::move(setup));
    run_apart(simulation);
    const Points& x = simulation.state().x;
    const Eigen::Index below = simulation.model().cloths[0].vertices();
    CHECK(x.row(1).tail(x.cols() - below).mean() < 1.1);  // it got there
    CHECK(x.row(1).head(below).mean() < x.row(1).tail(x.cols() - below).mean());
}

TEST_CASE("a sheet folded over and let go crosses itself in no frame", "[contact]") {
    for (const char* method : {"verlet", "backward_euler"}) {
        CAPTURE(method);
        const Mesh mesh = square(10, "alternating", 0.3);
        Setup setup = setup_of(mesh, layered(0.003), {obstacle_of("plane", {}, 0.4)}, 40, 16);
        setup.method = method;
        setup.model.cloths[0].self_contact = true;
        // a half turn of radius 2 cm between two flat halves
        for (Eigen::Index i = 0; i < setup.start.x.cols(); ++i) {
            constexpr double radius = 0.02, length = radius * std::numbers::pi;
            const double along = mesh.rest(0, i), angle = std::clamp(along / radius, 0.0, std::numbers::pi);
            setup.start.x.col(i) =
                Vec3(std::min(along, 0.0) + radius * std::sin(angle) - std::max(along - length, 0.0),
                     0.02 + radius * (1 - std::cos(angle)), mesh.rest(2, i));
        }
        Simulation simulation(std::move(setup));
        const double start = simulation.energies().total();
        run_apart(simulation);
        CHECK(simulation.energies().total() - start < 1e-6);
    }
}

TEST_CASE("a cloth that never touches itself moves by the same bits with self contact", "[contact]") {
    std::string hash[2];
    for (const bool meets : {false, true}) {
        Setup setup = ball_drop(6);
        setup.frames = 5;  // then its corners meet below the ball
        setup.model.cloths[0].self_contact = meets;
        Simulation simulation(std::move(setup));
        while (simulation.frame() < simulation.frames()) {
            const FrameReport report = simulation.advance();
            REQUIRE(report.trouble == "");
            CHECK(report.crossings == (meets ? 0 : -1));
            hash[meets] += report.hash;
        }
    }
    CHECK(hash[0] == hash[1]);
}

TEST_CASE("a run that goes on from a frame has the bits of one that was never stopped", "[contact]") {
    const auto piled = [] { return two_sheets(4, 0.006, 0.004, {sphere(Vec3(0, 0.9, 0), 0.08, 0.3)}); };
    Simulation whole(piled()), first(piled()), second(piled());
    std::string hash;
    for (int i = 0; i < 8; ++i) hash = whole.advance().hash;
    for (int i = 0; i < 5; ++i) first.advance();
    ByteWriter out;
    first.save(out);
    const std::string bytes = std::move(out).bytes();
    ByteReader in(bytes);
    REQUIRE(second.restore(in));
    for (int i = 5; i < 8; ++i) hash += second.advance().hash;
    CHECK(hash.substr(hash.size() - 16) == hash.substr(0, 16));
}

TEST_CASE("cloth that starts crossing or touching itself is refused with what crosses", "[contact]") {
    Setup crossing = two_sheets(3, 0.02, 0.001);
    crossing.start.x(1, crossing.model.cloths[0].vertices() + 6) -= 0.05;
    CHECK_THAT(error_of([&] { Simulation simulation(crossing); }), Catch::Contains("starts crossing") &&
                                                                       Catch::Contains("triangles in") &&
                                                                       Catch::Contains("the first "));
    CHECK_THAT(error_of([&] { Simulation simulation(two_sheets(3, 1e-6, 0.001)); }),
               Catch::Contains("m from itself at vertices"));
}

TEST_CASE("methods that cannot keep cloth off cloth say so", "[contact]") {
    for (const char* method : {"xpbd", "projective_dynamics"}) {
        Setup setup = two_sheets(2, 0.02, 0.001);
        setup.method = method;
        CHECK(error_of([&] { Simulation simulation(setup); }) ==
              cat("method ", method, " cannot do self_contact = true (verlet and backward_euler can)"));
    }
}

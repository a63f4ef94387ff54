#include <catch2/catch.hpp>
#include <numbers>

#include "contact/self_contact.h"
#include "support/gradient.h"
#include "support/matrices.h"
#include "support/meshes.h"
#include "support/obstacles.h"
#include "support/touching.h"

using namespace drape;
using namespace drape::test;

namespace {

constexpr double skin = 0.008;  // of every mesh here [m]

Obstacle mesh_obstacle(Mesh mesh, double friction = 0.3, RigidMotion motion = {}) {
    return {"mesh", make_mesh(std::move(mesh)), std::move(motion), friction, skin};
}

// A sheet in the barrier of a coarser, buckled one that moves, each vertex moving anyhow.
struct Pressed {
    Obstacle below = mesh_obstacle(buckled(), 0.3, wobble());
    Setup setup = setup_of(square(4, "one_way", 0.2), full_fabric(), {below}, 20, 10);
    double time = 0.4;
    Points x = facing(), v = random_points(x.cols(), 0.1, 6);
    std::unique_ptr<SelfContact> contact =
        SelfContact::make(setup.model, setup.obstacles, Vec3(0, -9.81, 0), setup.start, 1);

    static Mesh buckled() {
        Mesh mesh = square(3, "alternating", 0.3);
        mesh.rest += random_points(mesh.rest.cols(), 0.003, 8);
        return mesh;
    }
    Points facing() const {
        const Pose pose = below.motion.at(time).pose;
        Points at = setup.start.x + random_points(setup.start.x.cols(), 0.002, 5);
        for (Eigen::Index i = 0; i < at.cols(); ++i)
            at.col(i) = pose * Vec3(at.col(i) + 0.006 * Vec3::UnitY());
        return at;
    }
    Points force(In at, In moving) {
        Points f = Points::Zero(3, at.cols());
        contact->add_all(at, moving, time, f);
        return f;
    }
    double kinetic_energy() const {
        return 0.5 * v.colwise().squaredNorm().dot(setup.model.mass.transpose());
    }
};

Mesh ball_mesh(const Vec3& centre, double radius) {
    return sphere(centre, radius, 0.3).solid->surface(1);
}

Setup drop(std::vector<Obstacle> obstacles, std::string_view method = "verlet", int frames = 16) {
    Setup setup = setup_of(raised(square(8, "alternating", 0.3), 0.35), full_fabric(), std::move(obstacles),
                           40, frames);
    setup.method = method;
    return setup;
}

void run_apart(Simulation& simulation) {
    while (simulation.frame() < simulation.frames()) {
        const FrameReport report = simulation.advance();
        REQUIRE(report.trouble == "");
        REQUIRE(report.crossings == 0);
    }
}

}  // namespace

TEST_CASE("contact with a mesh pushes by the slope of its energy", "[contact]") {
    Pressed t;
    const Points still = Points::Zero(3, t.x.cols());
    const Points expected = minus_gradient([&](In x) { return t.contact->energy(x, t.time); }, t.x, 1e-6);
    REQUIRE(expected.norm() > 0);
    Points conservative = still;
    t.contact->add_conservative(t.x, t.time, conservative);
    CHECK((conservative - expected).norm() < 1e-5 * expected.norm());
}

TEST_CASE("what moves a mesh pays for what contact with it gives and takes", "[contact]") {
    Pressed t;
    const ObstacleContact::Result result = [&] {
        Points f = Points::Zero(3, t.x.cols());
        return t.contact->add_all(t.x, t.v, t.time, f);
    }();
    CHECK(result.contacts > 0);
    // the change of the barrier's energy along the motion of both, and what the force does to the cloth
    constexpr double h = 1e-6;
    const double slope =
        (t.contact->energy(t.x + h * t.v, t.time + h) - t.contact->energy(t.x - h * t.v, t.time - h)) /
        (2 * h);
    const double power = t.force(t.x, t.v).cwiseProduct(t.v).sum();
    CHECK(result.driven != 0);
    CHECK(power + slope == Approx(result.driven - result.dissipated).epsilon(1e-5));

    const double before = t.kinetic_energy();
    const ContactWork work = t.contact->rub(t.v, 1e-3);
    CHECK(work.dissipated > 0);
    CHECK(t.kinetic_energy() - before == Approx(work.driven - work.dissipated));
}

TEST_CASE("contact with a mesh gives implicit methods the slopes of its force", "[contact]") {
    Pressed t;
    t.below.motion = {};
    t.setup.obstacles = {t.below};
    t.contact = SelfContact::make(t.setup.model, t.setup.obstacles, Vec3(0, -9.81, 0), t.setup.start, 1);
    t.x = t.setup.start.x + random_points(t.x.cols(), 0.002, 5);
    t.x.row(1).array() += 0.006;
    const Points still = Points::Zero(3, t.x.cols());
    t.contact->couplings_version(t.x, t.time);
    Couplings couplings;
    t.contact->add_couplings(couplings);
    BlockMatrix k(t.setup.model, couplings), b(t.setup.model, couplings);
    t.contact->add_stiffness(t.x, still, t.time, k);
    t.contact->add_damping(t.x, still, t.time, b);
    const Eigen::MatrixXd by_x =
        minus_jacobian([&](In x) { return t.force(x, still); }, t.x, 1e-7, t.setup.model);
    CHECK(by_x.norm() > 0);
    CHECK((dense(k, t.x.cols()) - by_x).norm() < 1e-4 * by_x.norm());
    const Eigen::MatrixXd by_v =
        minus_jacobian([&](In v) { return t.force(t.x, v); }, still, 1e-6, t.setup.model);
    CHECK((dense(b, t.x.cols()) - by_v).norm() < 1e-6 * by_v.norm());
}

TEST_CASE("friction on a mesh slides against its motion, as implicit methods see it", "[contact]") {
    Pressed t;
    t.force(t.x, t.v);
    std::vector<Grip> grips;
    t.contact->list_grips(grips);
    REQUIRE(!grips.empty());
    const MovingPose moving = t.below.motion.at(t.time);
    for (const Grip& grip : grips) {
        CHECK(grip.corners < 4);
        double weights = 0;
        Vec3 at = Vec3::Zero();
        for (int k = 0; k < grip.corners; ++k) {
            weights += grip.weight[k];
            at += grip.weight[k] * t.x.col(grip.vertex[k]);
        }
        // the cloth's weights are a point of it, seen from either side
        CHECK(std::abs(weights) == Approx(1));
        const Vec3 surface = weights * moving.velocity_at(weights * at);
        CHECK((grip.surface_velocity - surface).norm() < 0.02 * surface.norm() + 0.02);
    }
}

TEST_CASE("cloth comes to rest on a mesh as it does on the solid the mesh is of", "[contact]") {
    const Vec3 centre(0, 0.2, 0);
    Simulation on_mesh(drop({mesh_obstacle(ball_mesh(centre, 0.1))}));
    run_apart(on_mesh);
    const double least = [&] {
        double distance = INFINITY;
        for (const auto& p : on_mesh.state().x.colwise())
            distance = std::min(distance, (p - centre).norm() - 0.1);
        return distance;
    }();
    // the barrier is the skin and half the fabric thick, and the mesh lies within its ball by next to nothing
    CHECK(least > 0.3 * skin);
    CHECK(least < 1.1 * skin);
    CHECK(on_mesh.state().x.row(1).maxCoeff() > 0.3);
}

TEST_CASE("cloth hangs over a single edge of an open mesh, whichever way it faces", "[contact]") {
    for (const bool flipped : {false, true}) {
        CAPTURE(flipped);
        // an upright plate of two triangles, as long as three cloths
        Mesh plate;
        plate.rest = points_of({{-0.5, 0, 0}, {0.5, 0, 0}, {0.5, 0.25, 0}, {-0.5, 0.25, 0}});
        plate.faces = flipped ? faces_of({{0, 2, 1}, {0, 3, 2}}) : faces_of({{0, 1, 2}, {0, 2, 3}});
        for (const char* method : {"verlet", "backward_euler"}) {
            CAPTURE(method);
            Simulation simulation(drop({mesh_obstacle(plate, 0.6)}, method));
            run_apart(simulation);
            CHECK(simulation.state().x.row(1).maxCoeff() > 0.25);
            CHECK(simulation.state().x.row(1).minCoeff() < 0.22);
        }
    }
}

TEST_CASE("a mesh that moves takes cloth along and books what it does", "[contact]") {
    const RigidMotion lift({{0, Vec3::Zero(), Vec3::Zero()}, {0.4, Vec3(0, 0.5, 0), Vec3(0, 90, 0)}});
    Setup setup = drop({mesh_obstacle(ball_mesh(Vec3(0, 0.2, 0), 0.1), 0.5, lift)});
    setup.model.cloths[0].self_contact = true;
    Simulation simulation(std::move(setup));
    const double start = simulation.energies().total();
    run_apart(simulation);
    CHECK(simulation.state().x.row(1).maxCoeff() > 0.75);
    CHECK(std::abs(drift(simulation, start)) < 0.02 * std::abs(simulation.flow().driven));
}

TEST_CASE("what a mesh does not reach moves by the same bits", "[contact]") {
    std::string hash[2];
    for (const bool beside : {false, true}) {
        std::vector<Obstacle> obstacles{sphere(Vec3(0, 0.2, 0), 0.1, 0.3)};
        if (beside) obstacles.push_back(mesh_obstacle(ball_mesh(Vec3(0.45, 0.2, 0), 0.1)));
        Simulation simulation(drop(std::move(obstacles), "verlet", 6));
        while (simulation.frame() < simulation.frames()) hash[beside] += simulation.advance().hash;
    }
    CHECK(hash[0] == hash[1]);
}

TEST_CASE("cloth that starts crossing a mesh is refused, a mesh that crosses itself is not", "[contact]") {
    Mesh crossed = ball_mesh(Vec3(0, 0.2, 0), 0.1);
    const Mesh other = ball_mesh(Vec3(0.05, 0.2, 0), 0.1);
    const int first = crossed.vertices();
    crossed.rest.conservativeResize(3, first + other.vertices());
    crossed.rest.rightCols(other.vertices()) = other.rest;
    Faces faces(3, crossed.triangles() + other.triangles());
    faces << crossed.faces, (other.faces.array() + first).matrix();
    crossed.faces = faces;
    Simulation simulation(drop({mesh_obstacle(crossed)}, "verlet", 8));
    run_apart(simulation);

    Setup setup = drop({mesh_obstacle(crossed)});
    setup.start.x.row(1).array() -= 0.1;
    CHECK_THAT(error_of([&] { Simulation refused(setup); }),
               Catch::Contains("cloth starts crossing the mesh: "));
}

TEST_CASE("methods that cannot keep cloth off a mesh say so", "[contact]") {
    for (const char* method : {"xpbd", "projective_dynamics"})
        CHECK(error_of([&] {
                  Simulation simulation(drop({mesh_obstacle(ball_mesh(Vec3(0, 0.2, 0), 0.1))}, method));
              }) ==
              cat("method ", method, " cannot do obstacles that are meshes (verlet and backward_euler can)"));
}

#include "support/touching.h"

#include "base/rigid_motion.h"

namespace drape::test {

Fabric Touching::fabric() {
    Fabric fabric = bare_springs(10);
    fabric.thickness = 0.01;
    return fabric;
}

Touching::Touching(const Obstacle& obstacle, unsigned seed, double speed)
    : model(model_of(square(3, "alternating", 0.06), fabric())),
      contact(model, model.cloths[0], obstacle, Vec3(0, -9.81, 0), 1),
      x(model.cloths[0].mesh.rest),
      v(random_points(x.cols(), speed, seed)) {
    std::mt19937 random(seed);
    const Solid& solid = *obstacle.solid;
    const double far = std::isfinite(solid.reach()) ? 3 * solid.reach() : 1;
    const Vec3 spot = on_surface(solid, solid.centre() + far * random_direction(random));
    const Mat3 turn = rotation_from_up(solid.sample(spot).normal);
    const double d = contact.barrier().thickness;
    x += random_points(x.cols(), 0.2 * d, seed + 1);
    x.row(1).array() += contact.offset() + 0.5 * d;
    const Pose pose = obstacle.motion.at(time).pose;
    for (Eigen::Index i = 0; i < x.cols(); ++i) x.col(i) = pose * (spot + turn * x.col(i));
    contact.gather(x, time, 1);
}

double Touching::kinetic_energy() const {
    return 0.5 * v.colwise().squaredNorm().dot(model.mass);
}

RigidMotion wobble() {
    return RigidMotion({{0, Vec3(0, 0, 0), Vec3(0, 0, 0)}, {1, Vec3(0.5, -0.3, 0.8), Vec3(90, 50, -120)}});
}

std::vector<std::pair<std::string, Obstacle>> every_obstacle(double friction) {
    std::vector<std::pair<std::string, Obstacle>> obstacles;
    for (const TestSolid& s : every_solid())
        for (const bool moves : {false, true})
            obstacles.emplace_back(cat(s.name, moves ? ", moving" : ", at rest"),
                                   Obstacle{s.name, s.solid, moves ? wobble() : RigidMotion(), friction});
    return obstacles;
}

Setup setup_of(Mesh mesh, const Fabric& fabric, std::vector<Obstacle> obstacles, double frame_rate,
               int frames) {
    Setup setup = scene_of(std::move(mesh), fabric);
    setup.obstacles = std::move(obstacles);
    setup.frame_rate = frame_rate;
    setup.frames = frames;
    return setup;
}

Mesh raised(Mesh mesh, double height) {
    mesh.rest.row(1).array() += height;
    return mesh;
}

double drift(const Simulation& simulation, double start) {
    return simulation.energies().total() + simulation.flow().dissipated - simulation.flow().driven - start;
}

double lattice_distance(const Faces& faces, In x, const Obstacle& obstacle, double time, int parts) {
    const Pose pose = obstacle.motion.at(time).pose;
    double least = INFINITY;
    for (Eigen::Index f = 0; f < faces.cols(); ++f) {
        const Vec3 a = x.col(faces(0, f)), b = x.col(faces(1, f)), c = x.col(faces(2, f));
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j) {
                const Vec3 p = a + double(i) / parts * (b - a) + double(j) / parts * (c - a);
                least = std::min(least, obstacle.solid->sample(pose.back(p)).distance);
            }
    }
    return least;
}

}  // namespace drape::test

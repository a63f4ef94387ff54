#include "scene/builder.h"

#include "base/error.h"
#include "base/names.h"
#include "base/timer.h"
#include "io/load_mesh.h"
#include "scene/curved_places.h"
#include "scene/find_pins.h"

namespace drape {

namespace {

Mesh load_noted(const SceneDescription& scene, const std::string& file, const Place& place,
                std::vector<std::string>& notes) {
    LoadedMesh loaded = in_context(place.text, [&] { return load_mesh(scene.path_to(file)); });
    for (const std::string& note : loaded.notes) notes.push_back(cat(file, ": ", note));
    if (loaded.dropped_zero_area > 0)
        notes.push_back(cat(file, ": ", loaded.dropped_zero_area, " triangles without area left out"));
    if (loaded.dropped_points_lines > 0)
        notes.push_back(cat(file, ": ", loaded.dropped_points_lines, " points and lines left out"));
    if (loaded.unused_vertices > 0)
        notes.push_back(
            cat(file, ": ", loaded.unused_vertices, " vertices belong to no triangle and stand still"));
    return std::move(loaded.mesh);
}

Points place(const Placement& placement, const Points& points) {
    const Mat3 turn = placement.scale * rotation_from_degrees(placement.rotate_deg);
    return (turn * points).colwise() + placement.translate;
}

// Positions of another file with the same vertices in the same order.
Points start_from_mesh(const SceneDescription& scene, const ClothDescription& cloth, const Mesh& rest,
                       std::vector<std::string>& notes) {
    const LoadedPositions other = in_context(cloth.start_mesh_place.text,
                                             [&] { return load_positions(scene.path_to(cloth.start.mesh)); });
    for (const std::string& note : other.notes) notes.push_back(cat(cloth.start.mesh, ": ", note));
    if (static_cast<size_t>(other.x.cols()) != rest.file_vertex.size())
        throw Error(cat(cloth.start_mesh_place.text, ": ", cloth.start.mesh, " has ", other.x.cols(),
                        " vertices, the cloth's mesh has ", rest.file_vertex.size(),
                        " (they must be the same, in the same order)"));
    Points start = rest.rest;
    for (size_t i = 0; i < rest.file_vertex.size(); ++i)
        if (rest.file_vertex[i] >= 0)
            start.col(rest.file_vertex[i]) = other.x.col(static_cast<Eigen::Index>(i));
    return place(cloth.placement, start);
}

Points start_positions(const SceneDescription& scene, const ClothDescription& cloth, const Mesh& rest,
                       std::vector<std::string>& notes) {
    if (!cloth.start.mesh.empty()) return start_from_mesh(scene, cloth, rest, notes);
    if (cloth.start.scale == Vec3::Ones()) return rest.rest;
    // scaled along the axes of the rest shape as its file has it
    const Mat3 turn = rotation_from_degrees(cloth.placement.rotate_deg);
    const Vec3 centre = (rest.rest.rowwise().minCoeff() + rest.rest.rowwise().maxCoeff()) / 2;
    const Mat3 stretch = turn * cloth.start.scale.asDiagonal() * turn.transpose();
    return (stretch * (rest.rest.colwise() - centre)).colwise() + centre;
}

void append(State& state, const Points& x, const Vec3& velocity) {
    const Eigen::Index before = state.x.cols();
    state.x.conservativeResize(3, before + x.cols());
    state.v.conservativeResize(3, before + x.cols());
    state.x.rightCols(x.cols()) = x;
    state.v.rightCols(x.cols()).colwise() = velocity;
}

std::shared_ptr<const Solid> make_solid(const SceneDescription& scene, const ObstacleDescription& obstacle,
                                        std::vector<std::string>& notes) {
    const SolidKind& kind = find_named(obstacle_kinds(), "obstacle", obstacle.shape);
    if (kind.make) return in_context(obstacle.place.text, [&] { return kind.make(obstacle.parameters); });
    Mesh mesh = load_noted(scene, obstacle.mesh, obstacle.mesh_place, notes);
    mesh.rest = place(obstacle.placement, mesh.rest);
    return make_mesh(std::move(mesh));
}

}  // namespace

PatternSize pattern_size_of(const SceneDescription& scene, const ClothDescription& cloth) {
    PatternSize size = cloth.pattern_size;
    if (!cloth.curved.mesh.empty())
        size.finer.curved = in_context(cloth.curved.place.text, [&] {
            const std::string& positions = cloth.curved.positions;
            return curved_places(scene.path_to(cloth.curved.mesh),
                                 positions.empty() ? "" : scene.path_to(positions));
        });
    return size;
}

Mesh placed_mesh(const SceneDescription& scene, const ClothDescription& cloth,
                 std::vector<std::string>& notes) {
    Mesh mesh = cloth.mesh.empty()
                    ? in_context(cloth.mesh_place.text,
                                 [&] { return make_pattern(cloth.pattern, pattern_size_of(scene, cloth)); })
                    : load_noted(scene, cloth.mesh, cloth.mesh_place, notes);
    mesh.rest = place(cloth.placement, mesh.rest);
    mesh.unused = place(cloth.placement, mesh.unused);
    return mesh;
}

Built build_scene(const SceneDescription& scene) {
    Built built;
    Setup& setup = built.setup;
    for (const ClothDescription& description : scene.cloths) {
        Mesh mesh;
        Points start;
        {
            const CpuScope timer(built.load_seconds);
            mesh = placed_mesh(scene, description, built.notes);
            start = start_positions(scene, description, mesh, built.notes);
        }
        add_cloth(setup.model, make_cloth(std::move(mesh), description.fabric));
        setup.model.cloths.back().self_contact = description.self_contact;
        append(setup.start, start, description.start.velocity);
        const Cloth& cloth = setup.model.cloths.back();
        for (const PinDescription& pin : description.pins)
            add_pins(setup.model, find_pins(pin, cloth, setup.start.x));
    }
    for (const ObstacleDescription& obstacle : scene.obstacles) {
        const CpuScope timer(built.load_seconds);
        const std::shared_ptr<const Solid> solid = make_solid(scene, obstacle, built.notes);
        setup.obstacles.push_back({obstacle.shape, solid,
                                   RigidMotion(obstacle.motion, obstacle.about.value_or(solid->centre())),
                                   obstacle.friction, obstacle.thickness, obstacle.place.text});
    }
    setup.world = {scene.gravity, scene.air};
    setup.world.air.seed = scene.seed;
    setup.frame_rate = scene.frame_rate;
    setup.frames = scene.frames();
    if (scene.accuracy.method != "auto") setup.method = scene.accuracy.method;
    setup.step = scene.accuracy.step;
    return built;
}

}  // namespace drape

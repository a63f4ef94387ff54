// inspect: what a scene uses, needs and costs, or what a mesh is like. Nothing is simulated.
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/demo_scenes.h"
#include "app/verbs.h"
#include "base/plain_line.h"
#include "io/load_mesh.h"
#include "mesh/crossings.h"
#include "mesh/quality.h"
#include "scene/builder.h"
#include "scene/reader.h"
#include "scene/scene_text.h"
#include "simulate/predicted_cost.h"
#include "simulate/ways.h"

namespace drape {

namespace {

void print_mesh(const Mesh& mesh) {
    const Topology topology = build_topology(mesh.faces, mesh.vertices());
    const MeshQuality q = measure_quality(mesh, topology);
    const Vec3 size = mesh.rest.rowwise().maxCoeff() - mesh.rest.rowwise().minCoeff();
    std::printf("  vertices            %d (%d in the file)\n", q.vertices,
                static_cast<int>(mesh.file_vertex.size()));
    std::printf("  edges, triangles    %d, %d\n", q.edges, q.triangles);
    std::printf("  components          %d\n", q.components);
    std::printf("  boundary loops      %d\n", q.boundary_loops);
    std::printf("  non-manifold edges  %d\n", q.non_manifold_edges);
    std::printf("  size                %.4g x %.4g x %.4g m, area %.4g m^2\n", size.x(), size.y(), size.z(),
                q.area);
    std::printf("  edge length         %.3g to %.3g m, mean %.3g m\n", q.shortest_edge, q.longest_edge,
                q.mean_edge);
    std::printf("  smallest angle      %.1f degrees (triangle %d)\n", q.smallest_angle_deg, q.worst_triangle);
    std::printf("  slivers             %d; the worst vertex makes the step %.2f times smaller\n", q.slivers,
                q.step_cost);
}

void print_fabric(const Cloth& cloth) {
    std::printf("  mass                %.4g kg\n", cloth.mass.sum());
    if (cloth.fabric.stretch == 0) return;
    const DirectionalModulus& m = cloth.network.modulus;
    if (cloth.fabric.membrane != MembraneKind::none) {
        std::printf("  stretch modulus     %.4g N/m in every direction, Poisson's ratio %g\n", m.mean,
                    cloth.fabric.membrane_poisson);
        return;
    }
    std::printf("  stretch modulus     %.4g N/m mean; %.4g at %.0f degrees to %.4g at %.0f degrees\n", m.mean,
                m.least, m.least_angle_deg, m.most, m.most_angle_deg);
    if (cloth.fabric.stretch_model == StretchModel::membrane)
        std::printf("  calibration         springs times %.4f, so that the mean is the fabric's\n",
                    cloth.network.calibration);
}

void print_plan(const Plan& plan) {
    std::printf("plan\n");
    for (const Stage& stage : plan.stages)
        std::printf("  %s %-34s %s\n", stage.used ? "used    " : "left out", stage.name.c_str(),
                    stage.because.c_str());
}

// How a run of the scene goes about it: the way that it tries first, and those that it may turn to.
struct Course {
    Setup first;
    std::vector<Way> then;
    const char* estimate;  // how the error is
};

Course course_of(const Setup& setup, const AccuracyDescription& accuracy) {
    if (!accuracy.tolerance && !accuracy.budget)
        return {setup, {}, "not quite as much again (--no-estimate leaves it out)"};
    const Ways ways = accuracy.tolerance ? ways_to(setup, *accuracy.tolerance) : ways_within_budget(setup);
    Course course{{}, {}, "a tolerance is asked: such passes until it is met"};
    std::vector<Way> all;
    if (ways.rough) all.push_back(*ways.rough);
    all.push_back(ways.usual);
    if (ways.fine) all.push_back(*ways.fine);
    // within a budget the rough way is for want of time
    const size_t first = !accuracy.tolerance && ways.rough ? 1 : 0;
    if (!accuracy.tolerance)
        course.estimate = "if the budget has time; steps are as many as it affords, these are the fewest";
    course.first = pass_along(all[first], setup, 1);
    for (size_t i = 0; i < all.size(); ++i)
        if (i != first) course.then.push_back(all[i]);
    return course;
}

// a step up to which something holds
std::string step_text(double seconds) {
    if (!std::isfinite(seconds)) return "any step";
    char text[32];
    std::snprintf(text, sizeof text, "%.4g s", seconds);
    return text;
}

void print_step(const Simulation& simulation, const Course& course) {
    const PredictedCost cost = predicted_cost(simulation);
    std::printf("step\n");
    std::printf("  method              %.*s: %s\n", static_cast<int>(simulation.method().name.size()),
                simulation.method().name.data(), simulation.chosen_because().c_str());
    for (const Way& way : course.then)
        std::printf("  or                  %s: %s\n", way.method.c_str(), way.because.c_str());
    std::printf("  guaranteed stable   %s (Gershgorin's bound)\n",
                step_text(simulation.guaranteed_step()).c_str());
    std::printf("  longest stable      %s (fastest mode measured, less 10 %%)\n",
                step_text(simulation.longest_step()).c_str());
    std::printf("  used                %.4g s: %.0f steps a frame, %.0f in all\n", simulation.step(),
                cost.steps / simulation.frames(), cost.steps);
    std::printf("predicted cost\n");
    std::printf("  simulate            %.3g CPU s (%.3g ms a step%s)\n", cost.seconds,
                1e3 * cost.seconds / cost.steps,
                simulation.obstacles().empty() ? "" : "; hard contact makes steps shorter");
    std::printf("  estimate the error  %s\n", course.estimate);
}

Exit inspect_mesh(const std::string& path) {
    const LoadedMesh loaded = load_mesh(path);
    std::printf("%s\n", path.c_str());
    print_mesh(loaded.mesh);
    std::printf("  left out            %d triangles without area, %d points and lines, %d unused vertices\n",
                loaded.dropped_zero_area, loaded.dropped_points_lines, loaded.unused_vertices);
    const Crossings crossings = count_crossings(loaded.mesh.faces, loaded.mesh.rest);
    std::printf("  crossings           %d triangles cross or touch others, in %d pairs", crossings.triangles,
                crossings.pairs);
    if (crossings.pairs > 0) std::printf(", the first %d and %d", crossings.first[0], crossings.first[1]);
    std::printf("\n");
    for (const std::string& note : loaded.notes)
        std::printf("  note                %s\n", plain_line(note).c_str());
    return Exit::done;
}

Exit inspect_scene(const std::string& path, const std::vector<std::string>& overrides) {
    const SceneDescription scene = read_scene(path, overrides);
    Built built = build_scene(scene);
    const Course course = course_of(built.setup, scene.accuracy);
    const Simulation simulation(course.first);
    std::printf("%s: %s, %d frames at %g a second\n", path.c_str(), plain_line(scene.name).c_str(),
                simulation.frames(), simulation.frame_rate());
    const std::vector<Cloth>& cloths = simulation.model().cloths;
    for (size_t c = 0; c < cloths.size(); ++c) {
        std::printf("cloth %zu\n", c + 1);
        print_mesh(cloths[c].mesh);
        print_fabric(cloths[c]);
    }
    for (const std::string& note : built.notes)
        std::printf("  note                %s\n", plain_line(note).c_str());
    print_plan(simulation.plan());
    print_step(simulation, course);
    std::printf("effective scene\n%s", scene_text(scene).c_str());
    return Exit::done;
}

}  // namespace

Exit inspect(const std::string& path, const std::vector<std::string>& overrides) {
    const std::filesystem::path file(path);
    const bool is_mesh = file.has_extension() && file.extension() != ".toml";
    if (!is_mesh) return inspect_scene(scene_path(path), overrides);
    if (!overrides.empty())
        throw Error(path + ": --set changes a scene, and this is a mesh (scenes end in .toml)");
    return inspect_mesh(path);
}

}  // namespace drape

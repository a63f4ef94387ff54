#include "simulate/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "contact/self_contact.h"

namespace drape {

namespace {

constexpr double sliver_aspect = 100;   // longest side over smallest height
constexpr double far_stretched = 0.3;   // strain
constexpr double light_vertex = 0.001;  // of the median mass

// the first that is not finite, else the fastest
int worst_vertex(const State& state) {
    int worst = 0;
    double fastest = -1;
    for (int i = 0; i < static_cast<int>(state.x.cols()); ++i) {
        const double speed = state.v.col(i).norm();
        if (!std::isfinite(speed) || !state.x.col(i).allFinite()) return i;
        if (speed > fastest) {
            fastest = speed;
            worst = i;
        }
    }
    return worst;
}

// the force with the largest share there; where positions are not finite any more, the first without a number
std::string strongest_force(const Dynamics& dynamics, const State& state, int vertex) {
    std::string strongest = "none";
    double most = 0;
    for (const ActiveForce& active : dynamics.forces()) {
        Points f = Points::Zero(3, state.x.cols());
        active.force->add_conservative(state.x, f);
        const double size = f.col(vertex).norm();
        if (!std::isfinite(size)) return active.stage;
        if (size > most) {
            most = size;
            strongest = active.stage;
        }
    }
    return strongest;
}

std::string_view met_by_cloth(const Dynamics& dynamics) {
    const Contact* contact = dynamics.contact();
    if (!contact || !contact->self()) return "an obstacle";
    const bool alone = contact->pairs().empty() && contact->self()->surfaces().meshes() == 0;
    return alone ? "cloth" : "an obstacle or cloth";
}

double median_mass(const Model& model) {
    std::vector<double> mass(model.mass.data(), model.mass.data() + model.mass.size());
    const auto middle = mass.begin() + static_cast<std::ptrdiff_t>(mass.size() / 2);
    std::nth_element(mass.begin(), middle, mass.end());
    return *middle;
}

// largest aspect of the rest triangles at the vertex
double aspect_at(const Model& model, int vertex) {
    double worst = 0;
    for (const Cloth& cloth : model.cloths) {
        const Mesh& mesh = cloth.mesh;
        for (const auto& face : mesh.faces.colwise()) {
            if (!(face.array() + cloth.first == vertex).any()) continue;
            const Vec3 a = mesh.rest.col(face[0]), b = mesh.rest.col(face[1]), c = mesh.rest.col(face[2]);
            const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
            worst = std::max(worst, longest * longest / (b - a).cross(c - a).norm());
        }
    }
    return worst;
}

std::string likely_cause(const Dynamics& dynamics, int vertex, const StepTaken& taken) {
    const Model& model = dynamics.model();
    if (taken.step > taken.longest)
        return cat("the step of ", taken.step, " s is beyond the longest stable one of ", taken.longest,
                   " s");
    if (const double aspect = aspect_at(model, vertex); aspect > sliver_aspect)
        return cat("a sliver at that vertex, ", aspect, " times as long as high");
    if (const double share = model.mass[vertex] / median_mass(model); share < light_vertex)
        return cat("a vertex of ", model.mass[vertex], " kg, ", share, " of the usual mass");
    if (dynamics.touch().contacts > 0)
        return cat("contact with ", met_by_cloth(dynamics), ", stiffer than the step allows for");
    return cat("forces that change within a step of ", taken.step, " s");
}

}  // namespace

std::string why_it_ran_away(const Dynamics& dynamics, const State& state, const StepTaken& taken) {
    const int vertex = worst_vertex(state);
    return cat("motion ran away at t = ", state.time, " s, at vertex ", vertex, " under ",
               strongest_force(dynamics, state, vertex),
               "; likely cause: ", likely_cause(dynamics, vertex, taken));
}

std::string why_inside(double depth, double time, double strain) {
    return cat("cloth is ", depth, " m inside an obstacle at t = ", time, " s; likely cause: ",
               strain > far_stretched ? cat("edges at ", 1 + strain, " times their length")
                                      : std::string("an obstacle smaller than the triangles"),
               ", between contact points too far apart");
}

std::string why_no_end(const Dynamics& dynamics, const State& state, long steps, double step) {
    const int vertex = worst_vertex(state);
    return cat(steps, " steps, the last of ", step, " s, have come no farther than t = ", state.time,
               " s; likely cause: ",
               dynamics.touch().contacts > 0
                   ? cat("contact with ", met_by_cloth(dynamics), ", far stiffer or faster than the cloth")
                   : cat(strongest_force(dynamics, state, vertex), " at vertex ", vertex));
}

std::string why_no_step(const Dynamics& dynamics, double time) {
    if (dynamics.touch().crossed || dynamics.touch().contacts > 0)
        return cat("cloth was pushed into ", met_by_cloth(dynamics), " at t = ", time,
                   " s and no step, however short, keeps it out");
    return cat("no step from t = ", time, " s, however short, could be solved for");
}

}  // namespace drape

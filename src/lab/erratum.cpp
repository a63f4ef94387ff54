// The notes share an altitude spring's force as f1 = l fm, f2 = (1 - l) fm, l being the foot's place from x1:
// the wrong end's share (force/altitude_spring.h).
#include "lab/erratum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/numbers.h"
#include "force/kinds.h"
#include "lab/elastic.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr double side = 0.1;          // [m]
constexpr double lasts = 0.4;         // a run [s]
constexpr double drawn = 0.15;        // of it [s]
constexpr double stretched = 0.1;     // along the first side
constexpr double step = 2e-5;         // [s], a four hundredth of the vibration
constexpr int every = 20;             // steps a sample
constexpr double run_away = 1e3;      // energy over that at the start
constexpr int loop_steps = 2000;      // of the midpoint rule, which is exact enough
constexpr double loop_radius = 0.15;  // of the apex's circle, over the side
constexpr std::array sharings{FootSharing::lever, FootSharing::notes};

Fabric with_altitudes() {
    Fabric fabric;
    fabric.altitude = AltitudeMode::all;
    return fabric;
}

// The triangle's forces; the notes' sharing is in no table of forces.
std::vector<std::unique_ptr<Force>> forces_with(const Cloth& cloth, FootSharing sharing) {
    std::vector<std::unique_ptr<Force>> forces;
    forces.push_back(make_edge_springs(cloth, {}).force);
    forces.push_back(std::make_unique<AltitudeSprings>(cloth, sharing));
    return forces;
}

struct Motion {
    const Eigen::VectorXd& mass;
    Points x, v;

    double kinetic() const { return 0.5 * (v.colwise().squaredNorm() * mass)(0); }
    Vec3 centre() const { return x * mass / mass.sum(); }
    Vec3 momentum() const {
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i < 3; ++i) sum += mass[i] * (x.col(i) - centre()).cross(Vec3(v.col(i)));
        return sum;
    }
    double inertia() const { return (x.colwise() - centre()).colwise().squaredNorm() * mass; }
};

std::vector<std::array<double, 2>> pairs(const std::vector<double>& x, const std::vector<double>& y,
                                         double scale) {
    std::vector<std::array<double, 2>> points;
    for (size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i] / scale});
    return points;
}

LabFigure erratum_figure(const std::array<FreeTriangle, 2>& runs) {
    PanelGrid grid{2, 1, 400, 320};
    LabFigure figure{"erratum",
                     "A free right-angled triangle, stretched by a tenth and let go. Left its energy over "
                     "that at the start, "
                     "right its angular momentum over the most that this energy could turn into.",
                     grid.width(),
                     grid.height(),
                     "",
                     grid.begin("How an altitude spring's force is shared") + plain_panel() +
                         cat("set xrange [0:", drawn, "]\nset xlabel 'time [s]'\nset key left top\n")};
    const auto panel = [&](const std::string& label, const std::string& name) {
        figure.plot +=
            cat("set ylabel ", plot_quoted(label), "\nplot $", name, "1 using 1:2 with lines lw 2 lc rgb '",
                plot_colour(1), "' title 'as the notes print it', $", name,
                "0 using 1:2 with lines lw 2 lc rgb '", plot_colour(0), "' title 'as a lever has it'\n");
    };
    for (size_t i = 0; i < runs.size(); ++i) {
        figure.data += data_block(cat("e", i), pairs(runs[i].time, runs[i].energy, 1));
        figure.data += data_block(cat("m", i), pairs(runs[i].time, runs[i].momentum, runs[i].momentum_scale));
    }
    figure.plot += "set logscale y\nset format y '10^{%L}'\nset yrange [0.5:*]\n";
    panel("energy over that at the start", "e");
    figure.plot += "unset logscale y\nset format y\nset yrange [*:*]\nunset key\n";
    panel("angular momentum", "m");
    figure.plot += "unset multiplot\n";
    return figure;
}

// Of the energy from its value at the start, at most.
double most_change(const FreeTriangle& run) {
    double most = 0;
    for (const double energy : run.energy) most = std::max(most, std::abs(energy - 1));
    return most;
}

double most_momentum(const FreeTriangle& run) {
    double most = 0;
    for (const double momentum : run.momentum) most = std::max(most, std::abs(momentum));
    return most / run.momentum_scale;
}

std::string runs_csv(const std::array<FreeTriangle, 2>& runs) {
    std::string text = "sharing,time_s,energy_over_start,angular_momentum_kg_m2_per_s\n";
    for (size_t i = 0; i < runs.size(); ++i)
        for (size_t k = 0; k < runs[i].time.size(); ++k)
            text += cat(i == 0 ? "lever" : "notes", ",", csv_number(runs[i].time[k]), ",",
                        csv_number(runs[i].energy[k]), ",", csv_number(runs[i].momentum[k]), "\n");
    return text;
}

}  // namespace

std::vector<TriangleShape> erratum_shapes() {
    return {{"right-angled, 10 : 6", 0, 0.6},
            {"half a square", 0, 1},
            {"acute", 0.3, 0.8},
            {"obtuse", -0.2, 0.6},
            {"equilateral", 0.5, std::sqrt(0.75)}};
}

FreeTriangle free_triangle(const TriangleShape& shape, FootSharing sharing, double duration) {
    const Model model = free_cloth(lone_triangle(side, shape.along, shape.above), with_altitudes());
    const Cloth& cloth = model.cloths.front();
    const auto forces = forces_with(cloth, sharing);
    Motion motion{cloth.mass, cloth.mesh.rest, Points::Zero(3, 3)};
    motion.x.row(0) *= 1 + stretched;
    const double start = energy_of(forces, motion.x);
    FreeTriangle run;
    run.momentum_scale = std::sqrt(2 * start * motion.inertia());

    // velocity Verlet, which keeps the energy of a conservative force within a bound and angular momentum
    Points force = forces_of(forces, motion.x);
    const Eigen::Vector3d inverse_mass = cloth.mass.cwiseInverse();
    for (int i = 0; i * step <= duration; ++i) {
        if (i % every == 0) {
            run.time.push_back(i * step);
            run.energy.push_back((motion.kinetic() + energy_of(forces, motion.x)) / start);
            run.momentum.push_back(motion.momentum().y());
            if (!(run.energy.back() < run_away)) break;
        }
        motion.v += step / 2 * force * inverse_mass.asDiagonal();
        motion.x += step * motion.v;
        force = forces_of(forces, motion.x);
        motion.v += step / 2 * force * inverse_mass.asDiagonal();
    }
    return run;
}

double work_round_loop(const TriangleShape& shape, FootSharing sharing) {
    const Model model = free_cloth(lone_triangle(side, shape.along, shape.above), with_altitudes());
    const AltitudeSprings altitudes(model.cloths.front(), sharing);
    const Points& rest = model.cloths.front().mesh.rest;
    const auto shape_at = [&](double turn) {
        Points x = rest;
        const double angle = 2 * std::numbers::pi * turn / loop_steps;
        x.col(2) += loop_radius * side * Vec3(std::cos(angle), 0, std::sin(angle));
        return x;
    };
    double work = 0, most = 0;
    for (int i = 0; i < loop_steps; ++i) {
        Points force = Points::Zero(3, 3);
        altitudes.add_conservative(shape_at(i + 0.5), force);
        work += force.cwiseProduct(shape_at(i + 1) - shape_at(i)).sum();
        most = std::max(most, altitudes.energy(shape_at(i)));
    }
    return work / most;
}

LabResult run_erratum() {
    LabTable table{{"triangle", "force shared", "runs [s]", "energy, least", "energy, most",
                    "angular momentum, most", "work round a closed loop"},
                   {},
                   2};
    std::array<FreeTriangle, 2> shown_runs;
    for (const TriangleShape& shape : erratum_shapes()) {
        for (size_t i = 0; i < sharings.size(); ++i) {
            const FreeTriangle run = free_triangle(shape, sharings[i], lasts);
            const auto [least, most] = std::minmax_element(run.energy.begin(), run.energy.end());
            table.rows.push_back({shape.name, i == 0 ? "as a lever has it" : "as the notes print it",
                                  figure(run.time.back()), figure(*least, 4), figure(*most, 4),
                                  figure(most_momentum(run)),
                                  figure(work_round_loop(shape, sharings[i]), 2)});
            if (shown_runs[i].time.empty()) shown_runs[i] = run;
        }
    }
    const auto& [lever, notes] = shown_runs;
    LabResult result;
    result.claim =
        cat("shared as the notes print it, a free triangle's energy grows to ",
            figure(*std::max_element(notes.energy.begin(), notes.energy.end()), 4), " times its start in ",
            figure(notes.time.back(), 2), " s and it spins; shared as a lever has it, energy keeps within ",
            figure(most_change(lever), 1), " of itself and nothing spins (", figure(most_momentum(lever), 1),
            ")");
    result.story = {
        "An altitude spring pulls at its foot, which is no vertex: the force there is handed to the edge's "
        "ends. With l the foot's place on the edge, 0 at x1 and 1 at x2, a lever gives the nearer end more, "
        "f1 = (1 - l) fm and f2 = l fm, and that is minus the gradient of the spring's energy. The notes "
        "print "
        "the shares of the elastic force the other way round.",
        "So shared, the forces still sum to nothing, but they turn the triangle by (1 - 2 l)(x1 - x2) x f3, "
        "and they are no gradient: round a closed loop of shapes they do work from nothing. A triangle alone "
        "in space that is let go starts to turn to and fro and its energy wanders; flat triangles, "
        "right-angled or obtuse, whose feet stand at an end of the edge or beyond, gain energy and spin "
        "without end. In an equilateral triangle every foot stands in the middle and both rules are one near "
        "rest. All are run by the same velocity Verlet steps; drape shares as a lever does, and no scene can "
        "ask for the other.",
        "In the table energies are over that at the start, angular momentum is over what all of that energy "
        "could turn into, and the work is over the most energy on the loop."};
    result.figures = {erratum_figure(shown_runs)};
    result.tables = {table};
    result.csv = {{"erratum", runs_csv(shown_runs)}};
    return result;
}

}  // namespace drape

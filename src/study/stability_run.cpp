#include "study/stability_run.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "base/error.h"
#include "study/stability_cloth.h"

namespace drape {

namespace {

constexpr long factorisation_work = 40;  // in evaluations of the forces, of the built-in cloths
constexpr int looks = 4;                 // at a run's energy, evenly spaced

// How far starts are moved: a thousandth of an edge, but no farther than leaves the fastest mode, and so
// every mode, under a hundredth of the kinetic energy that a free fall of `duration` gives: a jitter is there
// to be different every time, not to be what the run is about.
double jitter_of(const Setup& setup, double omega, double duration) {
    const double small = 1e-3 * mean_over_springs(setup.model, &Spring::rest_length),
                 g = setup.world.gravity.norm();
    if (g == 0 || omega == 0) return small;
    return std::min(small, 0.1 * g * duration / omega);
}

// Every free vertex moved by up to `way` in each direction, differently in each run.
State jittered(const Setup& setup, double way, int run) {
    std::mt19937 random(static_cast<unsigned>(run) + 1);
    State start = setup.start;
    for (Eigen::Index i = 0; i < start.x.cols(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double shift = way * (2.0 * double(random()) / double(std::mt19937::max()) - 1);
            if (setup.model.inverse_mass[i] > 0) start.x(c, i) += shift;
        }
    }
    return start;
}

// Watches one run, and keeps the worst of it in the verdict.
class Watch {
public:
    Watch(Verdict& verdict, Simulation& simulation, const Vec3& gravity, const State& start, double duration)
        : verdict_(verdict),
          guard_(simulation.dynamics(), gravity,
                 Books{!simulation.method().projects_springs || !has_moving_pins(simulation.model())}) {
        guard_.begin_frame(start, duration);
    }

    // After a step. False if there is nothing left to watch.
    bool goes_on(const State& state) {
        if (!state.x.allFinite() || !state.v.allFinite()) {
            note(Stability::not_finite);
            return false;
        }
        if (!guard_.step_holds(state.v)) note(Stability::unbounded);
        return true;
    }
    // Where positions and velocities are those of the motion, which within some methods they are not.
    bool look(const State& state) {
        if (!goes_on(state)) return false;
        const double gain = guard_.gain(state);
        if (!std::isfinite(gain)) {
            note(Stability::not_finite);
            return false;
        }
        verdict_.gained = std::max(verdict_.gained, gain);
        verdict_.lost = std::max(verdict_.lost, -gain);
        if (gain > bounded_gain)
            note(Stability::unbounded);
        else if (gain > Guard::most_gain)
            note(Stability::gains_energy);
        else if (gain < -most_loss)
            note(Stability::lossy);
        return true;
    }
    void refuse(std::string why) {
        note(Stability::refused);
        verdict_.why = std::move(why);
    }

private:
    void note(Stability state) { verdict_.state = std::max(verdict_.state, state); }

    Verdict& verdict_;
    Guard guard_;
};

// Of methods that project springs nobody books what damping takes: by the power at the step's end.
void book_all(Dynamics& dynamics, const State& state, double step, const EnergyFlow& before,
              Points& scratch) {
    dynamics.reset_flow(before);
    dynamics.acceleration(state.x, state.v, state.time, scratch);
    dynamics.book(step);
}

// False where that would take more than `most_work`; takes what it took from there.
bool run_steps(Dynamics& dynamics, const Method& method, State state, double step, int steps, Watch& watch,
               long& most_work) {
    const std::unique_ptr<Integrator> integrator = method.make();
    const bool books = method.projects_springs && !dynamics.is_conservative();
    const long began = dynamics.sweeps(), allowed = most_work;
    Points scratch;
    for (int look = 0; look < looks; ++look) {
        integrator->begin(dynamics, state, step);
        for (int i = 0; i < steps / looks; ++i) {
            const EnergyFlow before = dynamics.flow();
            if (!integrator->step(dynamics, state, step)) {
                watch.refuse(cat("no solution of the step to t = ", state.time + step, " s"));
                return true;
            }
            if (books) book_all(dynamics, state, step, before, scratch);
            if (!watch.goes_on(state)) return true;
            most_work = allowed - (dynamics.sweeps() - began) -
                        factorisation_work * integrator->work().factorisations;
            if (most_work < 0) return false;
        }
        integrator->end(dynamics, state, step);
        if (!watch.look(state)) return true;
    }
    return true;
}

Verdict refused(double step, const Error& error) {
    Verdict verdict;
    verdict.state = Stability::refused;
    verdict.step = step;
    verdict.why = error.what();
    return verdict;
}

}  // namespace

Verdict judge_method(const Setup& setup, const Method& method, double step, double omega,
                     const Trial& trial) {
    Setup asked = setup;
    asked.method = method.name;
    asked.step = step;
    std::optional<Simulation> simulation;
    try {
        simulation.emplace(std::move(asked));
    } catch (const Error& error) {
        return refused(step, error);
    }
    Dynamics& dynamics = simulation->dynamics();
    const double duration = step * trial.steps, way = jitter_of(setup, omega, duration);
    Verdict verdict;
    verdict.step = step;
    long most_work = trial.most_work;
    while (verdict.runs < trial.runs && holds(verdict.state)) {
        const State start = jittered(setup, way, verdict.runs);
        dynamics.reset_flow({});
        Watch watch(verdict, *simulation, setup.world.gravity, start, duration);
        if (!run_steps(dynamics, method, start, step, trial.steps, watch, most_work)) {
            if (verdict.runs > 0) break;
            verdict.state = Stability::left_out;
            verdict.why = cat("a run takes more than ", trial.most_work, " evaluations of the forces");
            break;
        }
        ++verdict.runs;
    }
    return verdict;
}

Verdict judge_auto(const Setup& setup, double omega, const Trial& trial) {
    Setup asked = setup;
    asked.frames = trial.auto_frames;
    const double duration = asked.frames / asked.frame_rate, way = jitter_of(setup, omega, duration);
    Verdict verdict;
    while (verdict.runs < trial.runs && holds(verdict.state)) {
        asked.start = jittered(setup, way, verdict.runs++);
        Simulation simulation(asked);
        verdict.step = simulation.step();
        verdict.method = simulation.method().name;
        Watch watch(verdict, simulation, setup.world.gravity, simulation.state(), duration);
        while (simulation.frame() < simulation.frames()) {
            const FrameReport report = simulation.advance();
            if (!report.trouble.empty()) watch.refuse(report.trouble);
            if (!report.trouble.empty() || !watch.look(simulation.state())) break;
        }
    }
    return verdict;
}

}  // namespace drape

// Frames from steps: chooses the step, advances frame by frame, keeps the last good state, books energy.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/plan.h"
#include "integrate/dynamics.h"
#include "integrate/method.h"
#include "simulate/archive.h"
#include "simulate/guard.h"
#include "simulate/stable_step.h"

namespace drape {

// Everything a simulation starts from.
struct Setup {
    Model model;
    State start;
    Surroundings world;
    std::vector<Obstacle> obstacles;
    double frame_rate = 30;  // [1/s]
    int frames = 1;
    std::string method;                 // "" = drape chooses
    std::string because = "asked for";  // why this method
    std::optional<double> step;         // [s]; none = the longest stable one, less a margin
    bool keep_stable = false;           // shorten a step that is asked for to the stable one
    // Multiplies the steps of a frame, contact's shorter ones too: passes that differ in nothing else tell
    // the error. At least one more or one less than 1 gives, as far as stability allows.
    double refine = 1;
    // Asked after every step; true ends the frame in hand with Error (Exit::interrupted).
    std::function<bool()> stop = {};
};

// What a frame brought.
struct FrameReport {
    int index = 0;
    double time = 0;  // [s]
    long steps = 0;
    int retries = 0;           // tries before this one, with longer steps, that did not hold
    long planned_steps = 0;    // without those that contact asked for
    double shortest_step = 0;  // [s]
    int contacts = 0;          // most at once
    int crossings = -1;        // pairs of triangles of cloths that meet cloth; -1: none does, not counted
    // from any obstacle, over the steps in contact and at the frame's end; infinite without obstacles [m]
    double least_distance = 0;
    double strain = 0;   // largest |l/l0 - 1|
    double fastest = 0;  // speed of any vertex at the frame [m/s]
    double cpu_seconds = 0;
    double error_rms = NAN, error_max = NAN;  // estimated, of the positions, over all vertices [m]
    std::string hash;                         // of the positions
    std::string trouble;  // "" = good; else why the run cannot go on (the state is the last good one)
};

struct Energies {
    double kinetic = 0, potential = 0;  // [J]
    double total() const { return kinetic + potential; }
};

// Where nothing asks for another [s].
inline constexpr double usual_implicit_step = 0.0025, usual_projecting_step = 0.0005;

class Simulation {
public:
    // Throws Error where cloth starts inside an obstacle or the method is not for such a scene.
    explicit Simulation(Setup setup);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    FrameReport advance();  // one frame

    // Frames from now on take steps of `step` [s], as Setup::step says.
    void ask_step(double step) { setup_.step = step; }

    const Model& model() const { return setup_.model; }
    const State& state() const { return state_; }
    int frame() const { return frame_; }  // frames done
    int frames() const { return setup_.frames; }
    double frame_rate() const { return setup_.frame_rate; }
    const std::vector<Obstacle>& obstacles() const { return setup_.obstacles; }

    const Plan& plan() const { return plan_; }
    const Method& method() const { return *method_; }
    const std::string& chosen_because() const { return chosen_because_; }
    double step() const { return step_; }  // of the last frame; before the first: planned [s]
    // that `method` would take if nothing asks for another; not for one that projects, unless it is this
    // one's [s]
    double usual_step(const Method& method) const;
    double longest_step() const { return longest_; }  // stable by the measured fastest mode [s]
    const Spectrum& spectrum() const {
        return spectrum_;
    }  // of all forces but contact, and of springs if projected
    double guaranteed_step() const { return guaranteed_; }  // stable by Gershgorin's bound [s]
    double lifted() const { return lifted_; }               // how far start overlaps were cleared [m]

    Dynamics& dynamics() { return *dynamics_; }
    bool has_contact() const { return dynamics_->contact() != nullptr; }  // with any obstacle within reach
    long sweeps() const { return dynamics_->sweeps(); }
    double contact_seconds() const { return dynamics_->contact_seconds(); }  // CPU, of the run so far [s]
    Energies energies() const;
    SolverWork solver_work() const { return integrator_->work(); }  // of the run so far
    // an obstacle within reach has friction, whose impulses are no part of a differential equation
    bool rubs() const { return rubs_; }
    const EnergyFlow& flow() const { return dynamics_->flow(); }

    // To go on from a frame reached earlier, with the same bits as a run that was never interrupted: whatever
    // a frame does follows from its first state alone.
    void save(ByteWriter& out) const;
    [[nodiscard]] bool restore(ByteReader& in);

private:
    void build();
    void choose_method();  // default_method.cpp
    void take_method(std::string_view method, std::string because);
    FrameReport next_frame();
    FrameReport try_frame();
    void look_for_penetration(FrameReport& report) const;
    void choose_step();
    double steps_a_frame(double wanted) const;
    double allowed_step() const;
    // one step of at most `h`; returns how long it was, 0 if none could be made
    double guarded_step(double h, FrameReport& report);

    Setup setup_;
    State state_, before_;
    Plan plan_;
    std::unique_ptr<Dynamics> dynamics_;
    const Method* method_ = nullptr;
    std::string chosen_because_;
    std::unique_ptr<Integrator> integrator_;
    Spectrum spectrum_;
    double step_ = 0, longest_ = 0, guaranteed_ = 0, lifted_ = 0;
    double pace_ = 1;                 // the step over the one a run that asks for nothing would take
    double left_out_gap_ = INFINITY;  // to the nearest obstacle that was left out as out of reach [m]
    int frame_ = 0;
    bool rubs_ = false;
    std::optional<Guard> guard_;
    int halvings_ = 0;        // of the present try at a frame
    bool runs_away_ = false;  // the present try did not stay finite, or took energy from nowhere
    bool weighed_ = false;    // the guard knows the energies of state_
};

}  // namespace drape

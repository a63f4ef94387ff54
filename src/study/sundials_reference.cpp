#include "study/sundials_reference.h"

#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_version.h>

#include <array>

#include "base/error.h"
#include "base/numbers.h"
#include "base/timer.h"

namespace drape {

namespace {

struct Tolerances {
    double relative, absolute;  // absolute in m and m/s
};
constexpr std::array tolerances{Tolerances{1e-10, 1e-12}, Tolerances{1e-8, 1e-10}, Tolerances{1e-6, 1e-8}};

// The scene between free vertices' unknowns and drape's state.
class Equation {
public:
    // `end`: of the thread's CPU time, when it is to give up [s]
    Equation(const Setup& setup, double end) : simulation_(setup), state_(simulation_.state()), end_(end) {
        const Eigen::VectorXd& inverse_mass = simulation_.model().inverse_mass;
        for (int i = 0; i < inverse_mass.size(); ++i)
            if (inverse_mass[i] > 0) free_.push_back(i);
        acceleration_.resize(3, state_.x.cols());
    }
    sunindextype unknowns() const { return static_cast<sunindextype>(6 * free_.size()); }
    double frame_time() const { return 1 / simulation_.frame_rate(); }
    int frames() const { return simulation_.frames(); }

    void read_start(double* y) const {
        for (size_t i = 0; i < free_.size(); ++i) {
            Eigen::Map<Vec3>(y + 3 * i) = simulation_.state().x.col(free_[i]);
            Eigen::Map<Vec3>(y + 3 * (i + free_.size())) = simulation_.state().v.col(free_[i]);
        }
    }
    const State& state_at(double time, const double* y) {
        state_.time = time;
        for (size_t i = 0; i < free_.size(); ++i) {
            state_.x.col(free_[i]) = Eigen::Map<const Vec3>(y + 3 * i);
            state_.v.col(free_[i]) = Eigen::Map<const Vec3>(y + 3 * (i + free_.size()));
        }
        place_pins(simulation_.model(), state_);
        return state_;
    }
    bool is_late() const { return thread_cpu_seconds() > end_; }
    // false where an obstacle was entered: a shorter step may not
    bool slope(double time, const double* y, double* slope) {
        const State& state = state_at(time, y);
        if (!state.x.allFinite() || !state.v.allFinite()) return false;
        Dynamics& dynamics = simulation_.dynamics();
        if (Contact* contact = dynamics.contact()) contact->prepare(state, 0);
        dynamics.acceleration(state.x, state.v, time, acceleration_);
        for (size_t i = 0; i < free_.size(); ++i) {
            Eigen::Map<Vec3>(slope + 3 * i) = state.v.col(free_[i]);
            Eigen::Map<Vec3>(slope + 3 * (i + free_.size())) = acceleration_.col(free_[i]);
        }
        return !dynamics.touch().crossed;
    }

private:
    Simulation simulation_;
    State state_;
    double end_;
    std::vector<int> free_;
    Points acceleration_;
};

int right_hand_side(realtype time, N_Vector y, N_Vector slope, void* data) {
    constexpr int recoverable = 1, give_up = -1;
    auto& equation = *static_cast<Equation*>(data);
    if (equation.is_late()) return give_up;
    return equation.slope(time, N_VGetArrayPointer(y), N_VGetArrayPointer(slope)) ? 0 : recoverable;
}

// SUNDIALS' own objects, freed whatever happens.
class Solver {
public:
    Solver(Equation& equation, const Tolerances& wanted) {
        SUNContext_Create(nullptr, &context_);
        y_ = N_VNew_Serial(equation.unknowns(), context_);
        equation.read_start(N_VGetArrayPointer(y_));
        memory_ = ERKStepCreate(right_hand_side, 0, y_, context_);
        ERKStepSetUserData(memory_, &equation);
        ERKStepSetTableNum(memory_, ARKODE_FEHLBERG_13_7_8);
        ERKStepSStolerances(memory_, wanted.relative, wanted.absolute);
        ERKStepSetMaxNumSteps(memory_, -1);
        // a failure comes back as a number, and is told in the result
        ERKStepSetErrHandlerFn(
            memory_, [](int, const char*, const char*, char*, void*) {}, nullptr);
    }
    ~Solver() {
        ERKStepFree(&memory_);
        N_VDestroy(y_);
        SUNContext_Free(&context_);
    }
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    // to `time` exactly, without interpolation; negative: failed
    int advance_to(double time) {
        ERKStepSetStopTime(memory_, time);
        realtype reached = 0;
        return ERKStepEvolve(memory_, time, y_, &reached, ARK_NORMAL);
    }
    const double* y() const { return N_VGetArrayPointer(y_); }
    long evaluations() const {
        long count = 0;
        ERKStepGetNumRhsEvals(memory_, &count);
        return count;
    }

private:
    SUNContext context_ = nullptr;
    N_Vector y_ = nullptr;
    void* memory_ = nullptr;
};

std::string name() {
    return cat("SUNDIALS ", sundials_version(), ", ARKODE's explicit Runge-Kutta pair of order 8(7)");
}

// Stops as soon as it is on the way to cost more than `most_cpu`, in the middle of a frame too.
SundialsRun attempt(const Setup& setup, const Tolerances& wanted, double most_cpu) {
    Equation equation(setup, thread_cpu_seconds() + most_cpu);
    Solver solver(equation, wanted);
    SundialsRun run;
    const double began = thread_cpu_seconds();
    for (int frame = 1; frame <= equation.frames(); ++frame) {
        const double time = frame * equation.frame_time();
        const int code = solver.advance_to(time);
        if (equation.is_late())
            return {{}, cat(name(), " would cost more than ", figure(most_cpu), " CPU s, and has no more")};
        if (code < 0) return {{}, cat(name(), " gave up before t = ", time, " s (code ", code, ")")};
        run.x.push_back(equation.state_at(time, solver.y()).x);
        const double projected = (thread_cpu_seconds() - began) * equation.frames() / frame;
        if (projected > most_cpu)
            return {
                {},
                cat(name(), " would cost about ", figure(projected), " CPU s, and has ", figure(most_cpu))};
    }
    run.how = cat(name(), ", rtol ", wanted.relative, ", atol ", wanted.absolute, ", ", solver.evaluations(),
                  " evaluations in ", figure(thread_cpu_seconds() - began), " CPU s");
    return run;
}

}  // namespace

SundialsRun run_sundials(const Setup& setup, double most_cpu) {
    Setup own = setup;
    own.method = "verlet";
    own.step.reset();
    SundialsRun run;
    const double end = thread_cpu_seconds() + most_cpu;
    for (const Tolerances& wanted : tolerances) {
        run = attempt(own, wanted, end - thread_cpu_seconds());
        if (!run.x.empty() || thread_cpu_seconds() >= end) break;
    }
    return run;
}

std::string sundials_version() {
    std::array<char, 32> text{};
    SUNDIALSGetVersion(text.data(), static_cast<int>(text.size()));
    return text.data();
}

}  // namespace drape

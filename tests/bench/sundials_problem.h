// A spring system as SUNDIALS takes it: y = (x, v), y' = (v, a(x)), in one serial vector.
#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <string>

#include "bench/contestant.h"
#include "bench/spring_system.h"

namespace drape::bench {

// Owns SUNDIALS' context and vector, and stops an integration that takes too long.
class SundialsProblem {
public:
    SundialsProblem(const SpringSystem& system, double most_cpu);
    ~SundialsProblem();
    SundialsProblem(const SundialsProblem&) = delete;
    SundialsProblem& operator=(const SundialsProblem&) = delete;

    SUNContext context() const { return context_; }
    N_Vector y() const { return y_; }
    const SpringSystem& system() const { return system_; }
    bool is_late();  // took longer than allowed; looks at the clock now and then

    // what an integrator that returned `code` leaves
    Outcome outcome(int code) const;

private:
    const SpringSystem& system_;
    double began_, most_cpu_;  // [s]
    int calls_ = 0;            // of is_late()
    bool late_ = false;
    SUNContext context_ = nullptr;
    N_Vector y_ = nullptr;
};

// The right-hand side; `problem` is a SundialsProblem.
int sundials_slope(realtype time, N_Vector y, N_Vector slope, void* problem);

}  // namespace drape::bench

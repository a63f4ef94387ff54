#include <arkode/arkode_erkstep.h>

#include "bench/sundials_problem.h"
#include "bench/sundials_solvers.h"

namespace drape::bench {

namespace {

Outcome run_pair(ARKODE_ERKTableID pair, const SpringSystem& system, double time, double tolerance,
                 double most_cpu) {
    SundialsProblem problem(system, most_cpu);
    void* memory = ERKStepCreate(sundials_slope, 0, problem.y(), problem.context());
    ERKStepSetUserData(memory, &problem);
    ERKStepSetTableNum(memory, pair);
    ERKStepSStolerances(memory, tolerance, tolerance);
    ERKStepSetMaxNumSteps(memory, -1);
    ERKStepSetErrHandlerFn(
        memory, [](int, const char*, const char*, char*, void*) {}, nullptr);
    // to the final time itself, without interpolation
    ERKStepSetStopTime(memory, time);
    realtype reached = 0;
    const int code = ERKStepEvolve(memory, time, problem.y(), &reached, ARK_NORMAL);
    ERKStepFree(&memory);
    return problem.outcome(code);
}

}  // namespace

Outcome run_bogacki_shampine(const SpringSystem& system, double time, double tolerance, double most_cpu) {
    return run_pair(ARKODE_BOGACKI_SHAMPINE_4_2_3, system, time, tolerance, most_cpu);
}

Outcome run_dormand_prince(const SpringSystem& system, double time, double tolerance, double most_cpu) {
    return run_pair(ARKODE_DORMAND_PRINCE_7_4_5, system, time, tolerance, most_cpu);
}

Outcome run_fehlberg_8(const SpringSystem& system, double time, double tolerance, double most_cpu) {
    return run_pair(ARKODE_FEHLBERG_13_7_8, system, time, tolerance, most_cpu);
}

}  // namespace drape::bench

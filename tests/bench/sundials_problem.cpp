#include "bench/sundials_problem.h"

#include <algorithm>

#include "base/error.h"
#include "base/timer.h"

namespace drape::bench {

namespace {

constexpr int calls_a_look = 64;  // at the clock, which costs as much as some springs

}  // namespace

SundialsProblem::SundialsProblem(const SpringSystem& system, double most_cpu)
    : system_(system), began_(thread_cpu_seconds()), most_cpu_(most_cpu) {
    SUNContext_Create(nullptr, &context_);
    y_ = N_VNew_Serial(static_cast<sunindextype>(2 * system.x.size()), context_);
    std::copy(system.x.begin(), system.x.end(), N_VGetArrayPointer(y_));
    std::copy(system.v.begin(), system.v.end(), N_VGetArrayPointer(y_) + system.x.size());
}

SundialsProblem::~SundialsProblem() {
    N_VDestroy(y_);
    SUNContext_Free(&context_);
}

bool SundialsProblem::is_late() {
    if (++calls_ % calls_a_look == 0) late_ = thread_cpu_seconds() - began_ > most_cpu_;
    return late_;
}

Outcome SundialsProblem::outcome(int code) const {
    if (late_) return {.trouble = cat("stopped after ", most_cpu_, " CPU s")};
    if (code < 0) return {.trouble = cat("gave up with code ", code)};
    return {.x = Eigen::Map<const Points>(N_VGetArrayPointer(y_), 3, system_.vertices())};
}

int sundials_slope(realtype, N_Vector y, N_Vector slope, void* problem) {
    auto& own = *static_cast<SundialsProblem*>(problem);
    if (own.is_late()) return -1;  // unrecoverable
    const auto half = static_cast<std::ptrdiff_t>(own.system().x.size());
    const double* x = N_VGetArrayPointer(y);
    double* dx = N_VGetArrayPointer(slope);
    std::copy(x + half, x + 2 * half, dx);
    accelerate(own.system(), x, dx + half);
    return 0;
}

}  // namespace drape::bench

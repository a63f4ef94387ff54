// Stopwatches: wall seconds for people, CPU seconds for comparisons on a shared machine.
#pragma once

#include <chrono>
#include <ctime>

namespace drape {

// Wall time since construction [s].
class WallTimer {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// CPU time of the whole process, all threads [s].
inline double process_cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// CPU time of the calling thread [s].
inline double thread_cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Adds the CPU seconds between construction and destruction to `total`.
template <double (*clock)()>
class Stopwatch {
public:
    explicit Stopwatch(double& total) : total_(total), start_(clock()) {}
    ~Stopwatch() { total_ += clock() - start_; }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    double& total_;
    double start_;
};
using CpuScope = Stopwatch<process_cpu_seconds>;       // of all threads
using ThreadCpuScope = Stopwatch<thread_cpu_seconds>;  // of this thread alone

}  // namespace drape

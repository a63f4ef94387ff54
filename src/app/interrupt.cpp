#include "app/interrupt.h"

#include <atomic>
#include <csignal>
#include <ctime>

#include "base/error.h"

namespace drape {

namespace {

// threads ask for it too
std::atomic<int> asked{0};
static_assert(decltype(asked)::is_always_lock_free);  // or a handler could not touch it

constexpr std::time_t patience = 3;    // [s]
std::atomic<std::time_t> asked_at{0};  // written before `asked` is set, never after

std::time_t seconds_now() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec;
}

extern "C" void note_signal(int signal) {
    if (asked) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    asked_at = seconds_now();
    asked = 1;
}

}  // namespace

void catch_interrupts() {
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);
}

bool interrupted() {
    return asked != 0;
}

bool interrupted_for_seconds() {
    return interrupted() && seconds_now() - asked_at > patience;
}

void demand_no_interrupt() {
    if (interrupted()) throw Error("interrupted", Exit::interrupted);
}

}  // namespace drape

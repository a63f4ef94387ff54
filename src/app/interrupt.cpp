#include "app/interrupt.h"

#include <csignal>
#include <ctime>

namespace drape {

namespace {

constexpr std::time_t patience = 3;  // [s]

volatile std::sig_atomic_t asked = 0;
volatile std::time_t asked_at = 0;  // written before `asked` is set, never after

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

}  // namespace drape

#include "app/interrupt.h"

#include <csignal>

#include "base/error.h"

namespace drape {

namespace {

volatile std::sig_atomic_t asked = 0;

extern "C" void note_signal(int signal) {
    if (asked) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
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

void demand_no_interrupt() {
    if (interrupted()) throw Error("interrupted", Exit::interrupted);
}

}  // namespace drape

#include "app/interrupt.h"

#include <atomic>
#include <csignal>

#include "base/error.h"

namespace drape {

namespace {

// threads ask for it too
std::atomic<int> asked{0};
static_assert(decltype(asked)::is_always_lock_free);  // or a handler could not touch it

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

// What ends a run early, and how it is said.
//   bad input          throw Error; printed once, in main, as one line
//   numbers gone wrong FrameReport::trouble (simulate/simulation.h), with the last good state kept
//   our own bug        DRAPE_ASSERT (assert.h)
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace drape {

// cat("radius must be positive, got ", -1) == "radius must be positive, got -1"
template <class... Parts>
std::string cat(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

// The process's exit codes; the command contract in the README lists them.
enum class Exit {
    done = 0,
    different = 1,
    bad_input = 2,
    cannot_write = 3,
    went_wrong = 4,
    interrupted = 130
};

// One line for the user: "FILE:LINE:COL: what is wrong (what is allowed)".
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message, Exit code = Exit::bad_input)
        : std::runtime_error(message), code_(code) {}
    Exit code() const { return code_; }

private:
    Exit code_;
};

// Runs `work`; an Error leaving it gets "context: " in front.
template <class Work>
auto in_context(const std::string& context, Work&& work) -> decltype(work()) {
    try {
        return std::forward<Work>(work)();
    } catch (const Error& error) {
        throw Error(context + ": " + error.what(), error.code());
    }
}

}  // namespace drape

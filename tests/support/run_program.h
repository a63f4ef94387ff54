// The program as its users run it: arguments in; exit code, standard output and standard error out.
#pragma once

#include <csignal>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace drape::test {

struct Ran {
    int exit_code = -1;  // minus the signal's number if one ended it
    std::string out, err;
    int error_lines() const;
};

// Runs DRAPE_PROGRAM in `folder`; returns when it ended.
Ran run_drape(const std::vector<std::string>& arguments, const std::string& folder = ".");

// The same with a limit on a resource (RLIMIT_FSIZE, RLIMIT_AS).
Ran run_drape_within(int resource, std::uint64_t most, const std::vector<std::string>& arguments,
                     const std::string& folder = ".");

// Runs DRAPE_PROGRAM and sends it `signal` soon after `sign` says so, unless it has ended by then. Returns
// the exit code.
int interrupted_drape(const std::vector<std::string>& arguments, const std::function<bool()>& sign,
                      int signal = SIGINT);

}  // namespace drape::test

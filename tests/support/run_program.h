// The program as its users run it: arguments in; exit code, standard output and standard error out.
#pragma once

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

}  // namespace drape::test

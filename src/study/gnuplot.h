// Runs gnuplot as a child process. drape does not link it, and does without where it is not installed.
#pragma once

#include <string>

namespace drape {

struct GnuplotRun {
    std::string trouble;  // one line; "" = the plots are there
    std::string version;
};

// Runs `folder`/plots.gp; what it writes appears in `folder` only once all is written.
GnuplotRun run_gnuplot(const std::string& folder);

}  // namespace drape

// gnuplot as the verbs run it: Ctrl-C leaves nothing half-drawn.
#pragma once

#include <string>

#include "study/gnuplot.h"

namespace drape {

// Writes `script` as plots.gp into the folder and runs it there. Throws Error (Exit::interrupted).
GnuplotRun make_plots_of(const std::string& script, const std::string& folder);

}  // namespace drape

// gnuplot as the verbs run it: Ctrl-C leaves nothing half-drawn.
#pragma once

#include <cstdint>
#include <string>

#include "study/gnuplot.h"

namespace drape {

inline constexpr std::uint64_t largest_plot = std::uint64_t{64} << 20;  // [bytes]

// Writes `script` as plots.gp into the folder and runs it there. Throws Error (Exit::interrupted).
GnuplotRun make_plots_of(const std::string& script, const std::string& folder);

}  // namespace drape

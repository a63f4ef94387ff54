// The plots, as a script for gnuplot: error against CPU time, and error over simulated time.
#pragma once

#include <string>

#include "study/study.h"

namespace drape {

// Run in any folder it writes error_time.svg, error_time.png, error_over_time.svg and error_over_time.png.
std::string plot_script(const Study& study);

}  // namespace drape

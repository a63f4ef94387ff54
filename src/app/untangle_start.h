// --untangle: a start that crosses itself is taken apart before anything runs.
#pragma once

#include <string>
#include <vector>

#include "simulate/simulation.h"

namespace drape {

// Moves setup.start and notes what that took. Throws Error where it does not come apart.
void untangle_start(Setup& setup, std::vector<std::string>& notes);

}  // namespace drape

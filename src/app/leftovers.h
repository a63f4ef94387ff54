// What a run that was killed left under temporary names.
#pragma once

#include <string>

namespace drape {

// Removes the temporaries (OutputFile) of `folder` whose targets' names begin with `prefix` and whose process
// is gone.
void remove_leftovers(const std::string& folder, const std::string& prefix = "");

}  // namespace drape

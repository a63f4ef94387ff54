// Another drape as a child process: what goes wrong in it, or is left behind in memory, stays there.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace drape {

struct ChildEnd {
    Exit code = Exit::done;
    std::string complaint;  // last line of its standard error, without "drape: "; "" if it said nothing
};

// Runs this very program with `arguments` in `folder` and waits; its standard output is dropped. An interrupt
// of this process is handed on.
ChildEnd run_child(const std::vector<std::string>& arguments, const std::string& folder);

}  // namespace drape

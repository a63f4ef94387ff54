// What each verb takes on the command line, and what then runs it.
#pragma once

#include <functional>

#include "base/error.h"

namespace CLI {
class App;
}

namespace drape {

using Action = std::function<Exit()>;

Action declare_render(CLI::App& verb);
Action declare_simulate(CLI::App& verb);
Action declare_inspect(CLI::App& verb);
Action declare_study(CLI::App& verb);
Action declare_stability(CLI::App& verb);
Action declare_lab(CLI::App& verb);
Action declare_compare(CLI::App& verb);
Action declare_video(CLI::App& verb);
Action declare_gallery(CLI::App& verb);
Action declare_mesh(CLI::App& verb);
Action declare_list(CLI::App& verb);

}  // namespace drape

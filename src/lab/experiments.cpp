#include <algorithm>
#include <array>

#include "base/names.h"
#include "lab/kinds.h"

namespace drape {

namespace {

constexpr std::array all_experiments{
    Experiment{"anisotropy", "how stiff each mesh pattern is by direction, in stretch and in shear",
               run_anisotropy},
    Experiment{"folds", "in which directions a buckled sheet folds, by mesh pattern", run_folds, false},
    Experiment{"density", "how much stronger the finer half of a strip is, by stiffness model", run_density},
    Experiment{"compression", "what one triangle answers as it is pushed through its base", run_compression},
    Experiment{"erratum", "an altitude's force shared as the notes print it, and as a lever has it",
               run_erratum},
    Experiment{"jumps", "where `shortest` changes its altitude its force jumps; that of `blend` does not",
               run_jumps},
    Experiment{"jitter", "how jerkily cloth moves by the altitudes it has: its acceleration by frequency",
               run_jitter, false},
    Experiment{"fabric", "fabric presets as a textile laboratory measures them: bending, stretch, drape",
               run_fabric, false},
    Experiment{"validation",
               "cantilever, curtain, strip and slope against closed forms: what passes, what fails",
               run_validation, false},
};

}  // namespace

std::span<const Experiment> experiments() {
    return all_experiments;
}

std::vector<const Experiment*> experiments_named(std::span<const std::string> names) {
    std::vector<const Experiment*> wanted;
    for (const std::string& name : names) find_named(all_experiments, "experiment", name);
    for (const Experiment& experiment : all_experiments) {
        const bool asked = std::find(names.begin(), names.end(), experiment.name) != names.end();
        if (names.empty() || asked) wanted.push_back(&experiment);
    }
    return wanted;
}

}  // namespace drape

#include "app/untangle_start.h"

#include "base/error.h"
#include "contact/untangle.h"

namespace drape {

void untangle_start(Setup& setup, std::vector<std::string>& notes) {
    const Untangled done = untangle(setup.model, setup.obstacles, setup.world.gravity, setup.start,
                                    setup.frames / setup.frame_rate);
    if (done.before.pairs == 0)
        notes.emplace_back("nothing to untangle: no cloth that meets any starts crossing it");
    else
        notes.push_back(cat("untangled the start: ", done.before.triangles, " triangles crossed in ",
                            done.before.pairs, " pairs; taken apart in ", done.rounds,
                            " rounds, no vertex moved by more than ", done.largest_move, " m"));
}

}  // namespace drape

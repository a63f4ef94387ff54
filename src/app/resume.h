// What a run that goes on takes from the folder of the one before it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options.h"
#include "scene/description.h"
#include "simulate/checkpoint.h"

namespace drape {

std::string checkpoint_of(const std::string& folder);
std::string kept_positions_of(const std::string& folder);
void forget_checkpoint(const std::string& folder);  // and the positions kept for it, if there are any

// What tells a checkpoint's run from others: the scene without what is expected of it, and the method and the
// steps of every frame where they are given. Fills in `scene` and `steps`.
void identify(Checkpoint& run, SceneDescription scene, const std::string& method,
              const std::vector<long>& steps);

// The folder's checkpoint if it is one of the run `now`, or --from accepts that it is of another, of which
// `notes` tells; nothing where there is none. Throws Error where it is broken or another's.
std::optional<Checkpoint> checkpoint_to_go_on_from(const std::string& folder, const Checkpoint& now,
                                                   const RunOptions& options,
                                                   std::vector<std::string>& notes);

// Throws Error where a picture of the frames from `first` on, as far as `run` went, is not there as it was
// drawn.
void demand_pictures(const std::string& folder, const Checkpoint& run, int first);

}  // namespace drape

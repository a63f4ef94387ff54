// Which frame is shown when.
#pragma once

#include <vector>

namespace drape {

// Frames 0 to `frames` - 1, `loops` times; there and back with `boomerang`, without the frames at the turns
// being shown twice, so that it goes on without a halt where it is looped.
std::vector<int> play_order(int frames, bool boomerang, int loops);

// What is left of `order`, played at `rate` frames a second, where only `most` a second are shown: as much
// time, frames left out evenly. Unchanged for a rate up to `most`.
std::vector<int> thinned(const std::vector<int>& order, double rate, double most);

}  // namespace drape

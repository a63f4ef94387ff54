// How a frame's picture is called.
#pragma once

#include <string>

namespace drape {

// "/frame_0012.png"
std::string frame_name(int frame);

}  // namespace drape

// Scenes that nobody chose: valid by the scene reference, otherwise as the dice fall.
#pragma once

#include <cstdint>
#include <string>

namespace drape::test {

// A scene file's text, small enough to run in a second or so; the same for the same seed.
std::string random_scene(std::uint64_t seed);

}  // namespace drape::test

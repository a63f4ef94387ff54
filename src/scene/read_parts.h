// The parts of a scene and who reads them; reader.cpp puts them together.
#pragma once

#include "scene/description.h"
#include "toml/value.h"

namespace drape {

ClothDescription read_cloth(const Value&);
void read_pattern(const Value&, ClothDescription&);
PinDescription read_pin(const Value&);
// `preset` receives the name of the preset the fabric is or starts from, or "".
Fabric read_fabric(const Value&, std::string& preset);
ObstacleDescription read_obstacle(const Value&);
// Keyframes, in increasing time.
std::vector<Keyframe> read_motion(const Value&);
Placement read_placement(const Value&);
AccuracyDescription read_accuracy(const Value&);
AirDescription read_air(const Value&);
LookDescription read_look(const Value&);
Expectation read_expect(const Value&);
Colour read_colour(const Value&, std::string_view name);

}  // namespace drape

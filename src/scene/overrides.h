// `--set KEY=VALUE`: a scene's values changed from the command line.
#pragma once

#include <string>

#include "toml/value.h"

namespace drape {

// KEY is dotted, elements of arrays by number: cloth.0.fabric or cloth[0].fabric. VALUE is TOML; what is not,
// and opens no quote or bracket, is a text: silk, 3 mm. Tables on the way are made. Throws Error "--set
// KEY=VALUE: ...".
void apply_override(Value& scene, const std::string& assignment);

}  // namespace drape

// Where something stands in a file, for messages.
#pragma once

#include <string>

namespace drape {

struct Place {
    std::string text;  // "scenes/flag.toml:12:3", or "--set cloth.0.fabric=silk"
};

}  // namespace drape

// Reads position caches back: for comparing two runs, and for the tests of what was written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/points.h"

namespace drape {

struct Cache {
    std::vector<Points>
        samples;  // each 3 x points, in the mesh file's vertex order [m]; of a glTF a point per UV
    std::vector<double> times;  // a number per sample: MDD and glTF [s], PC2 in frames (start + k rate)
};

// By its ending: .pc2, .mdd or .glb.
bool is_readable_cache(const std::string& path);

// The ending chooses; of a glTF only what drape writes is read. Throws Error naming the file if it is
// missing, of another ending, or if its header does not fit its size.
Cache read_cache(const std::string& path);

// The same of a file's bytes that are at hand.
Cache read_cache_bytes(const std::string& path, std::string_view bytes);

}  // namespace drape

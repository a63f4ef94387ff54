// What made the results, so that they can be made again.
#pragma once

#include <string>

namespace drape {

struct Provenance {
    std::string command, drape_version, gnuplot_version, sundials_version, processor;
    unsigned cores = 0;
};

}  // namespace drape

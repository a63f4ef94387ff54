// A small scene to run the program on, and what it reports.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"

namespace drape::test {

using Json = nlohmann::json;

// A sheet falls on a ball; four frames, or as many as `duration` has.
inline std::string small_drop(const std::string& duration = "0.4", const std::string& more = "") {
    return "schema = 1\n[scene]\nduration = " + duration +
           "\nframe_rate = 10\n[[cloth]]\npattern = { name = \"alternating\", size = [1, 1], divisions = "
           "[12, 12] }\n"
           "place = { translate = [0, 0.45, 0] }\nfabric = \"cotton\"\n"
           "[[obstacle]]\nshape = \"sphere\"\ncentre = [0, 0, 0]\nradius = 0.4\n"
           "[render]\nsize = [160, 90]\ncamera = { from = [1, 1, 2], at = [0, 0.2, 0], fov_deg = 35 }\n" +
           more;
}

inline Json report_of(const std::string& folder) {
    return Json::parse(bytes_of(folder + "/report.json"));
}

}  // namespace drape::test

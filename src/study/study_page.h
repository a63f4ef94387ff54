// index.html: the study for its reader, in one file that needs nothing else.
#pragma once

#include <string>

#include "study/provenance.h"
#include "study/study.h"

namespace drape {

struct StudyPlots {
    std::string error_time, error_over_time;  // SVG
    std::string trouble;                      // why there are none; "" = there are
};

std::string study_page(const Study& study, const StudyPlots& plots, const Provenance& provenance);

// "At 1 mm the cheapest is verlet with steps of 0.2 ms: 0.03 CPU s"
std::string cheapest_sentence(const Study& study, double metres);

}  // namespace drape

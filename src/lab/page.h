// index.html: the laboratory's story in order, in one file that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "lab/experiment.h"
#include "study/provenance.h"

namespace drape {

struct LabChapter {
    const Experiment* experiment = nullptr;
    LabResult result;
    std::vector<std::string> svg;  // of its figures; none where gnuplot failed
};

std::string lab_page(const std::vector<LabChapter>& chapters, const std::string& plot_trouble,
                     const Provenance& provenance);

}  // namespace drape

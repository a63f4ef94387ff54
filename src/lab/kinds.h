// Every experiment, for the table in experiments.cpp.
#pragma once

#include "lab/experiment.h"

namespace drape {

LabResult run_anisotropy();
LabResult run_folds();
LabResult run_density();
LabResult run_compression();
LabResult run_erratum();
LabResult run_jumps();
LabResult run_jitter();
LabResult run_fabric();
LabResult run_validation();

}  // namespace drape

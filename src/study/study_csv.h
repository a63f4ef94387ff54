// study.csv: a row per rung, run or not; SI units; what is not known is empty.
#pragma once

#include <string>

#include "study/study.h"

namespace drape {

std::string study_csv(const Study& study);

}  // namespace drape

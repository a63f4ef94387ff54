// study.csv: a row per rung, run or not; SI units; what is not known is empty. Comma separated, fields with
// commas or quotes quoted as RFC 4180 has it.
#pragma once

#include <string>

#include "study/study.h"

namespace drape {

std::string study_csv(const Study& study);

}  // namespace drape

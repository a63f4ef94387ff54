// Fields of a csv file: comma separated, quoted as RFC 4180 has it.
#pragma once

#include <string>

namespace drape {

std::string csv_text(const std::string& text);
std::string csv_number(double value);  // empty where it is not known

}  // namespace drape

// Numbers as people read them.
#pragma once

#include <string>

namespace drape {

std::string figure(double value, int digits = 3);  // "0.0123", "1.2e-09"; "-" where not known
std::string length_text(double metres);            // "590 µm"
std::string time_text(double seconds);             // "83 µs"

}  // namespace drape

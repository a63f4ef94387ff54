#include "study/csv.h"

#include <cmath>

#include "base/numbers.h"

namespace drape {

std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string csv_number(double value) {
    return std::isfinite(value) ? figure(value, 9) : "";
}

}  // namespace drape

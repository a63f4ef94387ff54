#include "compare/compared.h"

#include <algorithm>
#include <array>

namespace drape {

std::string_view verdict_name(Verdict verdict) {
    constexpr std::array<std::string_view, 5> names{"identical", "within", "different", "missing", "added"};
    return names[static_cast<size_t>(verdict)];
}

int Comparison::count(Verdict verdict) const {
    return static_cast<int>(std::count_if(files.begin(), files.end(),
                                          [&](const Compared& file) { return file.verdict == verdict; }));
}

bool Comparison::passed() const {
    return std::all_of(files.begin(), files.end(), [](const Compared& file) { return file.passed(); });
}

}  // namespace drape

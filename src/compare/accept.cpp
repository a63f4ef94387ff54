#include "compare/accept.h"

#include <filesystem>

#include "base/error.h"
#include "io/read_file.h"
#include "io/write_file.h"

namespace drape {

void accept(const Comparison& comparison, const std::string& result, const std::string& reference) {
    constexpr std::uint64_t largest_file = std::uint64_t{16} << 30;  // [bytes]
    for (const Compared& file : comparison.files) {
        if (file.passed()) continue;
        const ComparedPaths paths = paths_of(file, result, reference, {});
        if (file.verdict != Verdict::missing) {
            write_file(paths.reference, read_file(paths.result, largest_file));
            continue;
        }
        std::error_code trouble;
        if (!std::filesystem::remove(paths.reference, trouble))
            throw Error(cat(paths.reference, ": cannot be removed: ", trouble.message()), Exit::cannot_write);
    }
}

}  // namespace drape

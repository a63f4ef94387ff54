#include "study/stability_findings.h"

#include <algorithm>

#include "base/names.h"
#include "study/numbers.h"

namespace drape {

int StabilityCount::failed() const {
    return total - of(Stability::stable) - of(Stability::lossy) - of(Stability::left_out);
}

StabilityCount count_cells(const StabilityMap& map, std::string_view name) {
    StabilityCount count;
    double first_failed = INFINITY;
    std::vector<double> shares;
    for (const StabilityCell& cell : map.cells) {
        if (cell.name() != name) continue;
        ++count.total;
        ++count.cells[static_cast<size_t>(cell.verdict.state)];
        if (!std::isfinite(cell.limit) || cell.verdict.state >= Stability::refused) continue;
        const double share = cell.step / cell.limit;
        shares.push_back(share);
        if (!holds(cell.verdict.state)) first_failed = std::min(first_failed, share);
    }
    for (const double share : shares) {
        count.tried_to = std::max(count.tried_to, share);
        if (share < first_failed) count.up_to = std::max(count.up_to.value_or(0), share);
    }
    return count;
}

std::string summary_of(const StabilityMap& map, std::string_view name) {
    const StabilityCount count = count_cells(map, name);
    std::string text = cat(name, ": ");
    if (count.up_to) text += cat("stable up to ", figure(*count.up_to, 2), " of the theoretical limit; ");
    text += cat(count.of(Stability::stable), " of ", count.total, " cells");
    std::vector<std::string> others;
    for (size_t i = 1; i < count.cells.size(); ++i)
        if (count.cells[i] > 0) others.push_back(cat(stability_kinds()[i].name, " ", count.cells[i]));
    return others.empty() ? text : cat(text, " (", joined(others), ")");
}

}  // namespace drape

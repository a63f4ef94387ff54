#include "study/stability_findings.h"

#include <algorithm>

#include "base/names.h"
#include "base/numbers.h"

namespace drape {

int StabilityCount::failed() const {
    return total - of(Stability::stable) - of(Stability::lossy) - of(Stability::left_out);
}

namespace {

std::optional<double> holds_up_to(const StabilityMap& map, std::string_view name, bool soft) {
    double first_failed = INFINITY;
    std::vector<double> shares;
    for (const StabilityCell& cell : map.cells) {
        if (cell.name() != name || cell.is_soft != soft) continue;
        if (!std::isfinite(cell.limit) || cell.verdict.state >= Stability::refused) continue;
        shares.push_back(cell.step / cell.limit);
        if (!holds(cell.verdict.state)) first_failed = std::min(first_failed, shares.back());
    }
    std::optional<double> most;
    for (const double share : shares)
        if (share < first_failed) most = std::max(most.value_or(0), share);
    return most;
}

}  // namespace

StabilityCount count_cells(const StabilityMap& map, std::string_view name) {
    StabilityCount count;
    for (const StabilityCell& cell : map.cells) {
        if (cell.name() != name) continue;
        ++count.total;
        ++count.cells[static_cast<size_t>(cell.verdict.state)];
    }
    count.up_to = holds_up_to(map, name, false);
    count.soft_up_to = holds_up_to(map, name, true);
    return count;
}

std::string summary_of(const StabilityMap& map, std::string_view name) {
    const StabilityCount count = count_cells(map, name);
    std::string text = cat(name, ": ");
    if (count.up_to) {
        text += cat("stable up to ", figure(*count.up_to, 2), " of the theoretical limit");
        if (count.soft_up_to) text += cat(" (", figure(*count.soft_up_to, 2), " where soft cloth stretches)");
        text += "; ";
    }
    text += cat(count.of(Stability::stable), " of ", count.total, " cells");
    std::vector<std::string> others;
    for (size_t i = 1; i < count.cells.size(); ++i)
        if (count.cells[i] > 0) others.push_back(cat(stability_kinds()[i].name, " ", count.cells[i]));
    return others.empty() ? text : cat(text, " (", joined(others), ")");
}

}  // namespace drape

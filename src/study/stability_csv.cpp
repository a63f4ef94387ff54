#include "study/stability_csv.h"

#include "base/error.h"
#include "study/csv.h"

namespace drape {

std::string stability_csv(const StabilityMap& map) {
    std::string text =
        "method,mesh,options,stiffness_n_per_m,step_s,limit_s,near_limit,state,most_gained,most_lost,runs,"
        "chosen_method,why\n";
    for (const StabilityCell& cell : map.cells) {
        const StabilityCloth& cloth = map.cloths[cell.cloth];
        const Verdict& verdict = cell.verdict;
        text += cat(cell.name(), ",", csv_text(cloth.mesh), ",", csv_text(cloth.options), ",",
                    csv_number(cell.stiffness), ",", csv_number(cell.step), ",", csv_number(cell.limit), ",",
                    cell.on_grid ? 0 : 1, ",", kind_of(verdict.state).name, ",", csv_number(verdict.gained),
                    ",", csv_number(verdict.lost), ",", verdict.runs, ",", verdict.method, ",",
                    csv_text(verdict.why), "\n");
    }
    return text;
}

}  // namespace drape

#include "app/plots.h"

#include "app/interrupt.h"
#include "io/write_file.h"

namespace drape {

GnuplotRun make_plots_of(const std::string& script, const std::string& folder) {
    catch_interrupts();
    write_file(folder + "/plots.gp", script);
    GnuplotRun run = run_gnuplot(folder);
    demand_no_interrupt();
    return run;
}

}  // namespace drape

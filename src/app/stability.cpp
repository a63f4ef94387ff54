// stability: at which springs and steps every method is stable, as a table, maps and a page.
#include <cstdio>
#include <thread>

#include "app/demo_scenes.h"
#include "app/verbs.h"
#include "app/version.h"
#ifdef DRAPE_WITH_STUDY
#include "app/interrupt.h"
#include "app/plots.h"
#include "base/shell_word.h"
#include "io/read_file.h"
#include "io/write_file.h"
#include "report/report.h"
#include "scene/builder.h"
#include "scene/reader.h"
#include "study/stability_csv.h"
#include "study/stability_findings.h"
#include "study/stability_page.h"
#include "study/stability_plot.h"
#endif

namespace drape {

#ifdef DRAPE_WITH_STUDY

namespace {

// What is tried, and on how many of the cloths every method is.
struct Subject {
    std::vector<StabilityCloth> cloths;
    size_t whole = 0;
};

Subject subject_of(const StabilityRequest& request) {
    if (!request.scene.empty()) {
        const SceneDescription scene = read_scene(scene_path(request.scene), request.set);
        return {{cloth_of_scene(scene.name, build_scene(scene).setup)}, 1};
    }
    if (!request.set.empty()) throw Error("--set changes a value of a scene: which scene?");
    std::vector<StabilityCloth> all = built_in_cloths();
    if (request.full) return {all, all.size()};
    // the plainest, and of each other mesh the one with everything
    const size_t of_mesh = all.size() / 3;
    return {{all.front(), all[2 * of_mesh - 1], all[3 * of_mesh - 1]}, 1};
}

StabilityOptions options_of(const StabilityRequest& request) {
    StabilityOptions options;
    options.stiffness = decades(1e-2, 1e9, request.full ? 2 : 1);
    options.step = decades(1e-5, 0.1, request.full ? 6 : 4);
    options.methods = methods_named(request.methods);
    if (request.scene.empty()) options.recovery_trials = request.runs;
    options.trial.runs = request.runs;
    options.threads =
        request.threads > 0 ? request.threads : static_cast<int>(std::thread::hardware_concurrency());
    options.stop = interrupted;
    if (!request.quiet)
        options.say = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
    return options;
}

// The command that makes this map again.
std::string command_of(const StabilityRequest& request) {
    std::string command = "drape stability";
    if (!request.scene.empty()) command += cat(" ", shell_word(request.scene));
    for (const std::string& set : request.set) command += cat(" --set ", shell_word(set));
    for (const std::string& method : request.methods) command += cat(" --method ", shell_word(method));
    if (request.runs != StabilityRequest{}.runs) command += cat(" --runs ", request.runs);
    return command + (request.full ? " --full" : "");
}

StabilityPlots make_plots(const StabilityMap& map, const std::string& out, std::string& gnuplot_version) {
    const GnuplotRun run = make_plots_of(stability_script(map), out);
    gnuplot_version = run.version;
    StabilityPlots plots{{}, run.trouble};
    if (!run.trouble.empty()) return plots;
    for (const StabilityFigure& figure : figures_of(map))
        plots.svg.push_back(read_file(cat(out, "/", figure.file, ".svg"), largest_plot));
    return plots;
}

}  // namespace

Exit map_stability(const StabilityRequest& request) {
    const StabilityOptions options = options_of(request);
    Subject subject = subject_of(request);
    const std::string out = request.out.empty() ? "renders/stability" : request.out;
    catch_interrupts();
    make_folder(out);
    const StabilityMap map = make_stability_map(std::move(subject.cloths), subject.whole, options);
    demand_no_interrupt();

    write_file(out + "/stability.csv", stability_csv(map));
    if (!map.recoveries.empty()) write_file(out + "/collapse.csv", recovery_csv(map.recoveries));
    Provenance provenance{command_of(request),
                          std::string(version),
                          "",
                          "",
                          processor_name(),
                          std::thread::hardware_concurrency()};
    const StabilityPlots plots = make_plots(map, out, provenance.gnuplot_version);
    write_file(out + "/index.html", stability_page(map, plots, provenance));
    if (!request.quiet) {
        for (const std::string_view name : map.names()) std::printf("%s\n", summary_of(map, name).c_str());
        for (const std::string& line : recovery_summary(map.recoveries)) std::printf("%s\n", line.c_str());
        std::printf("%.1f CPU s\n%s/index.html\n", map.cpu_seconds, out.c_str());
    }
    if (!plots.trouble.empty())
        throw Error(cat(out, ": no plots: ", plots.trouble, " (stability.csv and index.html are written)"),
                    Exit::cannot_write);
    return Exit::done;
}

#else

Exit map_stability(const StabilityRequest&) {
    throw Error("this drape was built without `stability` (build with DRAPE_STUDY=ON, which needs SUNDIALS)");
}

#endif

}  // namespace drape

// study: error against run time of every method on one scene, as a table, plots and a page.
#include <cstdio>
#include <filesystem>
#include <thread>

#include "app/demo_scenes.h"
#include "app/verbs.h"
#include "app/version.h"
#ifdef DRAPE_WITH_STUDY
#include "app/plots.h"
#include "base/numbers.h"
#include "base/shell_word.h"
#include "io/read_file.h"
#include "io/write_file.h"
#include "report/report.h"
#include "scene/builder.h"
#include "scene/reader.h"
#include "study/study_csv.h"
#include "study/study_page.h"
#include "study/study_plot.h"
#include "study/sundials_reference.h"
#ifdef DRAPE_WITH_RENDER
#include "app/picture_maker.h"
#endif
#endif

namespace drape {

#ifdef DRAPE_WITH_STUDY

namespace {

namespace fs = std::filesystem;

// The command that makes this study again.
std::string command_of(const StudyRequest& request) {
    std::string command = "drape study " + shell_word(request.scene);
    for (const std::string& set : request.set) command += " --set " + shell_word(set);
    if (request.until) command += cat(" --until ", *request.until);
    for (const std::string& method : request.methods) command += " --method " + shell_word(method);
    command += cat(" --repeats ", request.repeats, " --budget ", request.budget);
    return command + (request.refine ? " --refine" : "");
}

DrawState drawer([[maybe_unused]] SceneDescription scene, [[maybe_unused]] const Setup& setup) {
#ifdef DRAPE_WITH_RENDER
    struct Kept {
        Simulation simulation;
        DrawnScene drawn;
        Renderer renderer;
        Kept(const SceneDescription& described, const Setup& from)
            : simulation(from), drawn(drawn_scene(described, simulation)), renderer(make_renderer(drawn)) {}
    };
    scene.look.size = {640, 360};
    scene.look.overlay = "none";
    Setup any = setup;
    any.method = "verlet";
    any.step.reset();
    const auto kept = std::make_shared<Kept>(scene, any);
    return [kept, overlay = scene.look.overlay](const State& state) {
        return kept->renderer.draw(frame_input(overlay, kept->simulation, state));
    };
#else
    return {};
#endif
}

StudyPlots make_plots(const Study& study, const std::string& out, std::string& gnuplot_version) {
    const GnuplotRun run = make_plots_of(plot_script(study), out);
    gnuplot_version = run.version;
    if (!run.trouble.empty()) return {{}, {}, run.trouble};
    return {read_file(out + "/error_time.svg", largest_plot),
            read_file(out + "/error_over_time.svg", largest_plot),
            {}};
}

void print_findings(const Study& study, const std::string& out) {
    std::printf("%s: %s\n", study.scene.c_str(), study.probe.window.c_str());
    for (const double metres : {1e-2, 1e-3, 1e-4})
        std::printf("  %s\n", cheapest_sentence(study, metres).c_str());
    std::printf("  error bar %s, predictability floor %s; %.1f CPU s\n  %s/index.html\n",
                length_text(study.bar()).c_str(), length_text(study.floor()).c_str(), study.cpu_seconds,
                out.c_str());
}

}  // namespace

Exit study_scene(const StudyRequest& request) {
    const SceneDescription scene = read_scene(scene_path(request.scene), request.set);
    StudyOptions options;
    options.until = request.until;
    options.repeats = request.repeats;
    options.budget = request.budget;
    options.methods = methods_named(request.methods);
    if (!request.quiet)
        options.say = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
    const std::string out =
        request.out.empty() ? "renders/" + fs::path(request.scene).stem().string() + "_study" : request.out;
    const Setup setup = build_scene(scene).setup;
    make_folder(out);
    // meshes twice as fine are dear: they have a third of the budget
    if (request.refine) options.budget *= 2.0 / 3;
    Study study = run_study(setup, options, drawer(scene, setup));
    study.scene = scene.name;
    write_file(out + "/study.csv", study_csv(study));
    if (request.refine)
        study.refinement = refine_mesh(scene, study.probe.frames, request.budget / 3, options.say);

    Provenance provenance{command_of(request), std::string(version), "",
                          sundials_version(),  processor_name(),     std::thread::hardware_concurrency()};
    const StudyPlots plots = make_plots(study, out, provenance.gnuplot_version);
    write_file(out + "/index.html", study_page(study, plots, provenance));
    if (!request.quiet) print_findings(study, out);
    if (!plots.trouble.empty())
        throw Error(cat(out, ": no plots: ", plots.trouble, " (study.csv and index.html are written)"),
                    Exit::cannot_write);
    return Exit::done;
}

#else

Exit study_scene(const StudyRequest&) {
    throw Error("this drape was built without `study` (build with DRAPE_STUDY=ON, which needs SUNDIALS)");
}

#endif

}  // namespace drape

// lab: claims of lecture notes on springs, measured, as tables, figures and a page.
#include <cstdio>

#include "app/verbs.h"
#include "app/version.h"
#ifdef DRAPE_WITH_STUDY
#include "app/plots.h"
#include "base/shell_word.h"
#include "io/read_file.h"
#include "io/write_file.h"
#include "lab/page.h"
#include "lab/plot.h"
#endif

namespace drape {

#ifdef DRAPE_WITH_STUDY

namespace {

constexpr std::uint64_t largest_plot = std::uint64_t{64} << 20;  // [bytes]

std::string command_of(const LabRequest& request) {
    std::string command = "drape lab";
    for (const std::string& name : request.experiments) command += cat(" ", shell_word(name));
    return command;
}

GnuplotRun draw(std::vector<LabChapter>& chapters, const std::string& out) {
    std::vector<LabResult> results;
    for (const LabChapter& chapter : chapters) results.push_back(chapter.result);
    GnuplotRun run = make_plots_of(lab_script(results), out);
    if (!run.trouble.empty()) return run;
    for (LabChapter& chapter : chapters)
        for (const LabFigure& figure : chapter.result.figures)
            chapter.svg.push_back(read_file(cat(out, "/", figure.file, ".svg"), largest_plot));
    return run;
}

}  // namespace

Exit run_lab(const LabRequest& request) {
    const std::vector<const Experiment*> wanted = experiments_named(request.experiments);
    const std::string out = request.out.empty() ? "renders/lab" : request.out;
    make_folder(out);
    std::vector<LabChapter> chapters;
    for (const Experiment* experiment : wanted) {
        chapters.push_back({experiment, experiment->run(), {}});
        const LabResult& result = chapters.back().result;
        for (const LabCsv& csv : result.csv) write_file(cat(out, "/", csv.file, ".csv"), csv.text);
        if (request.quiet) continue;
        std::printf("%s: %s\n", std::string(experiment->name).c_str(), result.claim.c_str());
        std::fflush(stdout);
    }
    const GnuplotRun run = draw(chapters, out);
    const Provenance provenance{command_of(request), std::string(version), run.version, "", "", 0};
    write_file(out + "/index.html", lab_page(chapters, run.trouble, provenance));
    if (!request.quiet) std::printf("%s/index.html\n", out.c_str());
    if (!run.trouble.empty())
        throw Error(cat(out, ": no plots: ", run.trouble, " (csv and index.html are written)"),
                    Exit::cannot_write);
    return Exit::done;
}

void list_experiments(void (*row)(std::string_view name, std::string_view says)) {
    for (const Experiment& experiment : experiments()) row(experiment.name, experiment.summary);
}

#else

Exit run_lab(const LabRequest&) {
    throw Error("this drape was built without `lab` (build with DRAPE_STUDY=ON, which needs SUNDIALS)");
}

void list_experiments(void (*)(std::string_view, std::string_view)) {}

#endif

}  // namespace drape

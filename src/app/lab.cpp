// lab: claims of lecture notes on springs, measured, as tables, figures and a page.
#include <algorithm>
#include <cstdio>
#include <functional>

#include "app/verbs.h"
#include "app/version.h"
#ifdef DRAPE_WITH_STUDY
#include "app/plots.h"
#include "base/names.h"
#include "base/shell_word.h"
#include "cloth/fabric.h"
#include "io/read_file.h"
#include "io/write_file.h"
#include "lab/fabrics.h"
#include "lab/fit.h"
#include "lab/page.h"
#include "lab/plot.h"
#endif

namespace drape {

#ifdef DRAPE_WITH_STUDY

namespace {

std::string command_of(const LabRequest& request) {
    std::string command = "drape lab";
    for (const std::string& name : request.experiments) command += cat(" ", shell_word(name));
    if (request.bending_length) command += cat(" --bending-length ", *request.bending_length);
    if (request.density) command += cat(" --density ", *request.density);
    return command;
}

struct Chapter {
    const Experiment* experiment;
    std::function<LabResult()> run;
};

const Experiment fitting{"fit", "spring constants from a measured stretch curve and bending length", nullptr};

// `fit` and a file; `fabric` and names of fabrics; else experiments.
std::vector<Chapter> chapters_asked(const LabRequest& request) {
    const std::vector<std::string>& words = request.experiments;
    const bool fits = !words.empty() && words.front() == fitting.name;
    if (!fits && (request.bending_length || request.density))
        throw Error("--bending-length and --density are for `drape lab fit FILE`");
    if (fits) {
        if (words.size() != 2 || !request.bending_length || !request.density)
            throw Error("lab fit: expected one file with --bending-length and --density");
        return {{&fitting, [&request] {
                     return run_fit({request.experiments[1], *request.bending_length, *request.density});
                 }}};
    }
    const auto all = names_of(experiments());
    const bool named = words.size() > 1 && words.front() == "fabric" &&
                       std::find(all.begin(), all.end(), words[1]) == all.end();
    const std::span<const std::string> span(words);
    if (named) {
        for (const std::string& name : span.subspan(1)) fabric_preset(name);
        return {
            {experiments_named(span.first(1)).front(), [span] { return measure_fabrics(span.subspan(1)); }}};
    }
    std::vector<Chapter> chapters;
    for (const Experiment* experiment : experiments_named(words))
        chapters.push_back({experiment, experiment->run});
    return chapters;
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
    const std::vector<Chapter> wanted = chapters_asked(request);
    if (wanted.front().experiment == &fitting) read_stretch_curve(request.experiments[1]);
    const std::string out = request.out.empty() ? "renders/lab" : request.out;
    make_folder(out);
    std::vector<LabChapter> chapters;
    for (const auto& [experiment, run] : wanted) {
        chapters.push_back({experiment, run(), {}});
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

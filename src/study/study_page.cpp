#include "study/study_page.h"

#include <algorithm>

#include "base/error.h"
#include "base/markup.h"
#include "base/numbers.h"
#include "study/findings.h"
#include "study/html.h"

namespace drape {

namespace {

std::string error_text(const Rung& rung) {
    return (rung.errors.below_bar ? "< " : "") + length_text(rung.errors.final_rms);
}

std::string rung_name(const Rung& rung) {
    return cat(rung.method->name, " with steps of ", time_text(rung.step));
}

std::string statistics(const Study& study) {
    std::vector<std::vector<std::string>> rows;
    for (const Rung& rung : study.rungs) {
        if (!rung.good()) continue;
        const auto [least, most] = std::minmax_element(rung.cpu.begin(), rung.cpu.end());
        rows.push_back({std::string(rung.method->name), time_text(rung.step), error_text(rung),
                        length_text(rung.errors.final_max), length_text(rung.errors.time_l2),
                        figure(rung.pass.energy_drift),
                        rung.picture ? figure(rung.picture->mean_levels) : "-",
                        rung.picture ? figure(100 * rung.picture->share_over) : "-", figure(median(rung.cpu)),
                        cat(figure(*least), " to ", figure(*most)), figure(median(rung.wall)),
                        std::to_string(rung.cpu.size()), std::to_string(rung.pass.steps),
                        std::to_string(rung.pass.sweeps), std::to_string(rung.pass.solver.factorisations),
                        std::to_string(rung.pass.solver.iterations)});
    }
    return table(
        {"method", "step", "RMS error", "largest", "over time", "energy drift, J", "levels", "pixels, %",
         "CPU s", "least to most", "wall s", "runs", "steps", "sweeps", "factorisations", "iterations"},
        rows, 1);
}

std::string orders(const Study& study) {
    std::vector<std::vector<std::string>> rows;
    for (const Method* method : study.methods()) {
        const SeenOrder order = seen_order(study, *method);
        rows.push_back({std::string(method->name), std::to_string(order.expected),
                        order.seen ? figure(*order.seen) : "-", std::to_string(order.rungs)});
    }
    return table({"method", "expected", "observed", "from rungs"}, rows, 1) +
           paragraph(
               "Observed: the slope of error over step of each method's shortest steps whose error is at "
               "least three times the reference's bar. Contact that comes and goes, and folds that "
               "buckle, lower it.");
}

std::string failures(const Study& study) {
    std::vector<std::vector<std::string>> failed, left_out;
    for (const RefusedMethod& refused : study.refused)
        failed.push_back({std::string(refused.method->name), "any step", refused.why});
    for (const Rung& rung : study.rungs) {
        if (!rung.failed.empty())
            failed.push_back({std::string(rung.method->name), time_text(rung.step), rung.failed});
        if (!rung.left_out.empty())
            left_out.push_back({std::string(rung.method->name), time_text(rung.step), rung.left_out});
    }
    const std::string failures =
        failed.empty() ? paragraph("Nothing failed.") : table({"method", "step", "what happened"}, failed, 3);
    if (left_out.empty()) return failures + paragraph("Nothing was left out.");
    return failures + paragraph("Left out to keep to the budget:") +
           table({"method", "step", "why"}, left_out, 3);
}

std::string reference_text(const Study& study) {
    return paragraph(cat("The reference: ", study.reference.how, ". Checked by: ", study.reference.checked_by,
                         ". At the last frame they differ by ", length_text(study.bar()),
                         " RMS or round-off does: that is the error bar, and no error is stated below it. A "
                         "coarser pass of the reference's own method puts its error at ",
                         length_text(study.reference.richardson), ".")) +
           paragraph(
               cat("Predictability floor: a run whose start was moved by 1e-12 m ends ",
                   length_text(study.floor()),
                   " away. Errors below it hold for this exact start alone, and no real start is known that "
                   "exactly."));
}

std::string refinement_text(const Study& study) {
    const MeshRefinement& refinement = *study.refinement;
    if (!refinement.refused.empty()) return paragraph("Not done: " + refinement.refused + ".");
    std::vector<std::vector<std::string>> rows;
    for (const RefinedMesh& mesh : refinement.meshes) {
        const bool finest = mesh.last.rms == 0;
        rows.push_back({cat("x ", mesh.factor), std::to_string(mesh.vertices), figure(mesh.cpu_seconds),
                        !mesh.left_out.empty() ? mesh.left_out
                        : finest               ? "what the others are compared with"
                                               : length_text(mesh.last.rms),
                        finest ? "-" : length_text(mesh.worst_rms)});
    }
    std::string text =
        table({"divisions", "vertices", "CPU s", "from the finest, last frame", "worst frame"}, rows, 1);
    if (!refinement.error)
        return text + paragraph("Too few meshes could be run to estimate the mesh's error.");
    if (!refinement.note.empty()) text += paragraph(refinement.note);
    if (refinement.converges)
        text += paragraph(cat("The scene's own mesh is about ", length_text(*refinement.error),
                              " RMS from cloth without a mesh, at order ", figure(refinement.order, 2),
                              refinement.order_seen ? " as these meshes show." : ", which is assumed."));
    else
        text += paragraph(cat("These meshes do not converge yet: the scene's own is at least ",
                              length_text(*refinement.error), " RMS from cloth without a mesh."));
    if (const Rung* rung = cheapest_under(study, *refinement.error))
        text += paragraph(cat("Time steps need not be better than that: ", rung_name(*rung), " reaches ",
                              error_text(*rung), " in ", figure(median(rung->cpu)), " CPU s."));
    else
        text += paragraph("No method reached that with its time steps: here they dominate.");
    return text;
}

std::string how_to_read() {
    return "<ul>\n<li>Error: distance from the reference, root mean square over all vertices at the last "
           "frame; "
           "<em>largest</em> is the worst vertex, <em>over time</em> the root mean square over all "
           "frames.</li>\n"
           "<li><em>Levels</em> and <em>pixels</em>: the last frame drawn at 640 x 360 against the "
           "reference's "
           "picture: mean absolute difference of 8-bit levels, and pixels that differ by more than 8.</li>\n"
           "<li>CPU seconds are of the thread that advances the pass, the median of all runs of a rung, "
           "which "
           "take turns with all other rungs.</li>\n"
           "<li>A sweep is one evaluation of all forces. Energy drift is what no damping, friction, wind or "
           "motion accounts for.</li>\n<li>Lower and further left is better. Dashed lines are methods that "
           "are "
           "stable with any step.</li>\n</ul>\n";
}

std::string made_by(const Study& study, const Provenance& p) {
    return "<p><code>" + escaped(p.command) + "</code></p>\n" +
           paragraph(cat("drape ", p.drape_version, "; SUNDIALS ", p.sundials_version, "; gnuplot ",
                         p.gnuplot_version.empty() ? "none" : p.gnuplot_version, "; ", p.processor, ", ",
                         p.cores, " cores. The study took ", figure(study.cpu_seconds), " CPU s."));
}

}  // namespace

std::string cheapest_sentence(const Study& study, double metres) {
    const std::string at = cat("At ", length_text(metres));
    if (study.bar() > metres) return at + " nothing can be said: the reference's error bar is wider.";
    const Rung* rung = cheapest_under(study, metres);
    if (!rung) return at + ": no method got there.";
    return cat(at, " the cheapest is ", rung_name(*rung), ": ", figure(median(rung->cpu)), " CPU s, error ",
               error_text(*rung), ".");
}

std::string study_page(const Study& study, const StudyPlots& plots, const Provenance& provenance) {
    std::string answer = "<ul class=\"answer\">\n";
    for (const double metres : {1e-2, 1e-3, 1e-4})
        answer += "<li>" + escaped(cheapest_sentence(study, metres)) + "</li>\n";
    answer += "</ul>\n";
    const std::string figures =
        plots.trouble.empty()
            ? figure_of(
                  plots.error_time, "a_",
                  "Every dot is a run with the step beside it. Grey: below the reference's error bar, where "
                  "nothing is claimed.") +
                  figure_of(plots.error_over_time, "b_",
                            "Each method's cheapest run that ends below 1 mm, or its most accurate one.")
            : paragraph("No plots: " + plots.trouble + ".");
    std::string body = answer + figures;
    body += section("Order of convergence", orders(study));
    body += section("All runs", statistics(study));
    body += section("What failed and why", failures(study));
    body += section("What errors are measured against", reference_text(study));
    if (study.refinement) body += section("The mesh's own error", refinement_text(study));
    body += section("How to read this", how_to_read());
    body += section("How it was made", made_by(study, provenance));
    return html_page("Error against run time", study.scene, study.probe.window, body);
}

}  // namespace drape

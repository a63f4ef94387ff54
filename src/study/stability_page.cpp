#include "study/stability_page.h"

#include <algorithm>

#include "base/error.h"
#include "base/markup.h"
#include "base/numbers.h"
#include "scene/fabric_words.h"
#include "study/html.h"
#include "study/stability_findings.h"
#include "study/stability_plot.h"

namespace drape {

namespace {

std::string maps(const StabilityMap& map, const StabilityPlots& plots) {
    if (!plots.trouble.empty()) return paragraph("No plots: " + plots.trouble + ".");
    const std::vector<StabilityFigure> figures = figures_of(map);
    std::string text;
    for (size_t i = 0; i < plots.svg.size(); ++i)
        text += figure_of(
            plots.svg[i], cat("f", i, "_"),
            figures[i].file == auto_name
                ? "Where the method and step that drape chooses lie, and how their runs end."
                : figures[i].title + ". Below the dashed line theory promises that small motion is bounded.");
    return text;
}

std::string counts(const StabilityMap& map) {
    std::vector<std::string> head{"method", "up to, of the limit", "where soft", "cells"};
    for (const StabilityKind& kind : stability_kinds()) head.emplace_back(kind.name);
    std::vector<std::vector<std::string>> rows;
    for (const std::string_view name : map.names()) {
        const StabilityCount count = count_cells(map, name);
        const auto share = [](std::optional<double> value) { return value ? figure(*value) : "-"; };
        rows.push_back(
            {std::string(name), share(count.up_to), share(count.soft_up_to), std::to_string(count.total)});
        for (const int cells : count.cells) rows.back().push_back(std::to_string(cells));
    }
    return table(head, rows, 1);
}

std::string collapses(const StabilityMap& map) {
    std::vector<std::vector<std::string>> rows;
    for (const Recovery& r : map.recoveries)
        rows.push_back({std::string(word_for(altitude_words, r.mode)), std::string(name_of(r.start)),
                        std::to_string(r.collapsed), std::to_string(r.recovered),
                        figure(100.0 * r.recovered / r.collapsed), std::to_string(r.stopped)});
    return table({"altitude springs", "start", "collapsed", "came back", "%", "runs stopped"}, rows, 2) +
           paragraph(
               "Sheets without weight, two damped seconds later. Thrown: held along the border, inner "
               "vertices up to "
               "one and a half edges out of place. Squashed: free, to a fiftieth of the width. A triangle "
               "with less "
               "than a tenth of its area, or turned over, is collapsed; one that ends with more than half of "
               "it has come back.");
}

// What was refused and why, each reason once.
std::string refusals(const StabilityMap& map) {
    std::vector<std::vector<std::string>> rows;
    for (const std::string_view name : map.names()) {
        std::vector<std::string> row;
        int cells = 0;
        for (const StabilityCell& cell : map.cells) {
            if (cell.name() != name || cell.verdict.state != Stability::refused) continue;
            if (cells++ == 0)
                row = {std::string(name),
                       cat(figure(cell.stiffness), " N/m, ", time_text(cell.step), ", ",
                           map.cloths[cell.cloth].mesh, ", ", map.cloths[cell.cloth].options),
                       cell.verdict.why};
        }
        if (cells > 0) rows.push_back(std::move(row));
    }
    if (rows.empty()) return paragraph("Nothing was refused.");
    return table({"method", "first at", "what it said"}, rows, 3);
}

std::string how_to_read(const StabilityMap& map) {
    std::vector<std::vector<std::string>> rows;
    for (const StabilityKind& kind : stability_kinds())
        rows.push_back({std::string(kind.name), std::string(kind.meaning)});
    const Trial& trial = map.trial;
    return paragraph(
               cat("A cell is ", trial.runs, " runs of ", trial.steps,
                   " steps, whatever the step, from starts that differ by a small seeded jitter; the worst "
                   "of them decides, and the first that does not hold ends the cell. Each run has exactly "
                   "the cell's step: nothing shortens it and nothing is tried again. Its energy balance is "
                   "drawn four times: kinetic, elastic and gravitational energy, less what moving pins put "
                   "in, plus what damping and drag took, against all the energies at play. A cell that would "
                   "cost more than ",
                   trial.most_work, " evaluations of the forces has fewer runs; the csv says how many.")) +
           table({"state", "means"}, rows, 2) +
           paragraph(
               "The dashed line is the longest step at which the method keeps every mode of small motion "
               "about the start bounded. Cloth is soft where its weight on one spring would stretch that by "
               "a "
               "tenth or more: its modes change as it stretches, and so does what is stable. Explicit "
               "methods "
               "are tried near the line too, in cells that the maps do not show and the csv holds.") +
           paragraph(
               cat("auto is drape as it runs where nothing is asked: it chooses method and step, guards "
                   "every frame, and is run for ",
                   trial.auto_frames, " frames at 30 a second.")) +
           (map.cloths.front().file == scene_file
                ? paragraph("Of the scene its cloths, pins and gravity are tried, at other stiffnesses: "
                            "without obstacles and air.")
                : "");
}

std::string made_by(const StabilityMap& map, const Provenance& p) {
    return "<p><code>" + escaped(p.command) + "</code></p>\n" +
           paragraph(cat("drape ", p.drape_version, "; gnuplot ",
                         p.gnuplot_version.empty() ? "none" : p.gnuplot_version, "; ", p.processor, ", ",
                         p.cores, " cores. The map took ", figure(map.cpu_seconds), " CPU s."));
}

}  // namespace

std::string stability_page(const StabilityMap& map, const StabilityPlots& plots,
                           const Provenance& provenance) {
    std::string answer = "<ul class=\"answer\">\n";
    for (const std::string_view name : map.names())
        answer += "<li>" + escaped(summary_of(map, name)) + "</li>\n";
    std::string body = answer + "</ul>\n" + maps(map, plots);
    body += section("Cells by state", counts(map));
    body += section("What was refused", refusals(map));
    if (!map.recoveries.empty()) body += section("Collapsed triangles that come back", collapses(map));
    body += section("How to read this", how_to_read(map));
    body += section("How it was made", made_by(map, provenance));
    const std::string subject = map.cloths.size() == 1 ? map.cloths[0].mesh : "built-in cloths";
    return html_page("Where each method is stable", subject,
                     cat(map.cells.size(), " cells, springs of ", figure(map.stiffness.front()), " to ",
                         figure(map.stiffness.back()), " N/m, steps of ", time_text(map.step.front()), " to ",
                         time_text(map.step.back())),
                     body);
}

}  // namespace drape

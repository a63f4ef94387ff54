#include "gallery/page.h"

#include <cstdio>

#include "base/error.h"
#include "base/markup.h"
#include "base/numbers.h"
#include "gallery/page_parts.h"

namespace drape {

namespace {

std::string fixed(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string error_text(const Cost& cost) {
    return cost.error ? length_text(*cost.error) : "not estimated";
}

std::string count(const ShownPiece& piece, const char* one, const char* many) {
    return cat(piece.runs.size(), " ", piece.runs.size() == 1 ? one : many);
}

std::string facts_of(const ShownPiece& piece) {
    if (piece.runs.empty()) return "";
    double cpu = 0;
    for (const ShownRun& run : piece.runs) cpu += run.cost.cpu;
    const Cost& first = piece.runs[0].cost;
    std::string facts = piece.has_panes ? count(piece, "run", "runs") + " of " : "";
    facts += cat(first.vertices, " vertices, ", first.frames, " frames, ");
    if (!piece.has_panes) facts += cat(first.method, ", error ", error_text(first), ", ");
    return facts + fixed("%.3g CPU s", cpu);
}

std::string picture_of(const ShownPiece& piece) {
    if (!piece.trouble.empty())
        return cat("<p class=\"trouble\">Not made: ", escaped(piece.trouble), "</p>\n");
    return cat("<a class=\"picture\" href=\"", escaped(piece.loop), "\"><img src=\"", escaped(piece.poster),
               "\" data-loop=\"", escaped(piece.loop), "\" width=\"", piece.width, "\" height=\"",
               piece.height, "\" loading=\"lazy\" alt=\"", escaped(piece.title), "\"></a>\n");
}

std::string article_of(const ShownPiece& piece) {
    std::string commands;
    for (const std::string& command : piece.commands) commands += escaped(command) + "\n";
    return cat("<article id=\"", escaped(piece.name), "\"", piece.has_panes ? " class=\"panes\"" : "", ">\n",
               picture_of(piece), "<h2>", escaped(piece.title), "</h2>\n<p>", escaped(piece.says), "</p>\n",
               "<p class=\"facts\">", escaped(facts_of(piece)), "</p>\n<details><summary>",
               piece.commands.size() == 1 ? "Command" : "Commands", "</summary><pre><code>", commands,
               "</code></pre></details>\n</article>\n");
}

std::string cell(const std::string& text, bool number = false) {
    return cat("<td", number ? " class=\"number\"" : "", ">", escaped(text), "</td>");
}

std::string row_of(const ShownPiece& piece, const ShownRun& run) {
    const Cost& cost = run.cost;
    return cat("<tr><td><a href=\"#", escaped(piece.name), "\">", escaped(piece.name), "</a></td>",
               cell(run.label), cell(cat(cost.vertices), true), cell(cat(cost.frames), true),
               cell(cost.method), cell(cost.step ? time_text(*cost.step) : "-", true),
               cell(error_text(cost), true), cell(fixed("%.3g", cost.simulation), true),
               cell(fixed("%.3g", cost.cpu), true), cell(fixed("%.0f", cost.memory), true), "</tr>\n");
}

std::string costs_of(const GalleryPage& page) {
    std::string rows;
    for (const ShownPiece& piece : page.pieces) {
        for (const ShownRun& run : piece.runs) rows += row_of(piece, run);
        if (!piece.trouble.empty())
            rows +=
                cat("<tr class=\"trouble\"><td><a href=\"#", escaped(piece.name), "\">", escaped(piece.name),
                    "</a></td><td colspan=\"9\">not made: ", escaped(piece.trouble), "</td></tr>\n");
    }
    return cat(
        "<section>\n<h2>What they cost</h2>\n<p>As each run's report has it, on ", escaped(page.machine),
        ". The error is that of the time steps, estimated by a second run with other steps, RMS of the "
        "worst frame; cloth that folds is chaotic, and there it tells how far results may differ. CPU "
        "seconds are of steps, estimate and pictures together; the steps alone are told beside.</p>\n"
        "<div class=\"wide\"><table>\n<thead><tr><th>piece</th><th>run</th><th class=\"number\">vertices</th>"
        "<th class=\"number\">frames</th><th>method</th><th class=\"number\">step</th><th class=\"number\">"
        "error</th><th class=\"number\">steps, CPU s</th><th class=\"number\">all, CPU s</th>"
        "<th class=\"number\">peak MB</th></tr></thead>\n<tbody>\n",
        rows, "</tbody></table></div>\n</section>\n");
}

}  // namespace

std::string gallery_page(const GalleryPage& page) {
    std::string articles;
    for (const ShownPiece& piece : page.pieces) articles += article_of(piece);
    return cat(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n<title>",
        escaped(page.title), "</title>\n<style>\n", gallery_style(), "</style>\n</head>\n<body>\n",
        "<header>\n<h1>", escaped(page.title),
        "</h1>\n<p>Cloth as masses on springs, simulated and drawn without a display. Every picture is "
        "drape's own; the commands under it, run in this page's folder, make it again.</p>\n"
        "</header>\n<main>\n",
        articles, "</main>\n", costs_of(page), "<footer>Made by ", escaped(page.made_by),
        ".</footer>\n<script>\n", gallery_script(), "</script>\n</body>\n</html>\n");
}

}  // namespace drape

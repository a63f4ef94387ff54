#include "compare/page.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/markup.h"
#include "base/numbers.h"
#include "compare/charts.h"
#include "compare/metrics.h"
#include "compare/page_frames.h"
#include "compare/page_parts.h"

namespace drape {

namespace {

std::string paragraph(const std::string& text, const char* style = "") {
    return cat("<p", *style ? cat(" class=\"", style, "\"") : std::string(), ">", escaped(text), "</p>\n");
}

std::string cell(const std::string& text, bool number = false) {
    return cat("<td", number ? " class=\"number\"" : "", ">", escaped(text), "</td>");
}

std::string counts_of(const Comparison& comparison) {
    std::string counts;
    for (const Verdict verdict :
         {Verdict::different, Verdict::missing, Verdict::added, Verdict::within, Verdict::identical})
        if (const int count = comparison.count(verdict); count > 0)
            counts += cat(counts.empty() ? "" : ", ", count, " ", verdict_name(verdict));
    return counts;
}

std::string head_of(const Comparison& comparison, const PageRequest& request) {
    const bool passed = comparison.passed();
    std::string head = cat("<h1>", escaped(request.result), " <span class=\"soft\">against</span> ",
                           escaped(request.reference), "</h1>\n<p><span class=\"outcome ",
                           passed ? "passed\">same" : "failed\">different",
                           "</span>: ", escaped(counts_of(comparison)), "</p>\n");
    if (const std::string cause = cause_of(comparison); !cause.empty()) head += paragraph(cause);
    if (!passed)
        head += cat("<p>Accept the results as the new references: <code id=\"accept\">",
                    escaped(request.accept), "</code></p>\n");
    return head;
}

std::optional<double> limit_of(const Comparison& comparison, const Metric& metric) {
    const auto limit = comparison.limits.find(metric.key);
    return limit == comparison.limits.end() ? std::nullopt : std::optional(limit->second);
}

std::string frame_timeline(const Comparison& comparison, const std::vector<ShownFrame>& shown) {
    const Metric& mean = metric_of("mean");
    std::vector<Mark> marks;
    for (size_t i = 0; i < comparison.files.size(); ++i) {
        const Compared& file = comparison.files[i];
        if (!file.name.ends_with(".png")) continue;
        Mark mark{.name = file.name, .text = std::string(verdict_name(file.verdict)), .bad = !file.passed()};
        const std::optional<double> value = mean.value(file);
        if (value) mark.text += ", " + metric_text(mean, *value);
        if (value || file.passed()) mark.value = value.value_or(0);
        for (const ShownFrame& frame : shown)
            if (frame.file == i) mark.link = cat("#", frame.id());
        marks.push_back(std::move(mark));
    }
    if (marks.size() < 2) return "";
    const std::string what = "Mean difference of each frame, in levels";
    return cat("<h3>", what, "</h3>\n<div class=\"chart\">",
               timeline(marks, limit_of(comparison, mean), what), "</div>\n",
               paragraph("On a scale of decades. Red did not pass; what is pale could not be measured, since "
                         "one side lacks it or "
                         "has another size; the dashed line is the limit. A bar leads to its frame where "
                         "that is shown below.",
                         "soft"));
}

std::string cache_timelines(const Comparison& comparison) {
    const Metric& rms = metric_of("rms");
    const std::optional<double> limit = limit_of(comparison, rms);
    std::string charts;
    for (const Compared& file : comparison.files) {
        if (!file.cache || file.cache->rms_each.size() < 2) continue;
        std::vector<Mark> marks;
        for (size_t s = 0; s < file.cache->rms_each.size(); ++s) {
            const double value = file.cache->rms_each[s];
            marks.push_back({.name = cat("sample ", s),
                             .value = value,
                             .text = metric_text(rms, value),
                             .bad = limit && exceeds(rms, value, *limit)});
        }
        const std::string what = cat("Positions of ", file.name, ", RMS of each sample in metres");
        charts += cat("<h3>", escaped(what), "</h3>\n<div class=\"chart\">", timeline(marks, limit, what),
                      "</div>\n");
    }
    return charts;
}

std::string numbers_of(const Compared& file) {
    std::string text;
    for (const Metric& metric : metrics())
        if (const std::optional<double> value = metric.value(file))
            text += cat(text.empty() ? "" : "; ", metric_text(metric, *value), " ", metric.name);
    return text;
}

std::string article_of(Compared& file, const ShownFrame& frame, const PageRequest& request) {
    const std::string figures =
        frame_figures(file, paths_of(file, request.result, request.reference, request.asked), frame.small);
    const bool two = file.verdict != Verdict::missing && file.verdict != Verdict::added;
    const bool compared = two && file.picture;
    std::string modes = "<button data-mode=\"side\">1 side by side</button>";
    if (two)
        modes += "<button data-mode=\"slider\">2 slider</button><button data-mode=\"blink\">3 blink</button>";
    if (compared)
        modes +=
            "<button data-mode=\"difference\">4 difference x16</button>"
            "<button data-mode=\"perception\">5 what an eye notices</button>";
    std::string text = cat("<article id=\"", frame.id(), "\">\n<h2>", escaped(file.name),
                           " <span class=\"soft\">", verdict_name(file.verdict), "</span></h2>\n");
    if (!file.why.empty()) text += paragraph(file.why);
    text += cat("<div class=\"modes\">", modes, "</div>\n<div class=\"stage side\">\n", figures, "</div>\n");
    if (two)
        text +=
            "<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" step=\"any\" aria-label=\"slider\">\n";
    if (frame.small) text += paragraph("Reduced; the numbers are of the full pictures.", "soft");
    if (compared) {
        text += paragraph(numbers_of(file));
        text +=
            cat("<p class=\"soft\">Pixels by how many levels their worst channel is off:</p><div "
                "class=\"histogram\">",
                histogram(file.picture->histogram), "</div>\n");
    }
    return text + "</article>\n";
}

std::string frames_of(Comparison& comparison, const std::vector<ShownFrame>& shown,
                      const PageRequest& request) {
    if (shown.empty()) return "";
    std::string links, articles;
    for (const ShownFrame& frame : shown) {
        Compared& file = comparison.files[frame.file];
        articles += article_of(file, frame, request);
        links += cat("<a href=\"#", frame.id(), "\" class=\"", verdict_name(file.verdict), "\">",
                     escaped(file.name), "</a>");
    }
    const auto pictures =
        std::count_if(comparison.files.begin(), comparison.files.end(), [](const Compared& file) {
            return file.name.ends_with(".png") && file.verdict != Verdict::identical;
        });
    std::string left_out;
    if (const auto more = pictures - static_cast<std::ptrdiff_t>(shown.size()); more > 0)
        left_out = paragraph(
            cat("Of ", pictures, " frames that are not identical ", shown.size(),
                " are shown, the worst; the pictures of ", more, " are left out to keep the page light."),
            "soft");
    return cat(
        "<h3>Frames</h3>\n", left_out,
        paragraph("Keys: up and down (or k and j) change the frame, 1 to 5 the view, left and right move the "
                  "slider, space blinks, and so does hovering.",
                  "soft"),
        "<div class=\"frames\"><nav>", links, "</nav>\n<main>\n", articles, "</main></div>\n");
}

std::string table_of(const Comparison& comparison) {
    std::vector<const Metric*> told;
    for (const Metric& metric : metrics())
        if (std::any_of(comparison.files.begin(), comparison.files.end(),
                        [&](const Compared& file) { return metric.value(file).has_value(); }))
            told.push_back(&metric);
    std::vector<const Compared*> rows;
    for (const bool failed : {true, false})
        for (const Compared& file : comparison.files)
            if (file.passed() != failed && file.verdict != Verdict::identical) rows.push_back(&file);
    if (rows.empty()) return "";
    std::string table =
        "<h3>All that is not identical</h3>\n<div "
        "class=\"wide\"><table>\n<thead><tr><th>file</th><th>verdict</th>";
    for (const Metric* metric : told) table += cat("<th class=\"number\">", metric->key, "</th>");
    table += "<th>why</th></tr></thead>\n<tbody>\n";
    for (const Compared* file : rows) {
        table += cat("<tr class=\"", verdict_name(file->verdict), "\">", cell(file->name),
                     cell(std::string(verdict_name(file->verdict))));
        for (const Metric* metric : told) {
            const std::optional<double> value = metric->value(*file);
            table += cell(value ? metric_text(*metric, *value) : "", true);
        }
        table += cell(file->why) + "</tr>\n";
    }
    return table + "</tbody></table></div>\n";
}

std::string limits_of(const Comparison& comparison) {
    std::string table =
        "<h3>What the numbers say, and their limits</h3>\n<div "
        "class=\"wide\"><table>\n<thead><tr><th>key</th><th>"
        "limit</th><th>it is</th></tr></thead>\n<tbody>\n";
    for (const Metric& metric : metrics()) {
        const std::optional<double> limit = limit_of(comparison, metric);
        table +=
            cat("<tr>", cell(std::string(metric.key)),
                cell(!limit ? "told, not judged"
                            : cat(metric.at_least ? "at least " : "at most ", metric_text(metric, *limit))),
                cell(std::string(metric.says)), "</tr>\n");
    }
    return table + "</tbody></table></div>\n" +
           paragraph("Limits come from compare.toml beside the references and from the command line.",
                     "soft");
}

}  // namespace

std::string comparison_page(Comparison comparison, const PageRequest& request) {
    const std::vector<ShownFrame> shown = shown_frames(comparison);
    const std::string frames = frames_of(comparison, shown, request);  // fills in what an eye would say
    return cat(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
        "'unsafe-inline'; script-src 'unsafe-inline'\">\n<title>",
        comparison.passed() ? "same: " : "different: ", escaped(request.result), "</title>\n<style>\n",
        page_style(), "</style>\n</head>\n<body>\n", head_of(comparison, request),
        frame_timeline(comparison, shown), cache_timelines(comparison), frames, table_of(comparison),
        limits_of(comparison), paragraph("Made by " + request.made_by + ".", "soft"), "<script>\n",
        page_script(), "</script>\n</body>\n</html>\n");
}

}  // namespace drape

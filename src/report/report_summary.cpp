// A run in a few lines, for the one who started it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "report/report.h"

namespace drape {

namespace {

std::string number(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string millimetres(double metres) {
    return cat(number("%.3g", metres * 1e3), " mm");
}

// The error's curve over the frames in one line, a step of a block for each factor of ten.
std::string error_curve(const std::vector<FrameReport>& frames) {
    constexpr std::array<std::string_view, 8> block{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    constexpr double least_decade = -8;  // 10 nm and below
    constexpr size_t width = 60;
    const size_t columns = std::min(width, frames.size());
    std::string curve;
    for (size_t c = 0; c < columns; ++c) {
        const double error = frames[c * frames.size() / columns].error_rms;
        if (std::isnan(error)) return "";
        const double height = std::clamp(std::log10(error) - least_decade, 0.0, 7.0);
        curve += block[static_cast<size_t>(height)];
    }
    return curve.empty() ? ""
                         : cat("    over time, a step for each factor of ten, from 10 nm: ", curve, "\n");
}

std::string error_summary(const ErrorAccount& error) {
    if (!std::isfinite(error.rms)) return cat("  time-step error not known: ", error.how, "\n");
    std::string text = cat("  time-step error ", millimetres(error.rms), " RMS, ", millimetres(error.max),
                           " at most, in the worst frame");
    if (error.asked) text += cat(" (asked: ", millimetres(*error.asked), ")");
    text += cat("; ", number("%.1f", error.seconds), " CPU s on it\n    by ", error.how, "\n");
    if (std::isfinite(error.floor))
        text += cat("  predictability floor ", millimetres(error.floor),
                    ": a start moved by 1e-12 m ends that far away\n");
    if (std::isfinite(error.floor_from))
        text +=
            cat("    from t = ", number("%.4g", error.floor_from),
                " s on, what was asked lies below the floor: those frames are the best that can be done\n");
    if (error.reached == false) text += "  the tolerance was not reached\n";
    return text;
}

}  // namespace

std::string report_summary(const RunReport& r) {
    const StageTimes& t = r.times;
    const double margin = r.longest_step / r.step;
    const std::string stable = std::isfinite(margin)
                                   ? number("%.2f", margin) + " of them would still be stable"
                                   : "any step is stable";
    std::string text = cat(r.scene, ": ", r.frames.size(), " frames, ", r.steps(), " steps of ",
                           r.method->name, ", ", number("%.3g", r.step * 1e6), " us each (", stable, ")\n");
    text += cat("  CPU ", number("%.1f", t.total), " s: simulate ", number("%.1f", t.simulate), " (contact ",
                number("%.1f", t.contact), "), render ", number("%.1f", t.render), ", encode ",
                number("%.1f", t.encode), t.video > 0 ? ", video " + number("%.1f", t.video) : "", "; wall ",
                number("%.1f", t.wall), " s; memory ", number("%.0f", peak_memory_mb()), " MB\n");
    text += cat("  energy ", number("%.4g", r.start.total()), " -> ", number("%.4g", r.end.total()),
                " J, heat ", number("%.4g", r.flow.dissipated), " J, put in ", number("%.4g", r.flow.driven),
                " J, unaccounted ", number("%.2g", r.energy_drift()), " J\n");
    if (const auto tried = std::count_if(r.frames.begin(), r.frames.end(),
                                         [](const FrameReport& frame) { return frame.retries > 0; });
        tried > 0)
        text += cat("  ", tried, " frames took energy from nowhere and were made again with shorter steps\n");
    if (r.budget)
        text +=
            cat("  wall time ", number("%.3g", r.spent()), " s of a budget of ", number("%.3g", *r.budget),
                " s", r.budget_kept() ? "" : ": the shortest way takes longer", "\n");
    if (std::isfinite(r.least_distance()))
        text +=
            cat("  contact: at most ", r.contacts_max(), " points, ",
                r.least_distance() < 0 ? cat("up to ", millimetres(-r.least_distance()), " inside")
                                       : cat("never nearer than ", millimetres(r.least_distance()), " to"),
                " an obstacle\n");
    if (const int most = r.crossings_max(); most >= 0)
        text += most == 0 ? std::string("  cloth crosses itself in no frame\n")
                          : cat("  cloth crosses itself: up to ", most, " pairs of triangles, ",
                                r.frames.back().crossings, " at the end\n");
    if (!r.frames.empty())
        text += cat("  largest strain at the end ", number("%.2f", 100 * r.frames.back().strain), " %\n");
    return text + error_summary(r.error) + error_curve(r.frames);
}

}  // namespace drape

#include "compare/charts.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/markup.h"
#include "base/numbers.h"

namespace drape {

namespace {

std::string opened(int width, int height, const std::string& label) {
    return cat("<svg viewBox=\"0 0 ", width, " ", height, "\" role=\"img\" aria-label=\"", escaped(label),
               "\">");
}

std::string text_at(double x, double y, const std::string& text, const char* style) {
    return cat("<text x=\"", figure(x, 5), "\" y=\"", figure(y, 5), "\" class=\"", style, "\">",
               escaped(text), "</text>");
}

std::string bar(double x, double y, double width, double height, const char* style) {
    return cat("<rect x=\"", figure(x, 6), "\" y=\"", figure(y, 5), "\" width=\"", figure(width, 4),
               "\" height=\"", figure(height, 5), "\" class=\"", style, "\"/>");
}

// From the decade below the least to that above the most of what is over 0.
struct Decades {
    double low = 0, high = 1;  // log10

    explicit Decades(const std::vector<double>& values) {
        double least = INFINITY, most = 0;
        for (const double value : values) {
            if (!(value > 0) || !std::isfinite(value)) continue;
            least = std::min(least, value);
            most = std::max(most, value);
        }
        if (most == 0) return;
        low = std::floor(std::log10(least) - 1e-9);
        high = std::max(std::ceil(std::log10(most)), low + 1);
    }
    double share(double value) const {
        return value > 0 ? std::clamp((std::log10(value) - low) / (high - low), 0.0, 1.0) : 0;
    }
};

}  // namespace

std::string timeline(const std::vector<Mark>& marks, std::optional<double> limit, const std::string& what) {
    constexpr int width = 1000, height = 190, left = 60, top = 26, bottom = 170;
    if (marks.empty()) return "";
    std::vector<double> values;
    for (const Mark& mark : marks) values.push_back(mark.value.value_or(0));
    if (limit) values.push_back(*limit);
    const Decades scale(values);
    const double step = static_cast<double>(width - left) / static_cast<double>(marks.size());
    const double thick = std::min(0.8 * step, 24.0);
    const auto y_of = [&](double value) { return bottom - scale.share(value) * (bottom - top); };
    std::string svg = opened(width, height, what);
    for (const double decade : {scale.low, scale.high})
        svg += text_at(left - 8, y_of(std::pow(10, decade)) + 4, figure(std::pow(10, decade)), "scale");
    svg += cat("<line x1=\"", left, "\" x2=\"", width, "\" y1=\"", bottom, "\" y2=\"", bottom,
               "\" class=\"axis\"/>");
    const auto first = std::find_if(marks.begin(), marks.end(), [](const Mark& mark) { return mark.bad; });
    for (size_t i = 0; i < marks.size(); ++i) {
        const Mark& mark = marks[i];
        const double x = left + (static_cast<double>(i) + 0.5) * step - thick / 2;
        const double y = mark.value ? std::min(y_of(*mark.value), bottom - 1.5) : top;
        const std::string drawn = cat("<g>",
                                      bar(x, y, thick, bottom - y,
                                          !mark.value ? "lacking"
                                          : mark.bad  ? "bad"
                                                      : "good"),
                                      "<title>", escaped(mark.name + ": " + mark.text), "</title></g>");
        svg += mark.link.empty() ? drawn : cat("<a href=\"", escaped(mark.link), "\">", drawn, "</a>");
    }
    if (limit && *limit > 0)
        svg += cat("<line x1=\"", left, "\" x2=\"", width, "\" y1=\"", figure(y_of(*limit), 5), "\" y2=\"",
                   figure(y_of(*limit), 5), "\" class=\"limit\"/>");
    if (first != marks.end()) {
        const double x = left + (static_cast<double>(first - marks.begin()) + 0.5) * step;
        svg += cat("<line x1=\"", figure(x, 5), "\" x2=\"", figure(x, 5), "\" y1=\"", top - 6, "\" y2=\"",
                   bottom, "\" class=\"first\"/>");
        svg += text_at(std::clamp(x, 150.0, 850.0), top - 10, "first bad: " + first->name, "first");
    }
    svg += text_at(left, height - 4, marks.front().name, "from");
    if (marks.size() > 1) svg += text_at(width, height - 4, marks.back().name, "to");
    return svg + "</svg>\n";
}

std::string histogram(const std::array<std::int64_t, 256>& pixels) {
    constexpr int width = 420, height = 150, top = 20, bottom = 125, step = 42;
    struct Class {
        int from, to;
        double count = 0;
    };
    std::vector<Class> classes{{0, 0}, {1, 1}};
    while (classes.back().to < 255)
        classes.push_back({classes.back().to + 1, std::min(2 * classes.back().to, 255)});
    double most = 1;
    for (Class& one : classes) {
        for (int level = one.from; level <= one.to; ++level)
            one.count += static_cast<double>(pixels[static_cast<size_t>(level)]);
        most = std::max(most, one.count);
    }
    std::string svg = opened(width, height, "Pixels by the levels that they differ");
    for (size_t i = 0; i < classes.size(); ++i) {
        const Class& one = classes[i];
        const double x = static_cast<double>(i) * step + 4;
        const double share = one.count > 0 ? (1 + std::log10(one.count)) / (1 + std::log10(most)) : 0;
        const double y = bottom - share * (bottom - top);
        svg += bar(x, y, step - 8, bottom - y, one.from > 8 ? "bad" : "good");
        if (one.count > 0) svg += text_at(x + step / 2.0 - 4, y - 4, figure(one.count, 7), "count");
        svg += text_at(x + step / 2.0 - 4, height - 10,
                       one.from == one.to ? cat(one.from) : cat(one.from, "-", one.to), "count");
    }
    return svg + "</svg>\n";
}

}  // namespace drape

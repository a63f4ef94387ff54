#include "study/plot_style.h"

#include <array>

namespace drape {

namespace {

// Okabe and Ito's colours, which eyes of every kind tell apart, darkened where white paper would drown them
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc6699", "#8a6d00",
                             "#5b4fa2", "#2aa1d3", "#a01c1c", "#444444"};
constexpr std::array dots{7, 5, 9, 11, 13};  // disc, square, triangles, diamond

}  // namespace

PlotStyle plot_style(const Method& method) {
    const auto row = static_cast<size_t>(&method - methods().data());
    return {plot_colour(row), method.is_implicit() ? 2 : 1, dots[row % dots.size()]};
}

std::string plot_colour(size_t row) {
    return colours[row % colours.size()];
}

std::string plot_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'')
            out += "''";
        else
            out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return out + "'";
}

}  // namespace drape

// How each method is drawn, the same in every plot.
#pragma once

#include <string>

#include "integrate/method.h"

namespace drape {

struct PlotStyle {
    std::string colour;  // "#rrggbb"
    int dash = 1;        // 1 solid: explicit; 2 dashed: stable with any step
    int dot = 7;         // gnuplot's point type
};

PlotStyle plot_style(const Method& method);

// Text between gnuplot's single quotes, on one line.
std::string plot_quoted(const std::string& text);

}  // namespace drape

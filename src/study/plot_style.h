// How methods, and rows of other tables, are drawn, the same in every plot.
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

// The colour of row `row` of any table; after nine they repeat.
std::string plot_colour(size_t row);

// Text between gnuplot's single quotes, on one line.
std::string plot_quoted(const std::string& text);

}  // namespace drape

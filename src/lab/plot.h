// Figures as a script for gnuplot.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lab/experiment.h"

namespace drape {

// "$name << EOD ..." with a line per point; a point that is not finite leaves a gap.
std::string data_block(const std::string& name, const std::vector<std::array<double, 2>>& points);

// What the axes and letters of every panel look like.
std::string plain_panel();

// Panels side by side: `margins` round them and between them in pixels.
struct PanelGrid {
    int columns = 1, rows = 1;
    double panel_width = 0, panel_height = 0;
    double left = 96, right = 24, top = 56, bottom = 68, across = 100, down = 64;  // [pixels]

    int width() const;
    int height() const;
    std::string begin(const std::string& title) const;  // set multiplot
};

// Run in any folder it writes each figure's file as SVG and as PNG.
std::string lab_script(const std::vector<LabResult>& results);

}  // namespace drape

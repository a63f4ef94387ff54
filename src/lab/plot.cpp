#include "lab/plot.h"

#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "study/plot_style.h"

namespace drape {

std::string data_block(const std::string& name, const std::vector<std::array<double, 2>>& points) {
    std::string text = cat("$", name, " << EOD\n");
    for (const auto& [x, y] : points)
        text += std::isfinite(x) && std::isfinite(y) ? cat(figure(x, 9), " ", figure(y, 9), "\n") : "\n";
    return text + "EOD\n";
}

std::string plain_panel() {
    return "set border 3 lc rgb '#777777'\nset tics out nomirror textcolor rgb '#333333' font ',11'\n"
           "set grid lc rgb '#e6e6e6' lw 1\nset key noenhanced samplen 2 spacing 1.2 font ',11'\n";
}

int PanelGrid::width() const {
    return static_cast<int>(left + right + columns * panel_width + (columns - 1) * across);
}

int PanelGrid::height() const {
    return static_cast<int>(top + bottom + rows * panel_height + (rows - 1) * down);
}

std::string PanelGrid::begin(const std::string& title) const {
    const double w = width(), h = height();
    return cat("set multiplot title ", plot_quoted(title), " noenhanced font ',16' layout ", rows, ",",
               columns, " margins ", left / w, ",", 1 - right / w, ",", bottom / h, ",", 1 - top / h,
               " spacing ", across / w, ",", down / h, "\n");
}

std::string lab_script(const std::vector<LabResult>& results) {
    std::string text = "# drape's spring laboratory; gnuplot 5 or later\n";
    for (const LabResult& result : results) {
        for (const LabFigure& figure : result.figures) {
            const std::string size = cat(" size ", figure.width, ",", figure.height,
                                         " font 'Helvetica,12' background rgb 'white'\n");
            text += cat("reset\nset encoding utf8\n", figure.data, "set terminal svg enhanced", size,
                        "set output '", figure.file, ".svg'\n", figure.plot,
                        "reset\nset encoding utf8\nset terminal pngcairo enhanced", size, "set output '",
                        figure.file, ".png'\n", figure.plot, "set output\n\n");
        }
    }
    return text;
}

}  // namespace drape

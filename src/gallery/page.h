// A gallery as a page beside its pictures, which needs no network.
#pragma once

#include <string>
#include <vector>

#include "gallery/cost.h"

namespace drape {

struct ShownRun {
    std::string label;  // "" where the piece has one run
    Cost cost;
};

struct ShownPiece {
    std::string name, title, says;
    bool has_panes = false;
    std::string loop, poster;           // files beside the page; "" where `trouble` says why there are none
    int width = 0, height = 0;          // of the poster [pixels]
    std::uintmax_t bytes = 0;           // of the loop
    std::vector<std::string> commands;  // that make it, run in the page's folder
    std::vector<ShownRun> runs;
    std::string trouble;
};

struct GalleryPage {
    std::string title, made_by, machine;
    std::vector<ShownPiece> pieces;
};

// Every name is escaped.
std::string gallery_page(const GalleryPage& page);

}  // namespace drape

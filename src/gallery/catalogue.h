// What a gallery shows, as its file tells it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "toml/place.h"

namespace drape {

// A run of a scene. Several of a piece play side by side.
struct Pane {
    std::string label;             // in its corner; "" = none
    std::vector<std::string> set;  // KEY=VALUE, as --set has them
};

struct Piece {
    std::string name;                   // of its files: letters, digits, - and _
    std::string title;                  // "" = the scene's own name
    std::string says;                   // a sentence or two
    std::string scene;                  // the name of a demo scene, or a file as the program can open it
    std::array<int, 2> size{640, 360};  // of a pane [pixels]
    std::optional<int> poster;  // which frame stands for the piece while it does not move; none: the last
    int columns = 0;            // of panes; 0 = all in one row
    std::vector<Pane> panes;    // at least one
    Place place;
};

struct Catalogue {
    std::string title;
    std::vector<Piece> pieces;  // no two of one name
};

// Throws Error at the place of what is wrong.
Catalogue read_catalogue(const std::string& path);

}  // namespace drape

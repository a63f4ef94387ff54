// What the command line asks of a run.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drape {

struct RunOptions {
    std::string scene;
    std::string out;               // "" = renders/<scene file's stem>
    std::vector<std::string> set;  // KEY=VALUE
    std::optional<std::string> method;
    std::optional<double> step;       // [s]
    std::optional<double> tolerance;  // [m]
    std::optional<double> budget;     // wall time [s]
    std::string replay;               // the report of a run to repeat; "" = none
    bool strict = false;              // exit 4 where tolerance or budget are not kept
    bool estimate = true;             // of the error, where no tolerance is asked
    bool untangle = false;            // a start that crosses itself
    int threads = 0;                  // 0 = as many as there are cores
    bool quiet = false;
    bool resume = false;
    std::optional<int> from;                   // resume though the scene is another: the checkpoint's frame
    double checkpoint_every = 5;               // seconds of work
    std::string verify_hashes;                 // the report of a run that this one repeats; "" = none
    bool pictures = true;                      // render; simulate makes none
    std::optional<std::array<int, 2>> frames;  // first and last to draw, both included
    std::optional<std::array<int, 2>> size;    // of the pictures
    std::string video;                         // render: "" = none
    std::string cache;                         // "" = none
};

struct StudyRequest {
    std::string scene;
    std::string out;                   // "" = renders/<scene file's stem>_study
    std::vector<std::string> set;      // KEY=VALUE
    std::optional<double> until;       // the first seconds of the scene; none: what the budget allows [s]
    int repeats = 3;                   // of every run
    double budget = 600;               // for all together [CPU s]
    std::vector<std::string> methods;  // none = all
    bool refine = false;               // judge the mesh's own error too
    bool quiet = false;
};

struct StabilityRequest {
    std::string scene;                 // "" = built-in cloths
    std::string out;                   // "" = renders/stability
    std::vector<std::string> set;      // KEY=VALUE
    std::vector<std::string> methods;  // none = all
    int runs = 10;                     // of each cell, and of each start of collapsed triangles
    int threads = 0;                   // 0 = as many as there are cores
    bool full = false;                 // every mesh with every option, on a finer grid
    bool quiet = false;
};

struct LabRequest {
    std::vector<std::string> experiments;  // none = all; or "fabric" and fabrics; or "fit" and a file
    std::optional<double> bending_length;  // of `fit` [m]
    std::optional<double> density;         // [kg/m^2]
    std::string out;                       // "" = renders/lab
    bool quiet = false;
};

struct CompareRequest {
    std::string result, reference;
    std::vector<std::string> limits;  // KEY=VALUE, keys as compare/metrics.h has them
    std::vector<std::string> ignore;  // X,Y,W,H
    bool perceptual = false, hausdorff = false;
    bool accept = false;            // make the results the references
    std::string json, junit, html;  // files to write; "" = none
    bool quiet = false;
};

struct VideoRequest {
    std::vector<std::string> sequences;  // folders
    std::string out;
    std::optional<double> fps;  // none: as the sequences' reports say, else 30 [1/s]
    double speed = 1;
    bool boomerang = false;
    int loops = 1;
    bool caption = true;
    std::vector<std::string> captions, labels;  // none, one for all, or one of each sequence
    bool side_by_side = false, difference = false;
    int columns = 0;  // of panes; 0 = all in one row
    int width = 0;    // of each picture [pixels]; 0 = as they are
    std::optional<double> most_megabytes;
    bool quiet = false;
};

struct GalleryRequest {
    std::string file;               // "" = the one that comes with drape
    std::string out;                // "" = renders/gallery_page
    std::vector<std::string> only;  // names of pieces; none = all
    int threads = 0;                // of each run; 0 = as many as there are cores
    bool quick = false;             // the first frames, small
    bool quiet = false;
};

struct PatternOptions {
    std::string pattern, file;
    std::optional<std::array<double, 2>> size;    // width, depth [m]
    std::optional<std::array<int, 2>> divisions;  // columns, rows
    std::uint64_t seed = 1;
    // as the keys of a scene's pattern are written; "" = not given
    std::string over, hole, outline, finer;
    std::string remesh;  // a mesh file to fill anew; "" = none
};

}  // namespace drape

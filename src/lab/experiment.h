// The spring laboratory: claims of lecture notes on cloth as masses and springs, each measured and shown. A
// new experiment: a file with its function, its declaration in kinds.h, its row in the table
// (experiments.cpp); the tests loop over the table.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

struct LabTable {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
    size_t words = 1;  // leading cells of a row that are no numbers
};

struct LabFigure {
    std::string file;  // without ending
    std::string caption;
    int width = 0, height = 0;  // [pixels]
    std::string data;           // gnuplot's data blocks
    std::string plot;           // and the commands that draw them
};

struct LabCsv {
    std::string file;  // without ending
    std::string text;
};

// What an experiment found.
struct LabResult {
    std::string claim;               // the measured claim, in one line
    std::vector<std::string> story;  // paragraphs
    std::vector<LabFigure> figures;
    std::vector<LabTable> tables;
    std::vector<LabCsv> csv;
};

struct Experiment {
    std::string_view name;
    std::string_view summary;  // what it shows
    LabResult (*run)();        // the same result each time
    bool quick = true;         // a second or two
};

// In the order of the story.
std::span<const Experiment> experiments();

// Those named, in the table's order, each once; all where none is. Throws Error naming the nearest known one.
std::vector<const Experiment*> experiments_named(std::span<const std::string> names);

}  // namespace drape

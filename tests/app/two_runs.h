// Two small sequences to be compared by the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/pictures.h"
#include "io/png.h"
#include "io/write_file.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace drape::test {

// Folders "after" and "before" of four frames: one the same, one with a disc elsewhere, one added, one
// missing.
struct TwoRuns {
    TemporaryFolder folder;

    TwoRuns() {
        for (const char* side : {"after", "before"}) std::filesystem::create_directory(folder.file(side));
        write("after/frame_0001.png", plain(80, 60));
        write("before/frame_0001.png", plain(80, 60));
        write("after/frame_0002.png", disc(80, 60, 45, 30, 15));
        write("before/frame_0002.png", disc(80, 60, 40, 30, 15));
        write("after/frame_0003.png", plain(80, 60));
        write("before/frame_0004.png", plain(80, 60));
    }
    void write(const std::string& name, const Image& image) const {
        write_file(folder.file(name), encode_png(image));
    }
    Ran compare(std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"compare", "after", "before"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_drape(arguments, folder.path());
    }
};

}  // namespace drape::test

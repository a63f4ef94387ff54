// Chromium without a window, for tests of pages.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <string>

#include <catch2/catch.hpp>

#include "support/temporary_folder.h"

namespace drape::test {

// The installed browser's name; "" if there is none.
inline std::string browser_name() {
    for (const char* name : {"chromium-headless-shell", "chromium"})
        if (std::system((std::string("command -v ") + name + " > /dev/null 2>&1").c_str()) == 0) return name;
    return "";
}

// Says so where a test cannot run.
inline bool skipped_without_browser() {
    static const bool installed = !browser_name().empty();
    if (!installed) WARN("skipped: neither chromium-headless-shell nor chromium is installed");
    return !installed;
}

// What a browser made of a page on disk.
struct Visit {
    int exit_code = -1;
    std::string dom;      // its elements after its script has run
    std::string console;  // what the script complained about, line by line
};

// Opens a page; with `screenshot` what a window of 1200 x 1400 pixels shows is written there instead of the
// elements.
inline Visit visit(const std::string& page, const std::string& screenshot = "") {
    const TemporaryFolder folder;
    const std::string out = folder.file("out"), err = folder.file("err");
    const std::string wanted =
        screenshot.empty() ? "--dump-dom"
                           : "--window-size=1200,1400 --hide-scrollbars --screenshot='" + screenshot + "'";
    // the sandbox cannot be had in every container, and the only page is our own
    const std::string command =
        "timeout 100 " + browser_name() +
        " --headless --no-sandbox --disable-gpu --enable-logging=stderr --virtual-time-budget=5000 " +
        "--user-data-dir='" + folder.file("profile") + "' " + wanted + " 'file://" + page + "' > '" + out +
        "' 2> '" + err + "'";
    Visit result;
    result.exit_code = std::system(command.c_str());
    result.dom = bytes_of(out);
    const std::string log = bytes_of(err);
    for (size_t begin = 0; begin < log.size();) {
        const size_t end = std::min(log.find('\n', begin), log.size());
        const std::string line = log.substr(begin, end - begin);
        if (line.find(":CONSOLE") != std::string::npos) result.console += line + "\n";
        begin = end + 1;
    }
    return result;
}

}  // namespace drape::test

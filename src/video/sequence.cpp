#include "video/sequence.h"

#include <charconv>
#include <filesystem>
#include <map>
#include <optional>

#include "base/error.h"
#include "io/endings.h"
#include "io/png.h"

namespace drape {

namespace {

namespace fs = std::filesystem;

struct Numbered {
    std::string prefix;
    int number;
};

// "frame_" and 12 of "frame_0012.png"
std::optional<Numbered> numbered(const fs::path& file) {
    if (ending_of(file.string()) != ".png") return std::nullopt;
    const std::string stem = file.stem().string();
    const size_t digits = stem.find_last_not_of("0123456789") + 1;
    Numbered found{stem.substr(0, digits), 0};
    const auto [stop, error] = std::from_chars(stem.data() + digits, stem.data() + stem.size(), found.number);
    if (digits == stem.size() || error != std::errc()) return std::nullopt;
    return found;
}

using Frames = std::map<int, fs::path>;

std::map<std::string, Frames> numbered_files(const std::string& folder) {
    std::map<std::string, Frames> by_prefix;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const auto found = numbered(entry.path());
        if (!found) continue;
        const auto [at, is_new] = by_prefix[found->prefix].emplace(found->number, entry.path());
        if (!is_new)
            throw Error(
                cat(entry.path().string(), ": has the same number as ", at->second.filename().string()));
    }
    return by_prefix;
}

Frames frames_of(const std::string& folder) {
    std::map<std::string, Frames> by_prefix = numbered_files(folder);
    if (by_prefix.empty())
        throw Error(cat(folder, ": no numbered PNG pictures in it (frame_0001.png and so on)"));
    if (const auto own = by_prefix.find("frame_"); own != by_prefix.end()) return own->second;
    if (by_prefix.size() > 1)
        throw Error(cat(folder, ": has more than one sequence of pictures: ",
                        by_prefix.begin()->second.begin()->second.filename().string(), " and ",
                        by_prefix.rbegin()->second.begin()->second.filename().string()));
    return by_prefix.begin()->second;
}

void demand_no_gap(const std::string& folder, const Frames& frames) {
    for (auto before = frames.begin(), at = std::next(before); at != frames.end(); before = at++) {
        const int first = before->first + 1, last = at->first - 1;
        if (first > last) continue;
        const std::string which =
            first == last ? cat("frame ", first, " is") : cat("frames ", first, " to ", last, " are");
        throw Error(cat(folder, ": ", which, " missing between ", before->second.filename().string(), " and ",
                        at->second.filename().string()));
    }
}

}  // namespace

Sequence find_sequence(const std::string& folder) {
    std::error_code none;
    if (!fs::exists(folder, none)) throw Error(cat(folder, ": no such folder"));
    if (!fs::is_directory(folder, none)) throw Error(cat(folder, ": is not a folder of PNG pictures"));
    const Frames frames = frames_of(folder);
    demand_no_gap(folder, frames);
    Sequence sequence{.folder = folder, .files = {}, .first = frames.begin()->first};
    for (const auto& [number, path] : frames) {
        const auto [width, height] = read_png_size(path.string());
        if (sequence.files.empty()) {
            sequence.width = width;
            sequence.height = height;
        }
        if (width != sequence.width || height != sequence.height)
            throw Error(cat(path.string(), ": is ", width, "x", height, " pixels, the frames before it ",
                            sequence.width, "x", sequence.height));
        sequence.files.push_back(path.string());
    }
    return sequence;
}

}  // namespace drape

#include "app/verification.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/read_file.h"
#include "toml/value.h"

namespace drape {

namespace {

constexpr std::uint64_t largest_report = std::uint64_t{256} << 20;  // [bytes]

[[noreturn]] void differs(const std::string& stage, const std::string& hash, const std::string& path,
                          const std::string& there) {
    throw Error(cat(stage, " (", hash, ") not as in ", path, " (", there, ")"), Exit::different);
}

}  // namespace

Verification::Verification(const std::string& path, const std::string& scene, int last) : path_(path) {
    const auto json = nlohmann::json::parse(read_file(path, largest_report), nullptr, false);
    try {
        const auto of = json.at("scene").get<std::string>();
        if (of != scene) throw Error(cat(path, ": is of the scene ", quoted(of), ", not of ", quoted(scene)));
        for (const auto& frame : json.at("frames")) {
            if (frame.at("index").get<size_t>() != positions_.size() + 1)
                throw Error(cat(path, ": frame ", positions_.size() + 1, " is missing"));
            positions_.push_back(frame.at("hash").get<std::string>());
            const auto picture = frame.find("picture_hash");
            const bool none = picture == frame.end() || picture->is_null();
            pictures_.push_back(none ? "" : picture->get<std::string>());
        }
    } catch (const nlohmann::json::exception&) {
        throw Error(path + ": is no report.json of a run (scene, frames[].index and .hash)");
    }
    if (positions_.size() < static_cast<size_t>(last))
        throw Error(cat(path, ": has ", positions_.size(), " frames, this run ", last));
}

void Verification::positions(const FrameReport& frame) const {
    const auto k = static_cast<size_t>(frame.index) - 1;
    if (frame.hash != positions_.at(k))
        differs(cat("frame ", k + 1, ": positions"), frame.hash, path_, positions_[k]);
}

void Verification::pictures(const std::vector<std::string>& hashes) {
    for (; seen_ < hashes.size(); ++seen_) {
        const std::string &now = hashes[seen_], &there = pictures_.at(seen_);
        if (now.empty() || there.empty()) continue;
        if (now != there) differs(cat("frame ", seen_ + 1, ": picture"), now, path_, there);
        ++compared_;
    }
}

std::string Verification::summary(int frames) const {
    return cat("the same as in ", path_, ": positions of ", frames, " frames, ", compared_, " pictures");
}

}  // namespace drape

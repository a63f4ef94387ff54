#include "app/replay.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "integrate/method.h"
#include "io/read_file.h"

namespace drape {

namespace {

constexpr std::uint64_t largest_report = std::uint64_t{256} << 20;  // [bytes]
constexpr long most_steps = 1000000000;                             // of a frame

}  // namespace

Replay read_replay(const std::string& path) {
    const auto bytes = read_file(path, largest_report);
    const auto json = nlohmann::json::parse(bytes, nullptr, false);
    try {
        Replay replay;
        replay.scene = json.at("scene").get<std::string>();
        replay.method = json.at("method").at("name").get<std::string>();
        static_cast<void>(method_named(replay.method));
        for (const auto& frame : json.at("frames")) {
            if (frame.at("index").get<size_t>() != replay.steps.size() + 1)
                throw Error(cat(path, ": does not begin at frame 1 (it is of a run that was resumed)"));
            replay.steps.push_back(frame.at("planned_steps").get<long>());
            if (replay.steps.back() < 1 || replay.steps.back() > most_steps)
                throw Error(cat(path, ": frame ", replay.steps.size(), ": planned_steps must be 1 to ",
                                most_steps, ", got ", replay.steps.back()));
        }
        if (replay.steps.empty()) throw Error(path + ": has no frames to replay");
        return replay;
    } catch (const nlohmann::json::exception&) {
        throw Error(path + ": is no report.json of a run (scene, method.name and frames[].planned_steps)");
    }
}

}  // namespace drape

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
            const auto& steps = frame.at("planned_steps");
            if (!steps.is_number_integer() || steps < 1 || steps > most_steps)
                throw Error(cat(path, ": frame ", replay.steps.size() + 1,
                                ": planned_steps must be a whole number, 1 to ", most_steps, ", got ",
                                steps.dump()));
            replay.steps.push_back(steps.get<long>());
            replay.hashes.push_back(frame.at("hash").get<std::string>());
        }
        if (replay.steps.empty()) throw Error(path + ": has no frames to replay");
        return replay;
    } catch (const nlohmann::json::exception&) {
        throw Error(path +
                    ": is no report.json of a run (scene, method.name, frames[].planned_steps and .hash)");
    }
}

}  // namespace drape

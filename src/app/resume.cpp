#include "app/resume.h"

#include <algorithm>
#include <filesystem>

#include "app/frame_name.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/names.h"
#include "io/read_file.h"
#include "scene/changed_keys.h"
#include "scene/scene_text.h"

namespace drape {

namespace {

constexpr std::uint64_t largest_checkpoint = std::uint64_t{4} << 30;  // [bytes]
constexpr std::uint64_t largest_picture = std::uint64_t{1} << 30;     // [bytes]

std::vector<std::string> changes(const Checkpoint& found, const Checkpoint& now) {
    std::vector<std::string> changed = changed_keys(found.scene, now.scene);
    if (changed.empty() && found.steps != now.steps) changed.push_back("--replay");
    return changed;
}

bool contains(const std::vector<std::string>& list, std::string_view what) {
    return std::find(list.begin(), list.end(), what) != list.end();
}

}  // namespace

std::string checkpoint_of(const std::string& folder) {
    return folder + "/checkpoint";
}

std::string kept_positions_of(const std::string& folder) {
    return folder + "/positions";
}

void forget_checkpoint(const std::string& folder) {
    std::error_code none;
    std::filesystem::remove(checkpoint_of(folder), none);
    std::filesystem::remove(kept_positions_of(folder), none);
}

void identify(Checkpoint& run, SceneDescription scene, const std::string& method,
              const std::vector<long>& steps) {
    scene.expected.reset();
    run.scene = scene_text(scene);
    run.steps = method;
    for (const long count : steps) run.steps += cat(" ", count);
}

std::optional<Checkpoint> checkpoint_to_go_on_from(const std::string& folder, const Checkpoint& now,
                                                   const RunOptions& options,
                                                   std::vector<std::string>& notes) {
    const std::string path = checkpoint_of(folder);
    if (!std::filesystem::exists(path)) {
        if (options.from) throw Error(cat("--from ", *options.from, ": ", path, ": no such file"));
        return std::nullopt;
    }
    auto found = read_checkpoint(read_file(path, largest_checkpoint));
    if (!found) throw Error(path + ": not a whole checkpoint of this version (remove it to start fresh)");
    const auto last = found->frames.size();
    const std::vector<std::string> changed = changes(*found, now);
    if (options.from && static_cast<size_t>(*options.from) != last)
        throw Error(cat("--from ", *options.from, ": ", path, " is of frame ", last, " (--from ", last, ")"));
    if (changed.empty()) return found;
    if (!options.from)
        throw Error(cat(path, ": is of a run with another ", joined(changed), " (--from ", last,
                        " goes on from its frame ", last, " all the same; remove it to start fresh)"));
    for (const char* key : {"scene.frame_rate", "accuracy.tolerance", "accuracy.budget"})
        if (contains(changed, key))
            throw Error(cat("--from ", last, ": ", path, " is of a run with another ", key,
                            ", which holds for all frames (remove it to start fresh)"));
    notes.push_back(cat("frames 1 to ", last, " are of a run with another ", joined(changed)));
    return found;
}

void demand_pictures(const std::string& folder, const Checkpoint& run, int first) {
    for (size_t k = static_cast<size_t>(first); k <= run.pictures.size(); ++k) {
        const std::string &hash = run.pictures[k - 1], file = folder + frame_name(static_cast<int>(k));
        if (hash.empty())
            throw Error(cat(checkpoint_of(folder), ": is of a run that did not draw frame ", k,
                            " (remove it to start fresh)"));
        const std::string bytes = read_file(file, largest_picture);
        if (hash_text(hash_bytes(bytes.data(), bytes.size())) != hash)
            throw Error(cat(file, ": is not the picture that the run drew (remove ", checkpoint_of(folder),
                            " to start fresh)"));
    }
}

}  // namespace drape

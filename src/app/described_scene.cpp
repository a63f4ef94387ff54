#include "app/described_scene.h"

#include "app/demo_scenes.h"
#include "base/error.h"
#include "scene/reader.h"

namespace drape {

namespace {

void refuse_contradictions(const RunOptions& options) {
    if (options.step && options.tolerance)
        throw Error("--tolerance chooses the step by itself (leave out --step, or --tolerance)");
    if (options.step && options.budget)
        throw Error("--budget chooses the step by itself (leave out --step, or --budget)");
    if (options.tolerance && options.budget)
        throw Error(
            "--tolerance and --budget: one says how good, the other how long (leave one of them out)");
    if (!options.replay.empty() && (options.step || options.tolerance || options.budget || options.method))
        throw Error(
            "--replay takes method and steps from the report (leave out --method, --step, "
            "--tolerance and --budget)");
}

}  // namespace

SceneDescription described_scene(const RunOptions& options) {
    SceneDescription scene = read_scene(scene_path(options.scene), options.set);
    if (options.size) scene.look.size = *options.size;
    refuse_contradictions(options);
    AccuracyDescription& accuracy = scene.accuracy;
    if (options.method) accuracy.method = *options.method;
    // the command line has the last word: each of the four takes the others' place
    if (options.step || options.tolerance || options.budget || !options.replay.empty()) {
        accuracy.step = options.step;
        accuracy.tolerance = options.tolerance;
        accuracy.budget = options.budget;
    }
    if (options.strict && !accuracy.tolerance && !accuracy.budget)
        throw Error(
            "--strict goes with a tolerance or a budget (--tolerance, --budget, or [accuracy] in the "
            "scene)");
    if (!options.estimate && accuracy.tolerance)
        throw Error("--no-estimate: a tolerance is met by estimating the error (leave one of them out)");
    if (!options.verify_hashes.empty() && accuracy.budget)
        throw Error(cat("--verify-hashes: a budget chooses steps by the clock (--replay ",
                        options.verify_hashes, " repeats them)"));
    return scene;
}

}  // namespace drape

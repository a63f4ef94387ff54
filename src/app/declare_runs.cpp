// render, simulate, inspect.
#include <limits>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/declare_verbs.h"
#include "app/flag_values.h"
#include "app/verbs.h"

namespace drape {

namespace {

void add_run_options(CLI::App& verb, const std::shared_ptr<RunOptions>& run) {
    verb.add_option("SCENE", run->scene, "a scene file, or the name of a demo scene")->required();
    verb.add_option("--out", run->out, "folder of the results (default: renders/ and the scene's name)")
        ->type_name("DIR");
    verb.add_option("--method", run->method, "how to step through time (drape list methods)")
        ->type_name("NAME");
    verb.add_option_function<std::string>(
            "--step",
            [run](const std::string& text) { run->step = positive_number(text, "--step", "seconds over 0"); },
            "the step in seconds (default: the longest stable one, less a margin)")
        ->type_name("S");
    verb.add_option_function<std::string>(
            "--tolerance",
            [run](const std::string& text) {
                run->tolerance = positive_number(text, "--tolerance", "metres over 0");
            },
            "run until every frame's RMS error is below this many metres")
        ->type_name("M");
    verb.add_option_function<std::string>(
            "--budget",
            [run](const std::string& text) {
                run->budget = positive_number(text, "--budget", "seconds over 0");
            },
            "the most accurate result within this many seconds, pictures included")
        ->type_name("S");
    verb.add_option("--replay", run->replay, "repeat the run of this report.json, step by step")
        ->type_name("FILE");
    verb.add_flag("--strict", run->strict, "exit with 4 where the tolerance or the budget is not kept");
    verb.add_flag("!--no-estimate", run->estimate, "leave out the second pass that tells the error");
    verb.add_flag("--untangle", run->untangle, "take a start apart that crosses itself or a mesh");
    verb.add_option("--threads", run->threads, "how many threads (default: one per core)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    verb.add_option("--set", run->set, "change a value of the scene; may be given again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb.add_option("--cache", run->cache,
                    "positions of the start and of every frame: .pc2 .mdd .obj .ply .glb")
        ->type_name("FILE");
    verb.add_flag("--resume", run->resume, "go on from the folder's checkpoint, if there is one");
    verb.add_option_function<int>(
            "--from",
            [run](const int frame) {
                run->from = frame;
                run->resume = true;
            },
            "go on from the checkpoint's frame K though the scene has changed")
        ->type_name("K")
        ->check(CLI::Range(1, std::numeric_limits<int>::max()));
    verb.add_option("--checkpoint-every", run->checkpoint_every,
                    "seconds of work between checkpoints; 0: after every frame (default 5)")
        ->type_name("S")
        ->check(CLI::Range(0.0, 1e9));
    verb.add_option("--verify-hashes", run->verify_hashes,
                    "exit with 1 at the first frame whose bits are not those of this report.json")
        ->type_name("FILE");
    verb.add_flag("--quiet", run->quiet, "print nothing but errors");
}

}  // namespace

Action declare_render(CLI::App& verb) {
    auto run = std::make_shared<RunOptions>();
    add_run_options(verb, run);
    verb.add_option_function<std::string>(
            "--frames",
            [run](const std::string& text) { run->frames = pair_of(text, ':', "--frames", "FIRST:LAST"); },
            "only these frames, both included; they count from 1")
        ->type_name("A:B");
    verb.add_option_function<std::string>(
            "--size",
            [run](const std::string& text) {
                run->size = pair_of(text, 'x', "--size", "WIDTHxHEIGHT in pixels");
            },
            "size of the pictures in pixels")
        ->type_name("WxH");
    verb.add_option("--video", run->video, "make a video of the frames as well: .mp4 .webm .webp .gif")
        ->type_name("FILE");
    return [run] { return run_scene(*run); };
}

Action declare_simulate(CLI::App& verb) {
    auto run = std::make_shared<RunOptions>();
    run->pictures = false;
    add_run_options(verb, run);
    return [run] { return run_scene(*run); };
}

Action declare_inspect(CLI::App& verb) {
    struct Wanted {
        std::string path;
        std::vector<std::string> set;
    };
    auto wanted = std::make_shared<Wanted>();
    verb.add_option("FILE", wanted->path, "a scene file, the name of a demo scene, or a mesh file")
        ->required();
    verb.add_option("--set", wanted->set, "change a value of the scene; may be given again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    return [wanted] { return inspect(wanted->path, wanted->set); };
}

}  // namespace drape

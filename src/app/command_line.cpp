#include "app/command_line.h"

#include <array>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <functional>
#include <limits>

#include <CLI/CLI.hpp>

#include "app/verbs.h"
#include "app/version.h"
#include "base/names.h"
#include "base/plain_line.h"
#include "compare/metrics.h"

namespace drape {

namespace {

using Action = std::function<Exit()>;

// Two whole numbers with a separator: "1:10", "640x360". Throws Error that says what is allowed.
std::array<int, 2> pair_of(const std::string& text, char separator, const std::string& flag,
                           const std::string& allowed) {
    std::array<int, 2> pair{};
    const char *at = text.data(), *const end = at + text.size();
    for (const size_t i : {0U, 1U}) {
        const auto [stop, error] = std::from_chars(at, end, pair[i]);
        const bool last = i == 1, separated = !last && stop != end && *stop == separator;
        if (error != std::errc() || (last ? stop != end : !separated))
            throw Error(cat(flag, " ", text, ": expected ", allowed));
        at = stop + 1;
    }
    return pair;
}

double positive_number(const std::string& text, const std::string& flag, const std::string& allowed) {
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size() || !(value > 0) || !std::isfinite(value))
        throw Error(cat(flag, " ", text, ": expected ", allowed));
    return value;
}

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

Action declare_study(CLI::App& verb) {
    auto study = std::make_shared<StudyRequest>();
    verb.add_option("SCENE", study->scene, "a scene file, or the name of a demo scene")->required();
    verb.add_option("--out", study->out,
                    "folder of the results (default: renders/, the scene's name, _study)")
        ->type_name("DIR");
    verb.add_option("--set", study->set, "change a value of the scene; may be given again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb.add_option_function<std::string>(
            "--until",
            [study](const std::string& text) {
                study->until = positive_number(text, "--until", "seconds over 0");
            },
            "study the first seconds of the scene (default: as many as the budget allows)")
        ->type_name("S");
    verb.add_option("--repeats", study->repeats, "runs of each method and step, fewer where dear (default 3)")
        ->type_name("N")
        ->check(CLI::Range(1, 100));
    verb.add_option_function<std::string>(
            "--budget",
            [study](const std::string& text) {
                study->budget = positive_number(text, "--budget", "CPU seconds over 0");
            },
            "CPU seconds for all together (default 600)")
        ->type_name("S");
    verb.add_option("--method", study->methods, "only this method; may be given again (default: all)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    verb.add_flag("--refine", study->refine, "judge the mesh's own error too, on coarser and finer ones");
    verb.add_flag("--quiet", study->quiet, "print nothing but errors");
    return [study] { return study_scene(*study); };
}

Action declare_stability(CLI::App& verb) {
    auto map = std::make_shared<StabilityRequest>();
    verb.add_option("SCENE", map->scene, "try methods on this scene's cloth (default: small built-in ones)");
    verb.add_option("--out", map->out, "folder of the results (default: renders/stability)")
        ->type_name("DIR");
    verb.add_option("--set", map->set, "change a value of the scene; may be given again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb.add_option("--method", map->methods, "only this method; may be given again (default: all)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    verb.add_option("--runs", map->runs, "jittered runs of each cell (default: 10)")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    verb.add_option("--threads", map->threads, "how many threads (default: one per core)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    verb.add_flag("--full", map->full, "every mesh with every option, on a finer grid: takes hours");
    verb.add_flag("--quiet", map->quiet, "print nothing but errors");
    return [map] { return map_stability(*map); };
}

Action declare_lab(CLI::App& verb) {
    auto lab = std::make_shared<LabRequest>();
    verb.add_option(
        "EXPERIMENT", lab->experiments,
        "drape list lab (default: all, in their order); or fabric NAME...; or fit FILE, a CSV of strain "
        "and force per width in N/m");
    verb.add_option_function<std::string>(
            "--bending-length",
            [lab](const std::string& text) {
                lab->bending_length = positive_number(text, "--bending-length", "metres over 0");
            },
            "fit: the measured bending length, in metres")
        ->type_name("M");
    verb.add_option_function<std::string>(
            "--density",
            [lab](const std::string& text) {
                lab->density = positive_number(text, "--density", "kg/m^2 over 0");
            },
            "fit: the cloth's mass per area, in kg/m^2")
        ->type_name("KG");
    verb.add_option("--out", lab->out, "folder of the results (default: renders/lab)")->type_name("DIR");
    verb.add_flag("--quiet", lab->quiet, "print nothing but errors");
    return [lab] { return run_lab(*lab); };
}

Action declare_compare(CLI::App& verb) {
    auto asked = std::make_shared<CompareRequest>();
    verb.add_option("RESULT", asked->result,
                    "a picture, a cache (.pc2, .mdd, .glb), or a folder of frames and caches")
        ->required();
    verb.add_option("REFERENCE", asked->reference, "what it should be like, of the same kind")->required();
    const struct {
        std::string key, type, says;
    } common[] = {
        {"share", "SHARE", "share of a picture's pixels that may be over 8 levels off (default 2e-5)"},
        {"mean", "LEVELS", "mean difference a picture may have (default 2e-3)"},
        {"rms", "M", "how far a cache's sample may be off, in metres (default 1e-6)"}};
    for (const auto& limit : common)
        verb.add_option_function<std::string>(
                "--" + limit.key,
                [asked, key = limit.key](const std::string& value) {
                    asked->limits.push_back(key + "=" + value);
                },
                limit.says)
            ->type_name(limit.type);
    verb.add_option("--limit", asked->limits,
                    cat("a limit by its key (", joined(metric_keys()), "); may be given again"))
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb.add_option("--ignore", asked->ignore, "a rectangle of pixels not to look at; may be given again")
        ->type_name("X,Y,W,H")
        ->allow_extra_args(false);
    verb.add_flag("--perceptual", asked->perceptual, "SSIM and FLIP of pictures that differ as well");
    verb.add_flag("--hausdorff", asked->hausdorff, "Hausdorff's distance of caches that differ as well");
    verb.add_option("--json", asked->json, "write what was found to this file")->type_name("FILE");
    verb.add_option("--html", asked->html, "the same as a page with the pictures, which needs no other file")
        ->type_name("FILE");
    verb.add_flag("--accept", asked->accept, "make the results the references where they differ");
    verb.add_option("--junit", asked->junit, "the same as JUnit XML, for continuous integration")
        ->type_name("FILE");
    verb.add_flag("--quiet", asked->quiet, "print nothing but errors");
    return [asked] { return compare_results(*asked); };
}

Action declare_video(CLI::App& verb) {
    auto asked = std::make_shared<VideoRequest>();
    verb.add_option("SEQUENCE", asked->sequences,
                    "a folder of numbered PNG pictures; several are shown one after the other")
        ->required();
    verb.add_option("-o,--out", asked->out, "the file to write: .mp4 .webm .webp .gif")
        ->type_name("FILE")
        ->required();
    verb.add_option_function<std::string>(
            "--fps",
            [asked](const std::string& text) {
                asked->fps = positive_number(text, "--fps", "frames a second over 0");
            },
            "frames a second at normal speed (default: as report.json says, else 30)")
        ->type_name("N");
    verb.add_option_function<std::string>(
            "--speed",
            [asked](const std::string& text) {
                asked->speed = positive_number(text, "--speed", "how many times as fast, over 0");
            },
            "so many times as fast (0.25: slow motion)")
        ->type_name("X");
    verb.add_flag("--boomerang", asked->boomerang, "there and back");
    verb.add_option("--loop", asked->loops, "write it so many times")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    verb.add_option("--caption", asked->captions,
                    "written into the frames; again for each sequence (default: what report.json says)")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    verb.add_flag("!--no-caption", asked->caption, "leave the frames without a caption");
    verb.add_option("--width", asked->width, "resize each picture to so many pixels across")
        ->type_name("N")
        ->check(CLI::Range(1, 16384));
    verb.add_option_function<std::string>(
            "--at-most",
            [asked](const std::string& text) {
                asked->most_megabytes = positive_number(text, "--at-most", "megabytes over 0");
            },
            "give up frames, quality and size until the file has at most so many megabytes")
        ->type_name("MB");
    verb.add_flag("--side-by-side", asked->side_by_side, "a pane for each sequence, playing together");
    verb.add_option("--label", asked->labels,
                    "in the upper corner; again for each sequence (default: of a pane its folder's name)")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    verb.add_option("--columns", asked->columns, "panes in a row (default: all)")
        ->type_name("N")
        ->check(CLI::Range(1, 100));
    verb.add_flag("--difference", asked->difference, "one more pane: what two sequences differ in, times 16");
    verb.add_flag("--quiet", asked->quiet, "print nothing but errors");
    return [asked] { return make_video(*asked); };
}

Action declare_gallery(CLI::App& verb) {
    auto asked = std::make_shared<GalleryRequest>();
    verb.add_option("FILE", asked->file,
                    "what to show, a TOML file (default: every demo scene and comparisons)");
    verb.add_option("--out", asked->out, "folder of the page (default: renders/gallery_page)")
        ->type_name("DIR");
    verb.add_option("--only", asked->only, "make only this piece; may be given again")
        ->type_name("NAME")
        ->allow_extra_args(false);
    verb.add_flag("--quick", asked->quick, "the first 15 frames of each, small");
    verb.add_option("--threads", asked->threads, "how many threads (default: one per core)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    verb.add_flag("--quiet", asked->quiet, "print nothing but errors");
    return [asked] { return make_gallery(*asked); };
}

Action declare_mesh(CLI::App& verb) {
    auto wanted = std::make_shared<PatternOptions>();
    verb.add_option("PATTERN", wanted->pattern, "drape list patterns")->required();
    verb.add_option("-o,--output", wanted->file, "the file to write, .obj or .ply")
        ->type_name("FILE")
        ->required();
    verb.add_option("--size", wanted->size, "of the sheet in metres (default 1 1)")->type_name("WIDTH DEPTH");
    verb.add_option("--divisions", wanted->divisions, "quads along the two sides (default 32 32)")
        ->type_name("COLUMNS ROWS");
    verb.add_option("--seed", wanted->seed, "of patterns that throw dice (default 1)")
        ->type_name("N")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()));
    verb.add_option("--over", wanted->over, "what it covers: rectangle, disc, annulus or outline")
        ->type_name("KIND");
    verb.add_option("--hole", wanted->hole, "inner diameter of an annulus in metres")->type_name("M");
    verb.add_option("--outline", wanted->outline, "corners, as a scene has them: \"[[0,0],[1,0],[0,1]]\"")
        ->type_name("CORNERS");
    verb.add_option("--finer", wanted->finer, "where `adaptive` is finer: \"{ points = [[0,0]] }\"")
        ->type_name("TABLE");
    verb.add_option("--remesh", wanted->remesh,
                    "fill this mesh's outline anew, with edges as long as its own but for --divisions")
        ->type_name("MESH");
    return [wanted] { return write_pattern(*wanted); };
}

Action declare_list(CLI::App& verb) {
    auto kind = std::make_shared<std::string>();
    verb.add_option("KIND", *kind,
                    "scenes, fabrics, methods, obstacles, patterns, membranes or lab (default: all)");
    return [kind] { return list_kinds(*kind); };
}

struct Verb {
    std::string_view name, summary;
    Action (*declare)(CLI::App&);  // adds the verb's options; returns what to do once they are read
};

constexpr std::array verbs{
    Verb{"render", "Simulate a scene and draw every frame as a PNG", declare_render},
    Verb{"simulate", "Simulate a scene without pictures; a cache keeps the positions", declare_simulate},
    Verb{"inspect", "Say what a scene uses and costs, or what a mesh is like; nothing is run",
         declare_inspect},
    Verb{"study", "Measure error against run time of every method on a scene", declare_study},
    Verb{"stability", "Map at which springs and steps every method is stable", declare_stability},
    Verb{"lab", "Measure what lecture notes claim of springs, and show it", declare_lab},
    Verb{"compare", "Hold pictures, caches or folders of them against references", declare_compare},
    Verb{"video", "Make a video or a looping picture of PNG sequences", declare_video},
    Verb{"gallery", "Render scenes and comparisons to looping pictures and a page of them", declare_gallery},
    Verb{"mesh", "Write a generated cloth mesh", declare_mesh},
    Verb{"list", "Print the names a scene or a command may use", declare_list},
};

// What was not understood, with the flag that was probably meant.
std::string unexpected(const CLI::App& app, const std::string& word) {
    const CLI::App* verb = app.get_subcommands().empty() ? &app : app.get_subcommands().front();
    std::vector<std::string> known;
    for (const CLI::Option* option : verb->get_options())
        if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
    if (word.starts_with("-")) return unknown_name("flag", word, known);
    return cat("unexpected argument \"", word, "\" (drape ", verb->get_name(), " --help)");
}

int parse_and_run(int argc, char** argv) {
    CLI::App app("drape: cloth simulated as masses on springs, drawn without a display", "drape");
    app.set_version_flag("--version", cat("drape ", version));
    app.footer("Run `drape VERB --help` for a verb's options.");
    app.require_subcommand(1);
    Action action;
    for (const Verb& verb : verbs) {
        CLI::App* sub = app.add_subcommand(std::string(verb.name), std::string(verb.summary));
        sub->callback([&action, todo = verb.declare(*sub)] { action = todo; });
    }
    if (argc < 2) throw Error(cat("what to do? (", joined(names_of(verbs)), "; drape --help)"));
    if (argv[1][0] != '-') find_named(verbs, "verb", argv[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ExtrasError&) {
        throw Error(unexpected(app, app.remaining(true).front()));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        throw Error(error.what());
    }
    return static_cast<int>(action());
}

int complain(const char* message, Exit code) {
    std::fprintf(stderr, "drape: %s\n", plain_line(message).c_str());
    return static_cast<int>(code);
}

}  // namespace

int run_command_line(int argc, char** argv) {
    // a file that grows beyond a limit is an error of write(), not the end
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return parse_and_run(argc, argv);
    } catch (const Error& error) {
        return complain(error.what(), error.code());
    } catch (const std::bad_alloc&) {
        return complain("out of memory", Exit::went_wrong);
    } catch (const std::exception& error) {
        // what a library throws: no threads, a folder that goes away
        return complain(error.what(), Exit::went_wrong);
    }
}

}  // namespace drape

#include "app/command_line.h"

#include <array>
#include <csignal>
#include <cstdio>

#include <CLI/CLI.hpp>

#include "app/declare_verbs.h"
#include "app/version.h"
#include "base/names.h"
#include "base/plain_line.h"

namespace drape {

namespace {

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

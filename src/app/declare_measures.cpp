// study, stability, lab.
#include <memory>

#include <CLI/CLI.hpp>

#include "app/declare_verbs.h"
#include "app/flag_values.h"
#include "app/verbs.h"

namespace drape {

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

}  // namespace drape

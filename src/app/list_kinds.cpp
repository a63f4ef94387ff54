// list: the names that scenes and commands may use, from the tables that implement them.
#include <array>
#include <cstdio>

#include "app/demo_scenes.h"
#include "app/verbs.h"
#include "base/names.h"
#include "cloth/fabric.h"
#include "integrate/method.h"
#include "mesh/pattern.h"
#include "obstacle/obstacle.h"
#include "scene/fabric_words.h"
#include "scene/reader.h"

namespace drape {

namespace {

void row(std::string_view name, std::string_view says) {
    std::printf("  %-18.*s %.*s\n", static_cast<int>(name.size()), name.data(), static_cast<int>(says.size()),
                says.data());
}

void list_scenes() {
    for (const DemoScene& scene : demo_scenes()) row(scene.name, read_scene(scene.path, {}).name);
}

void list_fabrics() {
    for (const FabricPreset& preset : fabric_presets()) {
        row(preset.name, preset.summary);
        row("", cat("from ", preset.source));
    }
}

void list_methods() {
    row("auto", "drape chooses, and the report says why");
    for (const Method& method : methods()) {
        row(method.name, method.summary);
        const std::string damped = method.conservative_only() ? "refused" : cat(method.order_with_damping);
        row("", cat("order ", method.order, ", with damping or contact ", damped, "; ", method.sweeps,
                    method.sweeps == 1 ? " force sweep " : " force sweeps ",
                    method.is_implicit() ? "an iteration" : "a step",
                    method.projects_springs ? " and one of projections" : ""));
        row("", cat("stable: ", method.limit));
        row("", cat("keeps: ", method.conserves));
        row("", cat("not: ", method.avoid));
    }
}

void list_obstacles() {
    for (const SolidKind& kind : obstacle_kinds()) {
        row(kind.name, kind.summary);
        row("", cat("keys: ", joined({kind.keys.begin(), kind.keys.end()}), ", friction, motion, colour"));
    }
}

void list_patterns() {
    for (const PatternKind& kind : pattern_kinds()) row(kind.name, kind.summary);
}

void list_membranes() {
    for (const auto& word : membrane_words) row(word.name, word.summary);
}

void list_lab() {
    list_experiments(row);
}

struct Listing {
    std::string_view name;
    void (*print)();
};

constexpr std::array listings{Listing{"scenes", list_scenes},
                              Listing{"fabrics", list_fabrics},
                              Listing{"methods", list_methods},
                              Listing{"obstacles", list_obstacles},
                              Listing{"patterns", list_patterns},
                              Listing{"membranes", list_membranes},
                              Listing{"lab", list_lab}};

}  // namespace

Exit list_kinds(const std::string& kind) {
    if (!kind.empty()) {
        find_named(listings, "kind", kind).print();
        return Exit::done;
    }
    for (const Listing& listing : listings) {
        std::printf("%.*s\n", static_cast<int>(listing.name.size()), listing.name.data());
        listing.print();
    }
    return Exit::done;
}

}  // namespace drape

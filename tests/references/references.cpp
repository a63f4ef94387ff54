#include "references/references.h"

#include <cstdlib>

#include "base/error.h"
#include "scene/builder.h"
#include "scene/reader.h"
#include "simulate/delivery.h"

namespace drape::test {

namespace {

const std::vector<Reference>& table() {
    static const std::vector<Reference> all{
        {"bare_springs", {"scene.duration=0.4", "scene.frame_rate=5"}},
        {"cape", {"scene.duration=0.5", "scene.frame_rate=4"}},
        {"chair", {"scene.duration=0.5", "scene.frame_rate=4", "cloth.0.pattern.divisions=[33, 27]"}},
        {"curtain", {"scene.duration=2", "scene.frame_rate=1", "cloth.0.pattern.divisions=[42, 30]"}},
        {"flag", {"scene.duration=0.5", "scene.frame_rate=4", "cloth.0.pattern.divisions=[48, 32]"}},
        {"hanging_swatch",
         {"scene.duration=0.5", "scene.frame_rate=4", "cloth.0.pattern.divisions=[32, 32]"}},
        {"napkin", {"scene.duration=0.8", "scene.frame_rate=2.5", "cloth.0.pattern.divisions=[16, 16]"}},
        {"pile", {"scene.duration=0.5", "scene.frame_rate=4", "cloth.0.pattern.divisions=[32, 32]"}},
        {"rollers", {"scene.duration=0.2", "scene.frame_rate=10"}},
        {"skirt", {"scene.duration=0.4", "scene.frame_rate=5"}},
        {"slope",
         {"scene.duration=0.8", "scene.frame_rate=2.5", "cloth.0.pattern.divisions=[16, 16]",
          "cloth.1.pattern.divisions=[16, 16]"}},
        // a coarser sheet in place of the file's
        {"sphere_drop",
         {"scene.duration=0.4", "scene.frame_rate=5",
          "cloth.0={ pattern = { name = \"alternating\", size = [1, 1], divisions = [32, 32] }, "
          "place = { translate = [0, 0.76, 0], rotate_deg = [10, 70, 0] }, fabric = \"cotton\", "
          "colour = { back = \"#8c2a26\" } }"}},
        // softer, which lets steps be longer
        {"tablecloth",
         {"scene.duration=0.2", "scene.frame_rate=10",
          "cloth.0.fabric={ preset = \"cotton\", stretch = { model = \"membrane\", value = 10 } }"}},
        {"twirl",
         {"scene.duration=0.5", "scene.frame_rate=4", "cloth.0.pattern.divisions=[24, 24]",
          "cloth.1.pattern.divisions=[28, 28]"}},
        {"two_panels", {"scene.duration=1", "scene.frame_rate=2"}},
        {"two_sheets",
         {"scene.duration=0.5", "scene.frame_rate=4", "cloth.0.pattern.divisions=[24, 24]",
          "cloth.1.pattern.divisions=[18, 18]"}},
    };
    return all;
}

}  // namespace

std::span<const Reference> references() {
    return table();
}

std::string reference_folder() {
    return DRAPE_SOURCE_DIR "/renders/reference";
}

std::vector<std::string> arguments_of(const Reference& reference) {
    std::vector<std::string> arguments{"render", reference.scene, "--no-estimate", "--size",
                                       cat(width, "x", height)};
    for (const std::string& set : reference.set) arguments.insert(arguments.end(), {"--set", set});
    return arguments;
}

void visit_moments(const Reference& reference, const std::function<void(const Moment&)>& visit) {
    SceneDescription scene =
        read_scene(cat(DRAPE_SOURCE_DIR, "/assets/scenes/", reference.scene, ".toml"), reference.set);
    scene.look.size = {width, height};
    const std::unique_ptr<Delivery> delivery =
        make_delivery(build_scene(scene).setup, {.estimate = false, .frames = scene.frames()});
    const DrawnScene drawn = drawn_scene(scene, delivery->simulation());
    while (delivery->frame() < scene.frames()) {
        const std::optional<FrameReport> frame = delivery->advance();
        if (!frame) continue;
        if (!frame->trouble.empty()) throw Error(cat(reference.scene, ": ", frame->trouble));
        const Moment moment{cat("frame_", reference.scene, "_", frame->index, ".png"), drawn,
                            frame_input(scene.look.overlay, delivery->simulation(), delivery->state())};
        visit(moment);
    }
}

Image picture_of(const Moment& moment, std::string* renderer) {
    setenv("LP_NUM_THREADS", "0", 1);  // Mesa draws on this thread
    Renderer drawing = make_renderer(moment.drawn);
    if (renderer) *renderer = drawing.description();
    return drawing.draw(moment.input);
}

}  // namespace drape::test

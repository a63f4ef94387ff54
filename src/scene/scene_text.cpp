#include "scene/scene_text.h"

#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "base/names.h"
#include "obstacle/obstacle.h"
#include "scene/fabric_words.h"
#include "scene/shape_keys.h"

namespace drape {

namespace {

// the shortest digits that read back as the same number
std::string toml(double number) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
    return std::string(digits, end);
}

std::string toml(bool value) {
    return value ? "true" : "false";
}

std::string toml(const Vec3& v) {
    return cat("[", toml(v[0]), ", ", toml(v[1]), ", ", toml(v[2]), "]");
}

std::string toml(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04X",
                          static_cast<unsigned>(static_cast<unsigned char>(c)));
            result += escape;
        } else {
            result += c;
        }
    }
    return result + "\"";
}

std::string toml(const Colour& colour) {
    const auto byte = [](float part) { return static_cast<unsigned>(std::lround(255 * part)); };
    char text[16];
    std::snprintf(text, sizeof text, "\"#%02x%02x%02x\"", byte(colour[0]), byte(colour[1]), byte(colour[2]));
    return text;
}

std::string toml(const std::vector<Keyframe>& motion) {
    std::string text;
    for (const Keyframe& key : motion)
        text += cat(text.empty() ? "" : ", ", "{ t = ", toml(key.t), ", translate = ", toml(key.translate),
                    ", rotate_deg = ", toml(key.rotate_deg), " }");
    return "[" + text + "]";
}

std::string toml(const PinDescription& pin) {
    std::string text;
    if (pin.near) text = cat("near = ", toml(*pin.near));
    if (pin.within) text += cat(", within = ", toml(*pin.within));
    if (pin.box) text = cat("box = [", toml((*pin.box)[0]), ", ", toml((*pin.box)[1]), "]");
    if (pin.boundary) text = cat("boundary = ", *pin.boundary);
    if (pin.about) text += cat(", about = ", toml(*pin.about));
    text += cat(", rigid = ", toml(pin.rigid), ", motion = ", toml(pin.motion));
    return "{ " + text + " }";
}

std::string toml(const Fabric& fabric, const std::string& preset) {
    std::string text = preset.empty() ? "{ " : cat("{ preset = ", toml(preset), ", ");
    text += cat("density = ", toml(fabric.density), ", thickness = ", toml(fabric.thickness));
    text += cat(", stretch = { model = ", toml(word_for(stretch_words, fabric.stretch_model)),
                ", value = ", toml(fabric.stretch), " }");
    text +=
        cat(", altitude = { mode = ", toml(word_for(altitude_words, fabric.altitude)),
            ", ratio = ", toml(fabric.altitude_ratio), ", beyond = ", toml(fabric.compressed_beyond), " }");
    text += cat(", membrane = { kind = ", toml(word_for(membrane_words, fabric.membrane)),
                ", poisson = ", toml(fabric.membrane_poisson), " }");
    text += cat(", bending = { kind = ", toml(word_for(bending_words, fabric.bending_kind)),
                ", value = ", toml(fabric.bending), ", poisson = ", toml(fabric.poisson), " }");
    return text + cat(", damping = ", toml(fabric.damping), ", friction = ", toml(fabric.friction), " }");
}

// colours the scene leaves to the picture's palette stay out
std::string colours_text(const ClothColours& colours) {
    std::string given;
    const auto add = [&](std::string_view key, const std::optional<Colour>& colour) {
        if (colour) given += cat(given.empty() ? "" : ", ", key, " = ", toml(*colour));
    };
    add("front", colours.front);
    add("back", colours.back);
    add("stripe", colours.stripe);
    return cat(given.empty() ? "" : "colour = { " + given + " }\n", "stripes = ", toml(colours.stripes),
               "\n");
}

std::string toml(const Eigen::Vector2d& place) {
    return cat("[", toml(place.x()), ", ", toml(place.y()), "]");
}

template <class List, class Text>
std::string listed(const List& list, Text text) {
    std::string all;
    for (const auto& one : list) all += cat(all.empty() ? "" : ", ", text(one));
    return "[" + all + "]";
}

std::string finer_text(const ClothDescription& cloth) {
    const Finer& finer = cloth.pattern_size.finer;
    const auto place = [](const Eigen::Vector2d& p) { return toml(p); };
    std::string text = cat(", finer = { growth = ", toml(finer.growth),
                           ", turn_deg = ", toml(finer.turn * degrees_a_radian));
    if (finer.finest > 0) text += cat(", finest = ", toml(finer.finest));
    if (!finer.points.empty()) text += cat(", points = ", listed(finer.points, place));
    if (!finer.lines.empty())
        text += cat(", lines = ", listed(finer.lines, [&](const auto& line) { return listed(line, place); }));
    if (!cloth.curved.mesh.empty()) {
        text += cat(", curved = { mesh = ", toml(cloth.curved.mesh));
        if (!cloth.curved.positions.empty()) text += cat(", positions = ", toml(cloth.curved.positions));
        text += " }";
    }
    return text + " }";
}

std::string pattern_text(const ClothDescription& cloth) {
    const PatternSize& pattern = cloth.pattern_size;
    const bool outline = pattern.over == "outline";
    std::string text = cat("pattern = { name = ", toml(cloth.pattern));
    if (!outline) text += cat(", size = [", toml(pattern.width), ", ", toml(pattern.depth), "]");
    text += cat(", divisions = [", pattern.columns, ", ", pattern.rows, "], seed = ", pattern.seed);
    if (pattern.over != "rectangle") text += cat(", over = ", toml(pattern.over));
    if (outline) text += cat(", outline = ", listed(pattern.outline, [](const auto& p) { return toml(p); }));
    if (pattern.hole > 0) text += cat(", hole = ", toml(pattern.hole));
    if (cloth.pattern == "adaptive") text += finer_text(cloth);
    return text + " }\n";
}

std::string placement_text(const Placement& placement) {
    return cat("place = { translate = ", toml(placement.translate),
               ", rotate_deg = ", toml(placement.rotate_deg), ", scale = ", toml(placement.scale), " }\n");
}

std::string cloth_text(const ClothDescription& cloth) {
    std::string text = "\n[[cloth]]\n";
    if (cloth.mesh.empty())
        text += pattern_text(cloth);
    else
        text += cat("mesh = ", toml(cloth.mesh), "\n");
    text += placement_text(cloth.placement);
    text += cat("start = { velocity = ", toml(cloth.start.velocity), ", scale = ", toml(cloth.start.scale));
    if (!cloth.start.mesh.empty()) text += cat(", mesh = ", toml(cloth.start.mesh));
    text += cat(" }\nfabric = ", toml(cloth.fabric, cloth.fabric_name), "\npins = [");
    for (const PinDescription& pin : cloth.pins) text += cat("\n    ", toml(pin), ",");
    text += cat(cloth.pins.empty() ? "]" : "\n]", "\nself_contact = ", toml(cloth.self_contact), "\n");
    return text + colours_text(cloth.colours);
}

std::string shape_value(const ShapeParameters& parameters, std::string_view name) {
    for (const auto& key : shape_vectors)
        if (key.name == name) return toml(parameters.*key.member);
    return toml(parameters.*find_named(shape_numbers, "obstacle key", name).member);
}

std::string obstacle_text(const ObstacleDescription& obstacle) {
    std::string text = cat("\n[[obstacle]]\nshape = ", toml(obstacle.shape), "\n");
    const SolidKind& kind = find_named(obstacle_kinds(), "obstacle", obstacle.shape);
    if (kind.make)
        for (const std::string_view key : kind.keys)
            text += cat(key, " = ", shape_value(obstacle.parameters, key), "\n");
    else
        text += cat("mesh = ", toml(obstacle.mesh), "\n", placement_text(obstacle.placement),
                    "thickness = ", toml(obstacle.thickness), "\n");
    text += cat("friction = ", toml(obstacle.friction), "\nmotion = ", toml(obstacle.motion), "\n");
    if (obstacle.about) text += cat("about = ", toml(*obstacle.about), "\n");
    return text + cat("colour = ", toml(obstacle.colour), "\n");
}

std::string air_text(const AirDescription& air) {
    std::string text = cat("\n[air]\ndrag = ", toml(air.drag), "\n");
    if (!air.aerodynamic) return text;
    return text + cat("wind = ", toml(air.wind), "\ndensity = ", toml(air.density),
                      "\nlift = ", toml(air.lift), "\ngust = { strength = ", toml(air.gust_strength),
                      ", period = ", toml(air.gust_period), " }\n");
}

std::string look_text(const LookDescription& look) {
    std::string text = cat("\n[render]\nsize = [", look.size[0], ", ", look.size[1], "]\n");
    if (look.camera)
        text += cat("camera = { from = ", toml(look.camera->from), ", at = ", toml(look.camera->at),
                    ", fov_deg = ", toml(look.camera->fov_deg), " }\n");
    return text + cat("overlay = ", toml(look.overlay), "\nground = ", toml(look.ground), "\n");
}

std::string expect_text(const Expectation& expected) {
    std::string text = cat("\n[expect]\noutcome = ", toml(expected.outcome), "\n");
    if (!expected.because.empty()) text += cat("because = ", toml(expected.because), "\n");
    if (expected.largest_strain) text += cat("largest_strain = ", toml(*expected.largest_strain), "\n");
    if (expected.fastest) text += cat("fastest = ", toml(*expected.fastest), "\n");
    return text;
}

}  // namespace

std::string scene_text(const SceneDescription& scene) {
    std::string text = cat("schema = 1\n\n[scene]\nname = ", toml(scene.name),
                           "\nduration = ", toml(scene.duration), "\nframe_rate = ", toml(scene.frame_rate),
                           "\ngravity = ", toml(scene.gravity), "\nseed = ", scene.seed, "\n");
    text += cat("\n[accuracy]\nmethod = ", toml(scene.accuracy.method), "\n");
    if (scene.accuracy.step) text += cat("step = ", toml(*scene.accuracy.step), "\n");
    if (scene.accuracy.tolerance) text += cat("tolerance = ", toml(*scene.accuracy.tolerance), "\n");
    if (scene.accuracy.budget) text += cat("budget = ", toml(*scene.accuracy.budget), "\n");
    for (const ClothDescription& cloth : scene.cloths) text += cloth_text(cloth);
    for (const ObstacleDescription& obstacle : scene.obstacles) text += obstacle_text(obstacle);
    text += air_text(scene.air) + look_text(scene.look);
    return scene.expected ? text + expect_text(*scene.expected) : text;
}

}  // namespace drape

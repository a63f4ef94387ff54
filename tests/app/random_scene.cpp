#include "app/random_scene.h"

#include <array>
#include <cmath>
#include <random>
#include <string_view>

#include "base/error.h"
#include "cloth/fabric.h"
#include "integrate/method.h"

namespace drape::test {

namespace {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    // the same on every machine, unlike the standard's distributions
    double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * share(); }
    double decades(double low, double high) { return low * std::pow(high / low, share()); }
    int whole(int low, int high) { return low + static_cast<int>(share() * (high - low + 1)); }
    bool one_in(int n) { return whole(1, n) == 1; }
    template <class List>
    auto pick(const List& list) {
        return list[static_cast<size_t>(whole(0, static_cast<int>(std::size(list)) - 1))];
    }
    std::string vector(double reach) {
        return cat("[", between(-reach, reach), ", ", between(-reach, reach), ", ", between(-reach, reach),
                   "]");
    }

private:
    std::mt19937_64 engine_;
};

std::string motion(Dice& dice) {
    std::string text = "[{ t = 0 }";
    double t = 0;
    for (int k = dice.whole(1, 3); k > 0; --k) {
        t += dice.decades(0.02, 0.5);
        text +=
            cat(", { t = ", t, ", translate = ", dice.vector(0.3), ", rotate_deg = ", dice.vector(120), " }");
    }
    return text + "]";
}

std::string fabric(Dice& dice) {
    if (dice.one_in(4)) return cat("fabric = \"", dice.pick(fabric_presets()).name, "\"\n");
    constexpr std::array altitude{"none", "all", "shortest", "compressed", "blend"};
    constexpr std::array bending{"none", "plate", "hinge", "spring"};
    constexpr std::array membrane{"none", "stvk", "neo_hookean"};
    constexpr std::array stretch{"membrane", "spring_constant", "force_per_strain"};
    const std::string_view kind = dice.pick(membrane), bend = dice.pick(bending);
    const std::string_view model = kind == "none" ? std::string_view(dice.pick(stretch)) : "membrane";
    std::string text =
        cat("fabric = { density = ", dice.decades(0.02, 2), ", thickness = ", dice.decades(2e-4, 5e-3),
            ", stretch = { model = \"", model, "\", value = ", dice.decades(1, 1e5), " }");
    if (kind == "none")
        text +=
            cat(", altitude = { mode = \"", dice.pick(altitude), "\", ratio = ", dice.decades(0.1, 10), " }");
    else
        text += cat(", membrane = { kind = \"", kind, "\", poisson = ", dice.between(0, 0.45), " }");
    if (bend != "none")
        text += cat(", bending = { kind = \"", bend, "\", value = ", dice.decades(1e-6, 1e-2), " }");
    return text + cat(", damping = ", dice.one_in(3) ? 0.0 : dice.decades(1e-3, 1), " }\n");
}

std::string cloth(Dice& dice) {
    constexpr std::array patterns{"one_way", "alternating", "crossed", "equilateral", "pseudo_random"};
    // not needles.obj, whose steps are a thousand times shorter than others'
    constexpr std::array meshes{"book",    "coincident", "disconnected", "dome",
                                "moebius", "pinched",    "sheet",        "zero_area"};
    std::string text = "[[cloth]]\n";
    if (dice.one_in(4))
        text += cat("mesh = \"", DRAPE_SOURCE_DIR, "/assets/meshes/extreme/", dice.pick(meshes), ".obj\"\n");
    else
        text += cat("pattern = { name = \"", dice.pick(patterns), "\", size = [", dice.decades(0.1, 3), ", ",
                    dice.decades(0.1, 3), "], divisions = [", dice.whole(1, 9), ", ", dice.whole(1, 9),
                    "], seed = ", dice.whole(1, 99), " }\n");
    text += cat("place = { translate = ", dice.vector(0.5), ", rotate_deg = ", dice.vector(180), " }\n");
    if (dice.one_in(4))
        text += cat("start = { velocity = ", dice.vector(5), ", scale = [", dice.between(0.5, 1.5), ", 1, ",
                    dice.between(0.5, 1.5), "] }\n");
    text += fabric(dice);
    if (dice.one_in(3)) return text;
    if (dice.one_in(3))
        return text + cat("pins = [{ boundary = 0, rigid = true, motion = ", motion(dice), " }]\n");
    // the nearest vertex, wherever it is
    const auto pin = [&] { return cat("{ near = ", dice.vector(1), ", within = 10"); };
    text +=
        cat("pins = [", pin(), dice.one_in(2) ? cat(", rigid = true, motion = ", motion(dice)) : "", " }, ");
    return text + cat(pin(), " }]\n");
}

std::string obstacle(Dice& dice) {
    std::string text = "[[obstacle]]\n";
    const double size = dice.decades(0.05, 0.6);
    switch (dice.whole(1, 6)) {
        case 1:
            text += cat("shape = \"plane\"\ncentre = [0, ", dice.between(-1.5, 0), ", 0]\n");
            break;
        case 2:
            text += cat("shape = \"sphere\"\ncentre = ", dice.vector(0.8), "\nradius = ", size, "\n");
            break;
        case 3:
            text += cat("shape = \"capsule\"\nfrom = ", dice.vector(0.8), "\nto = ", dice.vector(0.8),
                        "\nradius = ", size / 2, "\n");
            break;
        case 4:
            text += cat("shape = \"box\"\ncentre = ", dice.vector(0.8), "\nsize = [", size, ", ",
                        dice.decades(0.1, 1), ", ", size, "]\nrotate_deg = ", dice.vector(90),
                        "\nrounding = 0.02\n");
            break;
        case 5:
            text += cat("shape = \"cylinder\"\ncentre = ", dice.vector(0.8), "\naxis = ", dice.vector(1),
                        "\nradius = ", size, "\nheight = ", dice.decades(0.1, 1), "\nrounding = 0.02\n");
            break;
        default:
            text += cat("shape = \"torus\"\ncentre = ", dice.vector(0.8), "\naxis = ", dice.vector(1),
                        "\nradius = ", size, "\ntube_radius = ", size / 3, "\n");
    }
    text += cat("friction = ", dice.one_in(3) ? 0.0 : dice.between(0, 1), "\n");
    if (dice.one_in(3)) text += cat("motion = ", motion(dice), "\n");
    return text;
}

}  // namespace

std::string random_scene(std::uint64_t seed) {
    Dice dice(seed);
    std::string text = cat("schema = 1\n[scene]\nduration = 0.2\nframe_rate = ", dice.one_in(2) ? 20 : 30,
                           "\ngravity = [0, ", dice.one_in(8) ? 0.0 : dice.between(-20, 1), ", 0]\n");
    if (dice.one_in(2)) {
        const Method& method = dice.pick(methods());
        text += cat("[accuracy]\nmethod = \"", method.name, "\"\n");
        if (dice.one_in(3)) text += cat("step = ", dice.decades(1e-4, 0.02), "\n");
    } else if (dice.one_in(4)) {
        text += cat("[accuracy]\ntolerance = ", dice.decades(1e-3, 1e-1), "\n");
    }
    for (int n = dice.one_in(4) ? 2 : 1; n > 0; --n) text += cloth(dice);
    for (int n = dice.whole(0, 2); n > 0; --n) text += obstacle(dice);
    if (dice.one_in(3))
        text += cat("[air]\ndrag = ", dice.decades(1e-3, 1), "\nwind = ", dice.vector(10),
                    dice.one_in(2) ? "\ngust = { strength = 0.3, period = 0.5 }\n" : "\n");
    return text;
}

}  // namespace drape::test

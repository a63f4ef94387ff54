// [accuracy] and [air].

#include "integrate/method.h"
#include "scene/read_parts.h"
#include "toml/keys.h"

namespace drape {

AccuracyDescription read_accuracy(const Value& value) {
    const Keys keys(value, "accuracy", {"method", "step", "tolerance", "budget"});
    AccuracyDescription accuracy;
    accuracy.place = keys.place();
    if (const Value* method = keys.find("method")) {
        std::vector<std::string> known = names_of(methods());
        known.insert(known.begin(), "auto");
        accuracy.method = as_word(*method, "method", known);
        accuracy.place = method->place;
    }
    if (const Value* step = keys.find("step")) accuracy.step = as_number(*step, "step", positive("s"));
    if (const Value* tolerance = keys.find("tolerance")) {
        accuracy.tolerance = as_number(*tolerance, "tolerance", positive("m"));
        if (accuracy.step)
            fail(tolerance->key_place, "tolerance chooses the step by itself (leave out step, or tolerance)");
    }
    if (const Value* budget = keys.find("budget")) {
        accuracy.budget = as_number(*budget, "budget", positive("s"));
        if (accuracy.step || accuracy.tolerance)
            fail(budget->key_place, "budget chooses step and error by itself (leave out ",
                 accuracy.step ? "step" : "tolerance", ", or budget)");
    }
    return accuracy;
}

AirDescription read_air(const Value& value) {
    const Keys keys(value, "air", {"drag", "wind", "gust", "density", "lift"});
    AirDescription air;
    keys.read("drag", air.drag, not_negative("kg/(s m^2)"));
    air.aerodynamic = keys.find("wind") != nullptr;
    for (const std::string_view key : {"gust", "density", "lift"})
        if (const Value* given = keys.find(key); given && !air.aerodynamic)
            fail(given->key_place, key, " goes with wind only (wind = [0, 0, 0] is still air)");
    keys.read("wind", air.wind, any("m/s"));
    keys.read("density", air.density, positive("kg/m^3"));
    keys.read("lift", air.lift, not_negative());
    if (const Value* gust = keys.find("gust")) {
        const Keys gusts(*gust, "gust", {"strength", "period"});
        gusts.read("strength", air.gust_strength, not_negative());
        gusts.read("period", air.gust_period, positive("s"));
    }
    return air;
}

}  // namespace drape

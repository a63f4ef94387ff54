// A fabric: a preset's name, or a table over a preset or over a bare fabric (no altitude springs, no bending,
// no damping).

#include "scene/fabric_words.h"
#include "scene/read_parts.h"
#include "toml/keys.h"

namespace drape {

namespace {

// stretch = { model = "spring_constant", value = 500 }
void read_stretch(const Value& value, Fabric& fabric) {
    const Keys keys(value, "stretch", {"model", "value"});
    if (const Value* model = keys.find("model")) {
        fabric.stretch_model = as_kind(*model, "stretch model", stretch_words).choice;
        // a number of newtons is not one of newtons per metre: with a new model goes a new value
        keys.need("value");
    }
    const bool force = fabric.stretch_model == StretchModel::force_per_strain;
    if (const Value* number = keys.find("value"))
        fabric.stretch = as_number(*number, "stretch value", positive(force ? "N" : "N/m"));
}

// altitude = "blend", or { mode = "blend", ratio = 1, beyond = 0.25 }
void read_altitude(const Value& value, Fabric& fabric) {
    if (value.kind == Value::Kind::text) {
        fabric.altitude = as_kind(value, "altitude mode", altitude_words).choice;
        return;
    }
    const Keys keys(value, "altitude", {"mode", "ratio", "beyond"});
    if (const Value* mode = keys.find("mode"))
        fabric.altitude = as_kind(*mode, "altitude mode", altitude_words).choice;
    keys.read("ratio", fabric.altitude_ratio, positive());
    keys.read("beyond", fabric.compressed_beyond, {.least = 0, .most = 0.99});
}

constexpr Quantity poisson_ratio{.least = -1, .most = 0.5, .above_least = true};

// membrane = "stvk", or { kind = "stvk", poisson = 0.3 }
void read_membrane(const Value& value, Fabric& fabric) {
    if (value.kind == Value::Kind::text) {
        fabric.membrane = as_kind(value, "membrane", membrane_words).choice;
    } else {
        const Keys keys(value, "membrane", {"kind", "poisson"});
        if (const Value* kind = keys.find("kind"))
            fabric.membrane = as_kind(*kind, "membrane kind", membrane_words).choice;
        keys.read("poisson", fabric.membrane_poisson, poisson_ratio);
    }
    if (fabric.membrane != MembraneKind::none && fabric.stretch_model != StretchModel::membrane)
        fail(value.place, "membrane \"", word_for(membrane_words, fabric.membrane),
             "\" stretches by Young's ",
             "modulus times thickness: stretch model must be \"membrane\" (N/m), not \"",
             word_for(stretch_words, fabric.stretch_model), "\"");
}

// bending = 0, a number, or { kind = "plate", value = 1e-5, poisson = 0.3 }
void read_bending(const Value& value, Fabric& fabric) {
    if (value.kind == Value::Kind::table) {
        const Keys keys(value, "bending", {"kind", "value", "poisson"});
        const BendingKind before = fabric.bending_kind;
        if (fabric.bending_kind == BendingKind::none) fabric.bending_kind = BendingKind::plate;
        if (const Value* kind = keys.find("kind"))
            fabric.bending_kind = as_kind(*kind, "bending kind", bending_words).choice;
        // a rigidity [N m] means nothing to plain springs, nor their fraction to plates
        const bool changes_meaning =
            (fabric.bending_kind == BendingKind::spring) != (before == BendingKind::spring);
        if (fabric.bending_kind != BendingKind::none && (changes_meaning || before == BendingKind::none))
            keys.need("value");
        const bool fraction = fabric.bending_kind == BendingKind::spring;
        if (const Value* number = keys.find("value"))
            fabric.bending = as_number(*number, "bending value", not_negative(fraction ? "" : "N m"));
        keys.read("poisson", fabric.poisson, poisson_ratio);
    } else {
        fabric.bending = as_number(value, "bending", not_negative("N m"));
        if (fabric.bending_kind == BendingKind::none) fabric.bending_kind = BendingKind::plate;
    }
    if (fabric.bending == 0) fabric.bending_kind = BendingKind::none;
    if (fabric.bending_kind == BendingKind::none) fabric.bending = 0;
}

}  // namespace

Fabric read_fabric(const Value& value, std::string& preset) {
    preset.clear();
    if (value.kind == Value::Kind::text) {
        preset = value.text;
        return as_kind(value, "fabric", fabric_presets()).fabric;
    }
    const Keys keys(value, "fabric",
                    {"preset", "density", "thickness", "stretch", "altitude", "membrane", "bending",
                     "damping", "friction"});
    Fabric fabric;
    if (const Value* name = keys.find("preset")) {
        fabric = as_kind(*name, "fabric", fabric_presets()).fabric;
        preset = name->text;
    }
    keys.read("density", fabric.density, positive("kg/m^2"));
    keys.read("thickness", fabric.thickness, positive("m"));
    if (const Value* stretch = keys.find("stretch")) read_stretch(*stretch, fabric);
    if (const Value* altitude = keys.find("altitude")) read_altitude(*altitude, fabric);
    if (const Value* membrane = keys.find("membrane")) read_membrane(*membrane, fabric);
    if (const Value* bending = keys.find("bending")) read_bending(*bending, fabric);
    keys.read("damping", fabric.damping, not_negative());
    keys.read("friction", fabric.friction, not_negative());
    return fabric;
}

}  // namespace drape

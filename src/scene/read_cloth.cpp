// [[cloth]]: where its mesh comes from, where it stands, what it is made of, what holds it.

#include "scene/read_parts.h"
#include "toml/keys.h"

namespace drape {

Placement read_placement(const Value& value) {
    const Keys keys(value, "place", {"translate", "rotate_deg", "scale"});
    Placement placement;
    keys.read("translate", placement.translate, any("m"));
    keys.read("rotate_deg", placement.rotate_deg, any("degrees"));
    keys.read("scale", placement.scale, positive());
    return placement;
}

namespace {

void read_start(const Value& value, ClothDescription& cloth) {
    const Keys keys(value, "start", {"velocity", "scale", "mesh"});
    keys.read("velocity", cloth.start.velocity, any("m/s"));
    keys.read("scale", cloth.start.scale, any());
    keys.read("mesh", cloth.start.mesh);
    if (const Value* mesh = keys.find("mesh")) cloth.start_mesh_place = mesh->place;
}

void read_colours(const Value& value, ClothColours& colours) {
    const Keys keys(value, "colour", {"front", "back", "stripe"});
    if (const Value* front = keys.find("front")) colours.front = read_colour(*front, "front");
    if (const Value* back = keys.find("back")) colours.back = read_colour(*back, "back");
    if (const Value* stripe = keys.find("stripe")) colours.stripe = read_colour(*stripe, "stripe");
}

}  // namespace

PinDescription read_pin(const Value& value) {
    const Keys keys(value, "pin", {"near", "within", "box", "boundary", "motion", "about", "rigid"});
    PinDescription pin;
    pin.place = keys.place();
    const Value *near = keys.find("near"), *box = keys.find("box"), *boundary = keys.find("boundary");
    if ((near != nullptr) + (box != nullptr) + (boundary != nullptr) != 1)
        fail(keys.place(), "a pin needs exactly one of near, box, boundary");
    if (near) pin.near = as_vector(*near, "near", any("m"));
    if (const Value* within = keys.find("within")) {
        if (!near) fail(within->key_place, "within goes with near only");
        pin.within = as_number(*within, "within", not_negative("m"));
    }
    if (box) {
        const std::vector<Value>& corners = as_array(*box, "box", 2);
        const Vec3 one = as_vector(corners[0], "box", any("m")),
                   other = as_vector(corners[1], "box", any("m"));
        pin.box = {one.cwiseMin(other), one.cwiseMax(other)};
    }
    if (boundary) pin.boundary = as_integer(*boundary, "boundary", 0, std::numeric_limits<int>::max());
    if (const Value* motion = keys.find("motion")) pin.motion = read_motion(*motion);
    if (const Value* about = keys.find("about")) pin.about = as_vector(*about, "about", any("m"));
    keys.read("rigid", pin.rigid);
    return pin;
}

ClothDescription read_cloth(const Value& value) {
    const Keys keys(
        value, "cloth",
        {"mesh", "pattern", "place", "start", "fabric", "pins", "self_contact", "colour", "stripes"});
    ClothDescription cloth;
    cloth.place = cloth.mesh_place = cloth.fabric_place = keys.place();

    const Value *mesh = keys.find("mesh"), *pattern = keys.find("pattern");
    if ((mesh != nullptr) == (pattern != nullptr))
        fail(keys.place(), "a cloth needs exactly one of mesh, pattern");
    cloth.mesh_place = (mesh ? mesh : pattern)->place;
    if (mesh && as_text(*mesh, "mesh").empty()) fail(mesh->place, "mesh must name a file");
    keys.read("mesh", cloth.mesh);
    if (pattern) read_pattern(*pattern, cloth);

    if (const Value* place = keys.find("place")) cloth.placement = read_placement(*place);
    if (const Value* start = keys.find("start")) read_start(*start, cloth);
    if (const Value* fabric = keys.find("fabric")) {
        cloth.fabric = read_fabric(*fabric, cloth.fabric_name);
        cloth.fabric_place = fabric->place;
    } else {
        cloth.fabric_name = fabric_presets().front().name;
        cloth.fabric = fabric_presets().front().fabric;
    }
    if (const Value* pins = keys.find("pins"))
        for (const Value& pin : as_array(*pins, "pins")) cloth.pins.push_back(read_pin(pin));
    keys.read("self_contact", cloth.self_contact);

    if (const Value* colour = keys.find("colour")) read_colours(*colour, cloth.colours);
    keys.read("stripes", cloth.colours.stripes);
    return cloth;
}

}  // namespace drape

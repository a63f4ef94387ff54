// [[obstacle]]: a kind of solid with the keys that kind reads, and how it moves.

#include "base/error.h"
#include "obstacle/obstacle.h"
#include "scene/read_parts.h"
#include "scene/shape_keys.h"
#include "toml/keys.h"

namespace drape {

std::vector<Keyframe> read_motion(const Value& value) {
    std::vector<Keyframe> motion;
    for (const Value& item : as_array(value, "motion")) {
        const Keys keys(item, "keyframe", {"t", "translate", "rotate_deg"});
        Keyframe key;
        const Value& t = keys.need("t");
        key.t = as_number(t, "t", any("s"));
        if (!motion.empty() && !(key.t > motion.back().t))
            fail(t.place, "keyframe times must increase, got ", key.t, " after ", motion.back().t);
        keys.read("translate", key.translate, any("m"));
        keys.read("rotate_deg", key.rotate_deg, any("degrees"));
        motion.push_back(key);
    }
    return motion;
}

ObstacleDescription read_obstacle(const Value& value) {
    // the shape says which other keys are known
    if (value.kind != Value::Kind::table) Keys(value, "obstacle", {});
    const Value* shape = value.find("shape");
    if (!shape) fail(value.place, "obstacle: shape is missing");
    const SolidKind& kind = as_kind(*shape, "obstacle", obstacle_kinds());

    std::vector<std::string> known{"shape"};
    known.insert(known.end(), kind.keys.begin(), kind.keys.end());
    known.insert(known.end(), {"friction", "motion", "about", "colour"});
    const Keys keys(value, std::string(kind.name), known);

    ObstacleDescription obstacle;
    obstacle.place = keys.place();
    obstacle.shape = kind.name;
    for (const auto& key : shape_vectors)
        if (value.find(key.name)) keys.read(key.name, obstacle.parameters.*key.member, key.quantity);
    for (const auto& key : shape_numbers)
        if (value.find(key.name)) keys.read(key.name, obstacle.parameters.*key.member, key.quantity);
    keys.read("friction", obstacle.friction, not_negative());
    if (const Value* motion = keys.find("motion")) obstacle.motion = read_motion(*motion);
    if (const Value* about = keys.find("about")) obstacle.about = as_vector(*about, "about", any("m"));
    if (const Value* colour = keys.find("colour")) obstacle.colour = read_colour(*colour, "colour");

    if (!kind.make) {
        const Value& mesh = keys.need("mesh");
        obstacle.mesh = as_text(mesh, "mesh");
        obstacle.mesh_place = mesh.place;
        if (obstacle.mesh.empty()) fail(mesh.place, "mesh must name a file");
        if (const Value* place = keys.find("place")) obstacle.placement = read_placement(*place);
        keys.read("thickness", obstacle.thickness, positive("m"));
        return obstacle;
    }

    // what only the kind itself knows: a tube wider than its ring, a zero axis
    in_context(obstacle.place.text, [&] { return kind.make(obstacle.parameters); });
    return obstacle;
}

}  // namespace drape

// pattern = { name = "alternating", size = [1, 1], divisions = [64, 64], seed = 1, over = "disc" }: a cloth's
// mesh, generated.
#include "scene/read_parts.h"
#include "toml/keys.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr int most_divisions = 1'000'000;
constexpr size_t most_corners = 10'000;  // of an outline

Vec2 as_place(const Value& value, std::string_view name) {
    const std::vector<Value>& parts = as_array(value, name, 2);
    return {as_number(parts[0], name, any("m")), as_number(parts[1], name, any("m"))};
}

std::vector<Vec2> as_places(const Value& value, std::string_view name) {
    std::vector<Vec2> places;
    for (const Value& place : as_array(value, name)) places.push_back(as_place(place, name));
    return places;
}

// finer = { points = [[0, 0]], lines = [[[0, 0], [1, 0]]], curved = { mesh = "flat.obj", positions =
// "run.pc2" } }
void read_finer(const Value& value, ClothDescription& cloth) {
    const Keys keys(value, "finer", {"points", "lines", "curved", "finest", "growth", "turn_deg"});
    Finer& finer = cloth.pattern_size.finer;
    if (const Value* points = keys.find("points")) finer.points = as_places(*points, "points");
    if (const Value* lines = keys.find("lines")) {
        for (const Value& line : as_array(*lines, "lines")) {
            const std::vector<Value>& ends = as_array(line, "lines", 2);
            finer.lines.push_back({as_place(ends[0], "lines"), as_place(ends[1], "lines")});
        }
    }
    if (const Value* curved = keys.find("curved")) {
        const Keys files(*curved, "curved", {"mesh", "positions"});
        files.need("mesh");
        files.read("mesh", cloth.curved.mesh);
        files.read("positions", cloth.curved.positions);
        if (cloth.curved.mesh.empty()) fail(files.need("mesh").place, "mesh must name a file");
        cloth.curved.place = curved->place;
    }
    keys.read("finest", finer.finest, positive("m"));
    keys.read("growth", finer.growth, positive());
    double turn_deg = finer.turn * degrees_a_radian;
    keys.read("turn_deg", turn_deg, {.unit = "degrees", .least = 0, .most = 180, .above_least = true});
    finer.turn = turn_deg / degrees_a_radian;
    if (!finer.anywhere() && cloth.curved.mesh.empty())
        fail(keys.place(), "finer needs points, lines or curved");
}

}  // namespace

void read_pattern(const Value& value, ClothDescription& cloth) {
    const Keys keys(value, "pattern",
                    {"name", "size", "divisions", "seed", "over", "hole", "outline", "finer"});
    PatternSize& pattern = cloth.pattern_size;
    if (const Value* name = keys.find("name"))
        cloth.pattern = as_kind(*name, "pattern", pattern_kinds()).name;
    const Value *size = keys.find("size"), *outline = keys.find("outline"), *hole = keys.find("hole"),
                *over = keys.find("over"), *finer = keys.find("finer");
    if (size) {
        const std::vector<Value>& sides = as_array(*size, "size", 2);
        pattern.width = as_number(sides[0], "size", positive("m"));
        pattern.depth = as_number(sides[1], "size", positive("m"));
    }
    if (const Value* divisions = keys.find("divisions")) {
        const std::vector<Value>& counts = as_array(*divisions, "divisions", 2);
        pattern.columns = as_integer(counts[0], "divisions", 1, most_divisions);
        pattern.rows = as_integer(counts[1], "divisions", 1, most_divisions);
    }
    if (const Value* seed = keys.find("seed"))
        pattern.seed =
            static_cast<std::uint64_t>(as_integer(*seed, "seed", 0, std::numeric_limits<int>::max()));
    if (outline) pattern.over = "outline";
    if (over) pattern.over = as_kind(*over, "over", over_kinds()).name;
    if ((pattern.over == "outline") != (outline != nullptr))
        fail(over->place,
             outline ? "outline goes with over = \"outline\" only" : "over = \"outline\" needs outline");
    if (outline) {
        if (size) fail(size->key_place, "size does not go with outline, whose corners give it");
        pattern.outline = as_places(*outline, "outline");
        if (pattern.outline.size() > most_corners)
            fail(outline->place, "outline has ", pattern.outline.size(), " corners (at most ", most_corners,
                 ")");
        in_context(outline->place.text, [&] { polygon_outline(pattern.outline); });
    }
    if (hole) {
        if (pattern.over != "annulus") fail(hole->key_place, "hole goes with over = \"annulus\" only");
        pattern.hole = as_number(*hole, "hole", positive("m"));
    }
    if (finer && cloth.pattern != "adaptive")
        fail(finer->key_place, "finer goes with name = \"adaptive\" only");
    if (!finer && cloth.pattern == "adaptive") fail(keys.place(), "adaptive needs finer");
    if (finer) read_finer(*finer, cloth);
}

}  // namespace drape

// mesh: a generated cloth mesh into a file.
#include <cstdio>

#include "app/verbs.h"
#include "io/load_mesh.h"
#include "io/write_mesh.h"
#include "mesh/remesh.h"
#include "scene/builder.h"
#include "scene/read_parts.h"

namespace drape {

namespace {

// The options as a scene's pattern, so that they are checked and told apart as those are.
Value pattern_of(const PatternOptions& options) {
    Value pattern;
    pattern.place.text = "mesh";
    const auto add = [&](const std::string& key, const std::string& text, const std::string& source) {
        if (text.empty()) return;
        const Value given = parse_toml(cat(key, " = ", text), source);
        for (const Value& value : given.items) {
            pattern.items.push_back(value);
            // what stands on the command line has no line and column
            pattern.items.back().place.text = pattern.items.back().key_place.text = source;
        }
    };
    add("name", cat('"', options.pattern, '"'), "PATTERN");
    if (options.size) add("size", cat("[", (*options.size)[0], ", ", (*options.size)[1], "]"), "--size");
    if (options.divisions)
        add("divisions", cat("[", (*options.divisions)[0], ", ", (*options.divisions)[1], "]"),
            "--divisions");
    if (!options.over.empty()) add("over", cat('"', options.over, '"'), "--over");
    add("hole", options.hole, "--hole");
    add("outline", options.outline, "--outline");
    add("finer", options.finer, "--finer");
    add("seed", cat(options.seed), "--seed");
    return pattern;
}

Mesh made_anew(const PatternOptions& options, PatternSize size) {
    if (options.size || !options.over.empty() || !options.outline.empty())
        throw Error(
            "--remesh: the mesh says what is covered (it does not go with --size, --over, --outline)");
    if (!options.divisions) size.columns = size.rows = 0;
    const Mesh mesh = load_mesh(options.remesh).mesh;
    return in_context(options.remesh, [&] { return remesh(mesh, options.pattern, size); });
}

}  // namespace

Exit write_pattern(const PatternOptions& options) {
    ClothDescription cloth;
    read_pattern(pattern_of(options), cloth);
    const PatternSize size = pattern_size_of({}, cloth);
    const Mesh mesh = options.remesh.empty() ? make_pattern(cloth.pattern, size) : made_anew(options, size);
    write_mesh(options.file, mesh);
    std::printf("%s: %d vertices, %d triangles\n", options.file.c_str(), mesh.vertices(), mesh.triangles());
    return Exit::done;
}

}  // namespace drape

// mesh: a generated cloth mesh into a file.
#include <cstdio>

#include "app/verbs.h"
#include "io/write_mesh.h"
#include "mesh/pattern.h"

namespace drape {

Exit write_pattern(const PatternOptions& options) {
    const PatternSize size{options.size[0], options.size[1], options.divisions[0], options.divisions[1],
                           options.seed};
    const Mesh mesh = make_pattern(options.pattern, size);
    write_mesh(options.file, mesh);
    std::printf("%s: %d vertices, %d triangles\n", options.file.c_str(), mesh.vertices(), mesh.triangles());
    return Exit::done;
}

}  // namespace drape

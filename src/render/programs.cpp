#include "render/programs.h"

namespace drape {

namespace {

std::vector<ShaderFile> files(std::initializer_list<const char*> names) {
    std::vector<ShaderFile> found;
    for (const char* name : names) found.push_back(shader_file(name));
    return found;
}

}  // namespace

Programs::Programs(const Gl& gl)
    : shadow(gl, files({"frame.glsl", "shadow.vert"}), files({"shadow.frag"})),
      geometry(gl, files({"frame.glsl", "surface.vert"}), files({"frame.glsl", "geometry.frag"})),
      occlusion(gl, files({"screen.vert"}), files({"frame.glsl", "occlusion.frag"})),
      blur(gl, files({"screen.vert"}), files({"blur.frag"})),
      backdrop(gl, files({"screen.vert"}),
               files({"frame.glsl", "display.glsl", "backdrop.glsl", "backdrop.frag"})),
      ground(gl, files({"frame.glsl", "surface.vert"}),
             files({"frame.glsl", "display.glsl", "lighting.glsl", "backdrop.glsl", "ground.frag"})),
      solid(gl, files({"frame.glsl", "surface.vert"}),
            files({"frame.glsl", "display.glsl", "lighting.glsl", "solid.frag"})),
      cloth(gl, files({"frame.glsl", "surface.vert"}),
            files({"frame.glsl", "display.glsl", "lighting.glsl", "weave.glsl", "cloth.frag"})),
      key(gl, files({"frame.glsl", "surface.vert"}), files({"key.frag"})),
      resolve(gl, files({"screen.vert"}), files({"frame.glsl", "resolve.frag"})),
      line(gl, files({"frame.glsl", "line.vert"}), files({"line.frag"})) {}

}  // namespace drape

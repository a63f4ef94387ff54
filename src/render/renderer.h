// Draws frames with OpenGL 4.5 core in software, without a display.
#pragma once

#include <memory>
#include <string>

#include "render/picture.h"

namespace drape {

enum class Backend { osmesa, egl_surfaceless };

class Renderer {
public:
    // Throws Error (Exit::cannot_write) if the context cannot be made or a shader does not compile.
    Renderer(const RenderSettings& settings, std::vector<DrawnCloth> cloths, std::vector<DrawnSolid> solids,
             Backend backend = Backend::osmesa);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    Image draw(const FrameInput& frame);
    std::string description() const;  // GL_RENDERER and version, for the report

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// A camera that sees all of `bounds` from the front right and a little above.
Camera frame_automatically(const Eigen::AlignedBox3d& bounds, double aspect);

}  // namespace drape

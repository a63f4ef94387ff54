// Draws frames with OpenGL 4.5 core in software, without a display.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/picture.h"

namespace drape {

enum class Backend { osmesa, egl_surfaceless };

// CPU seconds of a stage of one frame, all threads.
struct StageTime {
    std::string_view name;
    double cpu_seconds = 0;
};

class Renderer {
public:
    // Throws Error (Exit::cannot_write) if the context cannot be made or a shader does not compile.
    Renderer(const RenderSettings& settings, const std::vector<DrawnCloth>& cloths,
             const std::vector<DrawnSolid>& solids, Backend backend = Backend::osmesa);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    // `stages`, where given, gets what each stage of the frame took; waiting for each to end costs a little.
    Image draw(const FrameInput& frame, std::vector<StageTime>* stages = nullptr);
    std::string description() const;  // GL_RENDERER and version, for the report

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// A camera that sees all of `bounds` from the front right and a little above.
Camera frame_automatically(const Eigen::AlignedBox3d& bounds, double aspect);

}  // namespace drape

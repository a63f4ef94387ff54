// Hands a simulation's frames to the renderer.
#pragma once

#include <memory>
#include <string>

#include "base/image.h"
#include "render/renderer.h"
#include "scene/description.h"
#include "simulate/delivery.h"

namespace drape {

class PictureMaker {
public:
    PictureMaker(const SceneDescription& scene, const Simulation& simulation);

    Image draw(const Delivery& delivery);  // its last frame
    std::string renderer() const { return renderer_.description(); }

private:
    std::string overlay_;
    Renderer renderer_;
};

}  // namespace drape

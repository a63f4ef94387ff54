// The seam between the renderer and whoever offers OpenGL without a display: a context that can be made
// current on this thread and resolves entry points. Upstream Mesa has dropped OSMesa, so there are two.
#pragma once

#include <memory>

#include "render/renderer.h"

namespace drape {

class Context {
public:
    using Procedure = void (*)();

    virtual ~Context() = default;  // releases the context if it is current
    virtual void make_current() = 0;
    virtual Procedure procedure(const char* name) const = 0;  // null: unknown
};

// An OpenGL 4.5 core context; all drawing goes to framebuffer objects. Throws Error (Exit::cannot_write).
std::unique_ptr<Context> make_osmesa_context();
std::unique_ptr<Context> make_egl_context();

std::unique_ptr<Context> make_context(Backend backend);

}  // namespace drape

#include "render/gl.h"

#include "base/error.h"

namespace drape {

Gl::Gl(const Context& context) {
#define DRAPE_GL_LOAD(name, type)                                              \
    name = reinterpret_cast<PFNGL##type##PROC>(context.procedure("gl" #name)); \
    if (!name) throw Error("OpenGL driver lacks gl" #name " (4.5 core is needed)", Exit::cannot_write);
    DRAPE_GL_FUNCTIONS(DRAPE_GL_LOAD)
#undef DRAPE_GL_LOAD
}

void Gl::check(const std::string& doing) const {
    const GLenum code = GetError();
    if (code == GL_NO_ERROR) return;
    const char* name = code == GL_OUT_OF_MEMORY                   ? "out of memory"
                       : code == GL_INVALID_OPERATION             ? "invalid operation"
                       : code == GL_INVALID_VALUE                 ? "invalid value"
                       : code == GL_INVALID_ENUM                  ? "invalid enum"
                       : code == GL_INVALID_FRAMEBUFFER_OPERATION ? "invalid framebuffer operation"
                                                                  : "unknown error";
    throw Error(cat("OpenGL: ", name, " while ", doing), Exit::cannot_write);
}

}  // namespace drape

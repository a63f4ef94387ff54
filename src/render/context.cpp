#include "render/context.h"

namespace drape {

std::unique_ptr<Context> make_context(Backend backend) {
    return backend == Backend::osmesa ? make_osmesa_context() : make_egl_context();
}

}  // namespace drape

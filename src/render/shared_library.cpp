#include "render/shared_library.h"

#include <dlfcn.h>

#include "base/error.h"

namespace drape {

SharedLibrary::SharedLibrary(const char* file, const char* advice)
    : file_(file), handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_) throw Error(cat("cannot load ", file, " (", advice, ")"), Exit::cannot_write);
}

void* SharedLibrary::symbol(const char* name) const {
    void* found = dlsym(handle_, name);
    if (!found) throw Error(cat(file_, " lacks ", name), Exit::cannot_write);
    return found;
}

}  // namespace drape

// EGL on Mesa's surfaceless platform. The library is opened at run time, when this back-end is asked for:
// a program that draws with OSMesa then neither links EGL nor needs it installed.
#include <array>
#include <cstdint>

#include "base/error.h"
#include "render/context.h"
#include "render/shared_library.h"

namespace drape {

namespace {

// the part of EGL 1.5 used here, as its specification numbers it
using Display = void*;
using Config = void*;
using Handle = void*;
constexpr unsigned platform_surfaceless_mesa = 0x31DD, opengl_api = 0x30A2;
constexpr std::int32_t none = 0x3038, surface_type = 0x3033, renderable_type = 0x3040, opengl_bit = 0x0008;
constexpr std::int32_t major_version = 0x3098, minor_version = 0x30FB, profile_mask = 0x30FD,
                       core_profile = 1;

void require(bool holds, const char* what) {
    if (!holds) throw Error(cat("EGL surfaceless: ", what), Exit::cannot_write);
}

class EglContext final : public Context {
public:
    EglContext() {
        display_ = library_.find<Display(unsigned, void*, const std::intptr_t*)>("eglGetPlatformDisplay")(
            platform_surfaceless_mesa, nullptr, nullptr);
        require(display_ != nullptr, "no such platform");
        require(library_.find<unsigned(Display, std::int32_t*, std::int32_t*)>("eglInitialize")(
                    display_, nullptr, nullptr),
                "display does not initialise");
        require(library_.find<unsigned(unsigned)>("eglBindAPI")(opengl_api), "no desktop OpenGL");
        const std::array<std::int32_t, 5> any = {surface_type, 0, renderable_type, opengl_bit, none};
        Config config = nullptr;
        std::int32_t found = 0;
        require(library_.find<unsigned(Display, const std::int32_t*, Config*, std::int32_t, std::int32_t*)>(
                    "eglChooseConfig")(display_, any.data(), &config, 1, &found) &&
                    found == 1,
                "no configuration");
        const std::array<std::int32_t, 7> wanted = {major_version, 4,   minor_version, 5, profile_mask,
                                                    core_profile,  none};
        context_ = library_.find<Handle(Display, Config, Handle, const std::int32_t*)>("eglCreateContext")(
            display_, config, nullptr, wanted.data());
        require(context_ != nullptr, "no OpenGL 4.5 core context");
    }
    ~EglContext() override {
        release_();
        library_.find<unsigned(Display, Handle)>("eglDestroyContext")(display_, context_);
    }

    void make_current() override {
        require(make_current_(display_, nullptr, nullptr, context_), "context cannot be made current");
    }
    Procedure procedure(const char* name) const override { return procedure_(name); }

private:
    // leaves the thread without a context only if ours is the one it has
    void release_() {
        if (library_.find<Handle()>("eglGetCurrentContext")() == context_)
            make_current_(display_, nullptr, nullptr, nullptr);
    }

    SharedLibrary library_{"libEGL.so.1", "EGL is not installed: Debian package libegl1, or use OSMesa"};
    Display display_ = nullptr;
    Handle context_ = nullptr;
    unsigned (*make_current_)(Display, Handle, Handle, Handle) =
        library_.find<unsigned(Display, Handle, Handle, Handle)>("eglMakeCurrent");
    Procedure (*procedure_)(const char*) = library_.find<Procedure(const char*)>("eglGetProcAddress");
};

}  // namespace

std::unique_ptr<Context> make_egl_context() {
    return std::make_unique<EglContext>();
}

}  // namespace drape

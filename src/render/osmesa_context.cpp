// OSMesa: Mesa's software rasteriser as a plain library, needing neither display, device nor driver files.
// Opened at run time: loading it, with the LLVM in it, takes longer than all else that `drape --help` does.
#include <GL/osmesa.h>

#include <array>

#include "base/error.h"
#include "render/context.h"
#include "render/shared_library.h"

namespace drape {

namespace {

class OsmesaContext final : public Context {
public:
    OsmesaContext() {
        const std::array<int, 13> wanted = {OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_PROFILE,
                                            OSMESA_CORE_PROFILE,
                                            OSMESA_CONTEXT_MAJOR_VERSION,
                                            4,
                                            OSMESA_CONTEXT_MINOR_VERSION,
                                            5,
                                            OSMESA_DEPTH_BITS,
                                            0,
                                            OSMESA_STENCIL_BITS,
                                            0,
                                            0};
        context_ = library_.find<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs")(
            wanted.data(), nullptr);
        if (!context_) throw Error("OSMesa has no OpenGL 4.5 core context to offer", Exit::cannot_write);
    }
    ~OsmesaContext() override { destroy_(context_); }

    void make_current() override {
        if (!make_current_(context_, window_.data(), GL_UNSIGNED_BYTE, 1, 1))
            throw Error("OSMesa cannot make its context current", Exit::cannot_write);
    }
    Procedure procedure(const char* name) const override { return procedure_(name); }

private:
    SharedLibrary library_{"libOSMesa.so.8", "Debian package libosmesa6"};
    decltype(OSMesaDestroyContext)* destroy_ =
        library_.find<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext");
    decltype(OSMesaMakeCurrent)* make_current_ =
        library_.find<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    decltype(OSMesaGetProcAddress)* procedure_ =
        library_.find<decltype(OSMesaGetProcAddress)>("OSMesaGetProcAddress");
    OSMesaContext context_ = nullptr;
    std::array<unsigned char, 4> window_{};  // OSMesa wants a window to draw in; we never do
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context() {
    return std::make_unique<OsmesaContext>();
}

}  // namespace drape

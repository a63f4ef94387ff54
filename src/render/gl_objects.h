// Owners of GL objects: what the renderer needs of buffers, textures and framebuffers, no more.
// All outlive neither their Gl table nor its context.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

#include "render/gl.h"

namespace drape {

// A GL name with the function that frees it.
class GlName {
public:
    using Delete = void(APIENTRYP)(GLsizei, const GLuint*);

    GlName() = default;
    GlName(GLuint name, Delete free) : name_(name), free_(free) {}
    ~GlName() {
        if (name_) free_(1, &name_);
    }
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)), free_(other.free_) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(free_, other.free_);
        return *this;
    }
    operator GLuint() const { return name_; }

private:
    GLuint name_ = 0;
    Delete free_ = nullptr;
};

// A buffer whose content is replaced as a whole.
class Buffer {
public:
    Buffer() = default;
    explicit Buffer(const Gl& gl);
    template <class T>
    void fill(const Gl& gl, const std::vector<T>& values, GLenum usage = GL_STREAM_DRAW) {
        fill_bytes(gl, values.data(), values.size() * sizeof(T), usage);
    }
    void fill_bytes(const Gl& gl, const void* data, std::size_t bytes, GLenum usage);
    operator GLuint() const { return name_; }

private:
    GlName name_;
};

// One attribute of a vertex: `floats` floats every `stride` bytes from `offset` in a buffer.
struct Attribute {
    GLuint location;
    const Buffer* buffer;
    int floats;
    int stride = 0;  // 0: tightly packed
    int offset = 0;
    bool per_instance = false;
};

GlName make_vertex_array(const Gl& gl, std::initializer_list<Attribute> attributes,
                         const Buffer* indices = nullptr);

struct TextureSize {
    int width, height, samples = 1;
};

// Nearest filtering, clamped to the edge.
GlName make_texture(const Gl& gl, GLenum format, TextureSize size);

// Throws Error (Exit::cannot_write) if the driver refuses the combination. 0 stands for "none".
GlName make_framebuffer(const Gl& gl, GLuint colour, GLuint depth);

}  // namespace drape

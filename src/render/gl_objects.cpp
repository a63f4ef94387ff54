#include "render/gl_objects.h"

#include "base/error.h"

namespace drape {

Buffer::Buffer(const Gl& gl) {
    GLuint name = 0;
    gl.CreateBuffers(1, &name);
    name_ = GlName(name, gl.DeleteBuffers);
}

void Buffer::fill_bytes(const Gl& gl, const void* data, std::size_t bytes, GLenum usage) {
    gl.NamedBufferData(name_, static_cast<GLsizeiptr>(bytes), data, usage);
}

GlName make_vertex_array(const Gl& gl, std::initializer_list<Attribute> attributes, const Buffer* indices) {
    GLuint name = 0;
    gl.CreateVertexArrays(1, &name);
    for (const Attribute& attribute : attributes) {
        const int stride =
            attribute.stride ? attribute.stride : attribute.floats * static_cast<int>(sizeof(float));
        gl.EnableVertexArrayAttrib(name, attribute.location);
        gl.VertexArrayVertexBuffer(name, attribute.location, *attribute.buffer, attribute.offset, stride);
        gl.VertexArrayAttribFormat(name, attribute.location, attribute.floats, GL_FLOAT, GL_FALSE, 0);
        gl.VertexArrayAttribBinding(name, attribute.location, attribute.location);
        gl.VertexArrayBindingDivisor(name, attribute.location, attribute.per_instance ? 1 : 0);
    }
    if (indices) gl.VertexArrayElementBuffer(name, *indices);
    return {name, gl.DeleteVertexArrays};
}

GlName make_texture(const Gl& gl, GLenum format, TextureSize size) {
    GLuint name = 0;
    if (size.samples > 1) {
        gl.CreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &name);
        gl.TextureStorage2DMultisample(name, size.samples, format, size.width, size.height, GL_TRUE);
    } else {
        gl.CreateTextures(GL_TEXTURE_2D, 1, &name);
        gl.TextureStorage2D(name, 1, format, size.width, size.height);
        gl.TextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl.TextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl.TextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    gl.check(cat("making a texture of ", size.width, " x ", size.height, " pixels"));
    return {name, gl.DeleteTextures};
}

GlName make_framebuffer(const Gl& gl, GLuint colour, GLuint depth) {
    GLuint name = 0;
    gl.CreateFramebuffers(1, &name);
    GlName framebuffer(name, gl.DeleteFramebuffers);
    if (colour) gl.NamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, colour, 0);
    if (depth) gl.NamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth, 0);
    if (!colour) {
        gl.NamedFramebufferDrawBuffer(name, GL_NONE);
        gl.NamedFramebufferReadBuffer(name, GL_NONE);
    }
    if (gl.CheckNamedFramebufferStatus(name, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error("OpenGL driver cannot draw into the textures asked for", Exit::cannot_write);
    return framebuffer;
}

}  // namespace drape

// The OpenGL entry points that the renderer calls, as a table loaded through the context's own resolver.
// A loader library would resolve them through libGL, which draws nothing under OSMesa.
// Private to this folder: the only header that speaks GL.
#pragma once

#include <GL/glcorearb.h>

#include <string>

#include "render/context.h"

namespace drape {

// name without "gl", for every function used; the type is PFNGL<NAME>PROC, spelt by the second word
#define DRAPE_GL_FUNCTIONS(X)                                   \
    X(AttachShader, ATTACHSHADER)                               \
    X(BindBufferBase, BINDBUFFERBASE)                           \
    X(BindFramebuffer, BINDFRAMEBUFFER)                         \
    X(BindTextureUnit, BINDTEXTUREUNIT)                         \
    X(BindVertexArray, BINDVERTEXARRAY)                         \
    X(BlendFuncSeparate, BLENDFUNCSEPARATE)                     \
    X(CheckNamedFramebufferStatus, CHECKNAMEDFRAMEBUFFERSTATUS) \
    X(ClearNamedFramebufferfv, CLEARNAMEDFRAMEBUFFERFV)         \
    X(ClearNamedFramebufferuiv, CLEARNAMEDFRAMEBUFFERUIV)       \
    X(CompileShader, COMPILESHADER)                             \
    X(CopyImageSubData, COPYIMAGESUBDATA)                       \
    X(CreateBuffers, CREATEBUFFERS)                             \
    X(CreateFramebuffers, CREATEFRAMEBUFFERS)                   \
    X(CreateProgram, CREATEPROGRAM)                             \
    X(CreateShader, CREATESHADER)                               \
    X(CreateTextures, CREATETEXTURES)                           \
    X(CreateVertexArrays, CREATEVERTEXARRAYS)                   \
    X(DeleteBuffers, DELETEBUFFERS)                             \
    X(DeleteFramebuffers, DELETEFRAMEBUFFERS)                   \
    X(DeleteProgram, DELETEPROGRAM)                             \
    X(DeleteShader, DELETESHADER)                               \
    X(DeleteTextures, DELETETEXTURES)                           \
    X(DeleteVertexArrays, DELETEVERTEXARRAYS)                   \
    X(DepthFunc, DEPTHFUNC)                                     \
    X(DepthMask, DEPTHMASK)                                     \
    X(Disable, DISABLE)                                         \
    X(DrawArrays, DRAWARRAYS)                                   \
    X(DrawArraysInstanced, DRAWARRAYSINSTANCED)                 \
    X(DrawElements, DRAWELEMENTS)                               \
    X(Enable, ENABLE)                                           \
    X(EnableVertexArrayAttrib, ENABLEVERTEXARRAYATTRIB)         \
    X(Finish, FINISH)                                           \
    X(GetError, GETERROR)                                       \
    X(GetIntegerv, GETINTEGERV)                                 \
    X(GetProgramInfoLog, GETPROGRAMINFOLOG)                     \
    X(GetProgramiv, GETPROGRAMIV)                               \
    X(GetShaderInfoLog, GETSHADERINFOLOG)                       \
    X(GetShaderiv, GETSHADERIV)                                 \
    X(GetString, GETSTRING)                                     \
    X(GetUniformLocation, GETUNIFORMLOCATION)                   \
    X(LinkProgram, LINKPROGRAM)                                 \
    X(NamedBufferData, NAMEDBUFFERDATA)                         \
    X(NamedFramebufferDrawBuffer, NAMEDFRAMEBUFFERDRAWBUFFER)   \
    X(NamedFramebufferReadBuffer, NAMEDFRAMEBUFFERREADBUFFER)   \
    X(NamedFramebufferTexture, NAMEDFRAMEBUFFERTEXTURE)         \
    X(PixelStorei, PIXELSTOREI)                                 \
    X(ProgramUniform1f, PROGRAMUNIFORM1F)                       \
    X(ProgramUniform1i, PROGRAMUNIFORM1I)                       \
    X(ProgramUniform2f, PROGRAMUNIFORM2F)                       \
    X(ProgramUniform3f, PROGRAMUNIFORM3F)                       \
    X(ProgramUniformMatrix4fv, PROGRAMUNIFORMMATRIX4FV)         \
    X(ReadPixels, READPIXELS)                                   \
    X(Scissor, SCISSOR)                                         \
    X(ShaderSource, SHADERSOURCE)                               \
    X(TextureParameteri, TEXTUREPARAMETERI)                     \
    X(TextureStorage2D, TEXTURESTORAGE2D)                       \
    X(TextureStorage2DMultisample, TEXTURESTORAGE2DMULTISAMPLE) \
    X(TextureSubImage2D, TEXTURESUBIMAGE2D)                     \
    X(UseProgram, USEPROGRAM)                                   \
    X(VertexArrayAttribBinding, VERTEXARRAYATTRIBBINDING)       \
    X(VertexArrayAttribFormat, VERTEXARRAYATTRIBFORMAT)         \
    X(VertexArrayBindingDivisor, VERTEXARRAYBINDINGDIVISOR)     \
    X(VertexArrayElementBuffer, VERTEXARRAYELEMENTBUFFER)       \
    X(VertexArrayVertexBuffer, VERTEXARRAYVERTEXBUFFER)         \
    X(Viewport, VIEWPORT)

struct Gl {
#define DRAPE_GL_MEMBER(name, type) PFNGL##type##PROC name = nullptr;
    DRAPE_GL_FUNCTIONS(DRAPE_GL_MEMBER)
#undef DRAPE_GL_MEMBER

    // `context` is current. Throws Error (Exit::cannot_write) naming a function the driver lacks.
    explicit Gl(const Context& context);

    // Throws Error (Exit::cannot_write) naming `doing` if GL has recorded an error since the last call.
    void check(const std::string& doing) const;
};

}  // namespace drape

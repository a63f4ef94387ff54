// Shader programs from the files of shaders/, which the build embeds.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/points.h"
#include "render/gl.h"

namespace drape {

struct ShaderFile {
    std::string_view name, text;
};

// The embedded file called `name`, such as "cloth.frag".
ShaderFile shader_file(std::string_view name);

class Program {
public:
    // Each stage is its files one after the other; common declarations first. Throws Error
    // (Exit::cannot_write) "shaders/FILE:LINE: ..." if one does not compile or they do not fit together.
    Program(const Gl& gl, const std::vector<ShaderFile>& vertex, const std::vector<ShaderFile>& fragment);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { gl_.UseProgram(name_); }
    // Uniforms by name; one that the driver optimised away is ignored.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const Eigen::Vector2f& value) const;
    void set(const char* uniform, const Eigen::Vector3f& value) const;
    void set(const char* uniform, const Eigen::Matrix4f& value) const;

private:
    const Gl& gl_;
    GLuint name_ = 0;
};

}  // namespace drape

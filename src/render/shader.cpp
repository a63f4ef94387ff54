#include "render/shader.h"

#include <algorithm>
#include <array>
#include <regex>

#include "base/error.h"
#include "render/shader_table.h"

namespace drape {

namespace {

// Mesa forgets #line's file number in most messages, so each file starts at a line of its own: file i at
// i * lines_per_file + 1.
constexpr size_t lines_per_file = 10000;

// "shaders/FILE:LINE:COLUMN: what is wrong" from "0:LINE(COLUMN): error: what is wrong".
std::string readable_log(const std::string& log, const std::vector<ShaderFile>& files) {
    std::smatch place;
    if (!std::regex_search(log, place, std::regex(R"(\d+:(\d+)\((\d+)\): [a-z ]*error: ([^\n]*))")))
        return log;
    const size_t line = std::stoul(place[1]), file = std::min(line / lines_per_file, files.size() - 1);
    return cat("shaders/", files[file].name, ":", line - file * lines_per_file, ":", place[2].str(), ": ",
               place[3].str());
}

GLuint compile(const Gl& gl, GLenum stage, const std::vector<ShaderFile>& files) {
    std::string text = "#version 450 core\n";
    for (size_t i = 0; i < files.size(); ++i)
        text += cat("#line ", i * lines_per_file + 1, "\n") + std::string(files[i].text) + "\n";
    const GLuint shader = gl.CreateShader(stage);
    const char* source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint compiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    std::array<char, 4096> log{};
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    gl.DeleteShader(shader);
    throw Error(readable_log(log.data(), files), Exit::cannot_write);
}

}  // namespace

ShaderFile shader_file(std::string_view name) {
    for (const ShaderFile& file : shader_table())
        if (file.name == name) return file;
    throw Error(cat("shaders/", name, ": no such shader was built in"), Exit::cannot_write);
}

Program::Program(const Gl& gl, const std::vector<ShaderFile>& vertex, const std::vector<ShaderFile>& fragment)
    : gl_(gl) {
    const GLuint vertex_shader = compile(gl, GL_VERTEX_SHADER, vertex);
    GLuint fragment_shader = 0;
    try {
        fragment_shader = compile(gl, GL_FRAGMENT_SHADER, fragment);
    } catch (...) {
        gl.DeleteShader(vertex_shader);
        throw;
    }
    name_ = gl.CreateProgram();
    gl.AttachShader(name_, vertex_shader);
    gl.AttachShader(name_, fragment_shader);
    gl.LinkProgram(name_);
    gl.DeleteShader(vertex_shader);
    gl.DeleteShader(fragment_shader);
    GLint linked = 0;
    gl.GetProgramiv(name_, GL_LINK_STATUS, &linked);
    if (linked) return;
    std::array<char, 4096> log{};
    gl.GetProgramInfoLog(name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    gl.DeleteProgram(name_);
    throw Error(cat("shaders/", vertex.back().name, " and shaders/", fragment.back().name, ": ", log.data()),
                Exit::cannot_write);
}

Program::~Program() {
    gl_.DeleteProgram(name_);
}

void Program::set(const char* uniform, int value) const {
    gl_.ProgramUniform1i(name_, gl_.GetUniformLocation(name_, uniform), value);
}

void Program::set(const char* uniform, float value) const {
    gl_.ProgramUniform1f(name_, gl_.GetUniformLocation(name_, uniform), value);
}

void Program::set(const char* uniform, const Eigen::Vector2f& value) const {
    gl_.ProgramUniform2f(name_, gl_.GetUniformLocation(name_, uniform), value.x(), value.y());
}

void Program::set(const char* uniform, const Eigen::Vector3f& value) const {
    gl_.ProgramUniform3f(name_, gl_.GetUniformLocation(name_, uniform), value.x(), value.y(), value.z());
}

void Program::set(const char* uniform, const Eigen::Matrix4f& value) const {
    gl_.ProgramUniformMatrix4fv(name_, gl_.GetUniformLocation(name_, uniform), 1, GL_FALSE, value.data());
}

}  // namespace drape

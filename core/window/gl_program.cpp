#include "core/window/gl_program.h"

#include <epoxy/gl.h>

#include <array>

#include "core/base/error.h"

namespace seesaw::detail {

namespace {

unsigned compiled(GLenum stage, const std::string& source) {
  const std::string text = "#version 330 core\n" + source;
  const char* const start = text.c_str();
  const unsigned shader = glCreateShader(stage);
  glShaderSource(shader, 1, &start, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  std::array<char, 2048> words = {};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), nullptr, words.data());
  glDeleteShader(shader);
  throw Error(std::string("the graphics driver refuses a shader: ") + words.data());
}

}  // namespace

GlProgram::GlProgram(const std::string& vertex, const std::string& geometry, const std::string& fragment)
    : name_(glCreateProgram()) {
  for (const auto& [stage, source] : {std::pair<GLenum, const std::string&>(GL_VERTEX_SHADER, vertex),
                                      {GL_GEOMETRY_SHADER, geometry},
                                      {GL_FRAGMENT_SHADER, fragment}}) {
    if (source.empty()) continue;
    const unsigned shader = compiled(stage, source);
    glAttachShader(name_, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(name_);
  GLint good = 0;
  glGetProgramiv(name_, GL_LINK_STATUS, &good);
  if (good) return;
  std::array<char, 2048> words = {};
  glGetProgramInfoLog(name_, static_cast<GLsizei>(words.size()), nullptr, words.data());
  glDeleteProgram(name_);
  throw Error(std::string("the graphics driver refuses a program: ") + words.data());
}

GlProgram::~GlProgram() { glDeleteProgram(name_); }

void GlProgram::use() const { glUseProgram(name_); }

void GlProgram::set(const char* name, double value) const {
  glUniform1f(glGetUniformLocation(name_, name), static_cast<float>(value));
}
void GlProgram::set(const char* name, double x, double y) const {
  glUniform2f(glGetUniformLocation(name_, name), static_cast<float>(x), static_cast<float>(y));
}
void GlProgram::set(const char* name, double x, double y, double z, double w) const {
  glUniform4f(glGetUniformLocation(name_, name), static_cast<float>(x), static_cast<float>(y),
              static_cast<float>(z), static_cast<float>(w));
}
void GlProgram::set(const char* name, const Eigen::Matrix4d& matrix) const {
  const Eigen::Matrix4f floats = matrix.cast<float>();
  glUniformMatrix4fv(glGetUniformLocation(name_, name), 1, GL_FALSE, floats.data());
}

}  // namespace seesaw::detail

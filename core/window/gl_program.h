// Inside core/window: a program that runs on the graphics card.
//
// Before it: GLSL 3.30 in a string. After it: view_3d.cpp.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>

namespace seesaw::detail {

class GlProgram {
 public:
  /// Stages in GLSL without their #version line; `geometry` may be empty. Throws Error with the compiler's
  /// words.
  GlProgram(const std::string& vertex, const std::string& geometry, const std::string& fragment);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  // Of the program in use; a name that it does not have is ignored, as OpenGL does.
  void set(const char* name, double value) const;
  void set(const char* name, double x, double y) const;
  void set(const char* name, double x, double y, double z, double w) const;
  void set(const char* name, const Eigen::Matrix4d& matrix) const;

 private:
  unsigned name_ = 0;
};

}  // namespace seesaw::detail

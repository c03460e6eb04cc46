#pragma once

namespace groundgrid::rendering {

/// A linked OpenGL program. Needs a current context all its life.
class ShaderProgram {
 public:
  /// Sources are GLSL 3.30. Throws std::runtime_error with OpenGL's words where they do not work.
  ShaderProgram(const char* vertex_source, const char* fragment_source);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;
  ShaderProgram(ShaderProgram&&) = delete;
  ShaderProgram& operator=(ShaderProgram&&) = delete;

  /// The following calls and drawings are about it.
  void use() const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, int value) const;
  /// Sixteen numbers, column by column.
  void set_matrix(const char* uniform, const float* values) const;

 private:
  unsigned int id_;
};

}  // namespace groundgrid::rendering

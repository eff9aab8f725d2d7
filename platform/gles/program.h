#pragma once

#include <array>
#include <initializer_list>
#include <string_view>

#include "platform/gles/gl_names.h"
#include "runtime/model/result.h"
#include "runtime/scene/draw_list.h"

namespace docent::gles {

/// Texture units. Each sampler is bound to the unit of its name, once, when its program is linked.
enum class Unit : GLuint { Image, LightMap, ShadeMap, ShadowAtlas, WallLevels };

/// Binding points of the uniform blocks.
enum class Block : GLuint { Frame, Avatars, Looks };

/// A linked program.
class Program {
 public:
  Program() = default;
  explicit Program(GlProgram program) noexcept : program_(std::move(program)) {}

  void use() const noexcept { glUseProgram(program_.get()); }
  /// The location of a uniform; -1, which `set` ignores, where the shader does without it.
  GLint operator[](const char* uniform) const noexcept {
    return glGetUniformLocation(program_.get(), uniform);
  }

 private:
  GlProgram program_;
};

/// Compiles and links the pieces; each stage is its pieces in order. `name` is for the message.
Result<Program> link_program(std::string_view name, std::initializer_list<std::string_view> vertex,
                             std::initializer_list<std::string_view> fragment);

inline void set(GLint uniform, const scene::Colour& c) noexcept {
  glUniform4f(uniform, c.r, c.g, c.b, c.a);
}

}  // namespace docent::gles

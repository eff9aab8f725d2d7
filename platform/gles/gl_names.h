#pragma once

#include <GLES3/gl3.h>

#include <utility>

namespace docent::gles {

/// Owns an OpenGL name; the deleting function is part of the type.
template <void (*remove)(GLuint) noexcept>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) noexcept : name_(name) {}
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlName() {
    if (name_ != 0) remove(name_);
  }
  GLuint get() const noexcept { return name_; }
  explicit operator bool() const noexcept { return name_ != 0; }

 private:
  GLuint name_ = 0;
};

namespace gl_remove {
inline void buffer(GLuint name) noexcept {
  glDeleteBuffers(1, &name);
}
inline void texture(GLuint name) noexcept {
  glDeleteTextures(1, &name);
}
inline void vertex_array(GLuint name) noexcept {
  glDeleteVertexArrays(1, &name);
}
inline void framebuffer(GLuint name) noexcept {
  glDeleteFramebuffers(1, &name);
}
inline void renderbuffer(GLuint name) noexcept {
  glDeleteRenderbuffers(1, &name);
}
inline void program(GLuint name) noexcept {
  glDeleteProgram(name);
}
inline void shader(GLuint name) noexcept {
  glDeleteShader(name);
}
}  // namespace gl_remove

using GlBuffer = GlName<gl_remove::buffer>;
using GlTexture = GlName<gl_remove::texture>;
using GlVertexArray = GlName<gl_remove::vertex_array>;
using GlFramebuffer = GlName<gl_remove::framebuffer>;
using GlRenderbuffer = GlName<gl_remove::renderbuffer>;
using GlProgram = GlName<gl_remove::program>;
using GlShader = GlName<gl_remove::shader>;

inline GlBuffer make_buffer() noexcept {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return GlBuffer(name);
}
inline GlTexture make_texture() noexcept {
  GLuint name = 0;
  glGenTextures(1, &name);
  return GlTexture(name);
}
inline GlVertexArray make_vertex_array() noexcept {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return GlVertexArray(name);
}
inline GlFramebuffer make_framebuffer() noexcept {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return GlFramebuffer(name);
}
inline GlRenderbuffer make_renderbuffer() noexcept {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  return GlRenderbuffer(name);
}

/// Binds a texture to a unit.
inline void bind_texture(GLuint unit, GLuint texture) noexcept {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
}

/// glVertexAttribPointer's offset is a pointer by heritage.
inline const void* buffer_offset(std::size_t bytes) noexcept {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace docent::gles

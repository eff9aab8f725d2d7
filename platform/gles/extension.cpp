#include "platform/gles/extension.h"

#include <GLES3/gl3.h>

namespace docent::gles {

bool has_extension(std::string_view name) noexcept {
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i)
    if (const auto* one = glGetStringi(GL_EXTENSIONS, i);
        one != nullptr && name == reinterpret_cast<const char*>(one))
      return true;
  return false;
}

bool can_shaders_encode() noexcept {
  return has_extension("GL_EXT_sRGB_write_control");
}

bool can_read_encoded() noexcept {
  return has_extension("GL_EXT_texture_sRGB_decode");
}

}  // namespace docent::gles

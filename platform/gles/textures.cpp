#include "platform/gles/textures.h"

#include <utility>

namespace docent::gles {
namespace {

void sample_with(GLint smaller, GLint larger) noexcept {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, smaller);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, larger);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

Textures::Textures() : entries_(most) {}

void Textures::keep(scene::TextureId id, GlTexture texture, std::uint32_t width,
                    std::uint32_t height) noexcept {
  const auto slot = static_cast<std::size_t>(id) - 1;  // None wraps beyond the end
  if (slot < entries_.size()) entries_[slot] = {std::move(texture), width, height};
}

void Textures::add_text(scene::TextureId id, std::uint32_t width, std::uint32_t height,
                        std::span<const std::uint8_t> coverage) noexcept {
  if (width == 0 || height == 0 || coverage.size() < std::size_t{width} * height) return;
  GlTexture texture = make_texture();
  bind_texture(0, texture.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_R8, static_cast<GLsizei>(width),
                 static_cast<GLsizei>(height));
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height),
                  GL_RED, GL_UNSIGNED_BYTE, coverage.data());
  sample_with(GL_NEAREST, GL_NEAREST);
  keep(id, std::move(texture), width, height);
}

void Textures::add_image(scene::TextureId id, std::span<const Pixels> levels) noexcept {
  if (levels.empty() || levels[0].rgba.empty()) return;
  GlTexture texture = make_texture();
  bind_texture(0, texture.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexStorage2D(GL_TEXTURE_2D, static_cast<GLsizei>(levels.size()), GL_SRGB8_ALPHA8,
                 static_cast<GLsizei>(levels[0].width), static_cast<GLsizei>(levels[0].height));
  // The driver could make them (glGenerateMipmap), but a software one draws for that, and waits.
  for (std::size_t level = 0; level < levels.size(); ++level)
    glTexSubImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), 0, 0,
                    static_cast<GLsizei>(levels[level].width),
                    static_cast<GLsizei>(levels[level].height), GL_RGBA, GL_UNSIGNED_BYTE,
                    levels[level].rgba.data());
  sample_with(levels.size() > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR, GL_LINEAR);
  keep(id, std::move(texture), levels[0].width, levels[0].height);
}

void Textures::replace_image(scene::TextureId id, const Pixels& picture) noexcept {
  const Entry* entry = find(id);
  if (entry == nullptr || picture.rgba.empty() || entry->width != picture.width ||
      entry->height != picture.height)
    return;
  bind_texture(0, entry->texture.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(picture.width),
                  static_cast<GLsizei>(picture.height), GL_RGBA, GL_UNSIGNED_BYTE,
                  picture.rgba.data());
}

void Textures::release(scene::TextureId id) noexcept {
  keep(id, {}, 0, 0);
}

const Textures::Entry* Textures::find(scene::TextureId id) const noexcept {
  const auto slot = static_cast<std::size_t>(id) - 1;  // None wraps beyond the end
  if (slot >= entries_.size() || !entries_[slot].texture) return nullptr;
  return &entries_[slot];
}

}  // namespace docent::gles

#include "platform/gles/scene_buffer.h"

#include <algorithm>

#include "platform/gles/extension.h"

namespace docent::gles {

SceneBuffer::SceneBuffer(std::uint32_t samples, std::size_t most_bytes) noexcept
    : most_bytes_(most_bytes) {
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  samples_ = samples > 1 ? std::min(static_cast<GLint>(samples), most) : 0;
}

void SceneBuffer::fit(PixelSize picture) noexcept {
  if (picture == picture_ || picture.width == 0 || picture.height == 0) return;
  picture_ = picture;
  constexpr std::size_t bytes_a_sample = 8;  // colour and depth
  const std::size_t row =
      bytes_a_sample * picture.width * static_cast<std::size_t>(std::max(samples_, 1));
  const std::size_t rows =
      std::clamp<std::size_t>(most_bytes_ / row, 64, std::max(64U, picture.height));
  strips_ = static_cast<std::uint32_t>((picture.height + rows - 1) / rows);
  strip_height_ = (picture.height + strips_ - 1) / strips_;

  const auto width = static_cast<GLsizei>(picture.width);
  const auto height = static_cast<GLsizei>(strip_height_);
  colour_ = make_renderbuffer();
  glBindRenderbuffer(GL_RENDERBUFFER, colour_.get());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_SRGB8_ALPHA8, width, height);
  depth_ = make_renderbuffer();
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.get());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, width, height);
  framebuffer_ = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.get());
  if (strips_ == 1 || samples_ == 0) return;
  resolved_ = make_renderbuffer();
  glBindRenderbuffer(GL_RENDERBUFFER, resolved_.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_SRGB8_ALPHA8, width, height);
  resolved_framebuffer_ = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_framebuffer_.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolved_.get());
}

Region SceneBuffer::part(std::uint32_t strip, const Region& of) const noexcept {
  const auto from = static_cast<GLint>(strip * strip_height_);
  const auto to = static_cast<GLint>(std::min(picture_.height, (strip + 1) * strip_height_));
  return {of.left, std::max(of.low, from), of.right, std::min(of.high, to)};
}

void SceneBuffer::begin(std::uint32_t strip, const Region& part) const noexcept {
  const auto from = static_cast<GLint>(strip * strip_height_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glViewport(0, -from, static_cast<GLsizei>(picture_.width), static_cast<GLsizei>(picture_.height));
  glScissor(part.left, part.low - from, part.right - part.left, part.high - part.low);
}

void SceneBuffer::hide(std::uint32_t strip, const Region& part,
                       const Region& hidden) const noexcept {
  const auto from = static_cast<GLint>(strip * strip_height_);
  const auto only = [&](const Region& of) {
    glScissor(of.left, of.low - from, of.right - of.left, of.high - of.low);
  };
  const Region here = common(part, hidden);
  if (here.is_empty()) return;
  only(here);
  glClearDepthf(0);
  glClear(GL_DEPTH_BUFFER_BIT);
  glClearDepthf(1);
  only(part);
}

SceneBuffer::Rows SceneBuffer::rows(const Region& part) const noexcept {
  const auto edge = [&](GLint y) {
    return 2 * static_cast<float>(y) / static_cast<float>(picture_.height) - 1;
  };
  return {edge(part.low), edge(part.high)};
}

void SceneBuffer::resolve(std::uint32_t strip, const Region& part,
                          GLuint framebuffer) const noexcept {
  const auto from = static_cast<GLint>(strip * strip_height_);
  const auto blit = [&](GLuint source, GLuint destination, GLint moved) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, destination);
    glBlitFramebuffer(part.left, part.low - from, part.right, part.high - from, part.left,
                      part.low - from + moved, part.right, part.high - from + moved,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
  };
  glDisable(GL_SCISSOR_TEST);  // which would cut where the part is copied to
  // OpenGL ES resolves samples only between equal rectangles (3.0, section 4.3.3), so the strip
  // takes its place in the picture by a second copy.
  const bool moves = from != 0 && samples_ > 0;
  if (moves) blit(framebuffer_.get(), resolved_framebuffer_.get(), 0);
  blit(moves ? resolved_framebuffer_.get() : framebuffer_.get(), framebuffer, from);
  constexpr GLenum forget[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.get());
  glInvalidateFramebuffer(GL_READ_FRAMEBUFFER, 2, forget);
}

void Picture::fit(PixelSize size) noexcept {
  if (size == size_) return;
  size_ = size;
  texture_ = make_texture();
  bind_texture(0, texture_.get());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_SRGB8_ALPHA8, static_cast<GLsizei>(size.width),
                 static_cast<GLsizei>(size.height));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  if (read_ == Read::Encoded) glTexParameteri(GL_TEXTURE_2D, texture_decodes, reads_encoded);
  framebuffer_ = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.get(), 0);
}

}  // namespace docent::gles

#include "platform/gles/read_back.h"

#include <GLES3/gl3.h>

namespace docent::gles {

void ReadBack::begin(std::uint32_t framebuffer, PixelSize size) noexcept {
  end();
  size_ = size;
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_);
  const auto bytes = static_cast<GLsizeiptr>(std::size_t{4} * size.width * size.height);
  glBufferData(GL_PIXEL_PACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glReadPixels(0, 0, static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height), GL_RGBA,
               GL_UNSIGNED_BYTE, nullptr);
  drawn_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

std::span<const std::byte> ReadBack::take() noexcept {
  if (buffer_ == 0 || !pixels_.empty()) return pixels_;
  const GLenum come = glClientWaitSync(static_cast<GLsync>(drawn_), 0, 0);
  if (come != GL_ALREADY_SIGNALED && come != GL_CONDITION_SATISFIED) return {};
  const std::size_t bytes = std::size_t{4} * size_.width * size_.height;
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_);
  const void* mapped =
      glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  if (mapped != nullptr) pixels_ = {static_cast<const std::byte*>(mapped), bytes};
  return pixels_;
}

void ReadBack::end() noexcept {
  if (buffer_ == 0) return;
  glDeleteSync(static_cast<GLsync>(drawn_));
  glDeleteBuffers(1, &buffer_);  // unmaps it
  buffer_ = 0;
  pixels_ = {};
}

}  // namespace docent::gles

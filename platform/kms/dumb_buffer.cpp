#include "platform/kms/dumb_buffer.h"

#include <drm_fourcc.h>
#include <sys/mman.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cstddef>

namespace docent::kms {
namespace {

/// XRGB8888: blue, green, red and a byte of nothing.
void write_rows(const Pixels& picture, std::byte* out, std::uint32_t stride) noexcept {
  const std::byte* pixel = picture.rgba.data();
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    std::byte* to = out + std::size_t{y} * stride;
    for (std::uint32_t x = 0; x < picture.width; ++x, pixel += 4, to += 4) {
      to[0] = pixel[2];
      to[1] = pixel[1];
      to[2] = pixel[0];
      to[3] = std::byte{0};
    }
  }
}

}  // namespace

std::optional<DumbBuffer> DumbBuffer::holding(int fd, const Pixels& picture) {
  constexpr std::uint32_t bits = 32;
  std::uint32_t handle = 0, stride = 0;
  std::uint64_t size = 0;
  if (drmModeCreateDumbBuffer(fd, picture.width, picture.height, bits, 0, &handle, &stride,
                              &size) != 0)
    return std::nullopt;
  DumbBuffer buffer(fd, handle);
  std::uint64_t offset = 0;
  if (drmModeMapDumbBuffer(fd, handle, &offset) != 0) return std::nullopt;
  void* const mapped =
      mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, fd, static_cast<off_t>(offset));
  if (mapped == MAP_FAILED) return std::nullopt;
  write_rows(picture, static_cast<std::byte*>(mapped), stride);
  munmap(mapped, size);
  const std::uint32_t handles[4] = {handle}, strides[4] = {stride}, offsets[4] = {};
  if (drmModeAddFB2(fd, picture.width, picture.height, DRM_FORMAT_XRGB8888, handles, strides,
                    offsets, &buffer.framebuffer_, 0) != 0)
    return std::nullopt;
  return buffer;
}

DumbBuffer::~DumbBuffer() {
  if (framebuffer_ != 0) drmModeRmFB(fd_, framebuffer_);
  if (handle_ != 0) drmModeDestroyDumbBuffer(fd_, handle_);
}

}  // namespace docent::kms

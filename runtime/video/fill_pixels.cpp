#include "runtime/video/fill_pixels.h"

#include <algorithm>

namespace docent::video {
namespace {

/// Conversion to red, green and blue in 1/65536: ITU-R BT.601-7 and BT.709-6, section 3.
struct Matrix {
  int brightness, red_of_v, green_of_u, green_of_v, blue_of_u, black;
};
constexpr Matrix bt601{76309, 104597, 25675, 53279, 132201, 16};
constexpr Matrix bt601_full{65536, 91881, 22554, 46802, 116130, 0};
constexpr Matrix bt709{76309, 117489, 13975, 34925, 138438, 16};
constexpr Matrix bt709_full{65536, 103206, 12276, 30679, 121609, 0};

const Matrix& matrix_of(const Planes& planes) noexcept {
  if (planes.is_bt709) return planes.is_full_range ? bt709_full : bt709;
  return planes.is_full_range ? bt601_full : bt601;
}

/// Which part of the frame is seen: pixels, from and how many.
struct Part {
  std::uint32_t from = 0, length = 0;

  /// The first that pixel `i` of `count` covers, and past the last: at least one.
  std::uint32_t begin(std::uint32_t i, std::uint32_t count) const noexcept {
    return from + static_cast<std::uint32_t>(std::uint64_t{length} * i / count);
  }
  std::uint32_t end(std::uint32_t i, std::uint32_t count) const noexcept {
    return std::max(begin(i, count) + 1, begin(i + 1, count));
  }
};

int mean(const std::byte* plane, std::ptrdiff_t stride, std::uint32_t left, std::uint32_t right,
         std::uint32_t top, std::uint32_t bottom) noexcept {
  unsigned sum = 0;
  for (std::uint32_t y = top; y < bottom; ++y) {
    const std::byte* row = plane + static_cast<std::ptrdiff_t>(y) * stride;
    for (std::uint32_t x = left; x < right; ++x) sum += std::to_integer<unsigned>(row[x]);
  }
  const unsigned count = (right - left) * (bottom - top);
  return static_cast<int>((sum + count / 2) / count);
}

std::byte clamped(int value) noexcept {
  return static_cast<std::byte>(std::clamp((value + 32768) >> 16, 0, 255));
}

void write_pixel(const Matrix& matrix, int y, int u, int v, std::byte* pixel) noexcept {
  const int bright = matrix.brightness * (y - matrix.black);
  u -= 128;
  v -= 128;
  pixel[0] = clamped(bright + matrix.red_of_v * v);
  pixel[1] = clamped(bright - matrix.green_of_u * u - matrix.green_of_v * v);
  pixel[2] = clamped(bright + matrix.blue_of_u * u);
  pixel[3] = std::byte{255};
}

}  // namespace

void fill_pixels(const Planes& planes, Pixels& picture) noexcept {
  const std::uint64_t width = picture.width, height = picture.height;
  if (width == 0 || height == 0 || picture.rgba.size() < 4 * width * height) return;
  Part columns{0, planes.width}, rows{0, planes.height};
  if (planes.width * height > width * planes.height) {
    columns.length = std::max<std::uint32_t>(
        1, static_cast<std::uint32_t>((width * planes.height + height / 2) / height));
    columns.from = (planes.width - columns.length) / 2;
  } else {
    rows.length = std::max<std::uint32_t>(
        1, static_cast<std::uint32_t>((height * planes.width + width / 2) / width));
    rows.from = (planes.height - rows.length) / 2;
  }
  const Matrix& matrix = matrix_of(planes);
  std::byte* pixel = picture.rgba.data();
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    const std::uint32_t top = rows.begin(y, picture.height), bottom = rows.end(y, picture.height);
    for (std::uint32_t x = 0; x < picture.width; ++x, pixel += 4) {
      const std::uint32_t left = columns.begin(x, picture.width),
                          right = columns.end(x, picture.width);
      const auto colour = [&](const std::byte* plane) {
        return mean(plane, planes.uv_stride, left / 2, (right + 1) / 2, top / 2, (bottom + 1) / 2);
      };
      write_pixel(matrix, mean(planes.y, planes.y_stride, left, right, top, bottom),
                  colour(planes.u), colour(planes.v), pixel);
    }
  }
}

Pixels whole_picture(const Planes& planes) {
  Pixels picture{.width = planes.width,
                 .height = planes.height,
                 .rgba = std::vector<std::byte>(std::size_t{4} * planes.width * planes.height)};
  fill_pixels(planes, picture);
  return picture;
}

}  // namespace docent::video

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "platform/image/image.h"

namespace docent::image {
namespace {

/// IEC 61966-2-1.
float to_linear(std::byte encoded) {
  static const auto table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double e = static_cast<double>(i) / 255.0;
      values[i] = static_cast<float>(e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4));
    }
    return values;
  }();
  return table[std::to_integer<std::size_t>(encoded)];
}

/// Where sRGB is steepest, in the dark, a step of the table is a fifth of a step of the encoding.
std::byte to_encoded(float linear) {
  constexpr std::size_t steps = 16384;
  static const auto table = [] {
    std::array<std::byte, steps + 1> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double c = static_cast<double>(i) / steps;
      const double e = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
      values[i] = static_cast<std::byte>(std::lround(255 * e));
    }
    return values;
  }();
  return table[static_cast<std::size_t>(std::lround(std::clamp(linear, 0.0F, 1.0F) * steps))];
}

/// Linear light, multiplied by opacity.
struct Light {
  float red = 0, green = 0, blue = 0, alpha = 0;

  void add(const std::byte* pixel, float weight) {
    const float opacity = weight * static_cast<float>(std::to_integer<int>(pixel[3])) / 255.0F;
    red += opacity * to_linear(pixel[0]);
    green += opacity * to_linear(pixel[1]);
    blue += opacity * to_linear(pixel[2]);
    alpha += opacity;
  }
  void write(std::byte* pixel, float area) const {
    const float weight = alpha > 0 ? 1 / alpha : 0;
    pixel[0] = to_encoded(red * weight);
    pixel[1] = to_encoded(green * weight);
    pixel[2] = to_encoded(blue * weight);
    pixel[3] = static_cast<std::byte>(std::lround(255.0F * std::min(alpha / area, 1.0F)));
  }
};

/// A range of the picture along one axis, in pixels and parts of pixels.
struct Range {
  double from = 0, to = 0;

  double length() const { return to - from; }
  std::uint32_t first() const { return static_cast<std::uint32_t>(from); }
  std::uint32_t end(std::uint32_t size) const {
    return std::min(size, static_cast<std::uint32_t>(std::ceil(to)));
  }
  /// How much of a pixel is inside.
  float share_of(std::uint32_t pixel) const {
    return static_cast<float>(std::min<double>(pixel + 1.0, to) - std::max<double>(pixel, from));
  }
  /// The part of it that pixel `i` of `count` covers.
  Range part(std::uint32_t i, std::uint32_t count) const {
    return {from + length() * i / count, from + length() * (i + 1.0) / count};
  }
};

/// A part of the picture, `width` by `height` pixels large: each the mean of the light on its area.
Pixels resample(const Pixels& source, Range columns, Range rows, std::uint32_t width,
                std::uint32_t height) {
  Pixels result{width, height, std::vector<std::byte>(std::size_t{4} * width * height)};
  std::vector<Light> sum(width);
  for (std::uint32_t y = 0; y < height; ++y) {
    std::ranges::fill(sum, Light{});
    const Range across = rows.part(y, height);
    for (std::uint32_t from_y = across.first(); from_y < across.end(source.height); ++from_y) {
      const std::byte* row = &source.rgba[std::size_t{4} * from_y * source.width];
      const float row_share = across.share_of(from_y);
      for (std::uint32_t x = 0; x < width; ++x) {
        const Range along = columns.part(x, width);
        for (std::uint32_t from_x = along.first(); from_x < along.end(source.width); ++from_x)
          sum[x].add(row + std::size_t{4} * from_x, row_share * along.share_of(from_x));
      }
    }
    const auto area = static_cast<float>(rows.length() / height * columns.length() / width);
    for (std::uint32_t x = 0; x < width; ++x)
      sum[x].write(&result.rgba[4 * (std::size_t{y} * width + x)], area);
  }
  return result;
}

std::uint32_t whole_pixels(double length) {
  return std::max(1U, static_cast<std::uint32_t>(std::lround(length)));
}

}  // namespace

Pixels shrink(Pixels picture, std::uint32_t longest_side) {
  const std::uint32_t longest = std::max(picture.width, picture.height);
  if (longest <= longest_side || longest_side == 0) return picture;
  const double scale = static_cast<double>(longest_side) / longest;
  return resample(picture, {0, static_cast<double>(picture.width)},
                  {0, static_cast<double>(picture.height)}, whole_pixels(picture.width * scale),
                  whole_pixels(picture.height * scale));
}

std::vector<Pixels> mip_levels(Pixels picture) {
  std::vector<Pixels> levels;
  if (picture.rgba.empty()) return levels;
  levels.push_back(std::move(picture));
  while (std::max(levels.back().width, levels.back().height) > 1) {
    const Pixels& last = levels.back();
    levels.push_back(resample(last, {0, static_cast<double>(last.width)},
                              {0, static_cast<double>(last.height)}, std::max(1U, last.width / 2),
                              std::max(1U, last.height / 2)));
  }
  return levels;
}

Pixels fill(const Pixels& picture, std::uint32_t width, std::uint32_t height) {
  if (picture.rgba.empty() || width == 0 || height == 0) return {};
  const double have_width = picture.width;
  const double have_height = picture.height;
  const double scale = std::min(have_width / width, have_height / height);
  const Range columns{(have_width - width * scale) / 2, (have_width + width * scale) / 2};
  const Range rows{(have_height - height * scale) / 2, (have_height + height * scale) / 2};
  if (scale >= 1) return resample(picture, columns, rows, width, height);
  return resample(picture, columns, rows, whole_pixels(columns.length()),
                  whole_pixels(rows.length()));
}

}  // namespace docent::image

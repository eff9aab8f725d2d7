#include "content/compile/load_logo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "content/compile/load_image.h"
#include "content/content_error.h"
#include "platform/image/image.h"

namespace docent::compile {
namespace {

constexpr std::uint32_t longest_side = 768;

content::ContentError unusable(const std::filesystem::path& file, const std::string& why) {
  return {file.string(), 0, 0, "unreadable-image", why, "export it again as SVG or PNG"};
}

const std::byte* pixel(const Pixels& pixels, std::uint32_t x, std::uint32_t y) noexcept {
  return pixels.rgba.data() + 4 * (std::size_t{y} * pixels.width + x);
}

float opacity(const std::byte* rgba) noexcept {
  return static_cast<float>(rgba[3]) / 255;
}

scene::Colour colour(const std::byte* rgba) noexcept {
  const auto channel = [&](int i) { return static_cast<std::uint32_t>(rgba[i]); };
  return scene::srgb(channel(0) << 16U | channel(1) << 8U | channel(2));
}

/// What of it can be seen.
Pixels trimmed(const Pixels& pixels) {
  std::uint32_t left = pixels.width, right = 0, top = pixels.height, bottom = 0;
  for (std::uint32_t y = 0; y < pixels.height; ++y)
    for (std::uint32_t x = 0; x < pixels.width; ++x) {
      if (pixel(pixels, x, y)[3] == std::byte{}) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = std::max(bottom, y + 1);
    }
  if (left >= right) return {};
  Pixels part{.width = right - left, .height = bottom - top, .rgba = {}};
  for (std::uint32_t y = top; y < bottom; ++y)
    part.rgba.insert(part.rgba.end(), pixel(pixels, left, y),
                     pixel(pixels, left, y) + 4 * std::size_t{part.width});
  return part;
}

/// The colour of its corners, where they are of one and nothing is seen through them.
std::optional<scene::Colour> ground_of(const Pixels& pixels) {
  constexpr int alike = 6;  // of 255: what JPEG makes of one colour
  const std::uint32_t right = pixels.width - 1, bottom = pixels.height - 1;
  const std::array corners{pixel(pixels, 0, 0), pixel(pixels, right, 0), pixel(pixels, 0, bottom),
                           pixel(pixels, right, bottom)};
  for (const std::byte* corner : corners) {
    if (opacity(corner) < 0.5F) return {};
    for (int i = 0; i < 3; ++i)
      if (std::abs(static_cast<int>(corner[i]) - static_cast<int>(corners[0][i])) > alike)
        return {};
  }
  return colour(corners[0]);
}

}  // namespace

Logo load_logo(const std::filesystem::path& file, const std::string& name) {
  Logo logo{.image = load_image(file, name), .pixels = {}};
  Result<Pixels> pixels = image::decode_image(logo.image.bytes);
  if (!pixels) throw unusable(file, pixels.error().what);
  logo.pixels = image::shrink(trimmed(*pixels), longest_side);
  if (logo.pixels.rgba.empty()) throw unusable(file, "nothing can be seen in this picture");
  logo.image.width = logo.pixels.width;
  logo.image.height = logo.pixels.height;
  Result<std::vector<std::byte>> bytes = image::encode_png(logo.pixels);
  if (!bytes) throw unusable(file, bytes.error().what);
  logo.image.bytes = std::move(*bytes);
  logo.ground = ground_of(logo.pixels);
  return logo;
}

bool shows_on(const Logo& logo, const scene::Colour& paper) noexcept {
  constexpr float enough = 1.0F / 3, least = 3;
  float all = 0, told = 0;
  for (std::uint32_t y = 0; y < logo.pixels.height; ++y)
    for (std::uint32_t x = 0; x < logo.pixels.width; ++x) {
      const std::byte* rgba = pixel(logo.pixels, x, y);
      all += opacity(rgba);
      if (scene::contrast(colour(rgba), paper) >= least) told += opacity(rgba);
    }
  return told >= enough * all;
}

}  // namespace docent::compile

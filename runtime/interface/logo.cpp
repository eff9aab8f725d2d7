#include "runtime/interface/logo.h"

#include <algorithm>
#include <cmath>

namespace docent::interface {
namespace {

constexpr float margin = 1.5F;  ///< Units.

struct ShownLogo {
  std::uint32_t image = none;
  bool has_ground = false;  ///< It lies on paper of the day.
};

ShownLogo shown_logo(const Livery& livery, bool is_night) noexcept {
  if (!is_night) return {livery.logo, false};
  if (livery.logo_at_night != none) return {livery.logo_at_night, false};
  return {livery.logo, !livery.logo_shows_at_night};
}

}  // namespace

std::optional<Logo> logo_of(Sheet& sheet, LogoSize most) {
  const Museum& museum = sheet.museum();
  const ShownLogo logo = shown_logo(museum.livery, sheet.request().shape.is_night);
  if (logo.image >= museum.images.size()) return {};
  const EncodedImage& image = museum.images[logo.image];
  const float unit = sheet.measures().unit;
  const float pad = logo.has_ground ? std::round(margin * unit) : 0;
  const float shape = static_cast<float>(image.width) / static_cast<float>(image.height);
  const auto size = [=](float width) {
    const float wide = std::min(width, most.units_wide * unit) - 2 * pad;
    const float high = std::round(std::min(most.units_high * unit, wide / shape));
    return PixelBox{0, 0, std::max(1.0F, std::round(high * shape)) + 2 * pad,
                    std::max(1.0F, high) + 2 * pad};
  };
  return Logo{.width = [=](float width) { return size(width).width; },
              .block = {.height = [=](float width) { return size(width).height; },
                        .draw =
                            [=, &sheet, image = logo.image](const PixelBox& box) {
                              const PixelBox is = size(box.width);
                              const PixelBox ground{box.x, box.y, is.width, is.height};
                              if (pad > 0)
                                sheet.fill(ground, scene::srgb(sheet.museum().livery.paper),
                                           sheet.measures().corner);
                              sheet.image(ground.inset(pad), image, 0);
                            },
                        .gap = 2 * sheet.measures().gap}};
}

}  // namespace docent::interface

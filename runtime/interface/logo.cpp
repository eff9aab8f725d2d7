#include "runtime/interface/logo.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace docent::interface {
namespace {

/// In units.
constexpr float highest = 11, widest = 44, margin = 1.5F;

struct ShownLogo {
  std::uint32_t image = none;
  bool has_ground = false;  ///< It lies on paper of the day.
};

ShownLogo logo_of(const Livery& livery, bool is_night) noexcept {
  if (!is_night) return {livery.logo, false};
  if (livery.logo_at_night != none) return {livery.logo_at_night, false};
  return {livery.logo, !livery.logo_shows_at_night};
}

}  // namespace

std::optional<Block> logo_block(Sheet& sheet) {
  const Museum& museum = sheet.museum();
  const ShownLogo logo = logo_of(museum.livery, sheet.request().shape.is_night);
  if (logo.image >= museum.images.size()) return {};
  const EncodedImage& image = museum.images[logo.image];
  const float unit = sheet.measures().unit;
  const float pad = logo.has_ground ? std::round(margin * unit) : 0;
  const float shape = static_cast<float>(image.width) / static_cast<float>(image.height);
  const auto size = [=](float width) {
    const float most = std::min(width - 2 * pad, widest * unit);
    const float high = std::round(std::min(highest * unit, most / shape));
    return PixelBox{0, 0, std::max(1.0F, std::round(high * shape)), std::max(1.0F, high)};
  };
  return Block{.height = [=](float width) { return size(width).height + 2 * pad; },
               .draw =
                   [=, &sheet, image = logo.image](const PixelBox& box) {
                     const std::size_t first = sheet.view().elements.size();
                     const PixelBox is = size(box.width);
                     const PixelBox ground{box.x, box.y, is.width + 2 * pad, is.height + 2 * pad};
                     if (pad > 0)
                       sheet.fill(ground, scene::srgb(sheet.museum().livery.paper),
                                  sheet.measures().corner);
                     sheet.image(ground.inset(pad), image, 0);
                     for (Element& element : std::span(sheet.view().elements).subspan(first))
                       element.is_logo = true;
                   },
               .gap = 2 * sheet.measures().gap};
}

}  // namespace docent::interface

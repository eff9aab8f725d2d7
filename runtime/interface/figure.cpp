#include "runtime/interface/figure.h"

#include <algorithm>
#include <cmath>

#include "runtime/scene/theme.h"

namespace docent::interface {
namespace {

/// Lengths are shares of a guide of ordinary height.
class FigureSketch {
 public:
  FigureSketch(Sheet& sheet, const scene::Look& look, const PixelBox& box, float opacity,
               std::int32_t control)
      : sheet_(sheet),
        look_(look),
        middle_(box.x + box.width / 2),
        floor_(box.bottom()),
        unit_(std::min(box.height / tallest, box.width / widest)),
        opacity_(opacity),
        control_(control) {}

  void draw() const {
    if (look_.outline.crown == scene::Crown::Long) part(0, 0.66F, head, 0.21F, look_.hair, 0.06F);
    draw_legs();
    draw_garment();
    part(0, 0.74F, 0.82F, 0.09F, look_.shirt, 0.03F);
    draw_behind_face();
    round(head, 0.085F, look_.skin);
    draw_before_face();
  }

 private:
  static constexpr float tallest = 1.1F, widest = 0.46F, head = 0.88F, shoulder = 0.79F;

  void part(float x, float from, float to, float width, std::uint32_t colour, float corner) const {
    const float upright = look_.height * unit_;
    sheet_.fill({middle_ + (x - width / 2) * unit_, floor_ - to * upright, width * unit_,
                 (to - from) * upright},
                on_paper(colour), corner * unit_, control_);
  }
  /// As seen through it: parts lie over one another, so that each by itself would be seen twice.
  scene::Colour on_paper(std::uint32_t hex) const {
    const scene::Colour colour = scene::srgb(hex), &paper = sheet_.theme().paper;
    return {std::lerp(paper.r, colour.r, opacity_), std::lerp(paper.g, colour.g, opacity_),
            std::lerp(paper.b, colour.b, opacity_), 1};
  }
  void round(float at, float radius, std::uint32_t colour) const {
    part(0, at - radius, at + radius, 2 * radius, colour, radius);
  }

  void draw_legs() const {
    constexpr float leg = 0.115F;
    for (const float side : {-0.52F, 0.52F}) {
      part(side * leg, 0, 0.06F, leg, look_.shoes, 0.02F);
      part(side * leg, 0.04F, std::max(0.05F, look_.outline.hem + 0.05F), 0.95F * leg,
           look_.outline.bare_legs ? look_.skin : look_.trousers, 0.02F);
    }
  }
  void draw_garment() const {
    const scene::Outline& outline = look_.outline;
    const float wide = 0.34F * outline.shoulders;
    part(0, std::max(0.5F, outline.hem), shoulder, wide, look_.coat, 0.09F);
    constexpr int strips = 8;  // from the waist down, each a little wider
    const float waist = 0.6F, strip = (waist - outline.hem) / strips;
    for (int i = 0; i < strips; ++i) {
      const float share = static_cast<float>(i + 1) / strips;
      const float top = waist - static_cast<float>(i) * strip;
      part(0, top - strip, top + 0.01F, wide * (1 + (outline.flare - 1) * share), look_.coat, 0);
    }
  }
  void draw_behind_face() const {
    constexpr float up = 0.015F;
    switch (look_.outline.crown) {
      case scene::Crown::Bun:
        round(head + 0.115F, 0.042F, look_.hair);
        return round(head + up, 0.1F, look_.hair);
      case scene::Crown::Curls:
        return round(head + up, 0.135F, look_.hair);
      case scene::Crown::Scarf:
        part(0, 0.72F, head + 0.06F, 0.25F, look_.second, 0.07F);
        return round(head + up, 0.115F, look_.second);
      case scene::Crown::Bald:
      case scene::Crown::Turban:
        return;
      case scene::Crown::Short:
      case scene::Crown::Long:
      case scene::Crown::Cap:
        return round(head + up, 0.1F, look_.hair);
    }
  }
  void draw_before_face() const {
    if (look_.outline.beard) part(0, head - 0.11F, head - 0.02F, 0.15F, look_.hair, 0.05F);
    if (look_.outline.crown == scene::Crown::Turban)
      part(0, head + 0.02F, head + 0.13F, 0.25F, look_.second, 0.06F);
    if (look_.outline.crown == scene::Crown::Cap) {
      part(0, head + 0.05F, head + 0.12F, 0.23F, look_.coat, 0.025F);
      part(0, head + 0.035F, head + 0.055F, 0.19F, look_.shoes, 0.01F);
    }
  }

  Sheet& sheet_;
  const scene::Look& look_;
  float middle_, floor_, unit_, opacity_;
  std::int32_t control_;
};

}  // namespace

void draw_figure(Sheet& sheet, const scene::Look& look, const PixelBox& box, float opacity,
                 std::int32_t control) {
  FigureSketch(sheet, look, box, opacity, control).draw();
}

}  // namespace docent::interface

#include "runtime/interface/scroll.h"

#include <algorithm>

namespace docent::interface {

scene::Rect seen_of(const ScrollArea& area, const scene::Rect& rect, float offset) noexcept {
  const float top = std::max(rect.y - offset, area.rect.y);
  const float bottom = std::min(rect.y - offset + rect.height, area.rect.y + area.rect.height);
  if (bottom <= top) return {};
  return {rect.x, top, rect.width, bottom - top};
}

scene::Quad moved(const ScrollArea& area, scene::Quad quad, float offset) noexcept {
  constexpr float begins = 1e-4F;
  quad.rect.y -= offset;
  quad.clip = {.top = area.rect.y,
               .bottom = area.rect.y + area.rect.height,
               .fade_above = offset > begins ? area.fade : 0,
               .fade_below = offset < area.most() - begins ? area.fade : 0};
  return quad;
}

bool is_seen(const ScrollArea& area, const scene::Quad& moved) noexcept {
  return moved.rect.y < area.rect.y + area.rect.height &&
         moved.rect.y + moved.rect.height > area.rect.y;
}

void place_scrolled(View& view, float offset) noexcept {
  const ScrollArea& area = view.scroll;
  if (!area.exists()) return;
  for (const ScrollArea::Scrolled& one : area.controls) {
    scene::Rect seen = seen_of(area, one.rect, offset);
    if (seen.height < std::min(area.least, one.rect.height)) seen = {};
    view.controls[static_cast<std::size_t>(one.control)].rect = seen;
  }
  constexpr float least = 1e-4F;
  if (area.up >= 0) view.controls[static_cast<std::size_t>(area.up)].enabled = offset > least;
  if (area.down >= 0)
    view.controls[static_cast<std::size_t>(area.down)].enabled = offset < area.most() - least;
}

float offset_showing(const ScrollArea& area, std::int32_t control, float offset) noexcept {
  const auto found = std::ranges::find(area.controls, control, &ScrollArea::Scrolled::control);
  if (found == area.controls.end()) return offset;
  const float above = found->rect.y - area.rect.y - area.fade;
  const float below = above + found->rect.height + 2 * area.fade - area.rect.height;
  return std::clamp(std::min(std::max(offset, below), above), 0.0F, area.most());
}

}  // namespace docent::interface

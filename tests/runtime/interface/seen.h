#pragma once

#include <algorithm>
#include <vector>

#include "runtime/interface/scroll.h"
#include "runtime/interface/view.h"

namespace docent::test {

/// Where the texts of a view are seen, when what scrolls has been moved up by `offset`.
inline std::vector<scene::Rect> seen_texts(const interface::View& view, float offset = 0) {
  std::vector<scene::Rect> texts;
  const auto add = [&](const scene::Quad& quad, bool scrolls) {
    const scene::Rect rect =
        scrolls ? interface::seen_of(view.scroll, quad.rect, offset) : quad.rect;
    if (rect.height > 0) texts.push_back(rect);
  };
  for (const interface::Element& element : view.elements)
    if (element.quad.fill == scene::QuadFill::Text) add(element.quad, element.scrolls);
  if (!view.remaining.empty()) add(view.remaining.back().quad, view.remaining_scrolls);
  return texts;
}

/// Where a control is seen now, or where it is seen once what scrolls has been moved; empty where
/// it never is.
inline scene::Rect reached(const interface::View& view, std::size_t control) {
  const interface::ScrollArea& area = view.scroll;
  const auto scrolled = std::ranges::find(area.controls, static_cast<std::int32_t>(control),
                                          &interface::ScrollArea::Scrolled::control);
  if (scrolled == area.controls.end()) return view.controls[control].rect;
  const float offset = interface::offset_showing(area, scrolled->control, 0);
  return interface::seen_of(area, scrolled->rect, offset);
}

/// How many items of a list are wholly seen before anything is moved.
inline std::size_t whole_items(const interface::View& view) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < view.controls.size(); ++i) {
    if (view.controls[i].role != interface::Role::ListItem) continue;
    const interface::ScrollArea& area = view.scroll;
    const auto scrolled = std::ranges::find(area.controls, static_cast<std::int32_t>(i),
                                            &interface::ScrollArea::Scrolled::control);
    const bool scrolls = scrolled != area.controls.end();
    const scene::Rect rect = scrolls ? scrolled->rect : view.controls[i].rect;
    const scene::Rect seen = scrolls ? interface::seen_of(area, rect, 0) : rect;
    count += rect.height > 0 && seen.height >= 0.999F * rect.height ? 1 : 0;
  }
  return count;
}

}  // namespace docent::test

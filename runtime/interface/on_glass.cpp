#include "runtime/interface/on_glass.h"

#include <algorithm>
#include <cmath>

#include "runtime/interface/scroll.h"
#include "runtime/scene/side.h"

namespace docent::interface {
namespace {

std::string_view name_of(Role role) noexcept {
  switch (role) {
    case Role::Button:
      return "button";
    case Role::ListItem:
      return "list-item";
    case Role::Spot:
      return "spot";
    case Role::Choice:
      return "choice";
  }
  return "button";
}

std::string_view state_of(const Control& control) noexcept {
  if (!control.enabled) return "disabled";
  return control.selected ? "selected" : "normal";
}

/// Letters are measured where they are, not where layout takes a small screen for a larger one.
float mm_of(const ScreenShape& shape, float pixels) noexcept {
  constexpr float mm_per_inch = 25.4F;
  return pixels * shape.diagonal_inches * mm_per_inch /
         std::hypot(static_cast<float>(shape.width), static_cast<float>(shape.height));
}

class Lister {
 public:
  Lister(const Museum& museum, const View& view, const ScreenShape& shape)
      : museum_(museum), view_(view), shape_(shape) {}

  void add_control(std::size_t index, bool has_focus) {
    const Control& control = view_.controls[index];
    if (control.rect.width <= 0) return;
    const std::string label(in_language(museum_, view_.state.language, control.label));
    items.push_back({.name = control.name,
                     .role = name_of(control.role),
                     .label = label,
                     .state = state_of(control),
                     .rect = control.rect,
                     .text_mm = letters_of(static_cast<std::int32_t>(index)),
                     .spoken = text_of(view_.speech.controls[index]),
                     .has_focus = has_focus});
  }
  void add_label(std::int32_t words, const scene::Rect& rect) {
    if (words < 0 || rect.width <= 0) return;
    const Words& said = view_.words[static_cast<std::size_t>(words)];
    items.push_back({.name = {},
                     .role = "text",
                     .label = said.text,
                     .state = "normal",
                     .rect = rect,
                     .text_mm = mm_of(shape_, said.capitals_px),
                     .spoken = said.text});
  }
  std::vector<OnGlass> items;

 private:
  /// Of the first text that is written on a control.
  float letters_of(std::int32_t control) const {
    std::int32_t words = -1;
    for (const Element& element : view_.elements)
      if (words < 0 && element.control == control) words = element.words;
    for (const FloorLabel& label : view_.labels)
      if (words < 0 && label.control == control) words = label.words;
    return words < 0 ? 0 : mm_of(shape_, view_.words[static_cast<std::size_t>(words)].capitals_px);
  }

  const Museum& museum_;
  const View& view_;
  const ScreenShape& shape_;
};

}  // namespace

std::vector<OnGlass> on_glass(const Museum& museum, const View& view, const ScreenShape& shape,
                              float remaining, std::int32_t focus, float offset) {
  Lister lister(museum, view, shape);
  const auto seen = [&](const scene::Quad& quad, bool scrolls) {
    return scrolls ? seen_of(view.scroll, quad.rect, offset) : quad.rect;
  };
  for (std::size_t i = 0; i < view.controls.size(); ++i)
    lister.add_control(i, static_cast<std::int32_t>(i) == focus);
  for (const Element& element : view.elements)
    if (element.control < 0) lister.add_label(element.words, seen(element.quad, element.scrolls));
  for (const FloorLabel& label : view.labels)
    if (label.control < 0) lister.add_label(label.words, label.rect);
  const auto counted = std::ranges::find_if(
      view.remaining, [&](const CountedText& text) { return remaining <= text.metres; });
  if (counted != view.remaining.end())
    lister.add_label(counted->words, seen(counted->quad, view.remaining_scrolls));
  for (OnGlass& item : lister.items) item.rect = scene::to_screen(view.side, item.rect);
  return std::move(lister.items);
}

std::vector<std::pair<std::size_t, std::size_t>> overlaps(const std::vector<OnGlass>& items,
                                                          const ScreenShape& shape) {
  const float x = 1 / static_cast<float>(shape.width), y = 1 / static_cast<float>(shape.height);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t j = i + 1; j < items.size(); ++j) {
      const scene::Rect &a = items[i].rect, &b = items[j].rect;
      if (a.x + x < b.x + b.width && b.x + x < a.x + a.width && a.y + y < b.y + b.height &&
          b.y + y < a.y + a.height)
        pairs.emplace_back(i, j);
    }
  return pairs;
}

std::vector<std::size_t> outside(const std::vector<OnGlass>& items, const ScreenShape& shape) {
  const float x = 1 / static_cast<float>(shape.width), y = 1 / static_cast<float>(shape.height);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const scene::Rect& r = items[i].rect;
    if (r.x < -x || r.y < -y || r.x + r.width > 1 + x || r.y + r.height > 1 + y) found.push_back(i);
  }
  return found;
}

}  // namespace docent::interface

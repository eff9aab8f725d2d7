#include "runtime/kiosk/staff_page.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/input/calibration.h"

namespace docent::kiosk {
namespace {

using scene::Theme;

/// Height of the capitals, as a share of the em square, in the families of the house.
constexpr float capitals = 0.72F;

struct Box {
  float x = 0, y = 0, width = 0, height = 0;
};

enum class Align : std::uint8_t { Start, Centre };

/// A page while it is laid out. Pixels, origin top left.
class Layout {
 public:
  Layout(const StaffPageRequest& request, const interface::SetText& set_text)
      : request_(request), set_text_(set_text), m_(interface::measures_of(request.shape)) {
    page_.screen = request.screen;
    page_.width = static_cast<float>(request.shape.width);
    page_.height = static_cast<float>(request.shape.height);
    page_.unit_px = m_.unit;
    page_.theme = staff_theme(request.livery, request.shape.is_night);
    fill({0, 0, page_.width, page_.height}, page_.theme.paper, 0);
  }

  const interface::Measures& m() const noexcept { return m_; }
  float width() const noexcept { return page_.width; }
  float height() const noexcept { return page_.height; }
  StaffPage finish() { return std::move(page_); }
  StaffPage& page() noexcept { return page_; }

  scene::Rect share(const Box& box) const noexcept {
    return {box.x / width(), box.y / height(), box.width / width(), box.height / height()};
  }

  void fill(const Box& box, scene::Colour colour, float corner) {
    scene::Quad quad;
    quad.rect = share(box);
    quad.colour = colour;
    quad.corner = corner / std::min(width(), height());
    page_.quads.push_back(quad);
  }

  void ring(const Box& box, scene::Colour colour, float thickness) {
    scene::Quad quad;
    quad.rect = share(box);
    quad.fill = scene::QuadFill::Ring;
    quad.colour = colour;
    quad.softness = thickness / std::min(width(), height());
    page_.quads.push_back(quad);
  }

  std::string_view word(StaffWord word) const noexcept { return request_.words[word]; }
  std::string figure(std::size_t value) const {
    return request_.words.in_digits(std::to_string(value));
  }

  /// The box where it lies for whoever reads from the right, if this language is read so.
  Box mirrored(const Box& box) const noexcept {
    if (!request_.words.right_to_left) return box;
    return {width() - box.x - box.width, box.y, box.width, box.height};
  }

  struct Letters {
    float capitals_mm = 5;
    scene::Colour Theme::* colour = &Theme::ink;
    Align align = Align::Centre;
    interface::Family family = interface::Family::Sans;
    std::uint16_t weight = 400;
    bool is_of_machine = false;  ///< As StaffFact.
  };

  /// Sets a text, smaller where it does not fit, and draws it in the box, in the middle of its
  /// height; Align::Start is where the language begins its lines.
  void text(const Box& box, std::string_view words, const Letters& letters) {
    if (words.empty() || page_.uploads.size() >= most_staff_texts) return;
    interface::TextStyle style;
    style.family = letters.family;
    style.weight = letters.weight;
    style.size = letters.capitals_mm * m_.mm / capitals * request_.shape.text_scale;
    style.tabular = true;
    style.right_to_left = request_.words.right_to_left && !letters.is_of_machine;
    style.language = letters.is_of_machine ? "en" : std::string_view(request_.words.language);
    const auto most = static_cast<std::uint32_t>(std::max(1.F, box.width));
    interface::TextBitmap bitmap = set_text_(style, words, most);
    constexpr float smaller = 0.9F, smallest = 0.7F;
    for (float scale = smaller; bitmap.cut && scale > smallest; scale *= smaller) {
      interface::TextStyle less = style;
      less.size *= scale;
      bitmap = set_text_(less, words, most);
    }
    const auto w = static_cast<float>(bitmap.width), h = static_cast<float>(bitmap.height);
    const float free = box.width - w, at_start = request_.words.right_to_left ? free : 0;
    const float x = box.x + (letters.align == Align::Centre ? free / 2 : at_start);
    scene::Quad quad;
    quad.fill = scene::QuadFill::Text;
    quad.texture = static_cast<scene::TextureId>(request_.first_texture +
                                                 static_cast<std::uint32_t>(page_.uploads.size()));
    quad.rect = share({std::round(x), std::round(box.y + (box.height - h) / 2), w, h});
    quad.colour = page_.theme.*letters.colour;
    page_.quads.push_back(quad);
    page_.uploads.push_back({.texture = quad.texture, .text = std::move(bitmap), .picture = {}});
  }

  enum class Emphasis : std::uint8_t { Plain, Strong };
  void button(StaffAction action, const Box& box, std::string_view label, float capitals_mm = 5.4F,
              Emphasis emphasis = Emphasis::Plain) {
    const bool strong = emphasis == Emphasis::Strong;
    fill(box, strong ? page_.theme.ink : page_.theme.plaster, m_.corner);
    text({box.x + m_.gap / 2, box.y, box.width - m_.gap, box.height}, label,
         {.capitals_mm = capitals_mm,
          .colour = strong ? &Theme::paper : &Theme::ink,
          .weight = 500});
    page_.buttons.push_back({action, share(box)});
  }

  /// The page's heading and its message, from the top of a column; returns what is left of it.
  Box heading(Box column, std::string_view title) {
    const float title_height = 11 * m_.mm * 2;
    const float wide = width() - 2 * m_.margin;  // what is said is wider than the keys below it
    text({m_.margin, column.y, wide, title_height}, title,
         {.capitals_mm = 9, .family = interface::Family::Serif});
    const float message_height = 5 * m_.mm * 2.6F;
    text({m_.margin, column.y + title_height, wide, message_height}, request_.message,
         {.colour = &Theme::quiet_ink});
    const float used = title_height + message_height + m_.gap;
    return {column.x, column.y + used, column.width, column.height - used};
  }

  /// A column in the middle of the screen.
  Box column(float wanted_width, float wanted_height) const noexcept {
    const float w = std::min(wanted_width, width() - 2 * m_.margin);
    const float h = std::min(wanted_height, height() - 2 * m_.margin);
    return {(width() - w) / 2, (height() - h) / 2, w, h};
  }

 private:
  const StaffPageRequest& request_;
  const interface::SetText& set_text_;
  interface::Measures m_;
  StaffPage page_;
};

void lay_out_pad(Layout& layout) {
  const interface::Measures& m = layout.m();
  const float head = 11 * m.mm * 2 + 5 * m.mm * 2.6F + m.gap;
  const float dots = m.touch;
  const float rows = 5;  // four of keys and one to close
  const float free = layout.height() - 2 * m.margin - head - dots - rows * m.gap;
  const float key = std::min(1.35F * m.touch, free / rows);
  const float key_width = 1.5F * key;
  const float keys_width = 3 * key_width + 2 * m.gap;
  const float whole = head + dots + rows * (key + m.gap);
  Box rest = layout.heading(layout.column(std::max(keys_width, 90 * m.mm), whole),
                            layout.word(StaffWord::Title));
  const float left = (layout.width() - keys_width) / 2;
  layout.page().entry = layout.share({left, rest.y, keys_width, dots});
  float y = rest.y + dots + m.gap;
  const auto place = [&](std::size_t column_index) {
    return Box{left + static_cast<float>(column_index) * (key_width + m.gap), y, key_width, key};
  };
  for (std::size_t figure = 1; figure <= 9; ++figure) {
    layout.button(static_cast<StaffAction>(figure), place((figure - 1) % 3), layout.figure(figure),
                  7);
    if (figure % 3 == 0) y += key + m.gap;
  }
  layout.button(StaffAction::Delete, place(0), layout.word(StaffWord::Delete));
  layout.button(StaffAction::Figure0, place(1), layout.figure(0), 7);
  layout.button(StaffAction::Enter, place(2), layout.word(StaffWord::Enter), 5.4F,
                Layout::Emphasis::Strong);
  y += key + m.gap;
  layout.button(StaffAction::Close, {left, y, keys_width, key}, layout.word(StaffWord::Close));
}

void lay_out_menu(Layout& layout) {
  const interface::Measures& m = layout.m();
  const float button = 1.3F * m.touch;
  const float head = 11 * m.mm * 2 + 5 * m.mm * 2.6F + m.gap;
  Box rest = layout.heading(layout.column(120 * m.mm, head + 4 * (button + m.gap)),
                            layout.word(StaffWord::Title));
  const auto add = [&](StaffAction action, std::string_view label, Layout::Emphasis emphasis) {
    layout.button(action, {rest.x, rest.y, rest.width, button}, label, 5.4F, emphasis);
    rest.y += button + m.gap;
  };
  add(StaffAction::Diagnose, layout.word(StaffWord::Diagnose), Layout::Emphasis::Plain);
  add(StaffAction::Calibrate, layout.word(StaffWord::Calibrate), Layout::Emphasis::Plain);
  add(StaffAction::Exit, layout.word(StaffWord::Exit), Layout::Emphasis::Plain);
  add(StaffAction::Close, layout.word(StaffWord::Close), Layout::Emphasis::Strong);
}

void lay_out_calibrate(Layout& layout, std::size_t mark) {
  const interface::Measures& m = layout.m();
  layout.heading(layout.column(140 * m.mm, 60 * m.mm), layout.word(StaffWord::Mark));
  const auto& [x, y] = input::calibration_marks[mark % input::calibration_marks.size()];
  const float cx = x * layout.width(), cy = y * layout.height();
  const auto around = [&](float size) { return Box{cx - size / 2, cy - size / 2, size, size}; };
  layout.ring(around(2 * m.touch), layout.page().theme.focus, 0.6F * m.unit);
  layout.fill(around(1.5F * m.unit), layout.page().theme.invitation, 0.75F * m.unit);
}

void lay_out_confirm(Layout& layout) {
  const interface::Measures& m = layout.m();
  const float button = 1.3F * m.touch;
  const float head = 11 * m.mm * 2 + 5 * m.mm * 2.6F + m.gap;
  const Box rest =
      layout.heading(layout.column(120 * m.mm, head + button), layout.word(StaffWord::Confirm));
  layout.button(StaffAction::Keep, {rest.x, rest.y, rest.width, button},
                layout.word(StaffWord::Keep), 5.4F, Layout::Emphasis::Strong);
}

void lay_out_diagnose(Layout& layout, const std::vector<StaffFact>& facts) {
  const interface::Measures& m = layout.m();
  const Box column = layout.column(260 * m.mm, layout.height());
  Box rest = layout.heading(column, layout.word(StaffWord::Diagnose));
  const float button = m.touch;
  const float bottom = column.y + column.height - button - m.gap;
  const float row =
      std::min(5 * m.mm * 2.1F,
               (bottom - rest.y) / static_cast<float>(std::max<std::size_t>(1, facts.size())));
  const float label_width = 0.26F * rest.width;
  for (const StaffFact& fact : facts) {
    if (rest.y + row > bottom + 1) break;
    layout.text(layout.mirrored({rest.x, rest.y, label_width - m.gap, row}), fact.label,
                {.capitals_mm = 4, .colour = &Theme::quiet_ink, .align = Align::Start});
    layout.text(layout.mirrored({rest.x + label_width, rest.y, rest.width - label_width, row}),
                fact.value,
                {.capitals_mm = 4, .align = Align::Start, .is_of_machine = fact.is_of_machine});
    rest.y += row;
  }
  const float half = (column.width - m.gap) / 2, y = column.y + column.height - button;
  layout.button(StaffAction::Menu, layout.mirrored({column.x, y, half, button}),
                layout.word(StaffWord::Back));
  layout.button(StaffAction::Close, layout.mirrored({column.x + half + m.gap, y, half, button}),
                layout.word(StaffWord::Close), 5.4F, Layout::Emphasis::Strong);
}

}  // namespace

scene::Theme staff_theme(const Livery& livery, bool is_night) noexcept {
  const Theme theme = scene::theme_of(livery, false, is_night);
  const auto is_told = [&](const scene::Colour& colour, const scene::Colour& ground, float least) {
    return scene::contrast(colour, ground) >= least;
  };
  const bool is_read = is_told(theme.ink, theme.paper, scene::least_of_text) &&
                       is_told(theme.ink, theme.plaster, scene::least_of_text) &&
                       is_told(theme.quiet_ink, theme.paper, scene::least_of_text) &&
                       is_told(theme.invitation, theme.paper, scene::least_of_focus) &&
                       is_told(theme.focus, theme.paper, scene::least_of_focus);
  return is_read ? theme : scene::theme_of({}, false, is_night);
}

StaffPage make_staff_page(const StaffPageRequest& request, const interface::SetText& set_text) {
  Layout layout(request, set_text);
  switch (request.screen) {
    case StaffScreen::Pad:
      lay_out_pad(layout);
      break;
    case StaffScreen::Menu:
      lay_out_menu(layout);
      break;
    case StaffScreen::Calibrate:
      lay_out_calibrate(layout, request.mark);
      break;
    case StaffScreen::Confirm:
      lay_out_confirm(layout);
      break;
    case StaffScreen::Diagnose:
      lay_out_diagnose(layout, request.facts);
      break;
  }
  return layout.finish();
}

}  // namespace docent::kiosk

/// What stands on the shared glass: the words on the model, and the card of each visitor.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "runtime/interface/face.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/seats.h"
#include "runtime/interface/sheet.h"
#include "runtime/scene/look.h"

namespace docent::interface {
namespace {

constexpr float card_margin = 2;  // units
constexpr float row_units = 8;    // height of a row of the list
constexpr float heading_units = 5;
constexpr float least_invitation = 10;  // units for where the way leads
constexpr float taken_opacity = 0.18F;  // of a guide whom somebody else has

/// Of the question above the list; beside it are the helps.
float height_of_heading(const Measures& m) noexcept {
  return std::round(std::max(m.touch + m.unit, heading_units * m.unit));
}

float height_of_row(const Measures& m) noexcept {
  return std::round(std::max(m.touch, row_units * m.unit));
}

/// A figure as large as a box allows, standing on its lower edge. Lengths are shares of a guide of
/// ordinary height.
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

void draw_figure(Sheet& sheet, const scene::Look& look, const PixelBox& box, float opacity,
                 std::int32_t control) {
  FigureSketch(sheet, look, box, opacity, control).draw();
}

/// A band in the guide's colour along the card's upper edge: whose card it is.
void draw_band(Sheet& sheet, const PixelBox& card) {
  const Measures& m = sheet.measures();
  const std::optional<std::uint32_t> look = sheet.request().state.look;
  if (!look) return;
  draw_stroke(sheet,
              {card.x + m.corner, card.y, card.width - 2 * m.corner, std::round(0.8F * m.unit)},
              scene::trail_colour(*look), 0, -1);
}

/// The helps of every screen as pictograms in the card's upper corner, and below them what is asked
/// of ways. Returns how wide and high they are, with the gap before and below.
struct Corner {
  float width = 0, height = 0;
};
Corner draw_corner(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  constexpr std::array<std::array<std::pair<std::string_view, Pictogram>, 3>, 2> rows{
      {{{{"toilets", pictogram_of(PlaceKind::Toilets)},
         {"places", Pictogram::Places},
         {"exhibits", Pictogram::Exhibits}}},
       {{{"step-free", Pictogram::StepFree},
         {"no-escalators", Pictogram::NoEscalators},
         {"", Pictogram::Count}}}}};
  const float gap = std::round(m.unit);
  Corner corner;
  for (const auto& row : rows) {
    float x = content.right();
    for (const auto& [name, pictogram] : row) {
      const std::int32_t control = name.empty() ? -1 : sheet.control(name);
      if (control < 0) continue;
      x -= m.touch;
      const PixelBox box{x, content.y + corner.height, m.touch, m.touch};
      const bool is_on = sheet.view().controls[static_cast<std::size_t>(control)].selected;
      sheet.place(control, box);
      sheet.fill(box, is_on ? sheet.theme().ink : sheet.theme().plaster, m.corner, control);
      sheet.pictogram(pictogram, box.inset(std::round(0.16F * m.touch)),
                      is_on ? sheet.theme().paper : sheet.theme().ink, control);
      x -= gap;
    }
    corner.width = std::max(corner.width, content.right() - x);
    if (x < content.right()) corner.height += m.touch + gap;
  }
  return corner;
}

/// Buttons side by side on the lowest row, those that this state has; returns its top.
float draw_buttons(Sheet& sheet, const PixelBox& content, std::span<const std::string_view> names) {
  const Measures& m = sheet.measures();
  const float top = content.bottom() - m.touch, gap = std::round(m.unit);
  std::vector<std::int32_t> there;
  for (const std::string_view name : names)
    if (const std::int32_t control = sheet.control(name); control >= 0) there.push_back(control);
  const auto count = static_cast<float>(there.size());
  const float width = std::floor((content.width + gap) / count - gap);
  const TextStyle word = sheet.row_style(there, width);
  const std::int32_t stop = sheet.control("stop"), start = sheet.control("start-tour");
  float x = content.x;
  for (const std::int32_t control : there) {
    const bool is_strong = control == stop || control == start;
    sheet.button(control, {x, top, width, m.touch},
                 is_strong ? Sheet::Emphasis::Strong : Sheet::Emphasis::Soft, word);
    x += width + gap;
  }
  return top;
}

/// An exhibit's number, or how long a tour is, and what it is called; and that it is closed.
std::string row_text(const Sheet& sheet, const Control& control) {
  std::string title(sheet.local(control.label));
  if (control.action.kind == Action::Kind::Seek) return title;
  if (control.action.kind == Action::Kind::ShowOwnTour) return title + "  " + own_tour_line(sheet);
  const Tour* tour = begun_tour(sheet, control);
  const std::string before = tour != nullptr
                                 ? tour_line(sheet, *tour)
                                 : number_in(sheet.museum(), sheet.request().state.language,
                                             static_cast<long>(control.action.argument) + 1);
  const std::string closed =
      tour == nullptr ? closed_line(sheet, control.action.argument) : std::string();
  return before + "  " + title + (closed.empty() ? "" : "  ·  ") + closed;
}

/// Plus or minus: whether a touch puts an exhibit into the visitor's own tour, or takes it out.
void draw_collect(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const Control& it = sheet.view().controls[static_cast<std::size_t>(control)];
  sheet.place(control, box);
  const bool is_in = it.action.kind == Action::Kind::Discard;
  sheet.fill(box, is_in ? sheet.theme().ink : sheet.theme().plaster, m.corner, control);
  const scene::Colour sign = is_in ? sheet.theme().paper : sheet.theme().ink;
  const float length = std::round(0.4F * m.touch), thick = std::round(0.06F * m.touch);
  const float x = box.x + box.width / 2, y = box.y + box.height / 2;
  const scene::Colour ink = it.enabled ? sign : scene::with_opacity(sign, 0.35F);
  sheet.fill({x - length / 2, y - thick / 2, length, thick}, ink, 0, control);
  if (!is_in) sheet.fill({x - thick / 2, y - length / 2, thick, length}, ink, 0, control);
}

void draw_row(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const Control& it = sheet.view().controls[static_cast<std::size_t>(control)];
  sheet.place(control, box);
  if (it.selected) sheet.fill(box, sheet.theme().plaster, m.corner, control);
  const PixelBox picture{box.x, box.y, box.height, box.height};
  draw_what(sheet, control, picture);
  const float x = picture.right() + m.unit;
  TextStyle style = sheet.style(Letters::Body, 2);
  style.line_height = style.right_to_left ? 1.4F : 1.2F;
  const TextPiece title = sheet.fitted(style, row_text(sheet, it), box.right() - x - m.unit / 2);
  sheet.piece(title, x, box.y + (box.height - title.height) / 2, box.right() - x, Align::Start,
              sheet.theme().ink, control);
}

/// A row of the list, and what collects it where that is an exhibit.
void draw_list_row(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const Action& action = sheet.view().controls[static_cast<std::size_t>(control)].action;
  const std::int32_t collect =
      action.kind == Action::Kind::Choose ? sheet.collect(action.argument) : -1;
  if (collect < 0) return draw_row(sheet, control, box);
  const float gap = std::round(m.unit / 2);
  draw_row(sheet, control, {box.x, box.y, box.width - m.touch - gap, box.height});
  draw_collect(sheet, collect,
               {box.right() - m.touch, box.y + (box.height - m.touch) / 2, m.touch, m.touch});
}

/// All the guides side by side.
void draw_guides(Sheet& sheet, const PixelBox& box) {
  const float width = box.width / scene::guide_look_count;
  for (std::size_t i = 0; i < scene::guide_look_count; ++i)
    draw_figure(sheet, scene::looks[i],
                {box.x + (static_cast<float>(i) + 0.08F) * width, box.y, 0.84F * width, box.height},
                1, -1);
}

/// Words on a slip of paper in the middle of `box`.
void draw_slip(Sheet& sheet, const TextPiece& words, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const float width = words.width + 2 * m.margin, height = words.height + 2 * m.gap;
  const PixelBox slip{box.x + (box.width - width) / 2, box.y + (box.height - height) / 2, width,
                      height};
  sheet.shadow(slip, 2 * m.unit, 0.16F);
  sheet.fill(slip, sheet.theme().paper, m.corner);
  sheet.piece(words, slip.x, slip.y + m.gap, slip.width, Align::Centre, sheet.theme().ink);
}

/// The card with letters of that share of their size.
void lay_out_card(Sheet& sheet, const PixelBox& card, float letters) {
  const InterfaceState& state = sheet.request().state;
  const Measures& m = sheet.measures();
  sheet.lie_on(card, letters);
  const Face& face = faces_of(state.screen).card;
  if (state.screen == Screen::Welcome) return face.lay_out(sheet, card);
  sheet.shadow(card, 2 * m.unit, 0.16F);
  sheet.fill(card, sheet.theme().paper, m.corner);
  draw_band(sheet, card);
  const PixelBox content = card.inset(std::round(card_margin * m.unit));
  face.lay_out(sheet, content);
}

}  // namespace

/// Nobody is here: where others are, whoever comes is invited.
void lay_out_welcome_card(Sheet& sheet, const PixelBox& card) {
  const Measures& m = sheet.measures();
  const std::int32_t join = sheet.control("begin");
  sheet.place(join, card);
  if (sheet.request().state.glass == Glass::Quiet) return;
  sheet.fill(card, scene::with_opacity(sheet.theme().paper, 0.55F), m.corner, join);
  const PixelBox inside = card.inset(card_margin * m.unit);
  const TextPiece words =
      sheet.fitted(sheet.style(Letters::Label, 3), sheet.word("join"), inside.width);
  sheet.piece(words, inside.x, card.y + (card.height - words.height) / 2, inside.width,
              Align::Centre, sheet.theme().quiet_ink, join);
}

void lay_out_picking_card(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const float gap = std::round(m.unit);
  float bottom = content.bottom() - m.touch;
  sheet.button(sheet.control("home"), {content.x, bottom, content.width, m.touch},
               Sheet::Emphasis::Soft);
  if (sheet.museum().languages.size() > 1) {
    bottom -= gap + m.touch;
    draw_languages(sheet, {content.x, bottom, content.width, m.touch});
  }
  const Corner corner = draw_corner(sheet, content);
  const float asked = sheet.text(Letters::Lead, sheet.word("pick_title"), content.x, content.y,
                                 content.width - corner.width, sheet.theme().ink, 2);
  const float top = std::max(asked + gap, content.y + corner.height);
  constexpr std::uint32_t columns = 4, rows = scene::guide_look_count / columns;
  const float width = std::floor((content.width - (columns - 1) * gap / 2) / columns);
  const float height = std::floor((bottom - gap - top - (rows - 1) * gap) / rows);
  for (std::uint32_t i = 0; i < scene::guide_look_count; ++i) {
    const std::int32_t control = sheet.control("look:" + std::string(scene::looks[i].name));
    if (control < 0) continue;
    const std::uint32_t column = i % columns, row = i / columns;
    const PixelBox cell{content.x + static_cast<float>(column) * (width + gap / 2),
                        top + static_cast<float>(row) * (height + gap), width, height};
    sheet.place(control, cell);
    const Control& it = sheet.view().controls[static_cast<std::size_t>(control)];
    if (it.enabled) sheet.fill(cell, sheet.theme().plaster, m.corner, control);
    TextStyle style = sheet.style(Letters::Small);
    const float pad = std::round(0.4F * m.unit);
    const TextPiece name = sheet.fitted(style, sheet.local(it.label), cell.width - 2 * pad);
    const float words = std::ceil(style.size * style.line_height);
    draw_figure(sheet, scene::looks[i],
                {cell.x + pad, cell.y + pad, cell.width - 2 * pad, cell.height - 2 * pad - words},
                it.enabled ? 1 : taken_opacity, control);
    if (!it.enabled) continue;
    sheet.piece(name, cell.x, cell.bottom() - pad - (words + name.height) / 2, cell.width,
                Align::Centre, sheet.theme().ink, control);
  }
}

void lay_out_choosing_card(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const float gap = std::round(m.unit / 2), row = height_of_row(m);
  const TextStyle style = sheet.style(Letters::Lead);
  const Listed lists = sheet.request().state.lists;
  const float width = content.width - draw_corner(sheet, content).width;
  sheet.piece(sheet.fitted(style, sheet.word(title_of(lists)), width), content.x, content.y, width,
              Align::Start, sheet.theme().ink);
  float y = content.y + height_of_heading(m);
  for (std::size_t i = 0; i < sheet.view().controls.size(); ++i) {
    if (sheet.view().controls[i].role != Role::ListItem) continue;
    draw_list_row(sheet, static_cast<std::int32_t>(i), {content.x, y, content.width, row});
    y += row + gap;
  }
  constexpr std::array<std::string_view, 4> buttons{"page:previous", "page:next", "back", "home"};
  const float bottom = draw_buttons(sheet, content, buttons) - gap;
  if (lists == Listed::OwnTour) {
    constexpr std::array<std::string_view, 2> start{"start-tour", "choose"};
    draw_buttons(sheet, {content.x, content.y, content.width, bottom - content.y}, start);
    return;
  }
  draw_languages(sheet, {content.x, bottom - m.touch, content.width, m.touch});
}

void lay_out_walking_card(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const float gap = std::round(m.unit);
  constexpr std::array<std::string_view, 3> buttons{"stop", "skip", "choose"};
  const float bottom = draw_buttons(sheet, content, buttons) - m.gap;
  const float column = 3 * m.touch + 2 * gap;
  const bool in_a_row = bottom - column - content.y < least_invitation * m.unit;
  const float height = in_a_row ? m.touch : column, routes = bottom - height;
  draw_routes(sheet, {content.x, routes, content.width, height},
              in_a_row ? Along::Row : Along::NarrowColumn);
  const Corner corner = draw_corner(sheet, content);
  const PixelBox words{content.x, content.y, content.width - corner.width,
                       routes - gap - content.y};
  const float said = draw_invitation(sheet, draw_tour_progress(sheet, words), Letters::Lead);
  const float y = std::max(said, content.y + corner.height);
  const float room = routes - m.gap - y;
  if (room > 8 * m.unit) draw_goal(sheet, {content.x, y, content.width, room});
}

void lay_out_arrived_card(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  constexpr std::array<std::string_view, 2> buttons{"choose", "home"};
  float bottom = draw_buttons(sheet, content, buttons) - m.gap;
  if (const std::int32_t next = sheet.control("next"); next >= 0) {
    const float row = height_of_row(m);
    draw_row(sheet, next, {content.x, bottom - row, content.width, row});
    bottom -= row + m.unit;
  }
  const Corner corner = draw_corner(sheet, content);
  const PixelBox rest = draw_tour_progress(
      sheet, {content.x, content.y, content.width - corner.width, bottom - content.y});
  float y = sheet.text(Letters::Heading, goal_title(sheet), content.x, rest.y, rest.width,
                       sheet.theme().ink, 2) +
            m.unit;
  y = std::max(y, content.y + corner.height);
  const float picture = std::min(0.4F * (bottom - y), 0.75F * content.width);
  y += draw_goal(sheet, {content.x, y, content.width, picture}) + m.unit;
  TextStyle style = sheet.style(Letters::Body);
  const float line = style.size * style.line_height;
  style.max_lines = static_cast<std::uint16_t>(std::clamp((bottom - y) / line, 1.0F, 40.0F));
  sheet.piece(sheet.fitted(style, goal_text(sheet), content.width), content.x, y, content.width,
              Align::Start, sheet.theme().ink);
}

std::uint32_t rows_of_card(const ScreenShape& shape, std::uint32_t seats) noexcept {
  const Measures m = measures_of(shape);
  const float height =
      card_of(shape, std::max(seats, 1U), 1).height * static_cast<float>(shape.height);
  const float gap = std::round(m.unit / 2);
  const float room = height - 2 * std::round(card_margin * m.unit) - height_of_heading(m) -
                     2 * m.touch - m.gap - gap;
  return static_cast<std::uint32_t>(
      std::clamp(std::floor((room + gap) / (height_of_row(m) + gap)), 1.0F, 12.0F));
}

void lay_out_seat(Sheet& sheet, const PixelBox& card) {
  // On a small glass, or in large letters, a card has little room: what does not fit is set
  // smaller.
  for (const float letters : {1.0F, 0.85F, 0.7F, 0.55F, 0.4F}) {
    lay_out_card(sheet, card, letters);
    if (!sheet.is_crowded()) return;
  }
}

void lay_out_model(Sheet& sheet) {
  const Measures& m = sheet.measures();
  const Museum& museum = sheet.museum();
  const ViewRequest& request = sheet.request();
  const auto width = static_cast<float>(request.shape.width);
  const auto height = static_cast<float>(request.shape.height);
  const float strip = strip_of(request.shape).y * height;
  switch (request.state.glass) {
    case Glass::Whole:
    case Glass::Busy:
      return;
    case Glass::Quiet: {
      const PixelBox paper{0, strip, width, height - strip};
      sheet.shadow(paper, 4 * m.unit, 0.16F);
      sheet.fill(paper, sheet.theme().paper, 0);
      PixelBox content = paper.inset(m.margin);
      PixelBox guides = content;
      guides.x = content.x + content.width * 0.4F;
      guides.width = content.right() - guides.x;
      content.width = guides.x - m.margin - content.x;
      float y = sheet.text(Letters::Label, sheet.local(museum.title), content.x, content.y,
                           content.width, sheet.theme().quiet_ink, 2);
      y = sheet.text(Letters::Welcome, sheet.word("welcome"), content.x, y + m.gap, content.width,
                     sheet.theme().ink);
      y = sheet.text(Letters::Lead, sheet.local(museum.welcome), content.x, y + m.gap,
                     content.width, sheet.theme().quiet_ink, 2);
      sheet.text(Letters::Lead, sheet.word("join_where"), content.x, y + m.gap, content.width,
                 sheet.theme().ink, 2);
      return draw_guides(sheet, guides);
    }
    case Glass::Full:
    case Glass::TurnedAway: {
      const bool told = request.state.glass == Glass::TurnedAway;
      const PixelBox box = told ? PixelBox{0, 0, width, strip}
                                : PixelBox{m.margin, m.margin, 0.2F * width, 0.15F * height};
      const TextPiece words =
          sheet.fitted(sheet.style(told ? Letters::Lead : Letters::Body, 4),
                       sheet.word("all_taken"), std::min(box.width, 0.6F * width) - 2 * m.margin);
      return draw_slip(sheet, words, box);
    }
  }
}

}  // namespace docent::interface

/// The parts that several screens share: cards, route kinds, the lowest row.
#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/interface/finder.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/places.h"
#include "runtime/interface/sheet.h"
#include "runtime/scene/look.h"

namespace docent::interface {
namespace {

constexpr std::string_view between = "  ·  ";  // parts of a line

}  // namespace

void draw_stroke(Sheet& sheet, const PixelBox& box, scene::Colour colour, float corner,
                 std::int32_t control) {
  constexpr float pale = 0.6F;  // linear light, from where paper is no ground for it
  if (colour.g > pale)
    sheet.fill(box.inset(-std::max(1.0F, 0.12F * sheet.measures().unit)), sheet.theme().quiet_ink,
               corner, control);
  sheet.fill(box, colour, corner, control);
}

namespace {

/// A sample of a route kind's ribbon.
void draw_pattern(Sheet& sheet, RouteKind kind, const PixelBox& box, std::int32_t control) {
  const InterfaceState& state = sheet.request().state;
  const scene::Colour colour =
      state.look ? scene::trail_colour(*state.look) : scene::route_colour(kind);
  const LinePattern& pattern = info_of(kind).pattern;
  const float thick = box.height;
  const auto pieces = static_cast<float>(pattern.sample_pieces);
  const bool are_dots = !pattern.is_solid() && pattern.piece == 0;
  const float length = are_dots ? thick : (box.width - (pieces - 1) * thick) / pieces;
  const float step = pieces > 1 ? (box.width - length) / (pieces - 1) : 0;
  for (int i = 0; i < pattern.sample_pieces; ++i)
    draw_stroke(sheet, {box.x + step * static_cast<float>(i), box.y, length, thick}, colour,
                thick / 2, control);
}

void draw_route(Sheet& sheet, std::int32_t control, const PixelBox& box, Along along) {
  const Measures& m = sheet.measures();
  sheet.place(control, box);
  const Control& it = sheet.view().controls[static_cast<std::size_t>(control)];
  const auto kind = static_cast<RouteKind>(it.action.argument);
  if (it.selected) sheet.mark_selected(box, control);

  const bool narrow = along != Along::Column;
  TextStyle style = narrow ? sheet.style(Letters::Small, 2) : sheet.style(Letters::Label);
  style.weight = it.selected ? 600 : 400;
  style.line_height = style.right_to_left ? 1.25F : 1.1F;
  const scene::Colour ink = it.selected ? sheet.theme().ink : sheet.theme().quiet_ink;
  const float pad = std::round(1.5F * m.unit), thick = std::round(0.9F * m.unit);
  const float sample = std::round((narrow ? 4.5F : 7) * m.unit);
  draw_pattern(sheet, kind,
               {box.x + pad, std::round(box.y + (box.height - thick) / 2), sample, thick}, control);
  const float x = box.x + pad + sample + pad;
  const TextPiece label = sheet.fitted(style, sheet.local(it.label), box.right() - x - pad / 2);
  sheet.piece(label, x, box.y + (box.height - label.height) / 2, box.right() - x, Align::Start, ink,
              control);
}

/// A language's own name, in its own letters.
TextPiece language_name(Sheet& sheet, const Control& control, float width) {
  const Language& language = sheet.museum().languages[control.action.argument];
  TextStyle style = sheet.style(Letters::Label);
  style.weight = control.selected ? 600 : 400;
  style.language = language.tag;
  style.right_to_left = language.right_to_left;
  style.line_height = 1.5F;
  return sheet.fitted(style, sheet.local(control.label), width);
}

std::vector<std::int32_t> languages_of(Sheet& sheet) {
  std::vector<std::int32_t> controls;
  for (std::size_t i = 0; i < sheet.view().controls.size(); ++i) {
    const Control& it = sheet.view().controls[i];
    if (it.action.kind == Action::Kind::Speak && it.role == Role::Choice)
      controls.push_back(static_cast<std::int32_t>(i));
  }
  return controls;
}

}  // namespace

void draw_language(Sheet& sheet, std::int32_t control, const PixelBox& box, Align align) {
  const Measures& m = sheet.measures();
  const Control& it = sheet.view().controls[static_cast<std::size_t>(control)];
  sheet.place(control, box);
  if (it.selected) sheet.mark_selected(box, control);
  const PixelBox inside = align == Align::Centre ? box.inset(m.unit / 2) : box.inset(m.unit);
  const TextPiece name = language_name(sheet, it, inside.width);
  sheet.piece(name, inside.x, box.y + (box.height - name.height) / 2, inside.width, align,
              it.selected ? sheet.theme().ink : sheet.theme().quiet_ink, control);
}

/// Languages side by side, each as wide as its name; narrower, or in equal shares, where that is
/// too much.
void draw_languages(Sheet& sheet, const PixelBox& box) {
  const Measures& m = sheet.measures();
  if (const std::int32_t list = sheet.control("languages"); list >= 0)
    return sheet.signed_button(list, Pictogram::Languages, box, sheet.style(Letters::Label));
  const std::vector<std::int32_t> controls = languages_of(sheet);
  if (controls.empty()) return;

  std::vector<float> widths;
  float whole = 0;
  for (const std::int32_t i : controls) {
    const Control& it = sheet.view().controls[static_cast<std::size_t>(i)];
    widths.push_back(std::max(m.touch, language_name(sheet, it, box.width).width + 2 * m.unit));
    whole += widths.back() + m.unit;
  }
  const float share = std::floor(box.width / static_cast<float>(controls.size()) - m.unit);
  // Long names take more of what there is than short ones, as long as all are wide enough to touch.
  const float scale = (box.width - m.unit * static_cast<float>(controls.size())) / whole;
  const bool in_proportion = std::ranges::all_of(
      widths, [&](float width) { return std::floor(scale * width) >= m.touch; });
  float x = box.x;
  for (std::size_t n = 0; n < controls.size(); ++n) {
    const float narrow = in_proportion ? std::floor(scale * widths[n]) : share;
    const PixelBox cell{x, box.y, whole - m.unit > box.width ? narrow : widths[n], box.height};
    x = cell.right() + m.unit;
    draw_language(sheet, controls[n], cell, Align::Centre);
  }
}

float draw_language_rows(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const std::vector<std::int32_t> controls = languages_of(sheet);
  const auto count = static_cast<float>(controls.size());
  constexpr float least = 17;  // units
  const float fitting =
      std::floor(content.width / (least * m.unit * sheet.request().shape.text_scale));
  const float columns = std::clamp(fitting, 1.0F, std::max(1.0F, count));
  const float gap = m.unit, rows = std::ceil(count / columns);
  const float width = std::floor((content.width - (columns - 1) * gap) / columns);
  const float top = content.bottom() - rows * (m.touch + gap) + gap;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const auto n = static_cast<float>(i);
    const float row = std::floor(n / columns), column = n - row * columns;
    draw_language(sheet, controls[i],
                  {content.x + column * (width + gap), top + row * (m.touch + gap), width, m.touch},
                  Align::Centre);
  }
  return top;
}

float draw_floors(Sheet& sheet, const PixelBox& free) {
  const Measures& m = sheet.measures();
  std::vector<std::int32_t> controls;
  for (std::size_t i = 0; i < sheet.view().controls.size(); ++i)
    if (sheet.view().controls[i].action.kind == Action::Kind::ShowFloor)
      controls.push_back(static_cast<std::int32_t>(i));
  if (controls.empty()) return 0;
  const auto count = static_cast<float>(controls.size());
  const float gap = std::round(m.unit);
  const float most = std::floor((free.height - 2 * m.margin - (count - 1) * gap) / count);
  const float side = std::min(m.touch, most);
  const float x = free.right() - m.margin - side;
  float y = std::round(free.y + (free.height - count * side - (count - 1) * gap) / 2);
  const PixelBox board{x - gap, y - gap, side + 2 * gap, count * (side + gap) + gap};
  sheet.shadow(board, 2 * m.unit, 0.12F);
  sheet.fill(board, sheet.theme().paper, m.corner);
  for (const std::int32_t control : controls) {
    const Control& it = sheet.view().controls[static_cast<std::size_t>(control)];
    const Floor& floor = sheet.museum().floors[it.action.argument];
    const PixelBox box{x, y, side, side};
    sheet.place(control, box);
    if (it.selected) sheet.mark_selected(box, control);
    TextStyle style = sheet.style(Letters::Label);
    style.weight = it.selected ? 600 : 400;
    const TextPiece name = sheet.fitted(style, floor.plan.short_name, side);
    sheet.piece(name, box.x, box.y + (box.height - name.height) / 2, box.width, Align::Centre,
                it.selected ? sheet.theme().ink : sheet.theme().quiet_ink, control);
    if (it.selected && !sheet.local(floor.title).empty())
      sheet.text(Letters::Lead, sheet.local(floor.title), free.x + m.margin, free.y + m.margin,
                 free.width - 2 * m.margin, sheet.theme().quiet_ink);
    y += side + gap;
  }
  return free.right() - board.x;
}

const Tour* begun_tour(const Sheet& sheet, const Control& control) noexcept {
  const bool begins = control.role == Role::ListItem &&
                      control.action.kind == Action::Kind::FollowTour && control.name != "next";
  const auto& tours = sheet.museum().tours;
  const std::uint32_t tour = control.action.stop.tour;
  return begins && tour < tours.size() ? &tours[tour] : nullptr;
}

std::string where_line(const Sheet& sheet, std::uint32_t floor, std::uint32_t room) {
  const Museum& museum = sheet.museum();
  std::string line;
  const auto add = [&line](std::string_view part) {
    if (!part.empty()) line.append(line.empty() ? "" : between).append(part);
  };
  if (room < museum.rooms.size()) add(sheet.local(museum.rooms[room].title));
  if (floor != museum.kiosk_floor) add(sheet.local(museum.floors[floor].title));
  return line;
}

std::string closed_line(const Sheet& sheet, std::uint32_t exhibit) {
  const ClosedExhibit* closed = closed_exhibit(sheet.closed(), exhibit);
  if (closed == nullptr) return {};
  if (!closed->until) return std::string(sheet.word("closed_now"));
  return filled_in(sheet.word("closed_until"), "when",
                   moment_in(sheet.museum(), sheet.request().state.language, *closed->until,
                             sheet.closed().day));
}

/// Its number, its gallery, and its floor where that is another; or that it is closed.
std::string exhibit_line(const Sheet& sheet, std::uint32_t index) {
  const Museum& museum = sheet.museum();
  const Exhibit& exhibit = museum.exhibits[index];
  std::string line =
      number_in(museum, sheet.request().state.language, static_cast<long>(index) + 1);
  const std::string closed = closed_line(sheet, index);
  const std::string after =
      closed.empty() ? where_line(sheet, exhibit.floor, exhibit.room) : closed;
  if (!after.empty()) line.append(between).append(after);
  return line;
}

std::string_view title_of(Listed lists) noexcept {
  switch (lists) {
    case Listed::Exhibits:
      break;
    case Listed::Places:
      return "places_title";
    case Listed::OwnTour:
      return "own_tour";
    case Listed::Languages:
      return "languages_title";
    case Listed::Found:
      return "search";
  }
  return "choose_title";
}

std::string own_tour_line(const Sheet& sheet) {
  const InterfaceState& state = sheet.request().state;
  const OwnTour& tour = state.own_tour;
  std::string line = filled_in(sheet.word("own_tour_stops"), "n",
                               number_in(sheet.museum(), state.language, tour.count));
  if (tour.is_ordered && tour.seconds > 0)
    line.append(between).append(time_in(sheet.museum(), state.language, tour.seconds));
  return line;
}

std::string tour_line(const Sheet& sheet, const Tour& tour) {
  return filled_in(sheet.word("tour_card"), "time",
                   time_in(sheet.museum(), sheet.request().state.language, tour.seconds));
}

/// Where the only one of its kind is, or how many there are.
std::string kind_line(const Sheet& sheet, PlaceKind kind) {
  const Museum& museum = sheet.museum();
  if (const auto only = only_place(museum, kind)) {
    const Place& place = museum.places[*only];
    return where_line(sheet, place.floor, room_of(museum, place.floor, place.position));
  }
  const auto count =
      std::ranges::count_if(museum.places, [&](const Place& p) { return answers(p.kind, kind); });
  return filled_in(sheet.word("place_nearest"), "n",
                   number_in(museum, sheet.request().state.language, count));
}

PixelBox draw_tour_progress(Sheet& sheet, const PixelBox& box) {
  const InterfaceState& state = sheet.request().state;
  const Museum& museum = sheet.museum();
  const std::optional<TourStops> tour = stops_of(museum, state.own_tour, state.tour);
  if (!tour) return box;
  const auto number = [&](std::size_t n) {
    return number_in(museum, state.language, static_cast<long>(n));
  };
  std::string line = filled_in(sheet.word("page_of"), "n", number(state.tour->stop + 1));
  line = filled_in(line, "total", number(tour->exhibits.size()));
  const bool is_over = state.arrived && !next_stop(museum, state.own_tour, state.tour);
  const double left = seconds_left(museum, state.own_tour, state.tour, state.arrived);
  const std::string_view title = state.tour->tour == TourWalk::own
                                     ? sheet.word("own_tour")
                                     : sheet.local(museum.tours[state.tour->tour].title);
  line = std::string(title).append(between) + line;
  if (is_over)
    line.append(between).append(sheet.word("tour_done"));
  else if (left > 0)
    line.append(between).append(
        filled_in(sheet.word("tour_left"), "time", time_in(museum, state.language, left)));
  const float bottom = sheet.piece(sheet.fitted(sheet.style(Letters::Small, 2), line, box.width),
                                   box.x, box.y, box.width, Align::Start, sheet.theme().quiet_ink) +
                       sheet.measures().unit;
  return {box.x, bottom, box.width, box.bottom() - bottom};
}

void draw_what(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const Action& action = sheet.view().controls[static_cast<std::size_t>(control)].action;
  if (action.kind == Action::Kind::Seek)
    return draw_sign(sheet, static_cast<PlaceKind>(action.argument), box, control);
  if (action.kind == Action::Kind::GoToPlace)
    return draw_sign(sheet, sheet.museum().places[action.argument].kind, box, control);
  const std::uint32_t exhibit = action.kind == Action::Kind::ShowOwnTour
                                    ? sheet.request().state.own_tour.exhibit[0]
                                : action.kind == Action::Kind::Browse
                                    ? group_of(sheet.museum(), action.argument).exhibits.front()
                                    : action.argument;
  sheet.fill(box, sheet.theme().plaster, m.corner, control);
  sheet.image(box, sheet.museum().exhibits[exhibit].image, m.corner, control);
}

void draw_sign(Sheet& sheet, PlaceKind kind, const PixelBox& box, std::int32_t control) {
  constexpr float margin = 0.14F;  // of the tile
  sheet.fill(box, sheet.theme().quiet_ink, sheet.measures().corner, control);
  sheet.pictogram(pictogram_of(kind), box.inset(std::round(margin * box.width)),
                  sheet.theme().paper, control);
}

std::string line_of(const Sheet& sheet, const Control& control) {
  if (control.action.kind == Action::Kind::Seek)
    return kind_line(sheet, static_cast<PlaceKind>(control.action.argument));
  if (control.action.kind == Action::Kind::GoToPlace) {
    const Place& place = sheet.museum().places[control.action.argument];
    return where_line(sheet, place.floor, room_of(sheet.museum(), place.floor, place.position));
  }
  if (control.action.kind == Action::Kind::Browse) {
    const Group group = group_of(sheet.museum(), control.action.argument);
    return std::string(sheet.word(group.kind))
        .append(between)
        .append(number_in(sheet.museum(), sheet.request().state.language,
                          static_cast<long>(group.exhibits.size())));
  }
  if (control.action.kind == Action::Kind::ShowOwnTour) return own_tour_line(sheet);
  const Tour* tour = begun_tour(sheet, control);
  return tour != nullptr ? tour_line(sheet, *tour) : exhibit_line(sheet, control.action.argument);
}

namespace {

/// To an exhibit that cannot be seen just now. A tour that begins with one can be begun.
bool leads_to_closed(const Sheet& sheet, const Control& control) noexcept {
  const bool is_exhibit =
      control.action.kind == Action::Kind::Choose ||
      (control.action.kind == Action::Kind::FollowTour && begun_tour(sheet, control) == nullptr);
  return is_exhibit && closed_exhibit(sheet.closed(), control.action.argument) != nullptr;
}

}  // namespace

void draw_card(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  if (control < 0) return;
  const Measures& m = sheet.measures();
  const Control& it = sheet.view().controls[static_cast<std::size_t>(control)];
  sheet.place(control, box);
  if (it.selected) sheet.mark_selected(box, control);
  const PixelBox picture{box.x, box.y, box.height, box.height};
  draw_what(sheet, control, picture);

  const float x = picture.right() + m.gap, width = box.right() - x - m.gap / 2;
  TextStyle title_style = sheet.style(Letters::Item);
  title_style.line_height = title_style.right_to_left ? 1.5F : 1.25F;
  TextPiece title = sheet.fitted(title_style, sheet.local(it.label), width);
  const std::string line = line_of(sheet, it);
  TextStyle room_style = sheet.style(Letters::Small);
  room_style.line_height = title_style.line_height;
  TextPiece second = sheet.fitted(room_style, line, width);
  const auto shrink_to = [&](float share) {
    title_style.size = std::floor(share * title_style.size);
    room_style.size = std::floor(share * room_style.size);
    title = sheet.fitted(title_style, sheet.local(it.label), width);
    second = sheet.fitted(room_style, line, width);
  };
  if (title.cut) {  // in two lines, as large as there is room for
    title_style.max_lines = 2;
    const float whole = (2 * title_style.size + room_style.size) * title_style.line_height;
    shrink_to(std::min(0.7F, box.height / whole));
  }
  if (const float whole = title.height + second.height; whole > box.height)
    shrink_to(box.height / whole);
  const float top = box.y + (box.height - title.height - second.height) / 2;
  const bool is_closed = leads_to_closed(sheet, it);
  sheet.piece(title, x, top, width, Align::Start,
              is_closed ? sheet.theme().quiet_ink : sheet.theme().ink, control);
  sheet.piece(second, x, top + title.height, width, Align::Start, sheet.theme().quiet_ink, control);
}

float draw_routes(Sheet& sheet, const PixelBox& box, Along along) {
  const Measures& m = sheet.measures();
  std::vector<std::int32_t> controls;
  for (std::size_t i = 0; i < sheet.view().controls.size(); ++i)
    if (sheet.view().controls[i].action.kind == Action::Kind::TakeRoute)
      controls.push_back(static_cast<std::int32_t>(i));
  const auto kinds = static_cast<float>(route_kinds.size());
  const float gap = std::round(m.unit);
  const bool row = along == Along::Row;
  const float width = row ? std::floor((box.width - (kinds - 1) * gap) / kinds) : box.width;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const auto n = static_cast<float>(i);
    draw_route(sheet, controls[i],
               {box.x + (row ? n * (width + gap) : 0), box.y + (row ? 0 : n * (m.touch + gap)),
                width, m.touch},
               along);
  }
  return box.y + (row ? m.touch : kinds * m.touch + (kinds - 1) * gap);
}

float draw_foot(Sheet& sheet, const PixelBox& content, std::string_view button_name) {
  const Measures& m = sheet.measures();
  const float top = content.bottom() - m.touch;
  const std::int32_t end_button = sheet.control(button_name);
  const float button_width = end_button < 0 ? 0 : std::round(content.width * 0.36F);
  if (end_button >= 0)
    sheet.button(end_button, {content.right() - button_width, top, button_width, m.touch},
                 Sheet::Emphasis::Soft);

  draw_languages(sheet, {content.x, top,
                         content.width - button_width - (end_button < 0 ? 0 : m.gap), m.touch});
  return top;
}

}  // namespace docent::interface

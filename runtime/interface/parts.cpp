/// The parts that several screens share: cards, route kinds, the lowest row.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "runtime/interface/button_grid.h"
#include "runtime/interface/finder.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/places.h"
#include "runtime/interface/sheet.h"
#include "runtime/scene/look.h"

namespace docent::interface {
namespace {

constexpr std::string_view dot_between = "  ·  ";  // parts of a line

}  // namespace

void draw_stroke(Sheet& sheet, const PixelBox& box, scene::Colour colour, float corner,
                 std::int32_t control) {
  constexpr float pale = 0.6F;  // linear light, from where paper is no ground for it
  if (colour.g > pale && !sheet.request().shape.is_night)
    sheet.fill(box.inset(-std::max(1.0F, 0.12F * sheet.measures().unit)), sheet.theme().quiet_ink,
               corner, control);
  sheet.fill(box, colour, corner, control);
}

namespace {

/// A sample of a route kind's ribbon.
void draw_pattern(Sheet& sheet, RouteKind kind, const PixelBox& box, std::int32_t control) {
  const InterfaceState& state = sheet.request().state;
  const scene::Colour colour =
      sheet.on_paper(state.look ? scene::trail_colour(*state.look) : scene::route_colour(kind));
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

constexpr float sample_thick = 0.9F, sample_long = 7, route_pad = 1.5F;  // units

/// The sample above its words, or before them where routes are below each other.
void draw_route(Sheet& sheet, std::int32_t control, const PixelBox& box, bool is_beside) {
  const Measures& m = sheet.measures();
  sheet.place(control, box);
  const Control& it = sheet.at(control);
  const auto kind = static_cast<RouteKind>(it.action.argument);
  if (it.selected) sheet.mark_selected(box, control);
  const float pad = std::round(route_pad * m.unit), thick = std::round(sample_thick * m.unit);
  const float sample = std::round(sample_long * m.unit);
  const scene::Colour ink = sheet.quiet_colour(control);
  if (is_beside) {
    draw_pattern(sheet, kind,
                 {box.x + pad, std::round(box.y + (box.height - thick) / 2), sample, thick},
                 control);
    const float x = box.x + pad + sample + pad;
    return sheet.control_word(control, {x, box.y, box.right() - x - pad, box.height}, Align::Start,
                              ink);
  }
  draw_pattern(sheet, kind,
               {std::round(box.x + (box.width - sample) / 2), box.y + pad, sample, thick}, control);
  const float top = pad + thick;
  sheet.control_word(control, {box.x + pad, box.y + top, box.width - 2 * pad, box.height - top},
                     Align::Centre, ink);
}

/// How routes lie in that width.
struct RouteGrid {
  ButtonGrid grid;
  bool is_beside = false;  ///< A sample and its words.
};
RouteGrid routes_in(Sheet& sheet, std::span<const std::int32_t> controls, float width,
                    Along along) {
  const Measures& m = sheet.measures();
  const float pad = std::round(route_pad * m.unit), thick = std::round(sample_thick * m.unit);
  GridRules rules{.width = width,
                  .margin = 2 * pad,
                  .gap = std::round(m.unit),
                  .lines = 3,
                  .above = pad + thick};
  if (along == Along::Row) {
    const ButtonGrid grid = grid_of(sheet, controls, rules);
    if (grid.columns == controls.size()) return {grid, false};
  }
  rules.margin = 3 * pad + std::round(sample_long * m.unit);
  rules.above = 0;
  rules.most_columns = 1;
  return {grid_of(sheet, controls, rules), true};
}

std::vector<std::int32_t> controls_that(Sheet& sheet, Action::Kind does, Role role) {
  std::vector<std::int32_t> controls;
  for (std::size_t i = 0; i < sheet.view().controls.size(); ++i) {
    const Control& it = sheet.view().controls[i];
    if (it.action.kind == does && it.role == role) controls.push_back(static_cast<std::int32_t>(i));
  }
  return controls;
}

}  // namespace

void draw_language(Sheet& sheet, std::int32_t control, const PixelBox& box, Align align) {
  const Measures& m = sheet.measures();
  sheet.place(control, box);
  if (sheet.at(control).selected) sheet.mark_selected(box, control);
  sheet.control_word(control, {box.x + m.unit, box.y, box.width - 2 * m.unit, box.height}, align,
                     sheet.quiet_colour(control));
}

namespace {

/// Side by side, each as wide as its name; empty where that is too much.
std::vector<float> widths_of_names(Sheet& sheet, std::span<const std::int32_t> controls,
                                   float width) {
  const Measures& m = sheet.measures();
  std::vector<float> widths;
  float whole = 0;
  for (const std::int32_t control : controls) {
    const float name =
        sheet.extent(sheet.word_style(control, 1e4F), sheet.label_of(control), 1e4F).width;
    widths.push_back(std::max(m.touch, std::ceil(name + 2 * m.unit) + 2));
    whole += widths.back() + m.unit;
  }
  return whole - m.unit > width ? std::vector<float>{} : widths;
}

ButtonGrid grid_of_names(Sheet& sheet, std::span<const std::int32_t> controls, float width) {
  const Measures& m = sheet.measures();
  return grid_of(sheet, controls,
                 {.width = width, .margin = 2 * m.unit, .gap = std::round(m.unit), .lines = 1});
}

/// Of names side by side.
float height_of_names(Sheet& sheet, std::span<const std::int32_t> controls) {
  float height = sheet.measures().touch;
  for (const std::int32_t control : controls)
    height = std::max(
        height,
        sheet.extent(sheet.word_style(control, 1e4F), sheet.label_of(control), 1e4F).height);
  return height;
}

float height_of_languages(Sheet& sheet, float width) {
  const std::int32_t list = sheet.control("languages");
  if (list >= 0) {
    const std::array one{list};
    return grid_of(sheet, one, {.width = width, .margin = sheet.signed_margin()}).height();
  }
  const auto controls = controls_that(sheet, Action::Kind::Speak, Role::Choice);
  if (controls.empty()) return 0;
  return widths_of_names(sheet, controls, width).empty()
             ? grid_of_names(sheet, controls, width).height()
             : height_of_names(sheet, controls);
}

/// Do languages take more than one row, or what leads to them more than a line?
bool needs_rows(Sheet& sheet, float width) {
  const std::int32_t list = sheet.control("languages");
  if (list >= 0) {
    const std::array one{list};
    return !have_room(sheet, one, width - sheet.signed_margin(), 2);
  }
  const auto controls = controls_that(sheet, Action::Kind::Speak, Role::Choice);
  return !controls.empty() && widths_of_names(sheet, controls, width).empty();
}

void draw_languages(Sheet& sheet, const PixelBox& box) {
  const Measures& m = sheet.measures();
  if (const std::int32_t list = sheet.control("languages"); list >= 0)
    return sheet.signed_button(list, Pictogram::Languages, box);
  const auto controls = controls_that(sheet, Action::Kind::Speak, Role::Choice);
  const std::vector<float> widths = widths_of_names(sheet, controls, box.width);
  if (widths.empty()) {
    const ButtonGrid grid = grid_of_names(sheet, controls, box.width);
    for (std::size_t i = 0; i < controls.size(); ++i)
      draw_language(sheet, controls[i], grid.cell(box, i), Align::Centre);
    return;
  }
  float x = box.x;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    draw_language(sheet, controls[i], {x, box.y, widths[i], box.height}, Align::Centre);
    x += widths[i] + m.unit;
  }
}

}  // namespace

Block languages_block(Sheet& sheet, float gap) {
  return {.height = [&sheet](float width) { return height_of_languages(sheet, width); },
          .draw =
              [&sheet](const PixelBox& box) {
                if (box.height > 0) draw_languages(sheet, box);
              },
          .gap = gap};
}

Block buttons_block(Sheet& sheet, std::vector<RowButton> all, float gap, float least) {
  std::erase_if(all, [](const RowButton& one) { return one.control < 0; });
  const auto buttons = std::make_shared<const std::vector<RowButton>>(std::move(all));
  const auto grid = [&sheet, buttons, least](float width) {
    std::vector<std::int32_t> controls;
    for (const RowButton& one : *buttons) controls.push_back(one.control);
    return grid_of(sheet, controls,
                   {.width = width,
                    .margin = sheet.button_margin(),
                    .gap = sheet.measures().gap,
                    .fills = true,
                    .least = least});
  };
  return {.height = [grid](float width) { return grid(width).height(); },
          .draw =
              [&sheet, buttons, grid](const PixelBox& box) {
                const ButtonGrid cells = grid(box.width);
                for (std::size_t i = 0; i < buttons->size(); ++i)
                  sheet.button((*buttons)[i].control, cells.cell(box, i), (*buttons)[i].emphasis);
              },
          .gap = gap};
}

Block routes_block(Sheet& sheet, Along along, float gap) {
  const auto controls = std::make_shared<const std::vector<std::int32_t>>(
      controls_that(sheet, Action::Kind::TakeRoute, Role::Choice));
  if (controls->empty())
    return {.height = [](float) { return 0.0F; }, .draw = [](const PixelBox&) {}};
  return {.height =
              [&sheet, controls, along](float width) {
                return routes_in(sheet, *controls, width, along).grid.height();
              },
          .draw =
              [&sheet, controls, along](const PixelBox& box) {
                const RouteGrid routes = routes_in(sheet, *controls, box.width, along);
                for (std::size_t i = 0; i < controls->size(); ++i)
                  draw_route(sheet, (*controls)[i], routes.grid.cell(box, i), routes.is_beside);
              },
          .gap = gap};
}

/// Languages at the start and the button at the end of one row, or in rows of their own.
std::vector<Block> foot_blocks(Sheet& sheet, std::string_view button_name) {
  const Measures& m = sheet.measures();
  const std::int32_t end = sheet.control(button_name);
  Block languages = languages_block(sheet, m.gap);
  if (end < 0) return {languages};
  const std::array one{end};
  constexpr float share = 0.36F;
  const auto is_one_row = [&sheet, one, languages](float width) {
    const float rest = width - std::round(share * width) - sheet.measures().gap;
    return have_room(sheet, one, std::round(share * width) - sheet.button_margin(), 2) &&
           !needs_rows(sheet, rest);
  };
  const auto row = buttons_block(sheet, {{end, Sheet::Emphasis::Soft}}, 0);
  Block all;
  all.height = [is_one_row, languages, row, gap = m.gap](float width) {
    if (is_one_row(width)) {
      const float wide = std::round(share * width);
      return std::max(row.height(wide), languages.height(width - wide - gap));
    }
    const float names = languages.height(width);
    return names + (names > 0 ? gap : 0) + row.height(width);
  };
  all.draw = [is_one_row, languages, row, gap = m.gap](const PixelBox& box) {
    if (is_one_row(box.width)) {
      const float width = std::round(share * box.width);
      const float height = row.height(width);
      row.draw({box.right() - width, box.bottom() - height, width, height});
      const float rest = box.width - width - gap, names = languages.height(rest);
      return languages.draw({box.x, box.bottom() - names, rest, names});
    }
    const float names = languages.height(box.width);
    languages.draw({box.x, box.y, box.width, names});
    const float top = names > 0 ? names + gap : 0;
    row.draw({box.x, box.y + top, box.width, box.height - top});
  };
  return {all};
}

float draw_floors(Sheet& sheet, const PixelBox& free) {
  const Measures& m = sheet.measures();
  const auto controls = controls_that(sheet, Action::Kind::ShowFloor, Role::Choice);
  if (controls.empty()) return 0;
  const auto floor_of = [&](std::int32_t control) -> const Floor& {
    return sheet.museum().floors[sheet.at(control).action.argument];
  };
  const auto count = static_cast<float>(controls.size());
  const float gap = std::round(m.unit);
  const float most = std::floor((free.height - 2 * m.margin - (count - 1) * gap) / count);
  const float height = std::min(m.touch, most);
  TextStyle style = sheet.style(Letters::Label);
  style.line_height = 1.15F;
  float width = height;
  for (const std::int32_t control : controls)
    width = std::max(width,
                     m.unit + sheet.extent(style, floor_of(control).plan.short_name, 1e4F).width);
  const float x = free.right() - m.margin - width;
  float y = std::round(free.y + (free.height - count * height - (count - 1) * gap) / 2);
  const PixelBox board{x - gap, y - gap, width + 2 * gap, count * (height + gap) + gap};
  sheet.shadow(board, 2 * m.unit, 0.12F);
  sheet.fill(board, sheet.theme().paper, m.corner);
  for (const std::int32_t control : controls) {
    const Control& it = sheet.at(control);
    const Floor& floor = floor_of(control);
    const PixelBox box{x, y, width, height};
    sheet.place(control, box);
    if (it.selected) sheet.mark_selected(box, control);
    style.weight = it.selected ? 600 : 400;
    const TextPiece name = sheet.set(style, floor.plan.short_name, width);
    sheet.piece(name, box.x, box.y + (box.height - name.height) / 2, box.width, Align::Centre,
                sheet.quiet_colour(control), control);
    if (it.selected)
      sheet.text(sheet.style(Letters::Lead), sheet.local(floor.title), free.x + m.margin,
                 free.y + m.margin, board.x - free.x - 2 * m.margin, sheet.theme().quiet_ink);
    y += height + gap;
  }
  return free.right() - board.x;
}

std::string where_line(const Sheet& sheet, std::uint32_t floor, std::uint32_t room) {
  const Museum& museum = sheet.museum();
  std::string line;
  const auto add = [&line](std::string_view part) {
    if (!part.empty()) line.append(line.empty() ? "" : dot_between).append(part);
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
  if (!after.empty()) line.append(dot_between).append(after);
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
    case Listed::Times:
      return "times";
  }
  return "choose_title";
}

std::string own_tour_line(const Sheet& sheet) {
  const InterfaceState& state = sheet.request().state;
  const OwnTour& tour = state.own_tour;
  std::string line = filled_in(sheet.word("own_tour_stops"), "n",
                               number_in(sheet.museum(), state.language, tour.count));
  if (tour.is_ordered && tour.seconds > 0)
    line.append(dot_between).append(time_in(sheet.museum(), state.language, tour.seconds));
  return line;
}

std::string tour_line(const Sheet& sheet, const Tour& tour) {
  const std::uint32_t language = sheet.request().state.language;
  const std::string time = time_in(sheet.museum(), language, tour.seconds);
  if (!is_for_time(tour)) return filled_in(sheet.word("tour_card"), "time", time);
  const std::string stops =
      number_in(sheet.museum(), language, static_cast<long>(tour.exhibits.size()));
  return filled_in(sheet.word("own_tour_stops"), "n", stops).append(dot_between).append(time);
}

std::string times_line(const Sheet& sheet) {
  const Museum& museum = sheet.museum();
  const std::uint32_t language = sheet.request().state.language;
  std::string line;
  for (std::size_t i = tours_of_staff(museum); i + 1 < museum.tours.size(); ++i)
    line.append(number_in(museum, language, std::lround(museum.tours[i].minutes)))
        .append(dot_between);
  return museum.tours.empty() ? line : line + title_in(museum, language, museum.tours.back());
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

std::string tour_progress(const Sheet& sheet) {
  const InterfaceState& state = sheet.request().state;
  const Museum& museum = sheet.museum();
  const std::optional<TourStops> tour = stops_of(museum, state.own_tour, state.tour);
  if (!tour) return {};
  const auto number = [&](std::size_t n) {
    return number_in(museum, state.language, static_cast<long>(n));
  };
  std::string line = filled_in(sheet.word("page_of"), "n", number(state.tour->stop + 1));
  line = filled_in(line, "total", number(tour->exhibits.size()));
  const bool is_over = state.arrived && !next_stop(museum, state.own_tour, state.tour);
  const double left = seconds_left(museum, state.own_tour, state.tour, state.arrived);
  const std::string title = state.tour->tour == TourWalk::own
                                ? std::string(sheet.word("own_tour"))
                                : title_in(museum, state.language, museum.tours[state.tour->tour]);
  line = title + std::string(dot_between) + line;
  if (is_over)
    line.append(dot_between).append(sheet.word("tour_done"));
  else if (left > 0)
    line.append(dot_between)
        .append(filled_in(sheet.word("tour_left"), "time", time_in(museum, state.language, left)));
  return line;
}

void draw_what(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const Action& action = sheet.view().controls[static_cast<std::size_t>(control)].action;
  if (action.kind == Action::Kind::Seek)
    return draw_sign(sheet, static_cast<PlaceKind>(action.argument), box, control);
  if (action.kind == Action::Kind::GoToPlace)
    return draw_sign(sheet, sheet.museum().places[action.argument].kind, box, control);
  const Tour* tour = begun_tour(sheet.museum(), sheet.at(control));
  if (action.kind == Action::Kind::ShowTimes || (tour != nullptr && is_for_time(*tour)))
    return draw_tile(sheet, Pictogram::Time, box, control);
  const std::uint32_t exhibit = action.kind == Action::Kind::ShowOwnTour
                                    ? sheet.request().state.own_tour.exhibit[0]
                                : action.kind == Action::Kind::Browse
                                    ? group_of(sheet.museum(), action.argument).exhibits.front()
                                    : action.argument;
  sheet.fill(box, sheet.theme().plaster, m.corner, control);
  sheet.image(box, sheet.museum().exhibits[exhibit].image, m.corner, control);
}

std::vector<std::int32_t> list_items(const Sheet& sheet) {
  std::vector<std::int32_t> items;
  for (std::size_t i = 0; i < sheet.controls().size(); ++i)
    if (sheet.controls()[i].role == Role::ListItem) items.push_back(static_cast<std::int32_t>(i));
  return items;
}

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

void draw_tile(Sheet& sheet, Pictogram what, const PixelBox& box, std::int32_t control) {
  constexpr float margin = 0.14F;  // of the tile
  sheet.fill(box, sheet.theme().quiet_ink, sheet.measures().corner, control);
  sheet.pictogram(what, box.inset(std::round(margin * box.width)), sheet.theme().paper, control);
}

void draw_sign(Sheet& sheet, PlaceKind kind, const PixelBox& box, std::int32_t control) {
  draw_tile(sheet, pictogram_of(kind), box, control);
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
        .append(dot_between)
        .append(number_in(sheet.museum(), sheet.request().state.language,
                          static_cast<long>(group.exhibits.size())));
  }
  if (control.action.kind == Action::Kind::ShowOwnTour) return own_tour_line(sheet);
  if (control.action.kind == Action::Kind::ShowTimes) return times_line(sheet);
  const Tour* tour = begun_tour(sheet.museum(), control);
  return tour != nullptr ? tour_line(sheet, *tour) : exhibit_line(sheet, control.action.argument);
}

namespace {

/// To an exhibit that cannot be seen just now. A tour that begins with one can be begun.
bool leads_to_closed(const Sheet& sheet, const Control& control) noexcept {
  const bool is_exhibit = control.action.kind == Action::Kind::Choose ||
                          (control.action.kind == Action::Kind::FollowTour &&
                           begun_tour(sheet.museum(), control) == nullptr);
  return is_exhibit && closed_exhibit(sheet.closed(), control.action.argument) != nullptr;
}

}  // namespace

namespace {

/// The two texts of a card, beside its picture.
struct CardTexts {
  TextStyle title, line;
  std::string second;
  float title_height = 0, line_height = 0;

  float height() const noexcept { return title_height + line_height; }
};

CardTexts texts_of(Sheet& sheet, std::int32_t control, float width) {
  CardTexts texts{.title = sheet.style(Letters::Item),
                  .line = sheet.style(Letters::Small),
                  .second = line_of(sheet, sheet.at(control))};
  for (TextStyle* style : {&texts.title, &texts.line})
    style->line_height = style->line_height > 1.5F ? 1.5F : 1.25F;
  texts.title_height = sheet.height_of(texts.title, sheet.label_of(control), width);
  texts.line_height = sheet.height_of(texts.line, texts.second, width);
  return texts;
}

float width_of_texts(const Sheet& sheet, float width, float picture) {
  return width - picture - 1.5F * sheet.measures().gap;
}

}  // namespace

float height_of_card(Sheet& sheet, std::int32_t control, float width, float least) {
  const float pad = std::round(sheet.measures().unit / 2);
  const CardTexts texts = texts_of(sheet, control, width_of_texts(sheet, width, least));
  return std::max(least, std::ceil(texts.height() + 2 * pad));
}

void draw_card(Sheet& sheet, std::int32_t control, const PixelBox& box, float picture) {
  if (control < 0) return;
  const Measures& m = sheet.measures();
  sheet.place(control, box);
  if (sheet.at(control).selected) sheet.mark_selected(box, control);
  draw_what(sheet, control,
            {box.x, std::round(box.y + (box.height - picture) / 2), picture, picture});
  const float x = box.x + picture + m.gap;
  const float width = width_of_texts(sheet, box.width, picture);
  const CardTexts texts = texts_of(sheet, control, width);
  const float top = box.y + (box.height - texts.height()) / 2;
  sheet.text_of(
      control, texts.title, sheet.label_of(control), x, top, width,
      leads_to_closed(sheet, sheet.at(control)) ? sheet.theme().quiet_ink : sheet.theme().ink);
  sheet.text_of(control, texts.line, texts.second, x, top + texts.title_height, width,
                sheet.theme().quiet_ink);
}

Block card_block(Sheet& sheet, std::int32_t control, float gap) {
  const float picture = list_shape(sheet.request().shape).row_height;
  return {.height = [&sheet, control, picture](
                        float width) { return height_of_card(sheet, control, width, picture); },
          .draw = [&sheet, control,
                   picture](const PixelBox& box) { draw_card(sheet, control, box, picture); },
          .gap = gap};
}

}  // namespace docent::interface

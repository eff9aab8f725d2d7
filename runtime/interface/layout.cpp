#include "runtime/interface/layout.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "runtime/interface/cues.h"
#include "runtime/interface/face.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/pictures.h"
#include "runtime/interface/scroll.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/look.h"

namespace docent::interface {
namespace {

constexpr float least_model = 0.55F;  ///< The share of the screen that the model keeps.

/// The panel in pixels, left to right.
PixelBox panel_box(const ScreenShape& shape) noexcept {
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  constexpr float most = 0.44F;  // so that it does
  if (!is_landscape(shape)) {
    const float panel = std::round(height * most);
    return {0, height - panel, width, panel};
  }
  const float unit = measures_of(shape).unit;
  const float panel =
      std::round(std::clamp(width * 0.37F, std::min(80 * unit, width * most), width * most));
  return {0, 0, panel, height};
}

/// What the panel leaves free, as for a language that runs from left to right.
PixelBox free_box(const ScreenShape& shape) noexcept {
  const scene::Rect free = free_part_of(shape, false);
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  return {free.x * width, free.y * height, free.width * width, free.height * height};
}

/// Where a glass is lowered to, in pixels: as wide for its height as the glass.
PixelBox low_box(const ScreenShape& shape) noexcept {
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  const ReachableBand reach = low_reach_of(shape);
  const float top = std::ceil(reach.top * height);
  const float tall = std::floor(reach.bottom * height) - top;
  const float wide = std::round(width * tall / height);
  return {std::floor((width - wide) / 2), top, wide, tall};
}

/// Moves a view that was laid out for the low part of a glass to where that is.
void lower(View& view, const ScreenShape& shape) noexcept {
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  const PixelBox low = low_box(shape);
  const float across = low.width / width, down = low.height / height;
  const float lengths = std::min(low.width, low.height) / std::min(width, height);
  const auto move = [&](scene::Rect& rect) {
    if (rect.width <= 0) return;  // it lies nowhere
    rect = {low.x / width + across * rect.x, low.y / height + down * rect.y, across * rect.width,
            down * rect.height};
  };
  const auto move_quad = [&](scene::Quad& quad) {
    move(quad.rect);
    quad.corner *= lengths;
    quad.softness *= lengths;
  };
  for (Control& control : view.controls) move(control.rect);
  for (Element& element : view.elements) move_quad(element.quad);
  for (CountedText& text : view.remaining) move_quad(text.quad);
  for (TimedText& text : view.cues)
    for (scene::Quad* quad : {&text.ground, &text.quad}) move_quad(*quad);
  for (scene::Rect* rect : {&view.panel, &view.countdown, &view.free, &view.inset.board,
                            &view.scroll.rect, &view.scroll.rail})
    move(*rect);
  for (scene::Rect& board : view.boards) move(board);
  for (float* length :
       {&view.scroll.length, &view.scroll.page, &view.scroll.least, &view.scroll.fade})
    *length *= down;
  for (ScrollArea::Scrolled& one : view.scroll.controls) move(one.rect);
  view.pixel_width = width;
  view.pixel_height = height;
}

/// The pictogram of a place where it is.
FloorLabel sign_on_model(Sheet& sheet, std::int32_t control) {
  constexpr float side = 3.4F;  // units
  const Action& action = sheet.view().controls[static_cast<std::size_t>(control)].action;
  const Place& place = sheet.museum().places[action.argument];
  const TextPiece sign = sheet.sign(pictogram_of(place.kind), side * sheet.measures().unit);
  return {.position = place.position,
          .height = 1.6F,
          .texture = sign.texture,
          .width_px = sign.width,
          .height_px = sign.height,
          .control = control,
          .is_sign = true,
          .rect = {}};
}

/// Is it another number for who stands at the other side, as 6 and 9 or 16 and 91 are?
bool is_another_upside_down(std::string_view number) {
  constexpr std::string_view upright = "01689", turned = "01986";
  std::string other;
  for (const char digit : number) {
    const std::size_t at = upright.find(digit);
    if (at == upright.npos) return false;
    other.insert(other.begin(), turned[at]);
  }
  return other != number && !other.starts_with('0');
}

/// With a line below it, which says where that is.
std::string underlined(std::string_view digits) {
  constexpr std::string_view low_line = "\u0332";  // it joins the digit before it
  std::string text;
  for (const char digit : digits) {
    text += digit;
    text += low_line;
  }
  return text;
}

/// An exhibit's number as it is set: where it is turned to people at several sides, it cannot be
/// taken for another.
TextPiece number_piece(Sheet& sheet, const std::string& number, float widest) {
  TextStyle style = sheet.style(Letters::Small);
  style.weight = 600;
  const bool is_turned = sheet.request().shape.sides.count() > 1;
  const bool is_marked = is_turned && is_another_upside_down(number);
  TextPiece piece = sheet.set(style, is_marked ? underlined(number) : number, widest);
  if (is_marked) piece.words = number;
  return piece;
}

/// Where each exhibit stands and each gallery is called, for the choosing screen.
void add_floor_labels(Sheet& sheet) {
  const Museum& museum = sheet.museum();
  View& view = sheet.view();
  const std::uint32_t language = sheet.request().state.language;

  const std::uint32_t floor = sheet.request().state.floor.value_or(museum.kiosk_floor);
  const float widest = 32 * sheet.measures().unit * sheet.request().shape.text_scale;

  for (const Room& room : museum.rooms) {
    if (room.floor != floor) continue;
    TextStyle style = sheet.style(Letters::Small);
    style.weight = 500;
    style.line_height = style.line_height > 1.5F ? 1.4F : 1.2F;
    const TextPiece name = sheet.set(style, sheet.local(room.title), widest);
    FloorLabel label{.position = room.label,
                     .texture = name.texture,
                     .width_px = name.width,
                     .height_px = name.height,
                     .words = sheet.words_of(name),
                     .least = room.label,
                     .most = room.label,
                     .rect = {}};
    for (const Vec2& corner : room.outline) {
      label.least = glm::min(label.least, corner);
      label.most = glm::max(label.most, corner);
    }
    view.labels.push_back(label);
  }
  for (std::size_t i = 0; i < view.controls.size(); ++i) {
    const Control& control = view.controls[i];
    if (control.role != Role::Spot) continue;
    if (control.action.kind == Action::Kind::GoToPlace) {
      view.labels.push_back(sign_on_model(sheet, static_cast<std::int32_t>(i)));
      continue;
    }
    const Exhibit& exhibit = museum.exhibits[control.action.argument];
    const std::string said =
        number_in(museum, language, static_cast<long>(control.action.argument) + 1);
    const TextPiece number = number_piece(sheet, said, widest);
    view.labels.push_back(
        {.position = exhibit.placement.position,
         .height = 2.3F,
         .texture = number.texture,
         .width_px = number.width,
         .height_px = number.height,
         .control = static_cast<std::int32_t>(i),
         .words = sheet.words_of(number),
         .on_disc = true,
         .is_closed = closed_exhibit(sheet.closed(), control.action.argument) != nullptr,
         .rect = {}});
  }
}

/// The model of a shared glass, or one of the cards about it.
void lay_out_shared(Sheet& sheet, const ScreenShape& shape) {
  View& view = sheet.view();
  const ViewRequest& request = sheet.request();
  if (!request.state.seat) {
    // Walls and figures at its edges stand clear of cards.
    const float x = shape.sides.is_table() ? sheet.measures().margin / view.pixel_width / 2 : 0;
    const float y = sheet.measures().margin / view.pixel_height / 2;
    const scene::Rect model = model_of(shape);
    view.free = {model.x + x, model.y + y, model.width - 2 * x, model.height - 2 * y};
    lay_out_model(sheet);
    add_floor_labels(sheet);
    return;
  }
  const scene::Rect card = card_of(shape, request.state.seats, *request.state.seat);
  lay_out_seat(sheet, {card.x * view.pixel_width, card.y * view.pixel_height,
                       card.width * view.pixel_width, card.height * view.pixel_height});
}

/// The model stands above what lies on its lower edge, as far as most of the screen stays its own.
void leave_to_model(View& view, float strip) noexcept {
  const float least = std::min(view.free.height, least_model / view.free.width);
  view.free.height = std::max(least, view.free.height - strip / view.pixel_height);
}

}  // namespace

bool runs_right_to_left(const Museum& museum, std::uint32_t language) noexcept {
  return language < museum.languages.size() && museum.languages[language].right_to_left;
}

scene::Rect panel_of(const ScreenShape& shape) noexcept {
  const PixelBox box = panel_box(shape);
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  return {box.x / width, box.y / height, box.width / width, box.height / height};
}

scene::Rect free_part_of(const ScreenShape& shape, bool right_to_left) noexcept {
  const scene::Rect panel = panel_of(shape);
  if (!is_landscape(shape)) return {0, 0, 1, panel.y};
  return {right_to_left ? 0 : panel.width, 0, 1 - panel.width, 1};
}

ScreenShape shape_for(ScreenShape shape, const InterfaceState& state) noexcept {
  constexpr float larger = 1.5F, largest = 2;
  if (state.large_letters) shape.text_scale = std::min(larger * shape.text_scale, largest);
  if (!state.low_reach) return shape;
  const PixelBox low = low_box(shape);
  shape.diagonal_inches *= low.height / static_cast<float>(shape.height);
  shape.width = static_cast<std::uint32_t>(low.width);
  shape.height = static_cast<std::uint32_t>(low.height);
  // What is left of a small glass has no room for letters that are much larger.
  constexpr float mm_per_inch = 25.4F, least_side = 240, whole_side = 300;
  const float side = shape.diagonal_inches * mm_per_inch * std::min(low.width, low.height) /
                     std::hypot(low.width, low.height);
  const float room = std::clamp((side - least_side) / (whole_side - least_side), 0.0F, 1.0F);
  shape.text_scale = std::min(shape.text_scale, std::lerp(1.0F, largest, room));
  return shape;
}

std::uint32_t exhibits_per_page(const ScreenShape& shape) noexcept {
  const ListShape list = list_shape(shape);
  return list.columns * list.rows;
}

std::uint32_t exhibits_per_page(const ScreenShape& shape, const InterfaceState& state) noexcept {
  if (state.seat) return rows_of_card(shape, state.seats, *state.seat);
  const ScreenShape shown = shape_for(shape, state);
  return state.screen == Screen::Searching ? found_per_page(shown) : exhibits_per_page(shown);
}

scene::Side side_of(const ScreenShape& shape, const InterfaceState& state) noexcept {
  return state.seat ? side_of(shape, state.seats, *state.seat) : scene::Side::Bottom;
}

bool shows_way(const InterfaceState& state) noexcept {
  return (state.seat || state.glass == Glass::Whole) &&
         (state.screen == Screen::Walking || state.screen == Screen::Arrived);
}

ListShape list_shape(const ScreenShape& shape) noexcept {
  const Measures m = measures_of(shape);
  const float content_height = panel_box(shape).height - 2 * m.margin;
  ListShape list;
  list.columns = is_landscape(shape) ? 1 : 2;
  list.row_height = std::round(std::max(m.touch, 9.8F * m.unit * (0.6F + 0.4F * shape.text_scale)));
  list.row_gap = std::round(m.unit);
  // A line of the tallest heading, which is Arabic's, has room on a small glass, too.
  list.heading_height = std::round(std::max(9.5F * m.unit, 18.5F * m.mm) * shape.text_scale);
  list.foot_height = std::ceil(3.6F * m.touch + 3 * m.gap);
  const float room = content_height - list.heading_height - list.foot_height + list.row_gap;
  list.rows = static_cast<std::uint32_t>(
      std::clamp(std::floor(room / (list.row_height + list.row_gap)), 1.0F, 12.0F));
  return list;
}

std::unique_ptr<View> make_view(const Museum& museum, const ViewRequest& asked, PieceCache& pieces,
                                const Closures& closed, const ShownWay* way) {
  ViewRequest request = asked;
  auto view = std::make_unique<View>();
  view->side = side_of(asked.shape, asked.state);
  request.shape = seen_from(view->side, shape_for(asked.shape, asked.state));
  view->request = request.id;
  view->part = request.part;
  view->state = request.state;
  view->controls = controls_of(museum, request.state, exhibits_per_page(asked.shape, asked.state));
  view->free = free_part_of(request.shape, runs_right_to_left(museum, request.state.language));
  view->pixel_width = static_cast<float>(request.shape.width);
  view->pixel_height = static_cast<float>(request.shape.height);
  const Measures measures = measures_of(request.shape);
  view->spot_px = measures.touch;
  view->unit_px = measures.unit;
  view->is_right_to_left = runs_right_to_left(museum, request.state.language);

  Sheet sheet(museum, request, pieces, closed, *view, way);
  view->accent = request.state.look ? sheet.on_paper(scene::trail_colour(*request.state.look))
                                    : sheet.theme().invitation;
  if (request.state.glass != Glass::Whole) {
    lay_out_shared(sheet, asked.shape);
    sheet.finish();
    view->speech = speech_of(museum, asked, view->controls, closed, way);
    return view;
  }
  const PixelBox panel = panel_box(request.shape);
  sheet.draw_panel(panel);
  const PixelBox content = panel.inset(sheet.measures().margin);
  faces_of(request.state.screen).whole.lay_out(sheet, content);
  PixelBox free = free_box(request.shape);
  float strip = draw_helps(sheet, free);
  if (request.state.screen == Screen::Searching) {
    strip += draw_search_board(sheet, {free.x, free.y, free.width, free.height - strip});
    leave_to_model(*view, strip);
  }
  if (shows_spots(request.state.screen)) add_floor_labels(sheet);
  if (shows_way(request.state)) draw_inset(sheet, free);
  draw_walk(sheet, free);
  // The guide's feet are seen above what helps.
  if (shows_way(request.state)) leave_to_model(*view, strip);
  if (request.state.screen == Screen::Choosing) {
    // The model stands beside the floors' buttons, not below them; and above the strip, as far as
    // most of the screen stays its own.
    free.height -= strip;
    const float column = draw_floors(sheet, free) / view->pixel_width;
    view->free.width -= column;
    if (runs_right_to_left(museum, request.state.language)) view->free.x += column;
    leave_to_model(*view, strip);
  }
  if (const auto sound = shown_sound(museum, request.state)) {
    view->cues.clear();  // of a video that stands still
    view->cues_scroll = false;
    draw_sound_cues(sheet, free, *sound);
  }
  if (request.state.asks_to_stay) draw_still_here(sheet, free_box(request.shape));
  sheet.finish();
  if (request.state.low_reach) lower(*view, asked.shape);
  view->speech = speech_of(museum, asked, view->controls, closed, way);
  return view;
}

}  // namespace docent::interface

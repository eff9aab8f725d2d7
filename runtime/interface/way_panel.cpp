/// What a visitor learns in ten seconds: the way in three sentences, and on a small plan.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "runtime/interface/button_grid.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/plan_drawing.h"
#include "runtime/interface/sentences.h"
#include "runtime/model/geometry/polyline.h"
#include "runtime/scene/look.h"

namespace docent::interface {
namespace {

/// The board of the inset plan, as for a language that runs from left to right: at the upper corner
/// that is farthest from the panel.
struct Board {
  PixelBox box;
  float head = 0;  ///< The height of its upper part, which bears the floor's name and the compass.
};
Board board_on(Sheet& sheet, const PixelBox& free, const FloorPlan& plan, double heading,
               const TextPiece& name) {
  const Measures& m = sheet.measures();
  const float pad = 1.5F * m.unit, head = std::max(9 * m.unit, name.height + pad);
  const float widest = std::min(46 * m.unit, 0.42F * free.width) - 2 * pad;
  const float highest = std::min(40 * m.unit, 0.44F * free.height) - head - pad;
  const auto aspect = static_cast<float>(aspect_of(plan, heading));
  const float least = std::max(22 * m.unit, name.width + 6 * m.unit);  // for the floor's name
  const float height = std::min(highest, widest / aspect);
  const float width = std::round(std::max(least, height * aspect) + 2 * pad);
  return {{std::round(free.right() - m.gap - width), std::round(free.y + m.gap), width,
           std::round(height + head + pad)},
          head};
}

/// Changes whenever the way does.
std::uint64_t print_of(std::span<const Vec2> line) noexcept {
  std::uint64_t print = 14695981039346656037ULL;  // FNV-1a
  for (const Vec2 point : line)
    for (const double number : {point.x, point.y})
      print = (print ^ std::bit_cast<std::uint64_t>(number)) * 1099511628211ULL;
  return print;
}

}  // namespace

std::vector<Block> sentence_blocks(Sheet& sheet) {
  if (sheet.way() == nullptr) return {};
  const WaySentences said =
      sentences_in(sheet.museum(), sheet.request().state.language, sheet.way()->directions);
  const TextStyle style = sheet.style(Letters::Body);
  const float gap = std::round(sheet.measures().unit);
  const scene::Theme& theme = sheet.theme();
  return {text_block(sheet, style, said.way, theme.ink, gap),
          text_block(sheet, style, said.goal, theme.ink, gap),
          text_block(sheet, style, said.figures, theme.quiet_ink, 2 * gap)};
}

namespace {

TextStyle style_of_name(Sheet& sheet) {
  TextStyle style = sheet.style(Letters::Small);
  style.line_height = style.line_height > 1.5F ? 1.4F : 1.2F;
  return style;
}

/// What is ahead of whoever looks at the model from the view's side.
double heading_of(const Sheet& sheet, scene::Side side) noexcept {
  constexpr double quarter = std::numbers::pi / 2;
  return sheet.museum().kiosk.heading - quarter * static_cast<double>(side);
}

/// The plan with the way, below the floor's name and the compass.
void draw_board(Sheet& sheet, const Board& board, const TextPiece& name) {
  const Museum& museum = sheet.museum();
  const Measures& m = sheet.measures();
  const Floor& floor = museum.floors[sheet.way()->floor];
  const scene::Side side = sheet.view().side;
  const double heading = heading_of(sheet, side);
  const auto& [box, head] = board;
  const float pad = 1.5F * m.unit;
  const DrawingShape shape{.width = static_cast<std::uint32_t>(box.width),
                           .height = static_cast<std::uint32_t>(box.height),
                           .plan_least = {pad, head},
                           .plan_most = {box.width - pad, box.height - pad}};
  const PlanFrame frame = frame_of(floor.plan, heading, shape);
  const bool turned = runs_right_to_left(museum, sheet.request().state.language);
  const float compass = box.width - pad - 2.6F * m.unit, middle = head / 2 + 0.6F * m.unit;
  const InterfaceState& state = sheet.request().state;
  const RouteKind kind = state.kind;
  const scene::Colour way_colour =
      state.look ? scene::srgb(scene::looks[*state.look % scene::looks.size()].coat)
                 : sheet.on_paper(scene::route_colour(kind));
  const bool is_here = sheet.way()->floor == museum.kiosk_floor;
  const bool is_night = sheet.request().shape.is_night;
  const PlanDrawing drawing{.plan = floor.plan,
                            .frame = frame,
                            .shape = shape,
                            .way = sheet.way()->line,
                            .way_colour = scene::hex_of(way_colour),
                            .is_cased = state.look || (kind == RouteKind::Offset && !is_night),
                            .colours = is_night ? plan_at_night : PlanColours{},
                            .here = is_here ? std::optional(museum.kiosk.position) : std::nullopt,
                            .compass = {turned ? box.width - compass : compass, middle},
                            .unit = m.unit};
  sheet.drawing(
      box,
      fmt::format("plan|{}|{}|{}|{}|{}|{}|{}|{}|{}", is_night, sheet.way()->floor, shape.width,
                  shape.height, turned, scene::hex_of(way_colour), museum.kiosk.position.x,
                  static_cast<int>(side), print_of(sheet.way()->line)),
      [&] { return draw_plan(drawing); });
  const float room = compass - 4.2F * m.unit - pad;
  sheet.piece(name, box.x + pad, box.y + middle - name.height / 2, room, Align::Start,
              sheet.theme().quiet_ink);
  TextStyle style = style_of_name(sheet);
  style.weight = 600;
  style.size = std::min(style.size, std::round(3.3F * m.unit));  // within its ring
  TextPiece north = sheet.set(style, sheet.word("north"), 1e4F);
  if (const float widest = 3.9F * m.unit; north.width > widest) {
    style.size = std::floor(style.size * widest / north.width);
    north = sheet.set(style, sheet.word("north"), 1e4F);
  }
  sheet.piece(north, box.x + compass - 2 * m.unit, box.y + middle - north.height / 2, 4 * m.unit,
              Align::Centre, sheet.theme().ink);

  InsetPlan& inset = sheet.view().inset;
  inset.board = sheet.share_of(box);
  inset.floor = sheet.way()->floor;
  inset.origin = frame.origin;
  inset.right = frame.scale / box.width * frame.right;
  inset.down = frame.scale / box.height * frame.down;
  inset.way = sheet.way()->line;
  inset.reach = distances_along(inset.way);
  inset.guide = state.look ? sheet.on_paper(scene::trail_colour(*state.look)) : sheet.theme().focus;
}

}  // namespace

void draw_inset(Sheet& sheet, const PixelBox& free) {
  if (sheet.way() == nullptr) return;
  const Museum& museum = sheet.museum();
  const Measures& m = sheet.measures();
  const Floor& floor = museum.floors[sheet.way()->floor];
  const TextPiece name =
      sheet.set(style_of_name(sheet), sheet.local(floor.title),
                std::max(16 * m.unit, std::min(38 * m.unit, 0.42F * free.width) - 8 * m.unit));
  const Board board = board_on(sheet, free, floor.plan, museum.kiosk.heading, name);
  if (board.box.height < board.head + 6 * m.unit) return;
  sheet.board(board.box);
  draw_board(sheet, board, name);
}

void draw_plan_on_card(Sheet& sheet, const PixelBox& box) {
  if (sheet.way() == nullptr) return;
  const Measures& m = sheet.measures();
  const Floor& floor = sheet.museum().floors[sheet.way()->floor];
  const TextPiece name =
      sheet.set(style_of_name(sheet), sheet.local(floor.title), box.width - 8 * m.unit);
  const float head = std::max(6.8F * m.unit, name.height + 1.5F * m.unit);
  const PixelBox whole{std::round(box.x), std::round(box.y), std::floor(box.width),
                       std::floor(box.height)};
  if (whole.height < head + 6 * m.unit || whole.width < 14 * m.unit) return;
  sheet.outline(whole, -1);
  draw_board(sheet, {whole, head}, name);
}

void draw_walk(Sheet& sheet, const PixelBox& free) {
  const std::int32_t walk = sheet.control("walk");
  if (walk < 0) return;
  // As wide in every language, and whether or not there is a plan beside it.
  constexpr float ordinary = 40, most = 0.45F;  // units; share of the model's width
  const Measures& m = sheet.measures();
  const float scale = sheet.request().shape.text_scale;
  const float width = std::round(std::min(ordinary * m.unit * scale, most * free.width));
  float y = free.y + m.gap;
  for (const auto& [control, emphasis] :
       {std::pair{walk, Sheet::Emphasis::Strong},
        std::pair{sheet.control("onward"), Sheet::Emphasis::Soft}}) {
    if (control < 0) continue;
    const Block button = buttons_block(sheet, {{control, emphasis}}, 0);
    const float height = button.height(width);
    button.draw({free.x + m.gap, y, width, height});
    y += height + m.gap;
  }
}

}  // namespace docent::interface

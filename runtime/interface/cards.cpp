/// What stands on the shared glass: the words on the model, and the card of each visitor.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/interface/card_parts.h"
#include "runtime/interface/face.h"
#include "runtime/interface/figure.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/pictures.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/look.h"

namespace docent::interface {
namespace {

constexpr float taken_opacity = 0.18F;  // of a guide whom somebody else has

/// What the visitor is led to, and the way there on the small plan.
Block view_of_goal(Sheet& sheet, float gap) {
  return {.height = [](float) { return 0.0F; },
          .draw =
              [&sheet](const PixelBox& box) {
                const Measures& m = sheet.measures();
                if (box.height < 2 * m.touch) return;
                if (sheet.way() == nullptr) {
                  draw_goal(sheet, box);
                  return;
                }
                if (box.height > box.width) {
                  const float top = draw_goal(sheet, {box.x, box.y, box.width, box.height / 2});
                  const float y = box.y + top + (top > 0 ? m.gap : 0);
                  return draw_plan_on_card(sheet, {box.x, y, box.width, box.bottom() - y});
                }
                const float half = std::floor((box.width - m.gap) / 2);
                draw_goal(sheet, {box.x, box.y, half, box.height});
                draw_plan_on_card(sheet, {box.right() - half, box.y, half, box.height});
              },
          .gap = gap,
          .most = [](float) { return 1e4F; }};
}

/// A band in the guide's colour along the card's upper edge: whose card it is.
void draw_band(Sheet& sheet, const PixelBox& card) {
  const Measures& m = sheet.measures();
  const std::optional<std::uint32_t> look = sheet.request().state.look;
  if (!look) return;
  draw_stroke(sheet,
              {card.x + m.corner, card.y, card.width - 2 * m.corner, std::round(0.8F * m.unit)},
              sheet.on_paper(scene::trail_colour(*look)), 0, -1);
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
  const PixelBox slip{std::max(0.0F, box.x + (box.width - width) / 2),
                      std::max(0.0F, box.y + (box.height - height) / 2), width, height};
  sheet.shadow(slip, 2 * m.unit, 0.16F);
  sheet.fill(slip, sheet.theme().paper, m.corner);
  sheet.piece(words, slip.x, slip.y + m.gap, slip.width, Align::Centre, sheet.theme().ink);
}

}  // namespace

namespace {

/// Nobody is at the table: each of its seats says what it is for.
void draw_welcome(Sheet& sheet, const PixelBox& card) {
  const Measures& m = sheet.measures();
  const scene::Theme& theme = sheet.theme();
  const std::int32_t join = sheet.control("begin");
  sheet.shadow(card, 2 * m.unit, 0.16F);
  sheet.fill(card, theme.paper, m.corner, join);
  const PixelBox content = card.inset(std::round(2 * card_margin * m.unit));
  const Block guides{.height = [](float) { return 0.0F; },
                     .draw = [&sheet](const PixelBox& box) { draw_guides(sheet, box); },
                     .most = [](float) { return 1e4F; }};
  lay_out_column(
      sheet, content,
      {heading_block(sheet, Letters::Heading, std::string(sheet.word("welcome")), theme.ink, m.gap),
       guides},
      {text_block(sheet, sheet.style(Letters::Lead), std::string(sheet.local(sheet.at(join).label)),
                  theme.ink, 0)});
}

}  // namespace

/// Nobody is here: where others are, whoever comes is invited.
void lay_out_welcome_card(Sheet& sheet, const PixelBox& card) {
  const Measures& m = sheet.measures();
  const std::int32_t join = sheet.control("begin");
  sheet.place(join, card);
  const bool is_table = sheet.request().shape.sides.is_table();
  if (sheet.request().state.glass == Glass::Quiet && is_table) return draw_welcome(sheet, card);
  if (sheet.request().state.glass == Glass::Quiet) return;
  sheet.fill(card, scene::with_opacity(sheet.theme().paper, 0.55F), m.corner, join);
  sheet.control_word(join, card.inset(card_margin * m.unit), Align::Centre,
                     sheet.theme().quiet_ink);
}

namespace {

/// The guides in rows. Where a card is too narrow for what they are called, they are seen, and
/// heard.
struct GuideGrid {
  std::uint32_t columns = 4;
  float width = 0, words = 0;  ///< Of a cell; the height of what is written in it.
};

class GuidesOnCard {
 public:
  explicit GuidesOnCard(Sheet& sheet)
      : sheet_(sheet),
        gap_(std::round(sheet.measures().unit)),
        style_(sheet.style(Letters::Small)) {
    style_.line_height = style_.line_height > 1.5F ? 1.4F : 1.15F;
    for (std::uint32_t i = 0; i < scene::guide_look_count; ++i)
      if (const auto control = sheet.control("look:" + std::string(scene::looks[i].name));
          control >= 0)
        guides_.emplace_back(control, i);
  }

  Block block(float gap) const {
    const auto least = [self = *this](float width) {
      constexpr float figure = 4;  // units
      const GuideGrid grid = self.grid_in(width);
      return self.rows_of(grid) *
                 (figure * self.sheet_.measures().unit + grid.words + 2 * self.pad() + self.gap_) -
             self.gap_;
    };
    return {.height = [least](float width) { return std::ceil(least(width)); },
            .draw = [self = *this](const PixelBox& box) { self.draw(box); },
            .gap = gap,
            .most = [](float) { return 1e4F; }};
  }

 private:
  float pad() const noexcept { return std::round(0.4F * sheet_.measures().unit); }
  float rows_of(const GuideGrid& grid) const noexcept {
    return std::ceil(static_cast<float>(scene::guide_look_count) /
                     static_cast<float>(grid.columns));
  }
  GuideGrid grid_in(float width) const {
    GuideGrid grid;
    const auto width_of = [&](std::uint32_t columns) {
      const auto n = static_cast<float>(columns);
      return std::floor((width - (n - 1) * gap_) / n);
    };
    // A fingertip, which is less than the height of other controls.
    const float least = std::ceil(15 * sheet_.measures().mm) + 1;
    while (grid.columns > 1 && width_of(grid.columns) < least) grid.columns /= 2;
    grid.width = width_of(grid.columns);
    const float room = grid.width - 2 * pad();
    const bool are_named = std::ranges::all_of(guides_, [&](const auto& guide) {
      return sheet_.longest_word(style_, sheet_.label_of(guide.first)) <= room;
    });
    for (const auto& [control, look] : guides_)
      if (are_named)
        grid.words =
            std::max(grid.words, sheet_.extent(style_, sheet_.label_of(control), room).height);
    return grid;
  }
  void draw(const PixelBox& box) const {
    const GuideGrid grid = grid_in(box.width);
    const float height = std::floor((box.height + gap_) / rows_of(grid) - gap_);
    for (const auto& [control, look] : guides_) {
      const auto column = static_cast<float>(look % grid.columns);
      const std::uint32_t rows_above = look / grid.columns;
      const auto row = static_cast<float>(rows_above);
      draw_one(control, look, grid.words,
               {box.x + column * (grid.width + gap_), box.y + row * (height + gap_), grid.width,
                height});
    }
  }
  void draw_one(std::int32_t control, std::uint32_t look, float words, const PixelBox& cell) const {
    const Control& it = sheet_.at(control);
    sheet_.place(control, cell);
    if (it.enabled) sheet_.fill(cell, sheet_.theme().plaster, sheet_.measures().corner, control);
    const PixelBox inside = cell.inset(pad());
    draw_figure(sheet_, scene::looks[look],
                {inside.x, inside.y, inside.width, inside.height - words},
                it.enabled ? 1 : taken_opacity, control);
    if (!it.enabled || words <= 0) return;
    const TextPiece name = sheet_.set(style_, sheet_.label_of(control), inside.width);
    sheet_.piece(name, inside.x, inside.bottom() - (words + name.height) / 2, inside.width,
                 Align::Centre, sheet_.theme().ink, control);
  }

  Sheet& sheet_;
  float gap_;
  TextStyle style_;
  std::vector<std::pair<std::int32_t, std::uint32_t>> guides_;  ///< Control and look.
};

}  // namespace

void lay_out_picking_card(Sheet& sheet, const PixelBox& content) {
  const float gap = std::round(sheet.measures().unit);
  const Block asked = text_block(sheet, sheet.style(Letters::Lead),
                                 std::string(sheet.word("pick_title")), sheet.theme().ink, gap);
  constexpr std::array<std::string_view, 1> home{"home"};
  const Block question = beside_corner(sheet, {asked}, gap);
  const Block guides = GuidesOnCard(sheet).block(gap);
  std::vector<Block> foot{languages_block(sheet, gap), card_buttons(sheet, home, 0)};
  if (lay_out_wide(sheet, content, {{question}, foot, {guides}, {}})) return;
  lay_out_column(sheet, content, {question, guides}, std::move(foot));
}

void lay_out_walking_card(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  constexpr std::array<std::string_view, 3> names{"stop", "skip", "choose"};
  const Block invitation = beside_corner(sheet, invitation_blocks(sheet, Letters::Lead), m.gap);
  const Block routes = routes_block(sheet, Along::Row, m.gap);
  const Block buttons = card_buttons(sheet, names, 0), goal = view_of_goal(sheet, m.gap);
  if (lay_out_wide(sheet, content, {{invitation}, {buttons}, {goal}, {routes}})) return;
  lay_out_column(sheet, content, {invitation, goal}, {routes, buttons});
}

void lay_out_arrived_card(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const bool is_longer = reads_more(sheet.museum(), sheet.request().state);
  const std::vector<Block> told =
      is_longer ? more_blocks(sheet, Letters::Heading) : goal_blocks(sheet, Letters::Heading);
  const Block tour = text_block(sheet, sheet.style(Letters::Small), tour_progress(sheet),
                                sheet.theme().quiet_ink, m.unit);
  const Block name = beside_corner(sheet, {tour, told.front()}, m.unit);
  const std::vector<Block> text(told.begin() + 1, told.end());
  std::vector<Block> foot;
  if (const std::int32_t next = sheet.control("next"); next >= 0)
    foot.push_back(row_block(sheet, next, m.unit));
  constexpr std::array<std::string_view, 4> buttons{"more", "less", "choose", "home"};
  foot.push_back(card_buttons(sheet, buttons, 0));
  std::vector<Block> words{name};
  // A longer text takes the wide end, where its pictures were.
  if (is_longer && lay_out_wide(sheet, content, {words, foot, text, {}})) return;
  std::vector<Block> seen = picture_blocks(sheet, 0, 6 * m.unit, m.unit);
  std::ranges::copy(text, std::back_inserter(words));
  if (lay_out_wide(sheet, content, {words, foot, seen, {}, true})) return;
  seen.front().most = [room = 0.4F * content.height, most = seen.front().most](float width) {
    return std::min(room, most(width));
  };
  std::vector<Block> body{name};
  if (!is_longer) std::ranges::copy(seen, std::back_inserter(body));
  std::ranges::copy(text, std::back_inserter(body));
  lay_out_column(sheet, content, std::move(body), std::move(foot));
}

void lay_out_seat(Sheet& sheet, const PixelBox& card) {
  const InterfaceState& state = sheet.request().state;
  const Measures& m = sheet.measures();
  sheet.lie_on(card);
  const Face& face = faces_of(state.screen).card;
  if (state.screen == Screen::Welcome) return face.lay_out(sheet, card);
  sheet.shadow(card, 2 * m.unit, 0.16F);
  sheet.fill(card, sheet.theme().paper, m.corner);
  draw_band(sheet, card);
  face.lay_out(sheet, card.inset(std::round(card_margin * m.unit)));
}

void lay_out_model(Sheet& sheet) {
  const Measures& m = sheet.measures();
  const Museum& museum = sheet.museum();
  const ViewRequest& request = sheet.request();
  const auto width = static_cast<float>(request.shape.width);
  const auto height = static_cast<float>(request.shape.height);
  const scene::Rect model = model_of(request.shape);
  const float strip = model.height * height;
  switch (request.state.glass) {
    case Glass::Whole:
    case Glass::Busy:
      return;
    case Glass::Quiet: {
      if (request.shape.sides.is_table()) return;  // its cards say so
      const PixelBox paper{0, strip, width, height - strip};
      sheet.shadow(paper, 4 * m.unit, 0.16F);
      sheet.fill(paper, sheet.theme().paper, 0);
      PixelBox content = paper.inset(m.margin);
      PixelBox guides = content;
      guides.x = content.x + content.width * 0.4F;
      guides.width = content.right() - guides.x;
      content.width = guides.x - m.margin - content.x;
      const scene::Theme& theme = sheet.theme();
      std::vector<Block> words{
          text_block(sheet, sheet.style(Letters::Label), std::string(sheet.local(museum.title)),
                     theme.quiet_ink, m.gap),
          heading_block(sheet, Letters::Welcome, std::string(sheet.word("welcome")), theme.ink,
                        m.gap),
          text_block(sheet, sheet.style(Letters::Lead), std::string(sheet.local(museum.welcome)),
                     theme.quiet_ink, m.gap),
          text_block(sheet, sheet.style(Letters::Lead), std::string(sheet.word("join_where")),
                     theme.ink, 0)};
      lay_out_column(sheet, content, std::move(words), {});
      return draw_guides(sheet, guides);
    }
    case Glass::Full:
    case Glass::TurnedAway: {
      const bool told = request.state.glass == Glass::TurnedAway;
      if (!told && request.shape.sides.is_table()) return;
      const PixelBox box = told ? PixelBox{model.x * width, model.y * height, model.width * width,
                                           model.height * height}
                                : PixelBox{m.margin, m.margin, 0.2F * width, 0.15F * height};
      const TextPiece words =
          sheet.set(sheet.style(told ? Letters::Lead : Letters::Body), sheet.word("all_taken"),
                    std::min(box.width, 0.6F * width) - 2 * m.margin);
      return draw_slip(sheet, words, box);
    }
  }
}

}  // namespace docent::interface

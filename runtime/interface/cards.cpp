/// What stands on the shared glass: the words on the model, and the card of each visitor.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/interface/face.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/look.h"

namespace docent::interface {
namespace {

constexpr float card_margin = 2;  // units
constexpr float row_units = 8;    // height of a row of the list
constexpr float heading_units = 5;
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
              sheet.on_paper(scene::trail_colour(*look)), 0, -1);
}

/// The helps of every screen as pictograms, in the card's upper corner: those that this state has,
/// and below them what is asked of ways.
class Corner {
 public:
  explicit Corner(Sheet& sheet) : sheet_(sheet), gap_(std::round(sheet.measures().unit)) {
    constexpr std::array<std::array<std::pair<std::string_view, Pictogram>, 3>, 2> rows{
        {{{{"toilets", pictogram_of(PlaceKind::Toilets)},
           {"places", Pictogram::Places},
           {"exhibits", Pictogram::Exhibits}}},
         {{{"step-free", Pictogram::StepFree},
           {"no-escalators", Pictogram::NoEscalators},
           {"", Pictogram::Count}}}}};
    for (const auto& row : rows) {
      std::vector<Help> there;
      for (const auto& [name, pictogram] : row)
        if (const std::int32_t control = name.empty() ? -1 : sheet.control(name); control >= 0)
          there.push_back({control, pictogram});
      if (!there.empty()) rows_.push_back(std::move(there));
    }
  }

  /// With the gap before it, or below it.
  float width() const noexcept {
    std::size_t most = 0;
    for (const auto& row : rows_) most = std::max(most, row.size());
    return static_cast<float>(most) * side();
  }
  float height() const noexcept { return static_cast<float>(rows_.size()) * side(); }

  void draw(const PixelBox& box) const {
    const float touch = sheet_.measures().touch;
    float y = box.y;
    for (const auto& row : rows_) {
      float x = box.right() - touch;
      for (const Help& help : row) {
        draw_help(help, {x, y, touch, touch});
        x -= side();
      }
      y += side();
    }
  }

 private:
  struct Help {
    std::int32_t control = -1;
    Pictogram pictogram = Pictogram::Count;
  };
  float side() const noexcept { return sheet_.measures().touch + gap_; }
  void draw_help(const Help& help, const PixelBox& box) const {
    const bool is_on = sheet_.at(help.control).selected;
    sheet_.place(help.control, box);
    sheet_.fill(box, is_on ? sheet_.theme().ink : sheet_.theme().plaster, sheet_.measures().corner,
                help.control);
    sheet_.pictogram(help.pictogram, box.inset(std::round(0.16F * box.width)),
                     is_on ? sheet_.theme().paper : sheet_.theme().ink, help.control);
  }

  Sheet& sheet_;
  float gap_;
  std::vector<std::vector<Help>> rows_;
};

/// Blocks with the helps beside them, or below those where that leaves them too little.
Block beside_corner(Sheet& sheet, std::vector<Block> blocks, float gap) {
  constexpr float least = 14;  // units
  const auto shared = std::make_shared<const std::vector<Block>>(std::move(blocks));
  const auto corner = std::make_shared<const Corner>(sheet);
  const float scale = sheet.request().shape.text_scale, unit = sheet.measures().unit;
  const auto room = [corner, scale, unit](float width) {
    return width - corner->width() >= least * unit * scale ? width - corner->width() : width;
  };
  return {.height =
              [shared, corner, room](float width) {
                const float wide = room(width), texts = height_of(*shared, wide);
                return wide < width || corner->height() == 0 ? std::max(texts, corner->height())
                                                             : texts + corner->height();
              },
          .draw =
              [shared, corner, room](const PixelBox& box) {
                const float wide = room(box.width);
                corner->draw(box);
                float y = box.y + (wide < box.width ? 0 : corner->height());
                for (const Block& block : *shared) {
                  const float height = block.height(wide);
                  block.draw({box.x, y, wide, height});
                  y += height + (height > 0 ? block.gap : 0);
                }
              },
          .gap = gap};
}

/// Buttons beside each other, those that this state has.
Block card_buttons(Sheet& sheet, std::span<const std::string_view> names, float gap) {
  std::vector<RowButton> there;
  for (const std::string_view name : names) {
    const bool is_strong = name == "stop" || name == "start-tour";
    there.push_back(
        {sheet.control(name), is_strong ? Sheet::Emphasis::Strong : Sheet::Emphasis::Soft});
  }
  return buttons_block(sheet, std::move(there), gap);
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

TextStyle row_style(const Sheet& sheet) {
  TextStyle style = sheet.style(Letters::Item);
  style.line_height = style.line_height > 1.5F ? 1.4F : 1.2F;
  return style;
}

float height_of_row_in(Sheet& sheet, std::int32_t control, float width) {
  const Measures& m = sheet.measures();
  const float picture = height_of_row(m), room = width - picture - 1.5F * m.unit;
  return std::max(picture, std::ceil(sheet.height_of(row_style(sheet),
                                                     row_text(sheet, sheet.at(control)), room)));
}

void draw_row(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  const Measures& m = sheet.measures();
  sheet.place(control, box);
  if (sheet.at(control).selected) sheet.fill(box, sheet.theme().plaster, m.corner, control);
  const float picture = height_of_row(m);
  draw_what(sheet, control,
            {box.x, std::round(box.y + (box.height - picture) / 2), picture, picture});
  const float x = box.x + picture + m.unit, width = box.width - picture - 1.5F * m.unit;
  const TextStyle style = row_style(sheet);
  const std::string text = row_text(sheet, sheet.at(control));
  const float height = sheet.height_of(style, text, width);
  sheet.text_of(control, style, text, x, box.y + (box.height - height) / 2, width,
                sheet.theme().ink);
}

/// A row of the list, and what collects it where that is an exhibit.
Block row_block(Sheet& sheet, std::int32_t control, float gap) {
  const Measures& m = sheet.measures();
  const Action& action = sheet.at(control).action;
  const std::int32_t collect =
      action.kind == Action::Kind::Choose ? sheet.collect(action.argument) : -1;
  const float aside = collect < 0 ? 0 : m.touch + std::round(m.unit / 2);
  return {
      .height = [&sheet, control,
                 aside](float width) { return height_of_row_in(sheet, control, width - aside); },
      .draw =
          [&sheet, control, collect, aside](const PixelBox& box) {
            const float touch = sheet.measures().touch;
            draw_row(sheet, control, {box.x, box.y, box.width - aside, box.height});
            if (collect >= 0)
              draw_collect(sheet, collect,
                           {box.right() - touch, box.y + (box.height - touch) / 2, touch, touch});
          },
      .gap = gap};
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

/// Nobody is here: where others are, whoever comes is invited.
void lay_out_welcome_card(Sheet& sheet, const PixelBox& card) {
  const Measures& m = sheet.measures();
  const std::int32_t join = sheet.control("begin");
  sheet.place(join, card);
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
  lay_out_column(sheet, content,
                 {beside_corner(sheet, {asked}, gap), GuidesOnCard(sheet).block(gap)},
                 {languages_block(sheet, gap), card_buttons(sheet, home, 0)});
}

void lay_out_choosing_card(Sheet& sheet, const PixelBox& content) {
  const float gap = std::round(sheet.measures().unit / 2);
  const Listed lists = sheet.request().state.lists;
  const Block title = text_block(sheet, sheet.style(Letters::Lead),
                                 std::string(sheet.word(title_of(lists))), sheet.theme().ink, gap);
  std::vector<Block> body{beside_corner(sheet, {title}, gap)};
  for (const std::int32_t control : list_items(sheet))
    body.push_back(row_block(sheet, control, gap));
  constexpr std::array<std::string_view, 2> pages{"page:previous", "page:next"};
  constexpr std::array<std::string_view, 2> buttons{"back", "home"};
  constexpr std::array<std::string_view, 2> start{"start-tour", "choose"};
  lay_out_column(
      sheet, content, std::move(body),
      {lists == Listed::OwnTour ? card_buttons(sheet, start, gap) : languages_block(sheet, gap),
       card_buttons(sheet, pages, gap), card_buttons(sheet, buttons, 0)});
}

void lay_out_walking_card(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  constexpr std::array<std::string_view, 3> buttons{"stop", "skip", "choose"};
  lay_out_column(sheet, content,
                 {beside_corner(sheet, invitation_blocks(sheet, Letters::Lead), m.gap),
                  picture_block(sheet, 0, 8 * m.unit, 0)},
                 {routes_block(sheet, Along::Row, m.gap), card_buttons(sheet, buttons, 0)});
}

void lay_out_arrived_card(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  std::vector<Block> told = goal_blocks(sheet, Letters::Heading);
  const Block name = told.front();
  told.front() = picture_block(sheet, 0, 6 * m.unit, m.unit);
  told.front().most = [room = 0.4F * content.height, most = told.front().most](float width) {
    return std::min(room, most(width));
  };
  const Block tour = text_block(sheet, sheet.style(Letters::Small), tour_progress(sheet),
                                sheet.theme().quiet_ink, m.unit);
  told.insert(told.begin(), beside_corner(sheet, {tour, name}, m.unit));
  std::vector<Block> foot;
  if (const std::int32_t next = sheet.control("next"); next >= 0)
    foot.push_back(row_block(sheet, next, m.unit));
  constexpr std::array<std::string_view, 2> buttons{"choose", "home"};
  foot.push_back(card_buttons(sheet, buttons, 0));
  lay_out_column(sheet, content, std::move(told), std::move(foot));
}

std::uint32_t rows_of_card(const ScreenShape& shape, std::uint32_t seats) noexcept {
  const Measures m = measures_of(shape);
  const float height =
      card_of(shape, std::max(seats, 1U), 1).height * static_cast<float>(shape.height);
  const float gap = std::round(m.unit / 2);
  const float room = height - 2 * std::round(card_margin * m.unit) - height_of_heading(m) -
                     3 * m.touch - m.gap - 2 * gap;
  return static_cast<std::uint32_t>(
      std::clamp(std::floor((room + gap) / (height_of_row(m) + gap)), 1.0F, 12.0F));
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
      const PixelBox box = told ? PixelBox{0, 0, width, strip}
                                : PixelBox{m.margin, m.margin, 0.2F * width, 0.15F * height};
      const TextPiece words =
          sheet.set(sheet.style(told ? Letters::Lead : Letters::Body), sheet.word("all_taken"),
                    std::min(box.width, 0.6F * width) - 2 * m.margin);
      return draw_slip(sheet, words, box);
    }
  }
}

}  // namespace docent::interface

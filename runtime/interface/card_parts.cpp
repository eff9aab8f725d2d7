#include "runtime/interface/card_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/interface/phrases.h"

namespace docent::interface {
namespace {

constexpr float row_units = 8;  // height of a row of the list

/// How much of a wide card is at its start, at least and at most.
constexpr std::array start_shares{0.34F, 0.4F, 0.46F, 0.52F};

float width_of_end(const Measures& m, float width, float share) noexcept {
  return width - std::floor(share * width) - 2 * m.gap;
}

}  // namespace

bool is_wide(const PixelBox& content) noexcept {
  constexpr float wide = 1.5F;
  return content.width >= wide * content.height;
}

float widest_end(const Measures& m, float width) noexcept {
  return width_of_end(m, width, start_shares.front());
}

bool lay_out_wide(Sheet& sheet, const PixelBox& content, const WideCard& card) {
  if (!is_wide(content)) return false;
  const Measures& m = sheet.measures();
  for (const float share : start_shares) {
    const float width = std::floor(share * content.width);
    const float foot = height_of(card.start_foot, width);
    const float space = card.start.empty() || foot <= 0 ? 0 : m.gap;
    const bool is_last = share == start_shares.back();
    if (height_of(card.start, width) + space + foot > content.height &&
        !(card.start_scrolls && is_last))
      continue;
    const float end = width_of_end(m, content.width, share);
    lay_out_column(sheet, {content.x, content.y, width, content.height}, card.start,
                   card.start_foot);
    lay_out_column(sheet, {content.right() - end, content.y, end, content.height}, card.end,
                   card.end_foot);
    return true;
  }
  return false;
}

std::size_t columns_in(const ScreenShape& shape, float width) noexcept {
  constexpr float least_mm = 88;
  const float least = least_mm * measures_of(shape).mm * shape.text_scale;
  return static_cast<std::size_t>(std::clamp(std::floor(width / least), 1.0F, 3.0F));
}

Block grid_block(Sheet& sheet, std::vector<Block> all, float row_gap, std::size_t columns) {
  struct Grid {
    Sheet& sheet;
    std::vector<Block> items;
    float row_gap;
    std::size_t wanted;

    std::size_t columns_of(float width) const {
      return wanted > 0 ? wanted : columns_in(sheet.request().shape, width);
    }
    float width_of(std::size_t columns, float width) const {
      const auto n = static_cast<float>(columns);
      return std::floor((width - (n - 1) * sheet.measures().gap) / n);
    }
    /// Calls for each row with its first item, its height and its top.
    float rows(float width, const std::function<void(std::size_t, float, float)>& row) const {
      const std::size_t columns = columns_of(width);
      float y = 0;
      for (std::size_t first = 0; first < items.size(); first += columns) {
        float height = 0;
        for (std::size_t i = first; i < std::min(first + columns, items.size()); ++i)
          height = std::max(height, items[i].height(width_of(columns, width)));
        row(first, height, y);
        y += height + row_gap;
      }
      return std::max(0.0F, y - row_gap);
    }
  };
  const auto grid = std::make_shared<const Grid>(sheet, std::move(all), row_gap, columns);
  return {.height = [grid](float width) { return grid->rows(width, [](auto, auto, auto) {}); },
          .draw =
              [grid](const PixelBox& box) {
                const std::size_t beside = grid->columns_of(box.width);
                const float wide = grid->width_of(beside, box.width);
                const float step = wide + grid->sheet.measures().gap;
                grid->rows(box.width, [&](std::size_t first, float height, float y) {
                  for (std::size_t i = first; i < std::min(first + beside, grid->items.size()); ++i)
                    grid->items[i].draw(
                        {box.x + static_cast<float>(i - first) * step, box.y + y, wide, height});
                });
              }};
}

float height_of_row(const Measures& m) noexcept {
  return std::round(std::max(m.touch, row_units * m.unit));
}

namespace {

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
           {"search", Pictogram::Search}}}}};
    for (const auto& row : rows) {
      std::vector<Help> there;
      for (const auto& [name, pictogram] : row)
        if (const std::int32_t control = sheet.control(name); control >= 0)
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

  float height_beside(float width) const noexcept {
    const std::size_t columns = columns_of(width), count = this->count();
    const std::size_t rows = (count + columns - 1) / columns;
    return static_cast<float>(rows) * side();
  }
  void draw_beside(const PixelBox& box) const {
    const float touch = sheet_.measures().touch;
    const std::size_t columns = columns_of(box.width);
    std::size_t i = 0;
    for (const auto& row : rows_)
      for (const Help& help : row) {
        const std::size_t column = i % columns, line = i / columns;
        draw_help(help, {box.x + static_cast<float>(column) * side(),
                         box.y + static_cast<float>(line) * side(), touch, touch});
        ++i;
      }
  }

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
  std::size_t count() const noexcept {
    std::size_t count = 0;
    for (const auto& row : rows_) count += row.size();
    return count;
  }
  /// In rows of the same length: four and two would be three and three.
  std::size_t columns_of(float width) const noexcept {
    const std::size_t most =
        static_cast<std::size_t>(std::max(1.0F, std::floor((width + gap_) / side())));
    const std::size_t rows = std::max<std::size_t>(1, (count() + most - 1) / most);
    return std::max<std::size_t>(1, (count() + rows - 1) / rows);
  }
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

}  // namespace

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

Block helps_block(Sheet& sheet, float gap) {
  const auto corner = std::make_shared<const Corner>(sheet);
  // Below the last row is no gap.
  const float below = std::round(sheet.measures().unit);
  return {
      .height = [corner, below](
                    float width) { return std::max(0.0F, corner->height_beside(width) - below); },
      .draw = [corner](const PixelBox& box) { corner->draw_beside(box); },
      .gap = gap};
}

Block card_buttons(Sheet& sheet, std::span<const std::string_view> names, float gap) {
  std::vector<RowButton> there;
  for (const std::string_view name : names) {
    const bool is_strong = name == "stop" || name == "start-tour";
    there.push_back(
        {sheet.control(name), is_strong ? Sheet::Emphasis::Strong : Sheet::Emphasis::Soft});
  }
  return buttons_block(sheet, std::move(there), gap);
}

namespace {

/// An exhibit's number, or how long a tour is, and what it is called; and that it is closed.
std::string row_text(const Sheet& sheet, const Control& control) {
  std::string title(sheet.local(control.label));
  const Action::Kind kind = control.action.kind;
  if (kind == Action::Kind::Seek || kind == Action::Kind::GoToPlace) return title;
  if (kind == Action::Kind::Browse) return title + "  ·  " + line_of(sheet, control);
  if (kind == Action::Kind::ShowOwnTour) return title + "  " + own_tour_line(sheet);
  if (kind == Action::Kind::ShowTimes) return title + "  " + times_line(sheet);
  const Tour* tour = begun_tour(sheet.museum(), control);
  if (tour != nullptr && is_for_time(*tour)) return title + "  ·  " + tour_line(sheet, *tour);
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

}  // namespace

Block row_block(Sheet& sheet, std::int32_t control, float gap) {
  const Measures& m = sheet.measures();
  const Action& action = sheet.at(control).action;
  if (action.kind == Action::Kind::Speak)
    return {.height = [&sheet](float) { return sheet.measures().touch; },
            .draw = [&sheet, control](
                        const PixelBox& box) { draw_language(sheet, control, box, Align::Start); },
            .gap = gap};
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

}  // namespace docent::interface

/// The list on the card of a seat: at least six rows of it are seen, however large the card is.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/interface/card_parts.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/seats.h"

namespace docent::interface {
namespace {

constexpr std::size_t fewest_rows = 6;
constexpr float heading_units = 5;

/// Of the question above the list; beside it are the helps.
float height_of_heading(const Measures& m) noexcept {
  return std::round(std::max(m.touch + m.unit, heading_units * m.unit));
}

/// A column of the list is so wide at least, in millimetres.
constexpr float least_column_mm = 62;

class ChoosingCard {
 public:
  ChoosingCard(Sheet& sheet, const PixelBox& content)
      : sheet_(sheet), content_(content), gap_(std::round(sheet.measures().unit / 2)) {
    const Listed lists = sheet.request().state.lists;
    const Block title =
        text_block(sheet, sheet.style(Letters::Lead), std::string(sheet.word(title_of(lists))),
                   sheet.theme().ink, gap_);
    titled_ = beside_corner(sheet, {title}, gap_);
    helps_ = helps_block(sheet, sheet.measures().unit);
    for (const std::int32_t control : list_items(sheet))
      rows_.push_back(row_block(sheet, control, gap_));
    constexpr std::array<std::string_view, 2> pages{"page:previous", "page:next"};
    constexpr std::array<std::string_view, 2> buttons{"back", "home"};
    constexpr std::array<std::string_view, 2> start{"start-tour", "choose"};
    choice_ =
        lists == Listed::OwnTour ? card_buttons(sheet, start, gap_) : languages_block(sheet, gap_);
    pages_ = card_buttons(sheet, pages, gap_);
    buttons_ = card_buttons(sheet, buttons, 0);
  }

  /// The first that shows all rows without anything that scrolls; or six of them.
  void lay_out() const {
    using enum Head;
    const bool is_first_wide = is_wide(content_);
    for (const Shown shown : {Shown::All, Shown::Six}) {
      if (is_first_wide &&
          (beside(Titled, Pages::InFoot, shown) || beside(Bare, Pages::InFoot, shown) ||
           beside(Bare, Pages::OnRail, shown)))
        return;
      if (below(Titled, shown) || below(Bare, shown)) return;
      if (!is_first_wide &&
          (beside(Bare, Pages::InFoot, shown) || beside(Bare, Pages::OnRail, shown)))
        return;
    }
    if (lay_out_wide(sheet_, content_,
                     {{helps_}, {choice_, pages_, buttons_}, {grid_of_rows(rows_, 0)}, {}}))
      return;
    lay_out_column(sheet_, content_, body(Titled, rows_, 1), {choice_, pages_, buttons_});
  }

 private:
  enum class Head : std::uint8_t { Titled, Bare };
  enum class Pages : std::uint8_t { InFoot, OnRail };  ///< Below the helps, or beside the list.
  enum class Shown : std::uint8_t { All, Six };

  const Block& head(Head head) const { return head == Head::Titled ? titled_ : helps_; }
  std::vector<Block> first_rows() const {
    return {rows_.begin(),
            rows_.begin() + static_cast<std::ptrdiff_t>(std::min(fewest_rows, rows_.size()))};
  }
  Block grid_of_rows(const std::vector<Block>& rows, std::size_t columns) const {
    return grid_block(sheet_, rows, gap_, columns);
  }
  std::vector<Block> body(Head above, const std::vector<Block>& rows, std::size_t columns) const {
    return {head(above), grid_of_rows(rows, columns)};
  }
  /// What is left beside the controls that turn what scrolls.
  float beside_turners(float width) const {
    const Measures& m = sheet_.measures();
    return width - m.touch - std::round(m.unit);
  }
  bool has_room(float width, std::size_t columns) const {
    const float least = least_column_mm * sheet_.measures().mm * sheet_.request().shape.text_scale;
    const auto n = static_cast<float>(columns);
    return columns == 1 || (width - (n - 1) * sheet_.measures().gap) / n >= least;
  }
  /// On a shallow card what lies beside each other comes nearer to its long edges.
  PixelBox nearer_to_edges() const {
    const float unit = std::floor(sheet_.measures().unit);
    return {content_.x, content_.y - unit, content_.width, content_.height + 2 * unit};
  }
  bool has_pages() const { return sheet_.control("page:next") >= 0; }

  /// Everything below each other; false where fewer rows would be seen.
  bool below(Head above, Shown shown) const {
    const std::vector<Block> foot{choice_, pages_, buttons_};
    const float room = content_.height - sheet_.measures().gap - height_of(foot, content_.width);
    const bool scrolls = shown == Shown::Six;
    const float width = scrolls ? beside_turners(content_.width) : content_.width;
    for (const std::size_t columns : {std::size_t{1}, std::size_t{2}}) {
      if (!has_room(width, columns)) continue;
      if (height_of(body(above, scrolls ? first_rows() : rows_, columns), width) > room) continue;
      lay_out_column(sheet_, content_, body(above, rows_, columns), foot);
      return true;
    }
    return false;
  }

  /// The list in columns beside the rest.
  bool beside(Head above, Pages pages, Shown shown) const {
    const Measures& m = sheet_.measures();
    if (pages == Pages::OnRail && !has_pages()) return false;
    std::vector<Block> foot{choice_, buttons_};
    if (pages == Pages::InFoot) foot.insert(foot.begin() + 1, pages_);
    const float rail = pages == Pages::OnRail ? m.touch + std::round(m.unit) : 0;
    const PixelBox box = above == Head::Bare ? nearer_to_edges() : content_;
    for (const float start : starts(above)) {
      if (height_of({head(above)}, start) + m.unit + height_of(foot, start) > box.height) continue;
      const float width = std::floor(content_.width - start - 2 * m.gap - rail);
      const std::size_t columns = columns_that_show(shown, width, box.height);
      if (columns == 0) continue;
      draw_start(above, foot, {content_.x, box.y, start, box.height});
      const PixelBox list{content_.right() - width - rail, box.y, width, box.height};
      lay_out_column(sheet_, list, {grid_of_rows(rows_, columns)}, {});
      if (rail > 0) draw_rail({content_.right() - m.touch, box.y, m.touch, box.height});
      return true;
    }
    return false;
  }
  /// How wide what is not the list may be, the narrowest first.
  std::vector<float> starts(Head above) const {
    std::vector<float> widths;
    if (above == Head::Bare) {
      const Measures& m = sheet_.measures();
      for (const float helps : {3.0F, 4.0F, 6.0F})
        widths.push_back(helps * (m.touch + std::round(m.unit)) - std::round(m.unit));
    }
    for (const float share : {0.34F, 0.4F, 0.46F, 0.52F})
      widths.push_back(std::floor(share * content_.width));
    std::ranges::sort(widths);
    return widths;
  }
  /// 0: as many rows are not seen in that width.
  std::size_t columns_that_show(Shown shown, float width, float height) const {
    const bool scrolls = shown == Shown::Six;
    const float wide = scrolls ? beside_turners(width) : width;
    const Block usual = grid_of_rows(scrolls ? first_rows() : rows_, 0);
    const std::size_t first = columns_in(sheet_.request().shape, wide);
    if (wide > 0 && usual.height(wide) <= height) return first;
    for (const std::size_t columns : {std::size_t{1}, std::size_t{2}, std::size_t{3}})
      if (has_room(wide, columns) && wide >= sheet_.measures().touch * 3 &&
          grid_of_rows(scrolls ? first_rows() : rows_, columns).height(wide) <= height)
        return columns;
    return 0;
  }
  /// They have been found to fit.
  void draw_start(Head above, const std::vector<Block>& foot, const PixelBox& box) const {
    const float low = height_of(foot, box.width);
    head(above).draw({box.x, box.y, box.width, head(above).height(box.width)});
    float y = box.bottom() - low;
    for (const Block& block : foot) {
      const float height = block.height(box.width);
      block.draw({box.x, y, box.width, height});
      y += height + (height > 0 ? std::round(block.gap) : 0);
    }
  }
  void draw_rail(const PixelBox& box) const {
    draw_page("page:previous", Pictogram::FurtherUp, {box.x, box.y, box.width, box.width});
    draw_page("page:next", Pictogram::FurtherDown,
              {box.x, box.bottom() - box.width, box.width, box.width});
  }
  void draw_page(std::string_view name, Pictogram what, const PixelBox& box) const {
    const std::int32_t control = sheet_.control(name);
    sheet_.place(control, box);
    sheet_.fill(box, sheet_.theme().plaster, sheet_.measures().corner, control);
    const scene::Colour ink = sheet_.theme().ink;
    sheet_.pictogram(what, box.inset(std::round(0.22F * box.width)),
                     sheet_.at(control).enabled ? ink : scene::with_opacity(ink, 0.35F), control);
  }

  Sheet& sheet_;
  PixelBox content_;
  float gap_;
  Block titled_, helps_, choice_, pages_, buttons_;
  std::vector<Block> rows_;
};

}  // namespace

void lay_out_choosing_card(Sheet& sheet, const PixelBox& content) {
  ChoosingCard(sheet, content).lay_out();
}

std::uint32_t rows_of_card(const ScreenShape& shape, std::uint32_t seats,
                           std::uint32_t seat) noexcept {
  constexpr float fewest = 6, most = 12;
  const Measures m = measures_of(shape);
  const ScreenShape seen = seen_from(side_of(shape, seats, seat), shape);
  const scene::Rect card = card_of(shape, seats, seat);
  const PixelBox content = PixelBox{0, 0, card.width * static_cast<float>(seen.width),
                                    card.height * static_cast<float>(seen.height)}
                               .inset(std::round(card_margin * m.unit));
  constexpr float with_long_names = 1.15F;  // some take more lines than their picture is high
  const float gap = std::round(m.unit / 2), row = with_long_names * height_of_row(m) + gap;
  float room = content.height + gap, columns = 1;
  if (is_wide(content))
    columns = static_cast<float>(columns_in(shape, widest_end(m, content.width)));
  else
    room -= height_of_heading(m) + 3 * m.touch + m.gap + 2 * gap;
  return static_cast<std::uint32_t>(std::clamp(columns * std::floor(room / row), fewest, most));
}

}  // namespace docent::interface

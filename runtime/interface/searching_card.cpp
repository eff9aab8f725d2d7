/// Searching on the card of a seat: the keyboard lies on the card, and turns with it.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/interface/card_parts.h"
#include "runtime/interface/key_board.h"
#include "runtime/interface/searching.h"

namespace docent::interface {
namespace {

constexpr std::array shares_of_keys{0.5F, 0.56F, 0.62F, 0.68F};

class SearchingCard {
 public:
  SearchingCard(Sheet& sheet, const PixelBox& content)
      : sheet_(sheet),
        content_(content),
        keys_(key_sizes(sheet.request().shape)),
        gap_(std::max(sheet.measures().gap, keys_.gap)),
        head_(beside_corner(sheet, {typed_block()}, 0)) {
    constexpr std::array<std::string_view, 2> buttons{"back", "home"};
    foot_ = {card_buttons(sheet, buttons, 0)};
    constexpr std::array<std::string_view, 2> pages{"page:previous", "page:next"};
    pages_ = card_buttons(sheet, pages, 0);
    for (const std::int32_t control : list_items(sheet))
      rows_.push_back(row_block(sheet, control, row_gap()));
  }

  void lay_out() {
    if (keys_stay_beside() || keys_stay_below()) return;
    if (lay_out_wide(sheet_, content_, {{head_}, foot_, with_keys({grid()}), {}})) return;
    const float head = head_.height(content_.width);
    const PixelBox below{content_.x, content_.y + head + gap_, content_.width,
                         content_.height - head - gap_};
    const bool head_stays = below.height >= least_list() + gap_ + foot_height(content_.width);
    std::vector<Block> body = with_keys(rows_);
    if (head_stays) {
      head_.draw({content_.x, content_.y, content_.width, head});
      return lay_out_column(sheet_, below, std::move(body), foot_);
    }
    head_.gap = gap_;
    body.insert(body.begin(), head_);
    lay_out_column(sheet_, content_, std::move(body), foot_);
  }

 private:
  float row_gap() const noexcept { return std::round(sheet_.measures().unit / 2); }
  float foot_height(float width) const { return height_of(foot_, width); }
  /// What was found may scroll, and has room for the controls that turn it and for two rows.
  float least_list() const noexcept {
    const Measures& m = sheet_.measures();
    return std::max(2 * m.touch + m.unit, 2 * height_of_row(m) + m.unit);
  }
  Block typed_block() const {
    return {.height = [this](float) { return sheet_.measures().touch; },
            .draw = [this](const PixelBox& box) { draw_typed(sheet_, box); }};
  }
  Block grid() const { return grid_block(sheet_, rows_, row_gap()); }

  /// How much was found, and what.
  std::vector<Block> list(std::vector<Block> rows) const {
    TextStyle style = sheet_.style(Letters::Small);
    style.line_height = style.line_height > 1.5F ? 1.4F : 1.2F;
    std::vector<Block> all{text_block(sheet_, style, found_line(sheet_), sheet_.theme().quiet_ink,
                                      sheet_.measures().unit)};
    std::ranges::move(rows, std::back_inserter(all));
    all.push_back(pages_);
    return all;
  }

  /// Where there is no room for both, the keys come first, so that they stay where they are
  /// whatever is found.
  std::vector<Block> with_keys(std::vector<Block> rows) const {
    const auto board = [this](float width) {
      KeyBoard keys = key_board(sheet_, width - keys_.gap, 1e6F);
      keys.tall = std::max(keys_.least, sheet_.measures().touch);  // or it is not touched
      return keys;
    };
    std::vector<Block> all{
        {.height = [board](float width) { return board(width).height(); },
         .draw = [this, board](const PixelBox& box) { draw_keys(sheet_, board(box.width), box); },
         .gap = gap_}};
    std::ranges::move(list(std::move(rows)), std::back_inserter(all));
    return all;
  }

  /// What is typed, and what was found, in a box, above the foot.
  void draw_list(const PixelBox& box, const std::vector<Block>& rows, std::vector<Block> foot) {
    const float head = head_.height(box.width);
    head_.draw({box.x, box.y, box.width, head});
    lay_out_column(sheet_, {box.x, box.y + head + gap_, box.width, box.height - head - gap_},
                   list(rows), std::move(foot));
  }

  /// On a wide card the keys are at its end.
  bool keys_stay_beside() {
    if (!is_wide(content_)) return false;
    for (const float share : shares_of_keys) {
      const float width = std::floor(share * content_.width);
      const PixelBox start{content_.x, content_.y, content_.width - width - gap_, content_.height};
      const float needed = head_.height(start.width) + least_list() + foot_height(start.width);
      if (needed + 2 * gap_ > content_.height) return false;
      const KeyBoard board = key_board(sheet_, width, content_.height);
      if (board.height() > content_.height) continue;
      draw_list(start, {grid()}, foot_);
      draw_keys(
          sheet_, board,
          {content_.right() - width, content_.bottom() - board.height(), width, board.height()});
      return true;
    }
    return false;
  }

  /// On a high one below what was found, above the foot.
  bool keys_stay_below() {
    const float foot = foot_height(content_.width), head = head_.height(content_.width);
    const float room = content_.height - head - least_list() - foot - 3 * gap_;
    if (room < keys_.least) return false;
    KeyBoard board = key_board(sheet_, content_.width, room);
    if (board.height() > room) return false;
    constexpr float most_tall = 1.12F;  // of a fingertip: the rest is for what was found
    board.tall = std::min(board.tall, std::floor(most_tall * keys_.least));
    const float bottom = content_.bottom() - foot - gap_;
    const PixelBox above{content_.x, content_.y, content_.width,
                         bottom - board.height() - gap_ - content_.y};
    draw_list(above, {grid()}, {});
    draw_keys(sheet_, board, {content_.x, bottom - board.height(), content_.width, board.height()});
    lay_out_column(sheet_, {content_.x, bottom + gap_, content_.width, foot}, {}, foot_);
    return true;
  }

  Sheet& sheet_;
  PixelBox content_;
  KeySizes keys_;
  float gap_;
  Block head_, pages_;
  std::vector<Block> foot_, rows_;
};

}  // namespace

void lay_out_searching_card(Sheet& sheet, const PixelBox& content) {
  SearchingCard(sheet, content).lay_out();
}

}  // namespace docent::interface

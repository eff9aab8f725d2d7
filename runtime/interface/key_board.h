#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/interface/sheet.h"

namespace docent::interface {

/// How large keys are and how far apart, in pixels.
struct KeySizes {
  float least = 54, most_wide = 90, most_tall = 80, gap = 11;
};
KeySizes key_sizes(const ScreenShape& shape) noexcept;

/// One line of keys: controls, and how many cells each takes.
struct KeyRow {
  std::vector<std::pair<std::int32_t, float>> keys;
  float cells = 0;

  void add(std::int32_t control, float wide) {
    keys.emplace_back(control, wide);
    cells += wide;
  }
};

/// The rows that fit into so much room, and the size of a letter's key on them.
struct KeyBoard {
  std::vector<KeyRow> rows;
  float wide = 0, tall = 0, gap = 0;

  float height() const noexcept { return static_cast<float>(rows.size()) * (tall + gap) - gap; }
};
/// Rows as people know them; where `width` or `height` have no room for those, the same keys in
/// lines of one length. Keys are never smaller than a fingertip: the board may be higher then.
KeyBoard key_board(const Sheet& sheet, float width, float height);
/// Draws them in the middle of the box, whose height is theirs. Every keyboard runs from left to
/// right: where the language does not, the sheet is turned over afterwards, and so is this.
void draw_keys(Sheet& sheet, const KeyBoard& board, const PixelBox& box);

}  // namespace docent::interface

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/interface/sheet.h"

namespace docent::interface {

/// Controls of equal width in rows, as high as their words need.
struct ButtonGrid {
  std::uint32_t columns = 1;
  float width = 0, gap = 0;    ///< Of each, and between them.
  std::size_t count = 0;       ///< How many there are.
  bool fills = false;          ///< Those of the last row are as wide as all of it.
  std::vector<float> heights;  ///< Of each row.

  float height() const noexcept;
  /// Of the control at `index`, in a grid whose upper corner is that of `box`.
  PixelBox cell(const PixelBox& box, std::size_t index) const noexcept;
};

/// What a grid has to be like.
struct GridRules {
  float width = 0;   ///< Of all of it.
  float margin = 0;  ///< How much of a control's width its word leaves free.
  float gap = 0;
  std::uint32_t most_columns = 100;
  std::uint32_t lines = 2;  ///< A word has at most so many, where there are two columns.
  float above = 0;          ///< How much of a control's height its word leaves free.
  bool fills = false;       ///< The last row is as wide as the others.
  float least = 0;          ///< Height of a control; 0: that of a fingertip.
};

/// As many beside each other as have room for their words, unbroken and in that many lines, or
/// fewer where that takes no more rows. What would not even have room in a row of its own is broken
/// there. Controls below 0 do not count.
ButtonGrid grid_of(Sheet& sheet, std::span<const std::int32_t> controls, const GridRules& rules);

/// Do all their words have room in that width, unbroken and in so many lines?
bool have_room(Sheet& sheet, std::span<const std::int32_t> controls, float width,
               std::uint32_t lines);

}  // namespace docent::interface

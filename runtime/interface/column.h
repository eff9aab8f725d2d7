#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "runtime/interface/sheet.h"

namespace docent::interface {

/// Something in a column: it has a height that depends on its width, and is drawn in a box of both.
struct Block {
  std::function<float(float width)> height;
  std::function<void(const PixelBox& box)> draw;
  float gap = 0;  ///< Before the next.
  /// It takes what room there is left, up to that height; empty: none.
  std::function<float(float width)> most{};
};

/// A text of any length.
Block text_block(Sheet& sheet, const TextStyle& style, std::string text, scene::Colour colour,
                 float gap);

/// Lays blocks below each other: `body` from the top of the box, `foot` on its lower edge. Where
/// they are higher than the box, the body scrolls, with two controls beside it that turn it; where
/// that would leave it less than a few lines, or than its first `lead` blocks take, the upper
/// blocks of the foot scroll with it. The first `headed` blocks are seen whole before anything
/// scrolls: headings are as small as that takes, down to what is read. At most once for a view.
void lay_out_column(Sheet& sheet, const PixelBox& box, std::vector<Block> body,
                    std::vector<Block> foot, std::size_t lead = 0, std::size_t headed = 0);

/// How high they are below each other.
float height_of(const std::vector<Block>& blocks, float width);

}  // namespace docent::interface

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace docent::interface {

enum class Family : std::uint8_t { Sans, Serif };

/// How a piece of text is set. Pixels of the screen.
struct TextStyle {
  Family family = Family::Sans;
  std::uint16_t weight = 400;   ///< 400 regular, 500 medium, 600 semibold.
  float size = 24;              ///< Pixels: the height of the em square.
  float line_height = 1.4F;     ///< Of the size.
  std::uint16_t max_lines = 1;  ///< What does not fit ends in an ellipsis. 0: as many as it takes.
  /// With `max_lines` 0: the part of a long text from this line on, ...
  std::uint16_t first_line = 0;
  std::uint16_t line_count = 0;  ///< ... of so many lines; 0: all.
  bool right_to_left = false;
  bool centred = false;       ///< Each line.
  bool tabular = false;       ///< Figures of one width, for numbers that change.
  std::string_view language;  ///< BCP 47; chooses between the forms of shared characters.

  bool operator==(const TextStyle&) const = default;
};

/// Text that has been set: how much of each pixel the letters cover.
struct TextBitmap {
  std::uint32_t width = 0, height = 0;  ///< Pixels. The height is a whole number of lines.
  std::uint32_t lines = 0;              ///< In it; of a part of a text, in the whole of it.
  bool cut = false;                     ///< It ended in an ellipsis.
  std::vector<std::uint8_t> coverage;   ///< width * height, row by row from the top.
};

/// Sets text in lines of at most `width` pixels; 0: in one line of any length. Right-to-left text
/// stands at the right end of its lines. Given to the layout by whoever can set type; called on the
/// worker, never in a frame.
using SetText =
    std::function<TextBitmap(const TextStyle& style, std::string_view text, std::uint32_t width)>;

}  // namespace docent::interface

#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "runtime/interface/column.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/sheet.h"

namespace docent::interface {

inline constexpr float card_margin = 2;  ///< Units.

/// Is a card so much wider than high that things stand beside each other on it?
bool is_wide(const PixelBox& content) noexcept;

/// What stands beside each other on a card that is much wider than high, each with its foot.
struct WideCard {
  std::vector<Block> start, start_foot, end, end_foot;
  bool start_scrolls = false;  ///< Of both one does where there is no room.
};
/// False where the card is narrow, or its start has no room for all that is to be there.
bool lay_out_wide(Sheet& sheet, const PixelBox& content, const WideCard& card);
/// How wide the end of a wide card is at most.
float widest_end(const Measures& m, float width) noexcept;

/// How many items of a list lie beside each other in that width.
std::size_t columns_in(const ScreenShape& shape, float width) noexcept;
/// Items in columns, read row by row; each row is as high as its highest. 0 columns: as many as
/// columns_in() says.
Block grid_block(Sheet& sheet, std::vector<Block> all, float row_gap, std::size_t columns = 0);

/// Of a row of the list, whose name may need more.
float height_of_row(const Measures& m) noexcept;
/// A row of the list, and what collects it where that is an exhibit.
Block row_block(Sheet& sheet, std::int32_t control, float gap);

/// Blocks with the helps of every screen beside them, or below those where that leaves them too
/// little.
Block beside_corner(Sheet& sheet, std::vector<Block> blocks, float gap);
/// Those helps alone, as many beside each other as there is room for.
Block helps_block(Sheet& sheet, float gap);
/// Buttons beside each other, those that this state has.
Block card_buttons(Sheet& sheet, std::span<const std::string_view> names, float gap);

}  // namespace docent::interface

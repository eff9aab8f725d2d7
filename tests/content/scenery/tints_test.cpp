#include "content/scenery/tints.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace docent::scenery::tints_test {
namespace {

/// Rooms of 6 m by 5 m, row by row, with walls of 0.4 m between them.
std::vector<PavedArea> rooms_in_a_grid(int columns, int rows) {
  std::vector<PavedArea> rooms;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vec2 low{column * 6.4, row * 5.4};
      rooms.push_back({.outline = {low, low + Vec2{6, 0}, low + Vec2{6, 5}, low + Vec2{0, 5}}});
    }
  return rooms;
}

TEST(AGallery, HasAnotherTintThanTheGalleriesBesideIt) {
  constexpr int columns = 7, rows = 5;
  std::vector<PavedArea> rooms = rooms_in_a_grid(columns, rows);

  tint_apart(rooms);

  const auto at = [&](int column, int row) {
    return rooms[static_cast<std::size_t>(row * columns + column)].tint;
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      EXPECT_LT(at(column, row), floor_tints);
      for (const auto& [x, y] :
           {std::pair{column - 1, row}, {column, row - 1}, {column - 1, row - 1}})
        if (x >= 0 && y >= 0) {
          EXPECT_NE(at(column, row), at(x, y));
        }
    }
}

TEST(AFloor, UsesAllTintsOnceItHasAsManyGalleries) {
  std::vector<PavedArea> rooms = rooms_in_a_grid(3, 3);

  tint_apart(rooms);

  std::set<int> tints;
  for (const PavedArea& room : rooms) tints.insert(room.tint);
  EXPECT_EQ(tints.size(), std::size_t{floor_tints});
}

}  // namespace
}  // namespace docent::scenery::tints_test

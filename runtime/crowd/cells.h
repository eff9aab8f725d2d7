#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"
#include "runtime/model/none.h"
#include "runtime/path/route.h"

namespace docent::crowd {

/// A floor cut into cells: pieces of it, a step or two wide, that no wall divides.
///
/// A Voronoi region lies on the open side of its wall, so the region of a point tells on which side
/// of the walls about it the point is. But regions are of any size: slivers at a column, a quarter
/// of a hall at its wall. So squares of one size are laid over the floor and cut each region into
/// pieces; the pieces in one square are joined again where their regions are neighbours there. The
/// two sides of a wall stay in different cells, unless one can walk round the wall within the
/// square or the eight squares about it. Two cells are next to each other if their squares share a
/// side and one region is in both.
///
/// In doubt (within a micrometre of a square's border) pieces are joined: cells may be larger, and
/// have more neighbours, than need be; never smaller or fewer. Every way on the floor leads from
/// cell to neighbouring cell. Frame: floor. Borrows the map. Immutable, so any thread may ask.
class WalkableCells {
 public:
  /// Squares of `size` metres; larger ones on floors that would have over a million.
  WalkableCells(const path::FloorMap& map, double size);

  const path::FloorMap& map() const noexcept { return map_; }
  double size() const noexcept { return size_; }
  std::size_t count() const noexcept { return centre_.size(); }

  /// Squares are numbered row by row; a point off the grid is in the nearest one.
  std::uint32_t square_at(Vec2 point) const noexcept {
    const Vec2 at = (point - origin_) * per_metre_;
    const auto index = [](double value, std::int32_t count) {
      return static_cast<std::uint32_t>(std::clamp(value, 0.0, count - 1.0));
    };
    return index(at.y, rows_) * static_cast<std::uint32_t>(columns_) + index(at.x, columns_);
  }
  /// The cell of a point in this square and this region; `none` where there is no such piece.
  std::uint32_t cell_at(std::uint32_t square, std::uint32_t region) const noexcept {
    for (std::uint32_t i = square_first_[square]; i < square_first_[square + 1]; ++i)
      if (piece_[i].region == region) return piece_[i].cell;
    return none;
  }
  std::span<const std::uint32_t> next_to(std::uint32_t cell) const noexcept {
    return std::span(next_).subspan(next_first_[cell], next_first_[cell + 1] - next_first_[cell]);
  }
  /// The squares that a box touches: columns left to right, rows bottom to top, both included.
  struct Squares {
    std::uint32_t left = 0, bottom = 0, right = 0, top = 0;
  };
  Squares squares_in(Vec2 low, Vec2 high) const noexcept {
    const auto columns = static_cast<std::uint32_t>(columns_);
    const std::uint32_t first = square_at(low), last = square_at(high);
    return {first % columns, first / columns, last % columns, last / columns};
  }
  std::uint32_t square(std::uint32_t column, std::uint32_t row) const noexcept {
    return row * static_cast<std::uint32_t>(columns_) + column;
  }
  /// The cell of a square that has just one; else `none`.
  std::uint32_t only_cell_of(std::uint32_t square) const noexcept { return only_cell_[square]; }
  std::uint32_t square_of(std::uint32_t cell) const noexcept { return square_[cell]; }
  Vec2 centre_of(std::uint32_t cell) const noexcept { return centre_[cell]; }
  Vec2 centre_of_square(std::uint32_t square) const noexcept {
    const auto columns = static_cast<std::uint32_t>(columns_);
    const std::uint32_t x = square % columns, y = square / columns;
    return origin_ + size_ * Vec2{x + 0.5, y + 0.5};
  }

  /// Calls `visit` for every wall that reaches into the box until it returns false; perhaps for
  /// some other walls too, and for some more than once.
  template <class Visitor>
  void visit_walls(Vec2 low, Vec2 high, Visitor visit) const {
    const auto columns = static_cast<std::uint32_t>(columns_ * tiles);
    const auto [left, bottom] = tile_at(low);
    const auto [right, top] = tile_at(high);
    for (std::uint32_t y = bottom; y <= top; ++y) {
      const std::uint32_t from = wall_first_[y * columns + left];
      const std::uint32_t to = wall_first_[y * columns + right + 1];
      for (std::uint32_t i = from; i < to; ++i)
        if (!visit(wall_[i].a, wall_[i].b)) return;
    }
  }

  /// Calls `visit` for every reflex corner in the box, and perhaps for some others.
  template <class Visitor>
  void visit_corners(Vec2 low, Vec2 high, Visitor visit) const {
    const auto columns = static_cast<std::uint32_t>(columns_ * tiles);
    const auto [left, bottom] = tile_at(low);
    const auto [right, top] = tile_at(high);
    for (std::uint32_t y = bottom; y <= top; ++y) {
      const std::uint32_t from = corner_first_[y * columns + left];
      const std::uint32_t to = corner_first_[y * columns + right + 1];
      for (std::uint32_t i = from; i < to; ++i) visit(corner_[i]);
    }
  }

 private:
  struct Piece {
    std::uint32_t region = 0, cell = 0;
  };
  struct Wall {
    Vec2 a{}, b{};
  };
  /// Walls and corners are sorted into smaller squares, `tiles` to the side of one.
  static constexpr std::int32_t tiles = 2;
  struct Tile {
    std::uint32_t x = 0, y = 0;
  };
  Tile tile_at(Vec2 point) const noexcept {
    const Vec2 at = (point - origin_) * (tiles * per_metre_);
    const auto index = [](double value, std::int32_t count) {
      return static_cast<std::uint32_t>(std::clamp(value, 0.0, count * tiles - 1.0));
    };
    return {index(at.x, columns_), index(at.y, rows_)};
  }
  struct Cut;
  void join_pieces(const Cut& cut);
  void link_cells();
  void join_cells();
  void sort_walls();
  void sort_corners();

  const path::FloorMap& map_;
  double size_ = 1, per_metre_ = 1;
  Vec2 origin_{};
  std::int32_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> square_first_;  ///< Per square: its pieces, by region.
  std::vector<Piece> piece_;
  std::vector<std::uint32_t> only_cell_;  ///< Per square; `none` where there are several, or none.
  std::vector<Vec2> centre_;              ///< Per cell: of its square.
  std::vector<std::uint32_t> square_;     ///< Per cell.
  std::vector<std::uint32_t> next_first_, next_;
  std::vector<std::uint32_t> wall_first_;  ///< Per tile.
  std::vector<Wall> wall_;
  std::vector<std::uint32_t> corner_first_;  ///< Per tile.
  std::vector<Vec2> corner_;
};

}  // namespace docent::crowd

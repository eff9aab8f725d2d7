#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace docent {

/// Evenly spaced values that a table is made for.
struct GridAxis {
  std::size_t count = 1;
  double step = 1;
  double first = 0;

  constexpr double value(std::size_t i) const noexcept {
    return first + static_cast<double>(i) * step;
  }
  constexpr double last() const noexcept { return value(count - 1); }
  /// Between which two values a number lies; beyond the ends of the axis it counts as the end.
  struct Place {
    std::size_t low;
    double share;  ///< Of the value after `low`, in [0, 1].
  };
  Place place(double value) const noexcept {
    const double at = std::clamp((value - first) * (1 / step), 0.0, static_cast<double>(count - 1));
    const auto low = std::min(static_cast<std::size_t>(at), count - 2);
    return {low, at - static_cast<double>(low)};
  }
};

/// Bend of the track: the square root of how it turns (radians a metre) with the sign of the turn,
/// so that gentle bends are told apart best.
constexpr GridAxis bend_axis{13, 0.21, -1.26};
constexpr GridAxis turn_axis{15, 0.1, -0.7};   ///< Radians that the body faces to its left.
constexpr GridAxis side_axis{13, 0.05, -0.3};  ///< Metres that the body stands to its left.
constexpr GridAxis room_axis{71, 0.1, -1.0};   ///< Metres of the track that are left.

constexpr std::size_t warped_slice = turn_axis.count;
constexpr std::size_t raw_slice = side_axis.count * turn_axis.count;

/// What it is likely to cost to walk on after each transition of a motion graph: the value
/// functions of the searches in runtime/motion, made by the content compiler.
/// runtime/motion/make_foresight.h tells what is counted. A table that was not made is empty; then
/// its search knows only the cost of what it has walked.
struct Foresight {
  static constexpr double unit = 1.0 / 8192;  ///< What 1 in the tables stands for.

  std::vector<std::uint16_t> warped;  ///< [transition][bend][turn], radians squared times metres.
  std::vector<std::uint16_t> raw;     ///< [transition][bend][side][turn], the same.
  std::vector<std::uint16_t> ending;  ///< [transition][room]: by how many metres the nearest stand
                                      ///< misses the end.
};

/// The value at a place of a table's row, interpolated.
template <class Number>
double value_at(const Number* row, const GridAxis::Place& at) noexcept {
  const auto low = static_cast<double>(row[at.low]);
  return low + at.share * (static_cast<double>(row[at.low + 1]) - low);
}
template <class Number>
double value_at(const Number* row, const GridAxis& axis, double at) noexcept {
  return value_at(row, axis.place(at));
}
/// Costs of one transition and one bend, in numbers of the table (Foresight::unit). `turn` in
/// radians, `side` in metres.
template <class Number>
double foreseen_warped(const Number* slice, double turn) noexcept {
  return value_at(slice, turn_axis, turn);
}
template <class Number>
double foreseen_raw(const Number* slice, const GridAxis::Place& side,
                    const GridAxis::Place& turn) noexcept {
  const Number* row = slice + side.low * turn_axis.count;
  const double low = value_at(row, turn);
  return low + side.share * (value_at(row + turn_axis.count, turn) - low);
}
template <class Number>
double foreseen_raw(const Number* slice, double side, double turn) noexcept {
  return foreseen_raw(slice, side_axis.place(side), turn_axis.place(turn));
}

}  // namespace docent

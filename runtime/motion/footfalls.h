#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/model/motion/side.h"
#include "runtime/motion/leg.h"

namespace docent::motion {

/// A foot put down once in a straight walk, and where it is to be put instead.
struct Footfall {
  Side side = Side::Left;
  std::size_t first = 0, last = 0;  ///< Frames in which it rests.
  Vec3 toe{};                       ///< Where it rests in the walk, world frame.
  double along = 0;                 ///< The same, metres along the straight line.
  double target = 0, height = 0;    ///< Where it is to be put: along the line, and how high.
};

/// Adds the footfalls of one foot. `from`, `along`: the straight line, floor frame.
void find_footfalls(const Walk& walk, Side side, std::span<const Foot> feet, Vec2 from, Vec2 along,
                    std::vector<Footfall>& falls);

/// Brings the footfalls of both feet into the order of their frames; those of a body that stands at
/// the end come last.
void order_footfalls(std::vector<Footfall>& falls);

/// Those in between: neither of the body as it stands at the beginning nor as it does at the end.
std::span<Footfall> steps(std::span<Footfall> falls) noexcept;
std::size_t count_of_steps(std::span<const Footfall> falls) noexcept;

/// The footfalls of one foot, in order.
std::vector<Footfall*> footfalls_of(std::span<Footfall> falls, Side side);

/// Takes what walks over footfalls to where they are to be put: smooth and monotone between them
/// (Fritsch and Carlson 1980), shifted before the first and after the last.
struct FootfallMap {
  struct Place {
    double along = 0, height = 0;
  };
  std::vector<double> along;
  std::vector<Place> place, slope;

  Place at(double metres) const noexcept;
};
FootfallMap make_footfall_map(std::span<const Footfall> falls);

}  // namespace docent::motion

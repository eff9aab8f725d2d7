#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "tests/content/floor/plans.h"

namespace docent::test {

/// Something thin that stands in a hall, as fitted curves, door leaves and slivers of drawings do:
/// shape, x and y in mm, length in mm, how sharp its tips are, how far it is turned in tenths of a
/// degree. Tips go from 0.3 down to 10^-4 rad.
using Spike = std::tuple<int, int, int, int, int, int>;

inline rc::Gen<Spike> any_spike() {
  return rc::gen::tuple(rc::gen::inRange(0, 8), rc::gen::inRange(0, 8000),
                        rc::gen::inRange(0, 8000), rc::gen::inRange(200, 4500),
                        rc::gen::inRange(0, 101), rc::gen::inRange(0, 3600));
}

/// The rings of a spike. Corners are not on any grid.
inline std::vector<Points> rings_of(const Spike& spike) {
  const auto [shape, x, y, millimetres, sharpness, turned] = spike;
  const double length = millimetres / 1000.0;
  const double tip = 0.3 * std::pow(1e-4 / 0.3, sharpness / 100.0);
  const double heading = turned * std::numbers::pi / 1800;
  const Vec2 along{std::cos(heading), std::sin(heading)};
  const auto at = [&](double forward, double left) {
    return Vec2{x / 1000.0, y / 1000.0} + forward * along + left * left_of(along);
  };
  const auto needle = [&](double turn, double from) {
    const Vec2 a{std::cos(turn), std::sin(turn)};
    const auto place = [&](double f, double l) {
      const Vec2 p = f * a + l * left_of(a);
      return at(p.x, p.y);
    };
    const double half = (length - from) * std::tan(tip / 2);
    return Points{place(from, 0), place(length, half), place(length, -half)};
  };
  // Between two curves that meet in tips: thin in the middle by the tips' angle.
  const auto band = [&](double turns, double radius, int pieces) {
    Points ring;
    const auto curve = [&](double t, double off) {
      const double angle = 2 * std::numbers::pi * turns * t;
      const double r = radius * (0.4 + 0.6 * t) + off;
      return at(r * std::cos(angle), r * std::sin(angle));
    };
    const double thickness = 0.5 * length * std::tan(tip);
    for (int i = 0; i <= pieces; ++i) ring.push_back(curve(i / double(pieces), 0));
    for (int i = pieces - 1; i > 0; --i) {
      const double t = i / double(pieces);
      ring.push_back(curve(t, thickness * std::min({4 * t, 4 * (1 - t), 1.0})));
    }
    return ring;
  };
  switch (shape) {
    case 0:
      return {needle(0, 0)};
    case 1:  // A sliver: sharp at both ends.
      return {{at(0, 0), at(0.4 * length, -length * 0.4 * std::tan(tip)), at(length, 0)}};
    case 2: {  // A blade: sharp at both ends, on both sides.
      const double half = 0.5 * length * std::tan(tip / 2);
      return {{at(0, 0), at(0.5 * length, -half), at(length, 0), at(0.5 * length, half)}};
    }
    case 3: {  // A fan of needles whose tips nearly meet.
      std::vector<Points> rings;
      for (int i = 0; i < 4; ++i) rings.push_back(needle(0.35 * i, 0.05 + 0.07 * i));
      return rings;
    }
    case 4:  // A spiral.
      return {band(1.4, 0.6 * length, 17)};
    case 5:  // A curved wall of many points.
      return {band(0.3, length, 23)};
    case 6: {  // A comb.
      Points ring{at(0, -0.05), at(length, -0.05)};
      for (int i = 4; i >= 0; --i) {
        const double middle = length * (i + 0.5) / 5;
        ring.push_back(at(middle + 0.3 * std::tan(tip), 0));
        ring.push_back(at(middle + 0.01 * i, 0.5));
        ring.push_back(at(middle - 0.3 * std::tan(tip), 0));
      }
      return {ring};
    }
    default:  // A door leaf, four centimetres thick, with one end cut at an angle.
      return {
          {at(0, 0), at(length, 0), at(length - 0.04 / std::tan(10 * tip), 0.04), at(0.001, 0.04)}};
  }
}

/// A hall of 8 by 8 m with spikes that may overlap and stick out through its walls.
inline import::ImportedPlan hall_with_spikes(const std::vector<Spike>& spikes) {
  std::vector<Points> holes;
  for (const Spike& spike : spikes)
    for (Points& ring : rings_of(spike)) {
      if (signed_area(ring) > 0) std::ranges::reverse(ring);
      holes.push_back(std::move(ring));
    }
  return drawn(rectangle({0, 0}, {8, 8}), holes);
}

}  // namespace docent::test

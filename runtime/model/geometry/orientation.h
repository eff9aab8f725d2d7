#pragma once

#include <cmath>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// The sign of the turn a -> b -> c: +1 left, -1 right, 0 exactly straight. Exact for all doubles
/// whose products neither overflow nor underflow (Shewchuk 1997, "Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates").
int exact_orientation(Vec2 a, Vec2 b, Vec2 c) noexcept;

/// The same, quicker: plain arithmetic decides where its rounding cannot matter, as nearly always.
inline int orientation(Vec2 a, Vec2 b, Vec2 c) noexcept {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  // Shewchuk's bound for this evaluation, (3 + 16 u) u with u = 2^-53.
  constexpr double bound = 3.3306690738754716e-16;
  const double error = bound * (std::abs(left) + std::abs(right));
  if (error == 0) return 0;  // Differences of doubles are 0 only where they are equal.
  if (determinant > error) return 1;
  if (-determinant > error) return -1;
  return exact_orientation(a, b, c);
}

}  // namespace docent

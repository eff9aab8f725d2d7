#pragma once

#include <cmath>
#include <numbers>

#include "runtime/model/geometry/vec2.h"

namespace docent::path {

// Angles and directions along an arc, without the tables of the C library: between two queries they
// have left the cache, and to wait for them costs a disc's way more than all that is computed here.

/// Sine and 1 - cosine of an angle, which is exact where the cosine is near 1.
struct SineVersine {
  double sine, versine;
};

/// Of an angle of at most 0.42 either way, radians; relative errors of 1e-15. Taylor's series.
constexpr SineVersine of_small_angle(double angle) noexcept {
  const double s = angle * angle;
  return {
      angle * (1 + s * (-1.0 / 6 +
                        s * (1.0 / 120 + s * (-1.0 / 5'040 +
                                              s * (1.0 / 362'880 + s * (-1.0 / 39'916'800 +
                                                                        s / 6'227'020'800.0)))))),
      s * (1.0 / 2 + s * (-1.0 / 24 + s * (1.0 / 720 + s * (-1.0 / 40'320 +
                                                            s * (1.0 / 3'628'800 +
                                                                 s * (-1.0 / 479'001'600 +
                                                                      s / 87'178'291'200.0))))))};
}

/// The direction at an angle from a unit direction, counter-clockwise; for angles from -pi/2 to
/// 3 pi/2, with errors of 2e-15.
constexpr Vec2 turned_by(Vec2 begin, double angle) noexcept {
  // From a quarter turn an eighth of the rest, and that doubled three times.
  SineVersine rest = of_small_angle((angle - std::numbers::pi / 2) / 8);
  for (int i = 0; i < 3; ++i)
    rest = {2 * rest.sine * (1 - rest.versine), 2 * rest.sine * rest.sine};
  return -rest.sine * begin + (1 - rest.versine) * left_of(begin);
}

/// The angle from one direction to another, of any lengths, counter-clockwise; for angles from
/// -pi/2 to 3 pi/2, both left out, with errors of 1e-14 between -0.01 and pi + 0.01.
inline double angle_between(Vec2 begin, Vec2 direction) noexcept {
  const double left = cross(begin, direction);
  const double ahead = dot(begin, direction);
  // The tangent of half of what a quarter turn lacks, and of a quarter of it.
  const double half = ahead / (left + std::sqrt(ahead * ahead + left * left));
  const double t = half / (1 + std::sqrt(1 + half * half));
  // Arc tangent of t over t, interpolated in t squared at ten of Chebyshev's nodes for t up to
  // tan(pi/8); split in two halves that do not wait for each other.
  const double s = t * t, s2 = s * s;
  const double even = 0.9999999999999990408 +
                      s2 * (0.19999999978392646267 +
                            s2 * (0.11111048853718136512 +
                                  s2 * (0.076735354218542684238 + s2 * 0.050247619910680784124)));
  const double odd = -0.33333333333221433954 +
                     s2 * (-0.14285712661683768365 +
                           s2 * (-0.090895299559632036816 +
                                 s2 * (-0.065059829283615081031 - s2 * 0.025316477823864781405)));
  return std::numbers::pi / 2 - 4 * t * (even + s * odd);
}

}  // namespace docent::path

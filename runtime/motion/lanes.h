#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "runtime/model/geometry/vec2.h"

/// Four of everything at once, as every processor that docent runs on reckons.
namespace docent::motion {

inline constexpr std::size_t lane_count = 4;
using Lanes = float __attribute__((vector_size(16)));
using LaneMask = std::int32_t __attribute__((vector_size(16)));  ///< -1 where it holds, else 0.

inline Lanes in_all_lanes(float x) noexcept {
  return Lanes{x, x, x, x};
}
inline bool any(LaneMask m) noexcept {
#ifdef __SSE2__
  return __builtin_ia32_movmskps(reinterpret_cast<Lanes>(m)) != 0;
#else
  return (m[0] | m[1] | m[2] | m[3]) != 0;
#endif
}
inline Lanes larger(Lanes a, Lanes b) noexcept {
  return a < b ? b : a;
}
inline Lanes smaller(Lanes a, Lanes b) noexcept {
  return b < a ? b : a;
}
/// By one instruction: what the library's own root becomes asks in each lane for errors.
inline Lanes root_of(Lanes x) noexcept {
#if defined(__clang__)
  return __builtin_elementwise_sqrt(x);
#elif defined(__SSE2__)
  return __builtin_ia32_sqrtps(x);
#else
  return Lanes{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

struct Vec3Lanes {
  Lanes x{}, y{}, z{};

  Vec3 operator[](std::size_t lane) const noexcept { return {x[lane], y[lane], z[lane]}; }

  friend Vec3Lanes operator+(const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Vec3Lanes operator-(const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Vec3Lanes operator*(Lanes s, const Vec3Lanes& v) noexcept {
    return {s * v.x, s * v.y, s * v.z};
  }
  friend Vec3Lanes operator*(float s, const Vec3Lanes& v) noexcept { return in_all_lanes(s) * v; }
};

/// The column of a matrix.
inline Lanes lanes_of(const Vec4& v) noexcept {
  return Lanes{v.x, v.y, v.z, v.w};
}
inline Vec3 first_three(Lanes v) noexcept {
  return {v[0], v[1], v[2]};
}
inline Vec3Lanes in_all_lanes(Vec3 v) noexcept {
  return {in_all_lanes(v.x), in_all_lanes(v.y), in_all_lanes(v.z)};
}
/// Four vectors beside each other, and what else each holds.
struct Vec4Lanes {
  Vec3Lanes xyz;
  Lanes w;
};
inline Vec4Lanes beside_each_other(Lanes a, Lanes b, Lanes c, Lanes d) noexcept {
  const Lanes xy = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Lanes xy_too = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const Lanes z = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Lanes z_too = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return {{__builtin_shufflevector(xy, xy_too, 0, 1, 4, 5),
           __builtin_shufflevector(xy, xy_too, 2, 3, 6, 7),
           __builtin_shufflevector(z, z_too, 0, 1, 4, 5)},
          __builtin_shufflevector(z, z_too, 2, 3, 6, 7)};
}
/// The reverse; each holds its lane of `w` too.
inline std::array<Lanes, lane_count> one_by_one(const Vec3Lanes& v, Lanes w) noexcept {
  const Lanes xy = __builtin_shufflevector(v.x, v.y, 0, 4, 1, 5);
  const Lanes xy_too = __builtin_shufflevector(v.x, v.y, 2, 6, 3, 7);
  const Lanes zw = __builtin_shufflevector(v.z, w, 0, 4, 1, 5);
  const Lanes zw_too = __builtin_shufflevector(v.z, w, 2, 6, 3, 7);
  return {__builtin_shufflevector(xy, zw, 0, 1, 4, 5), __builtin_shufflevector(xy, zw, 2, 3, 6, 7),
          __builtin_shufflevector(xy_too, zw_too, 0, 1, 4, 5),
          __builtin_shufflevector(xy_too, zw_too, 2, 3, 6, 7)};
}
inline Lanes dot(const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3Lanes cross(const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec3Lanes mix(const Vec3Lanes& a, const Vec3Lanes& b, float share) noexcept {
  return (1 - share) * a + share * b;
}
/// `a` where it holds, else `b`.
inline Vec3Lanes choose(LaneMask m, const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
  return {m ? a.x : b.x, m ? a.y : b.y, m ? a.z : b.z};
}

}  // namespace docent::motion

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/model/geometry/vec2.h"

namespace docent::motion::offline {

/// Frames to fill anew, and the sound ones beside them. `before` is none at the beginning of the
/// clip, `after` none at its end.
struct Gap {
  std::int64_t first = 0, last = 0;
  std::int64_t before = -1, after = -1;
};

/// The frames from `first` to `last` and `more` to each side. Two sound frames are needed to know a
/// speed.
inline Gap gap_of(std::int64_t first, std::int64_t last, std::int64_t frames, std::int64_t more) {
  Gap gap{.first = first - more, .last = last + more};
  gap.first = gap.first < 2 ? 0 : gap.first;
  gap.last = gap.last + 2 >= frames ? frames - 1 : gap.last;
  if (gap.first > 0) gap.before = gap.first - 1;
  if (gap.last < frames - 1) gap.after = gap.last + 1;
  return gap;
}

/// One rotation or place a frame, `stride` apart.
template <typename Value>
struct Channel {
  std::span<Value> values;
  std::size_t stride = 1, offset = 0;

  Value& at(std::int64_t frame) const {
    return values[static_cast<std::size_t>(frame) * stride + offset];
  }
};

/// The Hermite curve from a to b with speeds va and vb, each for the whole way.
template <typename Value>
Value on_hermite(const Value& a, const Value& va, const Value& b, const Value& vb, float t) {
  const float t2 = t * t, t3 = t2 * t;
  return a * (2 * t3 - 3 * t2 + 1) + va * (t3 - 2 * t2 + t) + b * (3 * t2 - 2 * t3) +
         vb * (t3 - t2);
}

inline Vec3 made_whole(const Vec3& place) {
  return place;
}
inline Quat made_whole(const Quat& rotation) {
  return glm::normalize(rotation);
}

/// Fills it: between two sound frames on the curve that keeps the speeds at both; at an end of the
/// clip the value goes on as it changed, ever slower.
template <typename Value>
void fill(const Gap& gap, const Channel<Value>& channel, std::int64_t frames) {
  const auto speed = [&](std::int64_t from, std::int64_t to) {
    return to >= 0 && to < frames && from >= 0 && from < frames ? channel.at(to) - channel.at(from)
                                                                : channel.at(from) * 0.0f;
  };
  if (gap.before >= 0 && gap.after >= 0) {
    const Value a = channel.at(gap.before), b = channel.at(gap.after);
    const auto steps = static_cast<float>(gap.after - gap.before);
    const Value va = gap.before > 0 ? speed(gap.before - 1, gap.before) * steps : b - a;
    const Value vb = gap.after + 1 < frames ? speed(gap.after, gap.after + 1) * steps : b - a;
    for (std::int64_t f = gap.first; f <= gap.last; ++f)
      channel.at(f) =
          made_whole(on_hermite(a, va, b, vb, static_cast<float>(f - gap.before) / steps));
    return;
  }
  // Away from the sound end, slowing down by a tenth from frame to frame.
  constexpr float slower = 0.9f;
  const bool backwards = gap.after >= 0;
  Value step = backwards ? speed(gap.after + 1, gap.after) : speed(gap.before - 1, gap.before);
  Value value = channel.at(backwards ? gap.after : gap.before);
  for (std::int64_t i = 0; i <= gap.last - gap.first; ++i) {
    step = step * slower;
    value = value + step;
    channel.at(backwards ? gap.last - i : gap.first + i) = made_whole(value);
  }
}

}  // namespace docent::motion::offline

#include "content/motion/resample.h"

#include <algorithm>
#include <cmath>

namespace docent::motion::offline {
namespace {

/// The Catmull-Rom curve between the middle two of four values that are one step apart.
template <typename Value>
Value on_curve(const Value& a, const Value& b, const Value& c, const Value& d, float t) {
  const float t2 = t * t, t3 = t2 * t;
  return (a * (-t + 2 * t2 - t3) + b * (2 - 5 * t2 + 3 * t3) + c * (t + 4 * t2 - 3 * t3) +
          d * (t3 - t2)) *
         0.5f;
}

}  // namespace

MotionClip resample(const MotionClip& clip, double frame_rate) {
  MotionClip result = clip;
  result.frame_rate = frame_rate;
  result.plants.clear();
  const std::size_t last = clip.root.size() - 1;
  const double seconds = static_cast<double>(last) / clip.frame_rate;
  const auto frames = static_cast<std::size_t>(std::floor(seconds * frame_rate + 1e-6)) + 1;
  result.root.resize(frames);
  result.rotation.resize(frames * clip.joint_count);
  for (std::size_t f = 0; f < frames; ++f) {
    const double at = static_cast<double>(f) / frame_rate * clip.frame_rate;
    const std::size_t b = std::min(static_cast<std::size_t>(at + 1e-6), last);
    const auto t = static_cast<float>(std::clamp(at - static_cast<double>(b), 0.0, 1.0));
    const std::size_t a = b > 0 ? b - 1 : b, c = std::min(b + 1, last), d = std::min(b + 2, last);
    result.root[f] = on_curve(clip.root[a], clip.root[b], clip.root[c], clip.root[d], t);
    for (std::size_t j = 0; j < clip.joint_count; ++j) {
      const auto turn = [&](std::size_t frame) {
        return clip.rotation[frame * clip.joint_count + j];
      };
      result.rotation[f * clip.joint_count + j] =
          glm::normalize(on_curve(turn(a), turn(b), turn(c), turn(d), t));
    }
  }
  return result;
}

}  // namespace docent::motion::offline

#include "content/motion/extract_root_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace docent::motion::offline {
namespace {

// Seconds: two steps at 109 a minute. Hann weights over two cycles cancel what repeats every cycle.
constexpr double gait_cycle = 1.1;

/// Hann weights of the frames up to `half` before and after one, from the first on.
std::vector<double> hann_weights(std::size_t half) {
  std::vector<double> weights(2 * half + 1);
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] = 0.5 + 0.5 * std::cos(std::numbers::pi *
                                      (static_cast<double>(i) - static_cast<double>(half)) /
                                      static_cast<double>(half + 1));
  return weights;
}

/// The value at `at` of the line that fits `values` best round it.
template <typename Value>
Value fit_line(const std::vector<Value>& values, std::size_t at, std::size_t half,
               const std::vector<double>& weights) {
  const std::size_t first = at > half ? at - half : 0;
  const std::size_t last = std::min(at + half, values.size() - 1);
  double w = 0, wt = 0, wtt = 0;
  Value wv{}, wtv{};
  for (std::size_t f = first; f <= last; ++f) {
    const double t = static_cast<double>(f) - static_cast<double>(at);
    const double weight = weights[f + half - at];
    w += weight;
    wt += weight * t;
    wtt += weight * t * t;
    wv += weight * values[f];
    wtv += weight * t * values[f];
  }
  const double determinant = w * wtt - wt * wt;
  if (determinant <= 1e-9 * w * w) return wv / w;
  return (wtt * wv - wt * wtv) / determinant;
}

}  // namespace

double hip_heading(const Skeleton& skeleton, const JointPositions& track, std::size_t frame,
                   double before) {
  const JointIndex left = skeleton[BodyPart::LeftHip], right = skeleton[BodyPart::RightHip];
  if (left == JointIndex::None || right == JointIndex::None) return before;
  const Vec2 to_left =
      to_floor(track.at(frame, index_of(left))) - to_floor(track.at(frame, index_of(right)));
  const double heading = std::atan2(-to_left.x, to_left.y);  // a quarter clockwise of to_left
  constexpr double turn = 2 * std::numbers::pi;
  return heading + turn * std::round((before - heading) / turn);
}

std::vector<Placement> extract_root_motion(const Skeleton& skeleton, const MotionClip& clip,
                                           const JointPositions& track) {
  std::vector<Vec2> place;
  std::vector<double> heading;
  for (std::size_t f = 0; f < clip.root.size(); ++f) {
    place.push_back(to_floor(clip.root[f]));
    heading.push_back(hip_heading(skeleton, track, f, f > 0 ? heading[f - 1] : 0));
  }
  const std::size_t half = frames_in(gait_cycle, clip.frame_rate);
  const std::vector<double> weights = hann_weights(half);
  std::vector<Placement> body;
  body.reserve(place.size());
  for (std::size_t f = 0; f < place.size(); ++f)
    body.push_back({fit_line(place, f, half, weights), fit_line(heading, f, half, weights)});
  return body;
}

std::vector<double> body_speed(const std::vector<Placement>& body, double frame_rate) {
  std::vector<double> speed(body.size());
  for (std::size_t f = 0; f < body.size(); ++f) {
    const std::size_t a = f > 0 ? f - 1 : f, b = std::min(f + 1, body.size() - 1);
    if (b > a)
      speed[f] = glm::distance(body[a].position, body[b].position) * frame_rate /
                 static_cast<double>(b - a);
  }
  return speed;
}

}  // namespace docent::motion::offline

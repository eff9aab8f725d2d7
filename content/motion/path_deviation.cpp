#include "content/motion/path_deviation.h"

#include <algorithm>
#include <cmath>

#include "runtime/model/geometry/polyline.h"

namespace docent::motion::offline {
namespace {

/// Metres of path that are searched from the last place.
constexpr double reach_back = 0.5, reach_ahead = 1.0;

struct NearestPoint {
  Vec2 offset{};
  double along = 0;
};

NearestPoint nearest_on(std::span<const Vec2> path, std::span<const double> walked, Vec2 point,
                        double from) {
  const auto first = std::upper_bound(walked.begin(), walked.end(), from - reach_back);
  std::size_t i =
      first == walked.begin() ? 0 : static_cast<std::size_t>(first - walked.begin()) - 1;
  NearestPoint best{point - path[std::min(i, path.size() - 1)],
                    walked[std::min(i, path.size() - 1)]};
  for (; i + 1 < path.size() && walked[i] <= from + reach_ahead; ++i) {
    const auto [squared, t] = nearest_on_segment(point, path[i], path[i + 1]);
    if (squared < dot(best.offset, best.offset))
      best = {point - glm::mix(path[i], path[i + 1], t), std::lerp(walked[i], walked[i + 1], t)};
  }
  return best;
}

}  // namespace

PathDeviation measure_deviation(std::span<const Vec2> roots, double frame_rate,
                                std::span<const Vec2> path) {
  const std::vector<double> walked = distances_along(path);
  PathDeviation result;
  std::vector<Vec2> sums(roots.size() + 1, Vec2{});
  double along = 0;
  for (std::size_t f = 0; f < roots.size(); ++f) {
    const NearestPoint nearest = nearest_on(path, walked, roots[f], along);
    along = nearest.along;
    sums[f + 1] = sums[f] + nearest.offset;
    result.reached = std::max(result.reached, along);
  }

  const auto half = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(frame_rate / 2)));
  for (std::size_t f = 0; f < roots.size(); ++f) {
    const std::size_t radius = std::min({half, f, roots.size() - 1 - f});
    const Vec2 sum = sums[f + radius + 1] - sums[f - radius];
    const double deviation = glm::length(sum) / static_cast<double>(2 * radius + 1);
    result.mean += deviation / static_cast<double>(roots.size());
    result.largest = std::max(result.largest, deviation);
  }
  return result;
}

}  // namespace docent::motion::offline

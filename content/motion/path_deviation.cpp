#include "content/motion/path_deviation.h"

#include <algorithm>
#include <cmath>

namespace docent::motion::offline {
namespace {

constexpr double back = 0.5, ahead = 1.0;  // metres of path that are searched from the last place

struct NearestPoint {
  Vec2 offset{};
  double along = 0;
};

NearestPoint nearest_on(std::span<const Vec2> path, std::span<const double> walked, Vec2 point,
                        double from) {
  const auto first = std::upper_bound(walked.begin(), walked.end(), from - back);
  std::size_t i =
      first == walked.begin() ? 0 : static_cast<std::size_t>(first - walked.begin()) - 1;
  NearestPoint best{point - path[std::min(i, path.size() - 1)],
                    walked[std::min(i, path.size() - 1)]};
  for (; i + 1 < path.size() && walked[i] <= from + ahead; ++i) {
    const Vec2 step = path[i + 1] - path[i];
    const double square = dot(step, step);
    const double t = square > 0 ? std::clamp(dot(point - path[i], step) / square, 0.0, 1.0) : 0.0;
    const Vec2 offset = point - path[i] - t * step;
    if (glm::length(offset) < glm::length(best.offset))
      best = {offset, walked[i] + t * std::sqrt(square)};
  }
  return best;
}

}  // namespace

PathDeviation measure_deviation(std::span<const Vec2> roots, double frame_rate,
                                std::span<const Vec2> path) {
  std::vector<double> walked(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i)
    walked[i] = walked[i - 1] + glm::distance(path[i - 1], path[i]);

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

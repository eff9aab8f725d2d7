#include "content/motion/path_deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/model/geometry/polyline.h"

namespace docent::motion::offline {
namespace {

/// Metres of path that are searched from the last place.
constexpr double reach_back = 0.5, reach_ahead = 1.0;

/// Where a path comes back beside itself, several of its places are about as near: the body has
/// come to the one to which it has walked. So much nearer must another be for each metre that it
/// lies ahead of that or, where nobody walks backwards, behind it.
constexpr double ahead_cost = 0.1, behind_cost = 0.3;

struct NearestPoint {
  Vec2 offset{};
  double along = 0;
};

/// `furthest`: metres along the path to where the body has been, which has gone `step` metres
/// since.
NearestPoint nearest_on(std::span<const Vec2> path, std::span<const double> walked, Vec2 point,
                        double furthest, double step) {
  const auto first = std::upper_bound(walked.begin(), walked.end(), furthest - reach_back);
  std::size_t i =
      first == walked.begin() ? 0 : static_cast<std::size_t>(first - walked.begin()) - 1;
  i = std::min(i, path.size() - 2);
  NearestPoint best;
  for (double least = std::numeric_limits<double>::infinity();
       i + 1 < path.size() && walked[i] <= furthest + reach_ahead; ++i) {
    const auto [squared, t] = nearest_on_segment(point, path[i], path[i + 1]);
    const double along = std::lerp(walked[i], walked[i + 1], t);
    const double off = along - (furthest + step);
    const double misfit = std::sqrt(squared) + std::max(ahead_cost * off, -behind_cost * off);
    if (misfit >= least) continue;
    least = misfit;
    best = {point - glm::mix(path[i], path[i + 1], t), along};
  }
  return best;
}

}  // namespace

PathDeviation measure_deviation(std::span<const Vec2> roots, double frame_rate,
                                std::span<const Vec2> path) {
  const std::vector<double> walked = distances_along(path);
  PathDeviation result;
  std::vector<Vec2> sums(roots.size() + 1, Vec2{});
  for (std::size_t f = 0; f < roots.size(); ++f) {
    const double step = f > 0 ? glm::distance(roots[f - 1], roots[f]) : 0;
    const NearestPoint nearest = nearest_on(path, walked, roots[f], result.reached, step);
    sums[f + 1] = sums[f] + nearest.offset;
    result.reached = std::max(result.reached, nearest.along);
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

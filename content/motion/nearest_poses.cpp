#include "content/motion/nearest_poses.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace docent::motion::offline {
namespace {

using Point = PoseFeatures::Point;
constexpr std::uint32_t largest_leaf = 16;

/// Sums beside each other, as in square_between, so that a box is never farther than its points.
constexpr std::size_t lanes = 4;
static_assert(PoseFeatures::dimensions % lanes == 0);

/// The squared distance to the closest place of a box.
float square_to_box(const Point& point, const Point& low, const Point& high) {
  std::array<float, lanes> sums{};
  for (std::size_t d = 0; d < point.size(); d += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const float below = low[d + k] - point[d + k], above = point[d + k] - high[d + k];
      const float outside = std::max(std::max(below, above), 0.0f);
      sums[k] += outside * outside;
    }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

NearestPoses::NearestPoses(std::span<const Point> points) {
  index_.resize(points.size());
  std::iota(index_.begin(), index_.end(), 0U);
  if (!points.empty()) add_box(0, static_cast<std::uint32_t>(points.size()), points);
  for (const std::uint32_t i : index_) point_.push_back(points[i]);
}

void NearestPoses::add_box(std::uint32_t first, std::uint32_t end, std::span<const Point> points) {
  Box box{.low = points[index_[first]], .high = points[index_[first]], .first = first, .end = end};
  for (std::uint32_t i = first; i < end; ++i)
    for (std::size_t d = 0; d < PoseFeatures::dimensions; ++d) {
      box.low[d] = std::min(box.low[d], points[index_[i]][d]);
      box.high[d] = std::max(box.high[d], points[index_[i]][d]);
    }
  const std::size_t own = boxes_.size();
  boxes_.push_back(box);
  if (end - first <= largest_leaf) return;

  std::size_t longest = 0;
  for (std::size_t d = 1; d < PoseFeatures::dimensions; ++d)
    if (box.high[d] - box.low[d] > box.high[longest] - box.low[longest]) longest = d;
  const std::uint32_t middle = first + (end - first) / 2;
  const auto at = [&](std::uint32_t i) { return index_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(points[a][longest], a) < std::pair(points[b][longest], b);
  });
  add_box(first, middle, points);
  boxes_[own].second_half = static_cast<std::uint32_t>(boxes_.size());
  add_box(middle, end, points);
}

void NearestPoses::find(const Point& point, std::size_t count, float within,
                        std::vector<Neighbour>& nearest) const {
  nearest.clear();
  if (boxes_.empty() || count == 0) return;
  const float limit = within * within;
  const auto worst = [&] { return nearest.size() < count ? limit : nearest.front().square; };
  const auto to_box = [&](std::uint32_t b) {
    return square_to_box(point, boxes_[b].low, boxes_[b].high);
  };
  // Depth first, the closer half first; a tree of 2^32 points is no deeper than 32.
  struct Waiting {
    float square;
    std::uint32_t box;
  };
  std::array<Waiting, 64> waiting{};
  std::size_t count_waiting = 0;
  waiting[count_waiting++] = {to_box(0), 0};
  while (count_waiting > 0) {
    const auto [square, b] = waiting[--count_waiting];
    if (square > worst()) continue;
    const Box& box = boxes_[b];
    if (box.second_half != 0) {
      const Waiting one{to_box(b + 1), b + 1}, other{to_box(box.second_half), box.second_half};
      const bool one_is_closer = one.square <= other.square;
      waiting[count_waiting++] = one_is_closer ? other : one;
      waiting[count_waiting++] = one_is_closer ? one : other;
      continue;
    }
    for (std::uint32_t i = box.first; i < box.end; ++i) {
      const Neighbour here{square_between(point, point_[i]), index_[i]};
      if (here.square > limit) continue;
      if (nearest.size() == count) {
        if (here >= nearest.front()) continue;
        std::ranges::pop_heap(nearest);
        nearest.back() = here;
      } else {
        nearest.push_back(here);
      }
      std::ranges::push_heap(nearest);
    }
  }
  std::ranges::sort_heap(nearest);
}

}  // namespace docent::motion::offline

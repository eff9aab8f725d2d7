#include "runtime/path/index/interval_tree.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace docent::path {

IntervalTree::IntervalTree(std::span<const Interval> intervals)
    : interval_(intervals.begin(), intervals.end()) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < interval_.size(); ++i)
    if (interval_[i].low < interval_[i].high) all.push_back(i);
  build(std::move(all));
}

/// Gives the node of some intervals. Its centre is the middle one of their lower ends, so at least
/// one interval stays and at most half go each way.
std::uint32_t IntervalTree::build(std::vector<std::uint32_t> rest) {
  if (rest.empty()) return none;
  const auto low_of = [&](std::uint32_t i) { return std::pair(interval_[i].low, i); };
  const auto high_of = [&](std::uint32_t i) { return std::pair(interval_[i].high, i); };
  std::ranges::sort(rest, {}, low_of);
  const double centre = interval_[rest[rest.size() / 2]].low;

  const auto number = static_cast<std::uint32_t>(node_.size());
  node_.push_back({.centre = centre, .first = static_cast<std::uint32_t>(by_low_.size())});
  std::vector<std::uint32_t> below, above;
  for (const std::uint32_t i : rest) {
    if (interval_[i].contains(centre))
      by_low_.push_back(i);
    else
      (interval_[i].low > centre ? above : below).push_back(i);
  }
  const std::uint32_t first = node_[number].first;
  node_[number].count = static_cast<std::uint32_t>(by_low_.size()) - first;
  by_high_.insert(by_high_.end(), by_low_.begin() + first, by_low_.end());
  std::ranges::sort(by_high_.begin() + first, by_high_.end(), std::greater{}, high_of);

  const std::uint32_t lower = build(std::move(below));
  const std::uint32_t upper = build(std::move(above));
  node_[number].below = lower;
  node_[number].above = upper;
  return number;
}

}  // namespace docent::path

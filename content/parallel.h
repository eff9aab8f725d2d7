#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace docent {

/// Calls `work(i)` for every i below `count`, on up to `jobs` threads. `work` must not throw, and
/// each call writes only what is its own, so the result does not depend on the number of threads.
void for_each_index(std::size_t count, unsigned jobs, const auto& work) {
  std::atomic<std::size_t> next{0};
  const auto take_turns = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> helpers;
  for (std::size_t i = 1; i < std::min<std::size_t>(jobs, count); ++i)
    helpers.emplace_back(take_turns);
  take_turns();
}

}  // namespace docent

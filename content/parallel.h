#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace docent::content {

/// Calls `work(i)` for every i below `count`, on up to `jobs` threads. Each call writes only what
/// is its own, so the result does not depend on the number of threads. Where calls throw, the
/// exception of the smallest i is thrown here once all have ended.
void for_each_index(std::size_t count, unsigned jobs, const auto& work) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::size_t failed = count;
  std::exception_ptr failure;
  const auto attempt = [&](std::size_t i) {
    try {
      work(i);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (i < failed) failure = std::current_exception();
      failed = std::min(failed, i);
    }
  };
  const auto take_turns = [&] {
    for (std::size_t i = next++; i < count; i = next++) attempt(i);
  };
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < std::min<std::size_t>(jobs, count); ++i)
      helpers.emplace_back(take_turns);
    take_turns();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace docent::content

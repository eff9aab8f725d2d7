#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

namespace docent::plan {

/// Which of some buffers hold a value, in the order in which they were filled, from one writer to
/// one reader. A buffer is listed once at most, so there is always room for all of them. Neither
/// side waits or allocates.
class FillOrder {
 public:
  explicit FillOrder(std::size_t buffers) : listed_(buffers), ring_(buffers + 1) {}

  /// Lists a buffer. True where it was not listed yet.
  bool add(std::size_t buffer) noexcept {
    if (listed_[buffer].exchange(true, std::memory_order_acq_rel)) return false;
    const std::size_t end = end_.load(std::memory_order_relaxed);
    ring_[end % ring_.size()] = buffer;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }
  std::optional<std::size_t> take() noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return {};
    const std::size_t buffer = ring_[begin % ring_.size()];
    begin_.store(begin + 1, std::memory_order_release);
    listed_[buffer].store(false, std::memory_order_release);
    return buffer;
  }

 private:
  std::vector<std::atomic<bool>> listed_;
  std::vector<std::size_t> ring_;
  std::atomic<std::size_t> begin_{0}, end_{0};
};

}  // namespace docent::plan

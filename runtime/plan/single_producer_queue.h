#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>

namespace docent::plan {

/// Values from one writer to one reader, in order: a ring. Neither side waits or allocates; put()
/// refuses while the queue holds `capacity` values.
template <typename T, std::size_t capacity>
class SingleProducerQueue {
 public:
  bool put(std::unique_ptr<T>& value) noexcept {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == capacity) return false;
    place_[end % capacity] = std::move(value);
    end_.store(end + 1, std::memory_order_release);
    return true;
  }
  std::unique_ptr<T> take() noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return nullptr;
    std::unique_ptr<T> value = std::move(place_[begin % capacity]);
    begin_.store(begin + 1, std::memory_order_release);
    return value;
  }

 private:
  std::array<std::unique_ptr<T>, capacity> place_;
  std::atomic<std::size_t> begin_{0}, end_{0};
};

}  // namespace docent::plan

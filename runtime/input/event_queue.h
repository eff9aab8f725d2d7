#pragma once

#include <array>
#include <atomic>
#include <cstddef>

#include "runtime/input/contact.h"

namespace docent::input {

/// Events on their way from one reader thread to the frame loop. One thread pushes, one pops;
/// neither ever waits for the other and nothing allocates.
class EventQueue {
 public:
  /// False when the queue is full: the event was not taken.
  bool push(const InputEvent& event) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail - head_.load(std::memory_order_acquire) == capacity) return false;
    ring_[tail % capacity] = event;
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

  /// For the thread that pushes: is the other one behind?
  bool is_half_full() const noexcept {
    return tail_.load(std::memory_order_relaxed) - head_.load(std::memory_order_acquire) >
           capacity / 2;
  }

  /// False when the queue is empty.
  bool pop(InputEvent& event) noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head == tail_.load(std::memory_order_acquire)) return false;
    event = ring_[head % capacity];
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

 private:
  static constexpr std::size_t capacity = 1024;  // a second of ten fingers at 100 reports a second
  std::array<InputEvent, capacity> ring_{};
  std::atomic<std::size_t> head_{0};
  std::atomic<std::size_t> tail_{0};
};

}  // namespace docent::input

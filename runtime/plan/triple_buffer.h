#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

namespace docent::plan {

/// Carries the latest value from one writer to one reader: a newer one replaces one not yet read.
/// The three buffers change hands by one atomic exchange, so neither side waits or allocates. `T`
/// is copied and must not throw.
template <typename T>
class TripleBuffer {
 public:
  void put(const T& value) noexcept {
    buffer_[writing_] = value;
    writing_ = waiting_.exchange(writing_ | fresh, std::memory_order_acq_rel) & index_mask;
  }
  std::optional<T> take() noexcept {
    if ((waiting_.load(std::memory_order_acquire) & fresh) == 0) return std::nullopt;
    reading_ = waiting_.exchange(reading_, std::memory_order_acq_rel) & index_mask;
    return buffer_[reading_];
  }

 private:
  static constexpr std::uint32_t fresh = 4, index_mask = 3;

  std::array<T, 3> buffer_{};
  std::uint32_t writing_ = 0, reading_ = 1;
  std::atomic<std::uint32_t> waiting_{2};
};

}  // namespace docent::plan

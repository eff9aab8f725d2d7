#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace docent {

/// Holds the latest letter from one writer to one reader: a newer one replaces one not yet read.
/// Three buffers change hands by one atomic exchange, so neither side waits or allocates. `T` is
/// copied and must not throw.
template <typename T>
class LatestMail {
 public:
  void put(const T& letter) noexcept {
    buffer_[writing_] = letter;
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

/// Which letterboxes hold a letter, in the order in which they were filled. A box is listed once at
/// most, so there is always room for all of them. Neither side waits or allocates.
class Round {
 public:
  explicit Round(std::size_t boxes) : listed_(boxes), ring_(boxes + 1) {}

  /// True where the box was not yet listed.
  bool add(std::size_t box) noexcept {
    if (listed_[box].exchange(true, std::memory_order_acq_rel)) return false;
    const std::size_t end = end_.load(std::memory_order_relaxed);
    ring_[end % ring_.size()] = box;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }
  std::optional<std::size_t> take() noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return {};
    const std::size_t box = ring_[begin % ring_.size()];
    begin_.store(begin + 1, std::memory_order_release);
    listed_[box].store(false, std::memory_order_release);
    return box;
  }

 private:
  std::vector<std::atomic<bool>> listed_;
  std::vector<std::size_t> ring_;
  std::atomic<std::size_t> begin_{0}, end_{0};
};

/// Parcels from one writer to one reader, in order. Neither side waits or allocates; put() refuses
/// while `capacity` parcels are on their way.
template <typename T, std::size_t capacity>
class Belt {
 public:
  bool put(std::unique_ptr<T>& parcel) noexcept {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == capacity) return false;
    place_[end % capacity] = std::move(parcel);
    end_.store(end + 1, std::memory_order_release);
    return true;
  }
  std::unique_ptr<T> take() noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return nullptr;
    std::unique_ptr<T> parcel = std::move(place_[begin % capacity]);
    begin_.store(begin + 1, std::memory_order_release);
    return parcel;
  }

 private:
  std::array<std::unique_ptr<T>, capacity> place_;
  std::atomic<std::size_t> begin_{0}, end_{0};
};

}  // namespace docent

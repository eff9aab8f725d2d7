#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

/// Bits in bytes, the high bit of a byte first.
namespace docent::schema {

class BitWriter {
 public:
  /// Goes on after these bytes.
  explicit BitWriter(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}

  /// Writes the low `count` bits of `value`, at most 64, the highest of them first.
  void put(std::uint64_t value, int count) {
    for (int i = count - 1; i >= 0; --i) {
      if (used_ == 8) {
        bytes_.push_back(std::byte{0});
        used_ = 0;
      }
      bytes_.back() |= static_cast<std::byte>((value >> i & 1) << (7 - used_++));
    }
  }

  void put_flag(bool flag) { put(flag ? 1 : 0, 1); }

  std::vector<std::byte> take_bytes() && { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
  int used_ = 8;  ///< Bits of the last byte.
};

/// Past the end it reads zeros, and has_overrun() tells that this has happened.
class BitReader {
 public:
  explicit BitReader(std::span<const std::byte> bytes) : bytes_(bytes) { fill(); }

  /// The next `count` bits, at most 32.
  std::uint64_t take(int count) noexcept {
    if (count == 0) return 0;
    const std::uint64_t value = window_ >> (64 - count);
    drop(count);
    return value;
  }
  bool take_flag() noexcept { return take(1) != 0; }

  /// How many ones follow, at most `most` (which is at most 32). Takes them and the zero behind
  /// them; after `most` ones no zero follows.
  int take_ones(int most) noexcept {
    const int ones = std::min(std::countl_one(window_), most);
    drop(ones < most ? ones + 1 : ones);
    return ones;
  }

  bool has_overrun() const noexcept { return place() > 8 * bytes_.size(); }
  /// Is nothing left but zeros that fill the last byte?
  bool is_at_end() const noexcept {
    return place() + 8 > 8 * bytes_.size() && !has_overrun() && window_ == 0;
  }

 private:
  std::size_t place() const noexcept { return 8 * next_ - static_cast<std::size_t>(held_); }

  void drop(int count) noexcept {
    window_ <<= count;
    held_ -= count;
    fill();
  }
  /// Leaves 57 bits or more in the window.
  void fill() noexcept {
    while (held_ <= 56) {
      const std::byte byte = next_ < bytes_.size() ? bytes_[next_] : std::byte{0};
      window_ |= std::to_integer<std::uint64_t>(byte) << (56 - held_);
      ++next_;
      held_ += 8;
    }
  }

  std::span<const std::byte> bytes_;
  std::size_t next_ = 0;      ///< Byte that comes into the window next; may lie past the end.
  std::uint64_t window_ = 0;  ///< Its high `held_` bits come next.
  int held_ = 0;
};

}  // namespace docent::schema

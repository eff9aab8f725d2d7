#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace docent::test {

/// Takes numbers from a fuzzer's bytes, one after another; zeros after their end.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  unsigned byte() {
    if (rest_.empty()) return 0;
    const unsigned first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }
  /// A number of two bytes, the lower one first.
  unsigned word() {
    const unsigned low = byte();
    return low + 256 * byte();
  }
  /// One of so many numbers, from 0.
  unsigned below(unsigned count) { return byte() % count; }
  /// A number from `least` to `most`, both included, of two bytes.
  double between(double least, double most) { return least + word() / 65535.0 * (most - least); }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace docent::test

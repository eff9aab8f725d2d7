#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace docent::sound {

/// Speech faster or slower at its own pitch (WSOLA). Samples of one channel, 48 kHz, go in and come
/// out; at speed 1 they come out as they went in. Does not allocate.
class Tempo {
 public:
  static constexpr float slowest = 0.5F, fastest = 3;
  static constexpr std::size_t most = 8192;  ///< Samples that may wait in it.

  /// Held between `slowest` and `fastest`.
  void set_speed(float speed) noexcept;

  /// How many samples it takes just now.
  [[nodiscard]] std::size_t room() const noexcept { return most - filled_; }
  /// Takes samples, at most room() of them.
  void push(std::span<const float> samples) noexcept;
  /// Gives the next samples; 0 where it needs more first.
  std::size_t pull(std::span<float> out) noexcept;
  /// All that is left, after the last push; 0 at the end.
  std::size_t finish(std::span<float> out) noexcept;
  /// Forgets all that waits in it.
  void clear() noexcept;

 private:
  static constexpr std::size_t overlap = 480;  // 10 ms; a window is two
  static constexpr std::size_t search = 360;   // 7.5 ms: a period of the lowest voices

  [[nodiscard]] std::size_t most_alike() const noexcept;
  void drop(std::size_t samples) noexcept;

  float speed_ = 1;
  std::array<float, most> waiting_{};
  std::size_t filled_ = 0;
  std::array<float, overlap> fading_{};  ///< The second half of the last window.
  bool is_fading_ = false;
  double surplus_ = 0;  ///< How far the reading is ahead of whole samples.
};

}  // namespace docent::sound

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "runtime/input/contact.h"

namespace docent::input {

/// A finger while it is on the glass.
struct Finger {
  Contact start;      ///< Where it came down.
  Contact at;         ///< Where it is.
  float seconds = 0;  ///< Since it came down.
};

/// What a finger meant when it left the glass.
struct Gesture {
  enum class Kind : std::uint8_t {
    Release,    ///< It moved little or stayed long: the control where it left is pressed.
    SwipeLeft,  ///< It flicked; in screen directions, whatever the language.
    SwipeRight,
  };
  Kind kind = Kind::Release;
  Finger finger;
};

/// Follows every finger on its own: two contacts are two fingers, each with its own gesture.
class GestureRecogniser {
 public:
  /// Fingers beyond these are not followed.
  static constexpr std::size_t most_fingers = 10;

  /// A flick goes sideways by at least that share of the glass's width.
  explicit GestureRecogniser(float flick_distance = 0.08F) noexcept
      : flick_distance_(flick_distance) {}

  /// Takes an event of the glass; returns the gesture that it ended, if any. Passes over keys, and
  /// contacts that never came down.
  std::optional<Gesture> take(const InputEvent& event) noexcept;
  void advance(float seconds) noexcept;

  std::span<const Finger> fingers() const noexcept { return {fingers_.data(), count_}; }

 private:
  Finger* find(std::uint32_t id) noexcept;

  float flick_distance_;
  std::array<Finger, most_fingers> fingers_{};
  std::size_t count_ = 0;
};

}  // namespace docent::input

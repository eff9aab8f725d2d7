#pragma once

#include <cstdint>
#include <optional>

#include "runtime/input/contact.h"

namespace docent::input {

/// What opens the staff's PIN pad: two fingers that rest in two opposite corners of the glass, and
/// nothing else on it, for five seconds. Hands that play do not do it, one arm cannot on a large
/// screen, and nothing on the glass tells of it. Either diagonal will do.
///
/// Time comes in as a value, in seconds. Screen frame.
class StaffGesture {
 public:
  static constexpr double seconds = 5;
  static constexpr float corner = 0.12F;  ///< Of the width and of the height.

  void take(const InputEvent& event, double time) noexcept;
  /// Has it just been made? True once.
  bool is_made(double time) noexcept;

 private:
  enum class Corner : std::uint8_t { None, TopLeft, TopRight, BottomLeft, BottomRight };
  struct Finger {
    std::uint32_t id = 0;
    Corner corner = Corner::None;
  };
  static Corner corner_of(const Contact& contact) noexcept;
  bool is_diagonal() const noexcept;

  std::optional<Finger> one_, other_;
  std::uint32_t others_ = 0;  ///< Fingers beyond those two.
  double since_ = 0;
  bool told_ = false;
};

}  // namespace docent::input

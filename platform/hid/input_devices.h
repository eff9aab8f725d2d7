#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "runtime/input/contact.h"
#include "runtime/input/keypad_policy.h"
#include "runtime/model/result.h"

namespace docent::hid {

/// All touch screens and keypads of the kiosk: each has a reader thread of its own, and one more
/// thread looks after devices that come and go.
class InputDevices {
 public:
  /// Takes the given hidraw paths, or with none every touch screen present now or later, and the
  /// keypads that input::refusal() has nothing against. Fails where a given path cannot be used.
  static Result<InputDevices> open(const std::vector<std::string>& paths,
                                   const std::vector<input::NamedKeypad>& keypads = {});
  InputDevices(InputDevices&&) noexcept;
  InputDevices& operator=(InputDevices&&) noexcept;
  ~InputDevices();  ///< Stops the threads; takes at most a tenth of a second.

  /// Writes the events that arrived since the last call into `out`, oldest first for each device,
  /// and returns how many. Screen frame of the panel, before rotation. Contact identifiers are
  /// unique across devices. For the frame thread: never waits, never allocates.
  std::size_t arrived(std::span<input::InputEvent> out) noexcept;

 private:
  struct State;
  explicit InputDevices(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace docent::hid

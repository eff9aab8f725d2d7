#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>

namespace docent::alsa {

/// Is this control of a sound card the switch in the socket for headphones? "Headphone Jack",
/// "Front Headphone Jack", "Headset Jack"; not the pair that means "nobody knows".
bool is_headphone_jack(std::string_view control) noexcept;

/// Where headphones go in and out: waits up to the given time and says whether they are in; nothing
/// where no socket tells, or is there any more.
using JackSource = std::function<std::optional<bool>(std::chrono::milliseconds patience)>;

/// All sockets of the sound cards, by ALSA's controls: they are there where evdev may not be read.
JackSource jacks_of_cards();

/// Knows whether headphones are plugged in, on a thread of its own.
class JackWatch {
 public:
  explicit JackWatch(JackSource source = jacks_of_cards());
  JackWatch(const JackWatch&) = delete;
  JackWatch& operator=(const JackWatch&) = delete;

  /// What has changed since the last call: in, out, or nothing. Headphones that are in from the
  /// beginning have come in. For the frame thread: never waits.
  std::optional<bool> changed() noexcept;

 private:
  std::atomic<bool> is_in_{false};
  bool told_ = false;
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace docent::alsa

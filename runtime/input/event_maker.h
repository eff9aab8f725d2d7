#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/input/contact_decoder.h"
#include "runtime/input/hid_device_kind.h"
#include "runtime/input/key_decoder.h"
#include "runtime/input/silence.h"

namespace docent::input {

/// Makes events of one device's reports: reports and time in, events out; knows no thread and no
/// device file. Its functions do not allocate; what they give stays valid until the next call.
class EventMaker {
 public:
  /// Contacts get identifiers from `first_id` on, so that those of several devices differ. Keys
  /// that are not among the `meanings` mean themselves.
  EventMaker(const ReportDescriptor& descriptor, const HidDeviceKind& kind, std::uint32_t first_id,
             std::vector<KeyMeaning> meanings = {});

  /// How many identifiers one device needs.
  static constexpr std::uint32_t ids_per_device = 1U << 20U;

  /// Whether a finger's way is told in every step, or, for a reader that is behind, only where it
  /// ends up. Fingers and keys that go down or up are told in both.
  enum class Moves : std::uint8_t { All, Later };

  std::span<const InputEvent> take(std::span<const std::byte> report, std::chrono::nanoseconds time,
                                   Moves moves = Moves::All) noexcept;

  /// No report has come: cancels the contacts of a device that should have sent one by now.
  std::span<const InputEvent> wait(std::chrono::nanoseconds time) noexcept;

  /// Contacts are cancelled, keys go up: the device has gone.
  std::span<const InputEvent> lift_all() noexcept;

 private:
  std::size_t contact_changes(std::span<const Contact> now, Moves moves) noexcept;
  std::size_t cancel_all() noexcept;
  std::size_t key_events(std::size_t edges, std::size_t first) noexcept;

  std::uint32_t first_id_;
  std::optional<ContactDecoder> contacts_;
  std::optional<KeyDecoder> keys_;
  std::vector<KeyMeaning> meanings_;
  Silence silence_;
  std::array<Contact, max_contacts> told_{};  ///< As the events so far say it.
  std::size_t told_count_ = 0;
  std::array<Contact, max_contacts> heard_{};  ///< Of the frame before, as the device names them.
  std::size_t heard_count_ = 0;
  std::array<KeyEdge, 64> edges_{};
  std::array<InputEvent, 2 * max_contacts + 64> events_{};
};

}  // namespace docent::input

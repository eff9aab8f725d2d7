#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/input/hid_device_kind.h"
#include "runtime/input/key_decoder.h"

namespace docent::input {

/// A keypad that staff have named: `[[keypad]]` in kiosk.toml.
struct NamedKeypad {
  HidDeviceId id;
  std::optional<std::uint64_t> descriptor;  ///< Its descriptor_hash(); none: whatever it is.
  std::vector<KeyMeaning> keys{};           ///< Those that do not mean themselves.
};

/// Tells one descriptor from another (FNV-1a, 64 bits). It proves nothing: who builds a device can
/// copy a keypad's descriptor as well as its numbers.
std::uint64_t descriptor_hash(std::span<const std::byte> descriptor) noexcept;

/// "04e7:0022", as lsusb and `docent hid list` write it; none where the text is no such thing.
std::optional<HidDeviceId> device_id_from(std::string_view text) noexcept;
/// Sixteen hexadecimal figures.
std::optional<std::uint64_t> descriptor_hash_from(std::string_view text) noexcept;

/// Can these keys write words? A device that has all letters is a keyboard; a keypad for visitors
/// has figures, arrows, or a few keys of its own.
bool has_all_letters(std::span<const ReportField> keys) noexcept;

/// One of the devices that are present, as far as letting it in goes.
struct KeypadCandidate {
  HidDeviceId id;
  std::uint64_t descriptor = 0;
  bool has_keys = false;
  bool is_keyboard = false;  ///< has_all_letters().
};

/// Why the kiosk does not listen to a device with keys, as a sentence part; empty where it does.
/// Where staff have named keypads, those and no others are listened to. Where they have named none,
/// every keypad is, but no keyboard, and nothing that came with one: a keyboard's keys for volume
/// and music are often a device of their own with the same numbers.
std::string refusal(const KeypadCandidate& device, std::span<const KeypadCandidate> present,
                    std::span<const NamedKeypad> named);

/// What the keys of a device mean, as the first of the named keypads that it is says.
std::vector<KeyMeaning> meanings_of(const KeypadCandidate& device,
                                    std::span<const NamedKeypad> named);

}  // namespace docent::input

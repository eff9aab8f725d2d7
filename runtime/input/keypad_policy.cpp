#include "runtime/input/keypad_policy.h"

#include <algorithm>
#include <bitset>
#include <charconv>

namespace docent::input {
namespace {

std::optional<std::uint64_t> hexadecimal(std::string_view text, std::size_t figures) noexcept {
  if (text.size() != figures) return std::nullopt;
  std::uint64_t value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool is_named(const KeypadCandidate& device, const NamedKeypad& keypad) noexcept {
  return keypad.id == device.id &&
         keypad.descriptor.value_or(device.descriptor) == device.descriptor;
}

}  // namespace

std::uint64_t descriptor_hash(std::span<const std::byte> descriptor) noexcept {
  constexpr std::uint64_t offset_basis = 0xcbf29ce484222325ULL, prime = 0x100000001b3ULL;
  std::uint64_t hash = offset_basis;
  for (const std::byte byte : descriptor)
    hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * prime;
  return hash;
}

std::optional<HidDeviceId> device_id_from(std::string_view text) noexcept {
  if (text.size() != 9 || text[4] != ':') return std::nullopt;
  const auto vendor = hexadecimal(text.substr(0, 4), 4);
  const auto product = hexadecimal(text.substr(5), 4);
  if (!vendor || !product) return std::nullopt;
  return HidDeviceId{static_cast<std::uint16_t>(*vendor), static_cast<std::uint16_t>(*product)};
}

std::optional<std::uint64_t> descriptor_hash_from(std::string_view text) noexcept {
  return hexadecimal(text, 16);
}

bool has_all_letters(std::span<const ReportField> keys) noexcept {
  constexpr std::size_t letters = 26;
  constexpr Usage a = usage(0x07, 0x04);
  std::bitset<letters> has;
  for (const ReportField& field : keys)
    for (std::size_t i = 0; i < letters; ++i) {
      const Usage letter = a + static_cast<Usage>(i);
      if (field.usage <= letter && letter <= (field.is_array ? field.usage_max : field.usage))
        has.set(i);
    }
  return has.all();
}

std::string refusal(const KeypadCandidate& device, std::span<const KeypadCandidate> present,
                    std::span<const NamedKeypad> named) {
  if (!device.has_keys) return {};
  if (!named.empty())
    return std::ranges::any_of(named, [&](const NamedKeypad& k) { return is_named(device, k); })
               ? ""
               : "it is none of the keypads in kiosk.toml";
  if (device.is_keyboard) return "a keyboard: it is listened to only where kiosk.toml names it";
  const bool came_with_keyboard = std::ranges::any_of(present, [&](const KeypadCandidate& other) {
    return other.is_keyboard && other.id == device.id;
  });
  return came_with_keyboard ? "it belongs to a keyboard" : "";
}

std::vector<KeyMeaning> meanings_of(const KeypadCandidate& device,
                                    std::span<const NamedKeypad> named) {
  const auto keypad =
      std::ranges::find_if(named, [&](const NamedKeypad& k) { return is_named(device, k); });
  return keypad == named.end() ? std::vector<KeyMeaning>{} : keypad->keys;
}

}  // namespace docent::input

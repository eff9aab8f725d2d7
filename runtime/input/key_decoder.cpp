#include "runtime/input/key_decoder.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace docent::input {
namespace {

constexpr std::uint16_t keyboard_page = 0x07;
constexpr std::uint16_t consumer_page = 0x0c;

constexpr std::uint16_t page_of(Usage u) noexcept {
  return static_cast<std::uint16_t>(u >> 16U);
}
constexpr std::uint16_t id_of(Usage u) noexcept {
  return static_cast<std::uint16_t>(u & 0xffffU);
}

constexpr std::array<std::pair<Key, std::string_view>, 9> named_keys{{
    {Key::Up, "UP"},
    {Key::Down, "DOWN"},
    {Key::Left, "LEFT"},
    {Key::Right, "RIGHT"},
    {Key::Enter, "ENTER"},
    {Key::Back, "BACK"},
    {Key::Help, "HELP"},
    {Key::VolumeUp, "VOLUME_UP"},
    {Key::VolumeDown, "VOLUME_DOWN"},
}};

KeyName keyboard_key(std::uint16_t id) noexcept {
  const auto character = [](int c) { return KeyName{Key::Character, static_cast<char>(c)}; };
  const auto function = [](int n) { return KeyName{Key::Function, static_cast<char>(n)}; };
  if (id >= 0x04 && id <= 0x1d) return character('A' + (id - 0x04));
  if (id >= 0x1e && id <= 0x26) return character('1' + (id - 0x1e));
  if (id == 0x27 || id == 0x62) return character('0');
  if (id >= 0x59 && id <= 0x61) return character('1' + (id - 0x59));  // the number block
  if (id >= 0x3a && id <= 0x45) return function(id - 0x3a + 1);
  if (id >= 0x68 && id <= 0x73) return function(id - 0x68 + 13);
  switch (id) {
    case 0x28:
    case 0x58:
      return {Key::Enter};
    case 0x29:
    case 0x2a:
      return {Key::Back};
    case 0x4f:
      return {Key::Right};
    case 0x50:
      return {Key::Left};
    case 0x51:
      return {Key::Down};
    case 0x52:
      return {Key::Up};
    case 0x75:
      return {Key::Help};
    case 0x80:
      return {Key::VolumeUp};
    case 0x81:
      return {Key::VolumeDown};
    default:
      return {};
  }
}

KeyName consumer_key(std::uint16_t id) noexcept {
  switch (id) {
    case 0x41:
      return {Key::Enter};
    case 0x42:
      return {Key::Up};
    case 0x43:
      return {Key::Down};
    case 0x44:
      return {Key::Left};
    case 0x45:
      return {Key::Right};
    case 0x46:
    case 0x224:
      return {Key::Back};
    case 0x95:
      return {Key::Help};
    case 0xe9:
      return {Key::VolumeUp};
    case 0xea:
      return {Key::VolumeDown};
    default:
      return {};
  }
}

/// The usage that an array element selects; 0 for none.
Usage selected(const ReportField& field, std::int64_t value) noexcept {
  if (value < field.logical_min || value > field.logical_max) return 0;
  const auto u = static_cast<std::uint64_t>(field.usage) +
                 static_cast<std::uint64_t>(value - field.logical_min);
  return u <= field.usage_max ? static_cast<Usage>(u) : 0;
}

constexpr Usage error_roll_over = usage(keyboard_page, 0x01);

}  // namespace

KeyName key_of(Usage usage) noexcept {
  if (page_of(usage) == keyboard_page) return keyboard_key(id_of(usage));
  if (page_of(usage) == consumer_page) return consumer_key(id_of(usage));
  return {};
}

std::string to_string(KeyName key) {
  if (key.key == Key::Character) return std::string(1, key.character);
  if (key.key == Key::Function) return fmt::format("F{}", static_cast<int>(key.character));
  for (const auto& [named, name] : named_keys)
    if (named == key.key) return std::string(name);
  return {};
}

KeyName key_from_string(std::string_view name) noexcept {
  for (const auto& [named, text] : named_keys)
    if (text == name) return {named};
  if (name.size() == 1) {
    const char c = name[0];
    if ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) return {Key::Character, c};
    if (c >= 'a' && c <= 'z') return {Key::Character, static_cast<char>(c - 'a' + 'A')};
  }
  if (name.size() > 1 && name[0] == 'F') {
    int number = 0;
    const auto [end, fault] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
    if (fault == std::errc() && end == name.data() + name.size() && number >= 1 && number <= 24)
      return {Key::Function, static_cast<char>(number)};
  }
  return {};
}

std::vector<ReportField> find_keys(const ReportDescriptor& descriptor) {
  std::vector<ReportField> fields;
  for (const ReportField& field : descriptor.inputs) {
    const Usage application = application_of(descriptor, field.collection);
    const bool keys = application == usages::keyboard || application == usages::keypad ||
                      application == usages::consumer_control;
    const std::uint16_t page = page_of(field.usage);
    if (keys && !field.is_relative && (page == keyboard_page || page == consumer_page))
      fields.push_back(field);
  }
  return fields;
}

KeyDecoder::KeyDecoder(const ReportDescriptor& descriptor, std::vector<ReportField> fields)
    : numbered_(descriptor.numbered), fields_(std::move(fields)) {}

std::size_t KeyDecoder::slot_of(KeyName key) noexcept {
  if (key.key == Key::Character) return static_cast<std::size_t>(key.character);
  if (key.key == Key::Function) return 128U + static_cast<std::size_t>(key.character);
  return static_cast<std::size_t>(key.key);
}

KeyName KeyDecoder::key_at(std::size_t slot) noexcept {
  if (slot > 128) return {Key::Function, static_cast<char>(slot - 128)};
  if (slot >= '0') return {Key::Character, static_cast<char>(slot)};
  return {static_cast<Key>(slot)};
}

std::size_t KeyDecoder::take(std::span<const std::byte> report, std::span<KeyEdge> out) noexcept {
  std::uint8_t id = 0;
  std::span<const std::byte> payload = report;
  if (numbered_) {
    if (report.empty()) return 0;
    id = std::to_integer<std::uint8_t>(report[0]);
    payload = report.subspan(1);
  }
  std::bitset<key_slots> now;
  bool spoke = false;
  for (const ReportField& field : fields_) {
    if (field.report_id != id || !holds(field, payload)) continue;
    spoke = true;
    const std::int64_t value = field_value(field, payload);
    const Usage pressed = field.is_array ? selected(field, value) : (value != 0 ? field.usage : 0);
    if (pressed == error_roll_over) return 0;  // too many keys to tell: nothing is known
    const KeyName key = key_of(pressed);
    if (key.key != Key::None) now.set(slot_of(key));
  }
  if (!spoke) return 0;

  const std::bitset<key_slots> before = down_in_any_report();
  down_by_report_[id] = now;
  const std::bitset<key_slots> after = down_in_any_report();
  std::size_t written = 0;
  for (const bool down : {false, true})
    for (std::size_t slot = 0; slot < key_slots; ++slot)
      if (after[slot] != before[slot] && after[slot] == down && written < out.size())
        out[written++] = {key_at(slot), down};
  return written;
}

std::bitset<KeyDecoder::key_slots> KeyDecoder::down_in_any_report() const noexcept {
  std::bitset<key_slots> down;
  for (const std::bitset<key_slots>& of_report : down_by_report_) down |= of_report;
  return down;
}

std::size_t KeyDecoder::release(std::span<KeyEdge> out) noexcept {
  const std::bitset<key_slots> down = down_in_any_report();
  std::size_t written = 0;
  for (std::size_t slot = 0; slot < key_slots; ++slot)
    if (down[slot] && written < out.size()) out[written++] = {key_at(slot), false};
  down_by_report_ = {};
  return written;
}

}  // namespace docent::input

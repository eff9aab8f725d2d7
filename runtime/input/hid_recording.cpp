#include "runtime/input/hid_recording.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace docent::input {
namespace {

std::string_view next_word(std::string_view& text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t start = std::min(text.find_first_not_of(blank), text.size());
  const std::size_t end = std::min(text.find_first_of(blank, start), text.size());
  const std::string_view word = text.substr(start, end - start);
  text.remove_prefix(end);
  return word;
}

std::optional<std::uint32_t> number(std::string_view word, int base) {
  std::uint32_t value = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value, base);
  if (fault != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// "SIZE b0 b1 ...": a decimal count, then so many bytes in hexadecimal.
std::optional<std::vector<std::byte>> counted_bytes(std::string_view text) {
  const auto size = number(next_word(text), 10);
  if (!size || *size > 1U << 16U) return std::nullopt;
  std::vector<std::byte> bytes;
  bytes.reserve(*size);
  for (std::uint32_t i = 0; i < *size; ++i) {
    const auto value = number(next_word(text), 16);
    if (!value || *value > 255) return std::nullopt;
    bytes.push_back(static_cast<std::byte>(*value));
  }
  return bytes;
}

/// "33.190234": seconds; 0 where it is no time.
std::chrono::nanoseconds recorded_time(std::string_view word) {
  double seconds = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), seconds);
  constexpr double longest = 1e9;
  if (fault != std::errc() || !(seconds >= 0 && seconds < longest)) return {};
  return std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

/// "VENDOR PRODUCT" in hexadecimal; zeros where it is not said.
HidDeviceId device_id(std::string_view text) {
  const auto vendor = number(next_word(text), 16);
  const auto product = number(next_word(text), 16);
  if (!vendor || !product || *vendor > 0xffff || *product > 0xffff) return {};
  return {static_cast<std::uint16_t>(*vendor), static_cast<std::uint16_t>(*product)};
}

}  // namespace

Result<HidRecording> parse_hid_recording(std::string_view text, std::string_view file) {
  HidRecording recording;
  int line_number = 0;
  const auto fail = [&](const char* why) {
    return std::unexpected(
        Error{Errc::InvalidInput, fmt::format("{}:{}: {}", file, line_number, why)});
  };
  while (!text.empty()) {
    ++line_number;
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.size() < 2 || line[1] != ':') continue;
    std::string_view rest = line.substr(2);
    if (line[0] == 'N') {
      recording.name = rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
    } else if (line[0] == 'I') {
      next_word(rest);  // the bus
      recording.id = device_id(rest);
    } else if (line[0] == 'R') {
      auto bytes = counted_bytes(rest);
      if (!bytes) return fail("the report descriptor is not a count and so many hexadecimal bytes");
      recording.descriptor = std::move(*bytes);
    } else if (line[0] == 'E') {
      const std::chrono::nanoseconds time = recorded_time(next_word(rest));
      auto bytes = counted_bytes(rest);
      if (!bytes) return fail("the report is not a time, a count and so many hexadecimal bytes");
      recording.reports.push_back(std::move(*bytes));
      recording.times.push_back(time);
    }
  }
  if (recording.descriptor.empty())
    return std::unexpected(Error{
        Errc::InvalidInput,
        fmt::format("{}: no report descriptor: give a recording made with hid-recorder, whose "
                    "first lines begin with R: and N:",
                    file)});
  return recording;
}

}  // namespace docent::input

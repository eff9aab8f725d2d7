#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/result.h"

namespace docent::input {

/// A HID usage: its page in the upper half, its id in the lower (HID 1.11, section 5.5).
using Usage = std::uint32_t;
constexpr Usage usage(std::uint16_t page, std::uint16_t id) noexcept {
  return (static_cast<Usage>(page) << 16U) | id;
}

namespace usages {
inline constexpr Usage pointer = usage(0x01, 0x01), mouse = usage(0x01, 0x02);
inline constexpr Usage keyboard = usage(0x01, 0x06), keypad = usage(0x01, 0x07);
inline constexpr Usage x = usage(0x01, 0x30), y = usage(0x01, 0x31);
inline constexpr Usage button_1 = usage(0x09, 0x01);
inline constexpr Usage consumer_control = usage(0x0c, 0x01);
inline constexpr Usage touch_screen = usage(0x0d, 0x04), touch_pad = usage(0x0d, 0x05);
inline constexpr Usage pen = usage(0x0d, 0x02), finger = usage(0x0d, 0x22);
inline constexpr Usage tip_switch = usage(0x0d, 0x42), in_range = usage(0x0d, 0x32);
inline constexpr Usage tip_pressure = usage(0x0d, 0x30);
inline constexpr Usage confidence = usage(0x0d, 0x47), contact_identifier = usage(0x0d, 0x51);
inline constexpr Usage contact_count = usage(0x0d, 0x54);
inline constexpr Usage contact_count_maximum = usage(0x0d, 0x55), scan_time = usage(0x0d, 0x56);
}  // namespace usages

/// A group of fields: an application (a whole device), or a logical or physical part such as a
/// finger.
struct Collection {
  Usage usage = 0;
  std::uint8_t kind = 0;     ///< 0 physical, 1 application, 2 logical (HID 1.11, section 6.2.2.6).
  std::int32_t parent = -1;  ///< Index of the enclosing collection; -1 at the top.
};

/// One value of an input or feature report. An element of an array field holds an index into its
/// usage range.
struct ReportField {
  std::uint8_t report_id = 0;    ///< 0 where the device's reports are not numbered.
  std::uint32_t bit_offset = 0;  ///< From the first bit after the report id.
  std::uint8_t bit_size = 0;     ///< 1 to 32.
  std::int32_t logical_min = 0, logical_max = 0;
  Usage usage = 0;      ///< Variable fields. Array elements: the usage that logical_min stands for.
  Usage usage_max = 0;  ///< Array elements: the last usage of the range.
  bool is_array = false, is_relative = false;
  std::int32_t collection = -1;
};

/// What a device's reports mean.
struct ReportDescriptor {
  bool numbered = false;  ///< The first byte of every report is its id.
  std::vector<Collection> collections;
  std::vector<ReportField> inputs;  ///< In the order of the descriptor, without padding.
  std::vector<ReportField> features;
};

/// Reads a report descriptor (HID 1.11, section 6.2.2). Fails with a sentence on one that is cut
/// short, nests too deep, or declares more than a report can hold; never reads outside `bytes`.
Result<ReportDescriptor> parse_report_descriptor(std::span<const std::byte> bytes);

/// The application that encloses a collection; 0 when there is none.
Usage application_of(const ReportDescriptor& descriptor, std::int32_t collection) noexcept;

/// The value of a field in a report whose id byte has been taken off, sign-extended where
/// logical_min is negative; 0 where the report is too short to hold it.
std::int64_t field_value(const ReportField& field, std::span<const std::byte> payload) noexcept;

/// Does the payload hold the whole field?
constexpr bool holds(const ReportField& field, std::span<const std::byte> payload) noexcept {
  return static_cast<std::uint64_t>(field.bit_offset) + field.bit_size <= payload.size() * 8;
}

/// A report split into its id and the rest. `id` is 0 where reports are not numbered.
struct ReportBytes {
  std::uint8_t id = 0;
  std::span<const std::byte> payload;
};
ReportBytes split_report(const ReportDescriptor& descriptor,
                         std::span<const std::byte> report) noexcept;

}  // namespace docent::input

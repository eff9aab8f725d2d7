#include "runtime/input/report_descriptor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace docent::input {
namespace {

// A HID descriptor is at most 4096 bytes in Linux, and a report at most 16 KiB; more is a fault.
constexpr std::uint16_t first_vendor_page = 0xff00;  // a maker's own fields mean nothing here
constexpr std::size_t max_depth = 32;
constexpr std::size_t max_fields = 8192;
constexpr std::uint64_t max_report_bits = 16384ULL * 8;

/// Global items: they hold until changed, and can be pushed and popped (section 6.2.2.7).
struct Globals {
  std::uint16_t usage_page = 0;
  std::int32_t logical_min = 0, logical_max = 0;
  std::uint32_t logical_max_raw = 0;
  std::uint32_t report_size = 0, report_count = 0;
  std::uint8_t report_id = 0;
};

/// Local items: they hold until the next main item (section 6.2.2.8).
struct Locals {
  std::vector<Usage> usages;
  Usage minimum = 0, maximum = 0;
  bool has_minimum = false, has_maximum = false;
};

struct Item {
  std::uint8_t type = 0, tag = 0, size = 0;
  std::uint32_t value = 0;  ///< Unsigned.
  std::int32_t signed_value = 0;
};

class Parser {
 public:
  explicit Parser(std::span<const std::byte> bytes) : bytes_(bytes) {}

  Result<ReportDescriptor> parse() {
    while (at_ < bytes_.size()) {
      const std::size_t start = at_;
      Item item;
      if (!next(item)) return fail(start, "it is cut short");
      const char* fault = apply(item);
      if (fault != nullptr) return fail(start, fault);
    }
    if (!open_.empty()) return fail(at_, "a collection is not closed");
    return std::move(out_);
  }

 private:
  static std::unexpected<Error> fail(std::size_t at, const char* why) {
    return std::unexpected(Error{
        Errc::InvalidInput, fmt::format("report descriptor: byte {}: {}; use another device or "
                                        "cable, or ask its maker for new firmware",
                                        at, why)});
  }

  bool next(Item& item) {
    constexpr std::uint8_t long_item = 0xfe;
    const auto prefix = std::to_integer<std::uint8_t>(bytes_[at_]);
    if (prefix == long_item) {  // section 6.2.2.3: none are defined, so skip it
      if (at_ + 1 >= bytes_.size()) return false;
      const std::size_t whole = 3 + std::to_integer<std::size_t>(bytes_[at_ + 1]);
      if (at_ + whole > bytes_.size()) return false;
      at_ += whole;
      item.type = 3;
      return true;
    }
    constexpr std::array<std::uint8_t, 4> sizes{0, 1, 2, 4};
    item.size = sizes[prefix & 3U];
    item.type = static_cast<std::uint8_t>((prefix >> 2U) & 3U);
    item.tag = static_cast<std::uint8_t>(prefix >> 4U);
    if (at_ + 1U + item.size > bytes_.size()) return false;
    for (std::uint32_t i = 0; i < item.size; ++i)
      item.value |= std::to_integer<std::uint32_t>(bytes_[at_ + 1 + i]) << (8U * i);
    item.signed_value = item.size == 1   ? static_cast<std::int8_t>(item.value)
                        : item.size == 2 ? static_cast<std::int16_t>(item.value)
                                         : static_cast<std::int32_t>(item.value);
    at_ += 1U + item.size;
    return true;
  }

  const char* apply(const Item& item) {
    switch (item.type) {
      case 0: {
        const char* fault = apply_main(item);
        locals_ = {};
        return fault;
      }
      case 1:
        return apply_global(item);
      case 2:
        apply_local(item);
        return nullptr;
      default:
        return nullptr;  // reserved
    }
  }

  const char* apply_main(const Item& item) {
    enum : std::uint8_t { Input = 8, Output = 9, Open = 10, Feature = 11, Close = 12 };
    switch (item.tag) {
      case Input:
        return add_fields(item.value, out_.inputs, input_bits_);
      case Feature:
        return add_fields(item.value, out_.features, feature_bits_);
      case Open:
        if (open_.size() >= max_depth) return "collections nest too deep";
        if (out_.collections.size() >= max_fields) return "there are too many collections";
        out_.collections.push_back({locals_.usages.empty() ? 0 : locals_.usages.front(),
                                    static_cast<std::uint8_t>(item.value),
                                    open_.empty() ? -1 : open_.back()});
        open_.push_back(static_cast<std::int32_t>(out_.collections.size() - 1));
        return nullptr;
      case Close:
        if (open_.empty()) return "a collection is closed that was not opened";
        open_.pop_back();
        return nullptr;
      default:
        return nullptr;  // outputs do not matter here
    }
  }

  const char* apply_global(const Item& item) {
    switch (item.tag) {
      case 0:
        globals_.usage_page = static_cast<std::uint16_t>(item.value);
        break;
      case 1:
        globals_.logical_min = item.signed_value;
        break;
      case 2:
        globals_.logical_max = item.signed_value;
        globals_.logical_max_raw = item.value;
        break;
      case 7:
        globals_.report_size = item.value;
        break;
      case 8:
        globals_.report_id = static_cast<std::uint8_t>(item.value);
        if (item.value == 0 || item.value > 255) return "a report id is not in 1 to 255";
        out_.numbered = true;
        break;
      case 9:
        globals_.report_count = item.value;
        break;
      case 10:
        if (stack_.size() >= max_depth) return "too many items are pushed";
        stack_.push_back(globals_);
        break;
      case 11:
        if (stack_.empty()) return "an item is popped that was not pushed";
        globals_ = stack_.back();
        stack_.pop_back();
        break;
      default:
        break;  // physical range and units are not needed: screens report logical shares
    }
    return nullptr;
  }

  void apply_local(const Item& item) {
    // A four-byte usage carries its own page.
    const Usage full = item.size == 4
                           ? item.value
                           : usage(globals_.usage_page, static_cast<std::uint16_t>(item.value));
    switch (item.tag) {
      case 0:
        if (locals_.usages.size() < max_fields) locals_.usages.push_back(full);
        break;
      case 1:
        locals_.minimum = full;
        locals_.has_minimum = true;
        break;
      case 2:
        locals_.maximum = full;
        locals_.has_maximum = true;
        break;
      default:
        break;
    }
    if (locals_.has_minimum && locals_.has_maximum) expand_usage_range();
  }

  /// Usage Minimum and Maximum stand for all usages between them, in order.
  void expand_usage_range() {
    for (Usage u = locals_.minimum; u <= locals_.maximum && locals_.usages.size() < max_fields; ++u)
      locals_.usages.push_back(u);
    locals_.has_minimum = locals_.has_maximum = false;
  }

  const char* add_fields(std::uint32_t flags, std::vector<ReportField>& into,
                         std::array<std::uint64_t, 256>& bits) {
    const bool constant = (flags & 1U) != 0;
    const bool variable = (flags & 2U) != 0;
    std::uint64_t& offset = bits[globals_.report_id];
    const std::uint64_t whole =
        static_cast<std::uint64_t>(globals_.report_size) * globals_.report_count;
    if (whole > max_report_bits || offset + whole > max_report_bits)
      return "a report is larger than 16 KiB";
    const bool readable = globals_.report_size >= 1 && globals_.report_size <= 32 &&
                          !locals_.usages.empty() && globals_.usage_page < first_vendor_page;
    if (!constant && readable) {
      if (into.size() + globals_.report_count > max_fields) return "there are too many fields";
      for (std::uint32_t i = 0; i < globals_.report_count; ++i)
        into.push_back(make_field(flags, variable, i,
                                  static_cast<std::uint32_t>(offset + i * globals_.report_size)));
    }
    offset += whole;
    return nullptr;
  }

  ReportField make_field(std::uint32_t flags, bool variable, std::uint32_t i,
                         std::uint32_t bit_offset) const {
    ReportField field;
    field.report_id = globals_.report_id;
    field.bit_offset = bit_offset;
    field.bit_size = static_cast<std::uint8_t>(globals_.report_size);
    field.logical_min = globals_.logical_min;
    field.logical_max = globals_.logical_max;
    // Many devices write 255 as the byte ff, which is -1 where it should be signed.
    if (field.logical_max < field.logical_min)
      field.logical_max =
          static_cast<std::int32_t>(std::min<std::uint32_t>(globals_.logical_max_raw, 0x7fffffffU));
    field.is_array = !variable;
    field.is_relative = (flags & 4U) != 0;
    field.collection = open_.empty() ? -1 : open_.back();
    // The last usage serves all further fields (section 6.2.2.8).
    field.usage = variable ? locals_.usages[std::min<std::size_t>(i, locals_.usages.size() - 1)]
                           : locals_.usages.front();
    field.usage_max = variable ? field.usage : locals_.usages.back();
    return field;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  Globals globals_;
  Locals locals_;
  std::vector<Globals> stack_;
  std::vector<std::int32_t> open_;
  std::array<std::uint64_t, 256> input_bits_{};
  std::array<std::uint64_t, 256> feature_bits_{};
  ReportDescriptor out_;
};

}  // namespace

Result<ReportDescriptor> parse_report_descriptor(std::span<const std::byte> bytes) {
  return Parser(bytes).parse();
}

Usage application_of(const ReportDescriptor& descriptor, std::int32_t collection) noexcept {
  constexpr std::uint8_t application = 1;
  for (; collection >= 0;
       collection = descriptor.collections[static_cast<std::size_t>(collection)].parent) {
    const Collection& c = descriptor.collections[static_cast<std::size_t>(collection)];
    if (c.kind == application) return c.usage;
  }
  return 0;
}

std::int64_t field_value(const ReportField& field, std::span<const std::byte> payload) noexcept {
  if (!holds(field, payload)) return 0;
  std::uint64_t value = 0;
  const std::size_t first = field.bit_offset / 8;
  const std::size_t last = (field.bit_offset + field.bit_size - 1U) / 8;
  for (std::size_t i = first; i <= last; ++i)
    value |= std::to_integer<std::uint64_t>(payload[i]) << (8 * (i - first));
  value >>= field.bit_offset % 8;
  const std::uint64_t mask = (1ULL << field.bit_size) - 1;
  value &= mask;
  const bool negative = field.logical_min < 0 && ((value >> (field.bit_size - 1U)) & 1U) != 0;
  return static_cast<std::int64_t>(negative ? value | ~mask : value);
}

ReportBytes split_report(const ReportDescriptor& descriptor,
                         std::span<const std::byte> report) noexcept {
  if (!descriptor.numbered) return {0, report};
  if (report.empty()) return {};
  return {std::to_integer<std::uint8_t>(report[0]), report.subspan(1)};
}

}  // namespace docent::input

#include "platform/hid/hid_report.h"

#include <fmt/format.h>

#include <iterator>

namespace docent::hid {
std::string kind_of(const HidDevice& device) {
  if (!device.unreadable.empty() || !device.kind.ignored.empty() || !device.refused.empty())
    return "ignored";
  return device.kind.touch ? "touch screen" : "keypad";
}

std::string reason_of(const HidDevice& device) {
  if (!device.unreadable.empty()) return device.unreadable;
  if (!device.refused.empty()) return device.refused;
  return device.closed.empty() || !is_for_visitors(device) ? device.kind.ignored : device.closed;
}

namespace {

std::string field_name(input::Usage usage) {
  switch (usage) {
    case input::usages::x:
      return "X";
    case input::usages::y:
      return "Y";
    case input::usages::tip_switch:
      return "Tip Switch";
    case input::usages::in_range:
      return "In Range";
    case input::usages::confidence:
      return "Confidence";
    case input::usages::contact_identifier:
      return "Contact Identifier";
    case input::usages::contact_count:
      return "Contact Count";
    case input::usages::scan_time:
      return "Scan Time";
    default:
      return fmt::format("{:04x}:{:04x}", usage >> 16U, usage & 0xffffU);
  }
}

/// JSON's rules for strings; names are plain ASCII here.
std::string json_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out.push_back('\\');
    out.push_back(c);
  }
  return out + '"';
}

}  // namespace

std::string describe_devices(std::span<const HidDevice> devices) {
  if (devices.empty())
    return "no hidraw devices: is a touch screen plugged in, and is /dev/hidraw* there?\n";
  std::string out;
  for (const HidDevice& d : devices) {
    const std::string reason = reason_of(d);
    fmt::format_to(std::back_inserter(out), "{}  {:04x}:{:04x}  {}: {}{}{}\n", d.path, d.vendor,
                   d.product, d.name, kind_of(d), reason.empty() ? "" : ", ", reason);
    if (!d.kind.keys.empty())
      fmt::format_to(std::back_inserter(out),
                     "    in kiosk.toml: [[keypad]] device = \"{:04x}:{:04x}\", descriptor = "
                     "\"{:016x}\"\n",
                     d.vendor, d.product, d.descriptor_hash);
    for (const input::ReportField& f : d.descriptor.inputs)
      if (!f.is_array)
        fmt::format_to(std::back_inserter(out), "    report {} bit {} size {}: {} {}..{}\n",
                       f.report_id, f.bit_offset, f.bit_size, field_name(f.usage), f.logical_min,
                       f.logical_max);
  }
  return out;
}

std::string describe_devices_json(std::span<const HidDevice> devices) {
  std::string out = "[";
  for (const HidDevice& d : devices) {
    fmt::format_to(std::back_inserter(out),
                   "{}\n  {{\"path\": {}, \"name\": {}, \"vendor\": {}, \"product\": {}, "
                   "\"kind\": {}, \"reason\": {}, \"descriptor\": \"{:016x}\", \"fields\": [",
                   out.size() > 1 ? "," : "", json_text(d.path), json_text(d.name), d.vendor,
                   d.product, json_text(kind_of(d)), json_text(reason_of(d)), d.descriptor_hash);
    bool first = true;
    for (const input::ReportField& f : d.descriptor.inputs) {
      fmt::format_to(std::back_inserter(out),
                     "{}{{\"report\": {}, \"bit\": {}, \"size\": {}, \"usage\": {}, "
                     "\"logical_min\": {}, \"logical_max\": {}}}",
                     first ? "" : ", ", f.report_id, f.bit_offset, f.bit_size,
                     json_text(field_name(f.usage)), f.logical_min, f.logical_max);
      first = false;
    }
    out += "]}";
  }
  return out + "\n]\n";
}

}  // namespace docent::hid

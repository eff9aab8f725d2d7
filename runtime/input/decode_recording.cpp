#include "runtime/input/decode_recording.h"

#include <fmt/format.h>

#include <iterator>

#include "runtime/input/hid_device_kind.h"

namespace docent::input {
namespace {

void append_contacts(std::string& csv, std::size_t report, std::span<const Contact> contacts,
                     bool& any_down) {
  if (contacts.empty() && any_down)
    fmt::format_to(std::back_inserter(csv), "{},none,,,,\n", report);
  for (const Contact& c : contacts)
    fmt::format_to(std::back_inserter(csv), "{},touch,{},{:.6f},{:.6f},down\n", report, c.id, c.x,
                   c.y);
  any_down = !contacts.empty();
}

std::string decode_touches(const ReportDescriptor& descriptor, const TouchLayout& layout,
                           const HidRecording& recording, std::string csv) {
  ContactDecoder decoder(descriptor, layout);
  bool any_down = false;
  for (std::size_t i = 0; i < recording.reports.size(); ++i)
    if (decoder.take(recording.reports[i])) append_contacts(csv, i, decoder.contacts(), any_down);
  return csv;
}

std::string decode_keys(const ReportDescriptor& descriptor, const std::vector<ReportField>& keys,
                        const HidRecording& recording, std::string csv) {
  KeyDecoder decoder(descriptor, keys);
  std::array<KeyEdge, 64> edges;
  for (std::size_t i = 0; i < recording.reports.size(); ++i) {
    const std::size_t count = decoder.take(recording.reports[i], edges);
    for (const KeyEdge& edge : std::span(edges).first(count))
      fmt::format_to(std::back_inserter(csv), "{},key,{},,,{}\n", i, to_string(edge.key),
                     edge.down ? "down" : "up");
  }
  return csv;
}

}  // namespace

Result<std::string> decode_recording(const HidRecording& recording) {
  const auto descriptor = parse_report_descriptor(recording.descriptor);
  if (!descriptor) return std::unexpected(descriptor.error());
  const HidDeviceKind kind = classify(*descriptor, recording.id);
  const std::string header = "report,kind,id,x,y,state\n";
  if (kind.touch) return decode_touches(*descriptor, *kind.touch, recording, header);
  if (!kind.keys.empty()) return decode_keys(*descriptor, kind.keys, recording, header);
  return std::unexpected(Error{
      Errc::InvalidInput,
      fmt::format("{}: neither a touch screen nor a keypad: {}", recording.name, kind.ignored)});
}

}  // namespace docent::input

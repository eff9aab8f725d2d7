#include "runtime/kiosk/control_list.h"

#include <fmt/format.h>

namespace docent::kiosk {
namespace {

/// A JSON string (RFC 8259, section 7) of UTF-8.
std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out.append({'\\', c});
    else if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

std::string object_of(const interface::OnGlass& item) {
  const scene::Rect& r = item.rect;
  return fmt::format(
      R"({{"name": {}, "role": "{}", "label": {}, "state": "{}", "rect": [{:.5f}, {:.5f}, {:.5f}, {:.5f}], )"
      R"("text_mm": {:.2f}, "spoken": {}, "focus": {}}})",
      json_string(item.name), item.role, json_string(item.label), item.state, r.x, r.y, r.width,
      r.height, item.text_mm, json_string(item.spoken), item.has_focus);
}

}  // namespace

std::string to_json(std::span<const interface::OnGlass> items) {
  std::string out = "[";
  for (const interface::OnGlass& item : items)
    out += (out.size() > 1 ? ",\n " : "\n ") + object_of(item);
  return out + "\n]\n";
}

}  // namespace docent::kiosk

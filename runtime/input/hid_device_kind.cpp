#include "runtime/input/hid_device_kind.h"

#include <algorithm>

namespace docent::input {
namespace {

std::string describe_other(const ReportDescriptor& descriptor) {
  if (descriptor.inputs.empty()) return "it sends no input reports";
  const auto is_application = [&](Usage wanted) {
    return std::any_of(
        descriptor.inputs.begin(), descriptor.inputs.end(),
        [&](const ReportField& f) { return application_of(descriptor, f.collection) == wanted; });
  };
  if (is_application(usages::pen)) return "a pen";
  if (is_application(usages::mouse) || is_application(usages::pointer))
    return "a mouse: it has no place on the screen";
  return "it has neither contacts nor keys";
}

/// A Windows 8 screen's specification leaves nothing open, one contact a report leaves no place
/// unused, and a mouse has neither identifiers nor count.
bool may_have_quirks(const TouchLayout& layout) noexcept {
  return !layout.scan_time && layout.slots.size() > 1 && !layout.single_touch;
}

}  // namespace

HidDeviceKind classify(const ReportDescriptor& descriptor, HidDeviceId id) {
  HidDeviceKind kind;
  kind.touch = find_touch_screen(descriptor);
  const TouchQuirk* const quirk = quirk_of(id.vendor, id.product);
  if (kind.touch && quirk != nullptr && may_have_quirks(*kind.touch))
    kind.touch->rules = quirk->rules;
  if (kind.touch && kind.touch->surface == TouchLayout::Surface::Pad)
    kind.ignored = "a touch pad: it has no place on the screen";
  if (kind.touch) return kind;
  kind.keys = find_keys(descriptor);
  if (kind.keys.empty()) kind.ignored = describe_other(descriptor);
  return kind;
}

}  // namespace docent::input

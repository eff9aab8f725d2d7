#include "runtime/input/contact_decoder.h"

#include <algorithm>
#include <utility>

namespace docent::input {
namespace {

bool in_application(const ReportDescriptor& descriptor, const ReportField& field,
                    Usage application) {
  return application_of(descriptor, field.collection) == application;
}

/// Begins a new slot where a finger's collection begins, or where a value comes round again.
class SlotCollector {
 public:
  void add(const ReportField& field) {
    if (field.collection != collection_ && (field.usage == usages::tip_switch || complete()))
      start();
    collection_ = field.collection;
    switch (field.usage) {
      case usages::x:
        if (has_x_ && has_y_) break;  // a second X and Y give the contact's centre or its edge
        if (!has_x_) current_.x = field;
        has_x_ = true;
        break;
      case usages::y:
        if (!has_y_) current_.y = field;
        has_y_ = true;
        break;
      case usages::tip_switch:
        if (current_.tip) start();
        current_.tip = field;
        break;
      case usages::in_range:
        current_.in_range = field;
        break;
      case usages::tip_pressure:
        if (!current_.pressure) current_.pressure = field;
        break;
      case usages::confidence:
        current_.confidence = field;
        break;
      case usages::contact_identifier:
        if (current_.identifier && complete()) start();
        current_.identifier = field;
        break;
      default:
        break;
    }
  }

  std::vector<ContactFields> finish() {
    start();
    return std::move(slots_);
  }

 private:
  bool complete() const { return has_x_ && has_y_; }
  void start() {
    if (complete() && slots_.size() < max_contacts) slots_.push_back(current_);
    current_ = {};
    has_x_ = has_y_ = false;
  }

  std::vector<ContactFields> slots_;
  ContactFields current_;
  bool has_x_ = false, has_y_ = false;
  std::int32_t collection_ = -1;
};

/// The reports of the application that hold contacts, in the order of the descriptor.
std::vector<std::uint8_t> contact_reports(const ReportDescriptor& descriptor, Usage application) {
  std::vector<std::uint8_t> ids;
  for (const ReportField& field : descriptor.inputs)
    if (in_application(descriptor, field, application) && field.usage == usages::x &&
        std::ranges::find(ids, field.report_id) == ids.end())
      ids.push_back(field.report_id);
  return ids;
}

std::optional<TouchLayout> layout_of_report(const ReportDescriptor& descriptor, Usage application,
                                            std::uint8_t report_id) {
  TouchLayout layout;
  layout.report_id = report_id;
  SlotCollector slots;
  for (const ReportField& field : descriptor.inputs) {
    if (field.report_id != report_id || field.is_array || field.is_relative ||
        !in_application(descriptor, field, application))
      continue;
    if (field.usage == usages::contact_count) layout.count = field;
    if (field.usage == usages::scan_time) layout.scan_time = field;
    slots.add(field);
  }
  layout.slots = slots.finish();
  if (layout.slots.empty()) return std::nullopt;
  layout.rules = usual_rules(layout);
  return layout;
}

std::optional<TouchLayout> find_multi_touch(const ReportDescriptor& descriptor, Usage application) {
  std::optional<TouchLayout> found;
  for (const std::uint8_t id : contact_reports(descriptor, application)) {
    std::optional<TouchLayout> layout = layout_of_report(descriptor, application, id);
    if (!layout) continue;
    if (found)
      found->others.push_back(std::move(*layout));
    else
      found = std::move(layout);
  }
  return found;
}

std::optional<TouchLayout> find_absolute_pointer(const ReportDescriptor& descriptor) {
  TouchLayout layout;
  ContactFields slot;
  bool has_x = false;
  bool has_y = false;
  for (const ReportField& field : descriptor.inputs) {
    const bool pointer = in_application(descriptor, field, usages::mouse) ||
                         in_application(descriptor, field, usages::pointer);
    if (!pointer || field.is_array || field.is_relative) continue;
    if (field.usage == usages::x && !has_x) {
      slot.x = field;
      has_x = true;
    }
    if (field.usage == usages::y && !has_y) {
      slot.y = field;
      has_y = true;
    }
    if (field.usage == usages::button_1 && !slot.tip) slot.tip = field;
  }
  if (!has_x || !has_y || !slot.tip || slot.x.report_id != slot.tip->report_id) return std::nullopt;
  layout.report_id = slot.x.report_id;
  layout.single_touch = true;
  layout.slots = {slot};
  layout.rules = usual_rules(layout);
  return layout;
}

/// The value as a share of its logical range.
float share(const ReportField& field, std::span<const std::byte> payload) noexcept {
  const double range = static_cast<double>(field.logical_max) - field.logical_min;
  if (range <= 0) return 0;
  const double value = static_cast<double>(field_value(field, payload) - field.logical_min);
  return static_cast<float>(std::clamp(value / range, 0.0, 1.0));
}

bool is_set(const std::optional<ReportField>& field, std::span<const std::byte> payload,
            bool otherwise) noexcept {
  return field ? field_value(*field, payload) != 0 : otherwise;
}

/// Are all values of a slot zero?
bool is_blank(const ContactFields& slot, std::span<const std::byte> payload) noexcept {
  const auto is_zero = [&](const std::optional<ReportField>& field) {
    return !is_set(field, payload, false);
  };
  return is_zero(slot.x) && is_zero(slot.y) && is_zero(slot.identifier) && is_zero(slot.in_range) &&
         is_zero(slot.confidence) && is_zero(slot.tip);
}

/// Is the finger on the glass? Where there is no tip switch, In Range says it, or else how hard it
/// presses.
bool is_down(const ContactFields& slot, std::span<const std::byte> payload) noexcept {
  return is_set(slot.tip, payload,
                is_set(slot.in_range, payload, is_set(slot.pressure, payload, true)));
}

bool speaks(TouchRules::Valid valid, const ContactFields& slot,
            std::span<const std::byte> payload) noexcept {
  switch (valid) {
    case TouchRules::Valid::WithTip:
      return is_down(slot, payload);
    case TouchRules::Valid::InRange:
      return is_set(slot.in_range, payload, true);
    case TouchRules::Valid::WithConfidence:
      return is_set(slot.confidence, payload, true);
    case TouchRules::Valid::Always:
      break;
  }
  return true;
}

}  // namespace

TouchRules usual_rules(const TouchLayout& layout) noexcept {
  TouchRules rules;
  if (layout.scan_time) {
    rules.missing = TouchRules::Missing::HasGone;
    rules.first_of_twins = true;
  } else if (layout.slots.size() == 1) {
    rules.missing = TouchRules::Missing::Rests;
    rules.count = TouchRules::Count::EndsTheFrame;
    rules.applies_at_once = true;
  }
  return rules;
}

std::optional<TouchLayout> find_touch_screen(const ReportDescriptor& descriptor) {
  if (auto layout = find_multi_touch(descriptor, usages::touch_screen)) return layout;
  if (auto layout = find_multi_touch(descriptor, usages::touch_pad)) {
    layout->surface = TouchLayout::Surface::Pad;
    return layout;
  }
  return find_absolute_pointer(descriptor);
}

ContactDecoder::ContactDecoder(const ReportDescriptor& descriptor, TouchLayout layout)
    : numbered_(descriptor.numbered), layout_(std::move(layout)) {
  for (const TouchLayout& other : layout_.others) others_.emplace_back(descriptor, other);
}

void ContactDecoder::reset() noexcept {
  frame_count_ = received_ = expected_ = down_count_ = contact_count_ = palm_count_ = 0;
  last_scan_time_ = -1;
  for (ContactDecoder& other : others_) other.reset();
}

bool ContactDecoder::read_slot(std::size_t index, std::span<const std::byte> payload,
                               Reading& reading) const noexcept {
  const ContactFields& slot = layout_.slots[index];
  if (!holds(slot.x, payload) || !holds(slot.y, payload)) return false;
  const bool by_position =
      !slot.identifier || layout_.rules.identity == TouchRules::Identity::Position;
  reading.contact.id = by_position
                           ? static_cast<std::uint32_t>(received_ + index)
                           : static_cast<std::uint32_t>(field_value(*slot.identifier, payload));
  reading.contact.x = share(slot.x, payload);
  reading.contact.y = share(slot.y, payload);
  const bool is_sure = is_set(slot.confidence, payload, true);
  reading.down = is_down(slot, payload);
  // "Confidence" of a Windows 8 screen: 0 is a palm. Others use it for places that are not in use.
  reading.palm = layout_.scan_time && reading.down && !is_sure && is_ever_sure_;
  reading.down &= !reading.palm;
  reading.blank = is_blank(slot, payload);
  reading.speaks = speaks(layout_.rules.valid, slot, payload) &&
                   !(layout_.rules.identity == TouchRules::Identity::IdentifierFromOne &&
                     slot.identifier && reading.contact.id == 0);
  return true;
}

void ContactDecoder::note_confidence(std::span<const std::byte> payload) noexcept {
  for (const ContactFields& slot : layout_.slots)
    is_ever_sure_ |= is_down(slot, payload) && is_set(slot.confidence, payload, false);
}

bool ContactDecoder::repeats_scan_time(std::span<const std::byte> payload) const noexcept {
  return layout_.scan_time && field_value(*layout_.scan_time, payload) == last_scan_time_;
}

/// Some devices repeat the count in every report of a frame: one that comes while a frame is open,
/// promises as many contacts, and brings none that the frame already has, belongs to it.
bool ContactDecoder::continues_frame(std::size_t count,
                                     std::span<const std::byte> payload) const noexcept {
  if (!is_open() || count != expected_) return false;
  if (layout_.scan_time) return repeats_scan_time(payload);
  const std::size_t looked_at = std::min(expected_ - received_, layout_.slots.size());
  for (std::size_t i = 0; i < looked_at; ++i) {
    Reading next;
    if (read_slot(i, payload, next) && in_frame(next.contact.id)) return false;
  }
  return true;
}

bool ContactDecoder::take(std::span<const std::byte> report) noexcept {
  std::span<const std::byte> payload = report;
  palm_count_ = 0;
  if (numbered_) {
    if (report.empty()) return false;
    if (std::to_integer<std::uint8_t>(report[0]) != layout_.report_id) {
      const bool taken =
          std::ranges::any_of(others_, [&](ContactDecoder& other) { return other.take(report); });
      if (taken) gather();
      return taken;
    }
    payload = report.subspan(1);
  }
  if (!holds(layout_.slots.front().x, payload) || !holds(layout_.slots.front().y, payload))
    return false;
  note_confidence(payload);
  const bool ended = take_own(payload);
  if (layout_.scan_time) last_scan_time_ = field_value(*layout_.scan_time, payload);
  if (ended) gather();
  return ended;
}

bool ContactDecoder::take_own(std::span<const std::byte> payload) noexcept {
  const std::size_t room = layout_.slots.size();
  if (!layout_.count || layout_.rules.applies_at_once) {
    received_ = 0;
    expected_ = room;
  } else {
    const auto count = static_cast<std::size_t>(
        std::clamp<std::int64_t>(field_value(*layout_.count, payload), 0, max_contacts));
    if (count == 0 && !is_open() && layout_.rules.count == TouchRules::Count::IsExact)
      return take_zero_count(payload);
    if (count > 0 && !continues_frame(count, payload)) begin_frame(count);
  }

  const bool counted = layout_.count && layout_.rules.count == TouchRules::Count::IsExact;
  const std::size_t meant = counted ? std::min(expected_ - received_, room) : room;
  for (std::size_t i = 0; i < meant; ++i)
    if (Reading reading; read_slot(i, payload, reading)) add(reading);
  received_ += meant;
  if (is_open()) return false;
  if (counted) read_uncounted_lifts(meant, payload);
  end_frame();
  return true;
}

/// A frame begins, and its promise holds. Whatever the last one still owed will not come, but what
/// did come is true.
void ContactDecoder::begin_frame(std::size_t count) noexcept {
  for (const Reading& reading : std::span(frame_).first(frame_count_)) merge(reading);
  frame_count_ = received_ = 0;
  expected_ = count;
}

/// No frame is open, and a report counts none. Either nothing is down, or the report is the empty
/// rest of a frame (one scan time), or the device does not keep its count.
bool ContactDecoder::take_zero_count(std::span<const std::byte> payload) noexcept {
  if (repeats_scan_time(payload)) return false;
  bool blank = true;
  bool down = false;
  for (std::size_t i = 0; i < layout_.slots.size(); ++i) {
    Reading reading;
    if (!read_slot(i, payload, reading)) continue;
    blank &= reading.blank;
    down |= reading.down;
    if (!reading.blank) add(reading);
  }
  if (blank) down_count_ = 0;
  if (!down && layout_.scan_time) down_count_ = 0;
  end_frame();
  return true;
}

void ContactDecoder::add(const Reading& reading) noexcept {
  if (!reading.speaks || frame_count_ >= max_contacts) return;
  if (layout_.rules.first_of_twins) {
    const auto end = frame_.begin() + static_cast<std::ptrdiff_t>(frame_count_);
    const auto twin = std::find_if(frame_.begin(), end, [&](const Reading& r) {
      return r.down && r.contact.id == reading.contact.id;
    });
    if (twin != end) return;
  }
  frame_[frame_count_++] = reading;
}

/// Some devices count only the contacts that are down, and put one that has just gone behind them,
/// tip up. What is nothing but zeros there is no contact.
void ContactDecoder::read_uncounted_lifts(std::size_t first,
                                          std::span<const std::byte> payload) noexcept {
  for (std::size_t i = first; i < layout_.slots.size(); ++i) {
    Reading reading;
    if (!read_slot(i, payload, reading) || reading.down || reading.blank) continue;
    if (!in_frame(reading.contact.id)) add(reading);
  }
}

bool ContactDecoder::in_frame(std::uint32_t id) const noexcept {
  const std::span<const Reading> seen(frame_.data(), frame_count_);
  return std::any_of(seen.begin(), seen.end(),
                     [&](const Reading& r) { return r.contact.id == id; });
}

void ContactDecoder::merge(const Reading& reading) noexcept {
  const auto end = down_.begin() + static_cast<std::ptrdiff_t>(down_count_);
  const auto known = std::find_if(
      down_.begin(), end, [&](const Held& h) { return h.contact.id == reading.contact.id; });
  if (known != end && reading.down) {
    *known = {reading.contact, 0};
  } else if (known != end) {
    if (reading.palm && palm_count_ < max_contacts) palms_[palm_count_++] = reading.contact.id;
    std::move(known + 1, end, known);
    --down_count_;
  } else if (reading.down && down_count_ < max_contacts) {
    down_[down_count_++] = {reading.contact, 0};
  }
}

/// A contact says goodbye with its tip up. One that a frame does not mention has gone where the
/// device tells all of them in every frame; others leave one out now and then, so it is missed for
/// a few frames before it is given up. A serial device may stay silent about a finger that rests.
void ContactDecoder::forget_missing() noexcept {
  if (layout_.rules.missing == TouchRules::Missing::Rests) return;
  const std::uint32_t patience = layout_.rules.missing == TouchRules::Missing::HasGone ? 0 : 10;
  for (Held& held : std::span(down_).first(down_count_))
    held.missed = in_frame(held.contact.id) ? 0 : held.missed + 1;
  const auto end = down_.begin() + static_cast<std::ptrdiff_t>(down_count_);
  const auto kept =
      std::remove_if(down_.begin(), end, [&](const Held& held) { return held.missed > patience; });
  down_count_ = static_cast<std::size_t>(kept - down_.begin());
}

void ContactDecoder::end_frame() noexcept {
  forget_missing();
  for (const Reading& reading : std::span(frame_).first(frame_count_)) merge(reading);
  frame_count_ = received_ = expected_ = 0;
}

/// The contacts of further reports have identifiers of their own, behind those of a byte or a word.
void ContactDecoder::gather() noexcept {
  constexpr std::uint32_t ids_per_report = 4096;
  contact_count_ = 0;
  for (const Held& held : std::span(down_).first(down_count_))
    contacts_[contact_count_++] = held.contact;
  std::uint32_t first_id = 0;
  for (const ContactDecoder& other : others_) {
    first_id += ids_per_report;
    for (const Contact& contact : other.contacts())
      if (contact_count_ < max_contacts)
        contacts_[contact_count_++] = {first_id + contact.id, contact.x, contact.y};
    for (const std::uint32_t palm : other.turned_to_palms())
      if (palm_count_ < max_contacts) palms_[palm_count_++] = first_id + palm;
  }
}

std::size_t contact_events(std::span<const Contact> before, std::span<const Contact> after,
                           std::span<InputEvent> out) noexcept {
  std::size_t written = 0;
  const auto find = [](std::span<const Contact> in, std::uint32_t id) {
    return std::find_if(in.begin(), in.end(), [&](const Contact& c) { return c.id == id; });
  };
  const auto emit = [&](InputEvent::Kind kind, const Contact& contact) {
    if (written < out.size()) out[written++] = {.kind = kind, .contact = contact};
  };
  for (const Contact& c : before)
    if (find(after, c.id) == after.end()) emit(InputEvent::Kind::Up, c);
  for (const Contact& c : after) {
    const auto old = find(before, c.id);
    if (old == before.end())
      emit(InputEvent::Kind::Down, c);
    else if (old->x != c.x || old->y != c.y)
      emit(InputEvent::Kind::Move, c);
  }
  return written;
}

}  // namespace docent::input

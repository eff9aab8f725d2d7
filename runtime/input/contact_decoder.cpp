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

/// The first report of the application that holds contacts; empty when there is none.
std::optional<std::uint8_t> contact_report(const ReportDescriptor& descriptor, Usage application) {
  for (const ReportField& field : descriptor.inputs)
    if (in_application(descriptor, field, application) && field.usage == usages::x)
      return field.report_id;
  return std::nullopt;
}

std::optional<TouchLayout> find_multi_touch(const ReportDescriptor& descriptor, Usage application) {
  const auto report_id = contact_report(descriptor, application);
  if (!report_id) return std::nullopt;
  TouchLayout layout;
  layout.report_id = *report_id;
  SlotCollector slots;
  for (const ReportField& field : descriptor.inputs) {
    if (field.report_id != *report_id || field.is_array ||
        !in_application(descriptor, field, application))
      continue;
    if (field.usage == usages::contact_count) layout.count = field;
    if (field.usage == usages::scan_time) layout.scan_time = field;
    slots.add(field);
  }
  layout.slots = slots.finish();
  if (layout.slots.empty()) return std::nullopt;
  return layout;
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
         is_zero(slot.confidence);
}

}  // namespace

std::optional<TouchLayout> find_touch_screen(const ReportDescriptor& descriptor) {
  if (auto layout = find_multi_touch(descriptor, usages::touch_screen)) return layout;
  if (auto layout = find_multi_touch(descriptor, usages::touch_pad)) {
    layout->surface = TouchLayout::Surface::Pad;
    return layout;
  }
  return find_absolute_pointer(descriptor);
}

ContactDecoder::ContactDecoder(const ReportDescriptor& descriptor, TouchLayout layout)
    : numbered_(descriptor.numbered), layout_(std::move(layout)) {}

void ContactDecoder::reset() noexcept {
  frame_count_ = expected_ = down_count_ = 0;
}

bool ContactDecoder::read_slot(const ContactFields& slot, std::span<const std::byte> payload,
                               std::size_t index, Reading& reading) const noexcept {
  if (!holds(slot.x, payload) || !holds(slot.y, payload)) return false;
  reading.contact.id = slot.identifier
                           ? static_cast<std::uint32_t>(field_value(*slot.identifier, payload))
                           : static_cast<std::uint32_t>(index);
  reading.contact.x = share(slot.x, payload);
  reading.contact.y = share(slot.y, payload);
  reading.down = is_set(slot.tip, payload, true);
  return true;
}

/// Some serial devices repeat the count in every report of a frame: one that promises as many
/// contacts as the frame that is still open, and brings one that the frame lacks, belongs to it.
bool ContactDecoder::continues_frame(std::size_t count,
                                     std::span<const std::byte> payload) const noexcept {
  Reading next;
  if (layout_.slots.size() != 1 || expected_ == 0 || frame_count_ + expected_ != count ||
      !read_slot(layout_.slots.front(), payload, 0, next))
    return false;
  return !in_frame(next.contact.id);
}

bool ContactDecoder::take(std::span<const std::byte> report) noexcept {
  std::span<const std::byte> payload = report;
  if (numbered_) {
    if (report.empty() || std::to_integer<std::uint8_t>(report[0]) != layout_.report_id)
      return false;
    payload = report.subspan(1);
  }
  if (!holds(layout_.slots.front().x, payload) || !holds(layout_.slots.front().y, payload))
    return false;

  std::size_t promised = layout_.slots.size();
  if (layout_.count) {
    const auto count = static_cast<std::size_t>(
        std::clamp<std::int64_t>(field_value(*layout_.count, payload), 0, max_contacts));
    if (count > 0 && !continues_frame(count, payload)) {
      frame_count_ = 0;  // a new frame; whatever the last one still owed will not come
      expected_ = count;
    }
    promised = std::min(expected_, layout_.slots.size());
  } else {
    frame_count_ = 0;
  }

  for (std::size_t i = 0; i < promised && frame_count_ < max_contacts; ++i) {
    Reading reading;
    if (read_slot(layout_.slots[i], payload, i, reading)) frame_[frame_count_++] = reading;
  }
  expected_ -= std::min(expected_, promised);
  if (layout_.count && expected_ > 0) return false;
  if (layout_.count) read_uncounted_lifts(promised, payload);
  apply_frame();
  frame_count_ = 0;
  return true;
}

/// Some devices count only the contacts that are down, and put one that has just gone behind them,
/// tip up. What is nothing but zeros there is no contact.
void ContactDecoder::read_uncounted_lifts(std::size_t first,
                                          std::span<const std::byte> payload) noexcept {
  for (std::size_t i = first; i < layout_.slots.size() && frame_count_ < max_contacts; ++i) {
    Reading reading;
    if (!read_slot(layout_.slots[i], payload, i, reading) || reading.down) continue;
    if (is_blank(layout_.slots[i], payload)) continue;
    if (!in_frame(reading.contact.id)) frame_[frame_count_++] = reading;
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
    std::move(known + 1, end, known);
    --down_count_;
  } else if (reading.down && down_count_ < max_contacts) {
    down_[down_count_++] = {reading.contact, 0};
  }
}

/// A contact says goodbye with its tip up. One that a frame does not mention has gone where the
/// device promises to send all of them (Windows 8, known by its scan time); others leave one out
/// now and then, so it is missed for a few frames before it is given up. A serial device may stay
/// silent about a finger that rests.
void ContactDecoder::forget_missing() noexcept {
  if (layout_.slots.size() == 1) return;
  const std::uint32_t patience = layout_.scan_time ? 0 : 10;
  for (Held& held : std::span(down_).first(down_count_))
    held.missed = in_frame(held.contact.id) ? 0 : held.missed + 1;
  const auto end = down_.begin() + static_cast<std::ptrdiff_t>(down_count_);
  const auto kept =
      std::remove_if(down_.begin(), end, [&](const Held& held) { return held.missed > patience; });
  down_count_ = static_cast<std::size_t>(kept - down_.begin());
}

void ContactDecoder::apply_frame() noexcept {
  forget_missing();
  for (const Reading& reading : std::span(frame_).first(frame_count_)) merge(reading);
  for (std::size_t i = 0; i < down_count_; ++i) contacts_[i] = down_[i].contact;
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

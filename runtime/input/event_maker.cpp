#include "runtime/input/event_maker.h"

#include <algorithm>
#include <utility>

namespace docent::input {

EventMaker::EventMaker(const ReportDescriptor& descriptor, const HidDeviceKind& kind,
                       std::uint32_t first_id, std::vector<KeyMeaning> meanings)
    : first_id_(first_id),
      meanings_(std::move(meanings)),
      silence_(kind.touch && kind.touch->scan_time.has_value()) {
  if (kind.touch) contacts_.emplace(descriptor, *kind.touch);
  if (!kind.keys.empty()) keys_.emplace(descriptor, kind.keys);
}

std::span<const InputEvent> EventMaker::take(std::span<const std::byte> report,
                                             std::chrono::nanoseconds time, Moves moves) noexcept {
  std::size_t count = 0;
  if (contacts_ && contacts_->take(report)) {
    const auto now = contacts_->contacts();
    silence_.heard(std::span(heard_).first(heard_count_), now, time);
    std::ranges::copy(now, heard_.begin());
    heard_count_ = now.size();
    count = contact_changes(now, moves);
  }
  if (keys_) count += key_events(keys_->take(report, edges_), count);
  return std::span(events_).first(count);
}

std::span<const InputEvent> EventMaker::wait(std::chrono::nanoseconds time) noexcept {
  if (!contacts_ || !silence_.lifts(std::span(heard_).first(heard_count_), time)) return {};
  contacts_->reset();
  heard_count_ = 0;
  return std::span(events_).first(cancel_all());
}

std::span<const InputEvent> EventMaker::lift_all() noexcept {
  if (contacts_) contacts_->reset();
  heard_count_ = 0;
  std::size_t count = cancel_all();
  if (keys_) count += key_events(keys_->release(edges_), count);
  return std::span(events_).first(count);
}

std::size_t EventMaker::contact_changes(std::span<const Contact> now, Moves moves) noexcept {
  std::array<Contact, max_contacts> after{};
  std::size_t count = 0;
  const std::span<const Contact> told(told_.data(), told_count_);
  for (Contact contact : now.first(std::min(now.size(), after.size()))) {
    // Only a device whose identifiers are beyond all measure loses a finger here.
    contact.id = first_id_ + contact.id % ids_per_device;
    const auto same_finger = [&](const Contact& c) { return c.id == contact.id; };
    if (std::ranges::any_of(std::span(after).first(count), same_finger)) continue;
    // A finger that is known stays where it was last told to be; the next step tells the whole way.
    const auto known = std::ranges::find_if(told, same_finger);
    after[count++] = moves == Moves::Later && known != told.end() ? *known : contact;
  }
  const std::size_t events = contact_events(told, std::span(after).first(count), events_);
  told_ = after;
  told_count_ = count;
  for (const std::uint32_t palm : contacts_->turned_to_palms())
    for (InputEvent& event : std::span(events_).first(events))
      if (event.kind == InputEvent::Kind::Up &&
          event.contact.id == first_id_ + palm % ids_per_device)
        event.kind = InputEvent::Kind::Cancel;
  return events;
}

/// No finger has done that: nothing is pressed by it.
std::size_t EventMaker::cancel_all() noexcept {
  const std::size_t count = std::min(told_count_, events_.size());
  for (std::size_t i = 0; i < count; ++i)
    events_[i] = {.kind = InputEvent::Kind::Cancel, .contact = told_[i]};
  told_count_ = 0;
  return count;
}

/// Makes events of the first edges, behind `first` events; returns how many.
std::size_t EventMaker::key_events(std::size_t edges, std::size_t first) noexcept {
  const auto out = std::span(events_).subspan(first);
  const std::size_t count = std::min(edges, out.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto meaning = std::ranges::find(meanings_, edges_[i].key, &KeyMeaning::sent);
    const KeyName key = meaning == meanings_.end() ? edges_[i].key : meaning->meant;
    out[i] = {.kind = edges_[i].down ? InputEvent::Kind::KeyDown : InputEvent::Kind::KeyUp,
              .contact = {},
              .key = key.key,
              .character = key.character};
  }
  return count;
}

}  // namespace docent::input

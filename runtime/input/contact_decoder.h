#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/input/contact.h"
#include "runtime/input/report_descriptor.h"
#include "runtime/input/touch_quirks.h"

namespace docent::input {

inline constexpr std::size_t max_contacts = 64;

/// Where one contact's values lie in an input report. Fields that a device lacks are empty.
struct ContactFields {
  ReportField x, y;
  std::optional<ReportField> tip, in_range, pressure, confidence, identifier;
};

/// How a touch screen reports its contacts: parallel (all in one report), serial (one a report) or
/// hybrid (a few a report): the modes of the Windows 7 and 8 touch specifications.
struct TouchLayout {
  /// A pad reports contacts like a screen, but lies beside the picture: the kiosk does not use it.
  enum class Surface : std::uint8_t { Screen, Pad };
  Surface surface = Surface::Screen;
  std::uint8_t report_id = 0;
  std::vector<ContactFields> slots;
  std::optional<ReportField> count;      ///< Contact count: in the first report of a frame.
  std::optional<ReportField> scan_time;  ///< Has one value in all reports of a frame.
  bool single_touch = false;  ///< A mouse with absolute axes: one contact, button 1 is the tip.
  TouchRules rules;           ///< usual_rules(), or those of a quirk.
  std::vector<TouchLayout> others;  ///< Further reports of the device that hold contacts.
};

/// What follows from the layout alone. A Windows 8 screen (known by its scan time) tells all its
/// contacts in every frame. A Windows 7 screen with room for one contact in a report tells of one
/// at a time, and its count is no guide to where a frame ends.
TouchRules usual_rules(const TouchLayout& layout) noexcept;

/// The touch screen in a descriptor: a Touch Screen application, or else a pointer with absolute
/// axes; empty when there is none. Where a touch screen also offers a mouse, the mouse is ignored.
std::optional<TouchLayout> find_touch_screen(const ReportDescriptor& descriptor);

/// Turns input reports into the set of contacts that are down. One per device; take() does not
/// allocate.
class ContactDecoder {
 public:
  ContactDecoder(const ReportDescriptor& descriptor, TouchLayout layout);

  /// Takes one input report as the device sent it. True when it completed a frame; contacts() then
  /// holds all that are down. A report that is short or of another id changes nothing.
  bool take(std::span<const std::byte> report) noexcept;

  /// Contacts down after the last complete frame, in the order they came down. x and y in [0, 1] of
  /// the logical range.
  std::span<const Contact> contacts() const noexcept { return {contacts_.data(), contact_count_}; }

  /// Identifiers of those that the last frame ended because they are a palm and no finger.
  std::span<const std::uint32_t> turned_to_palms() const noexcept {
    return {palms_.data(), palm_count_};
  }

  /// Forgets all contacts: the device was unplugged, or has fallen silent.
  void reset() noexcept;

 private:
  struct Reading {
    Contact contact;
    bool down = false;
    bool speaks = true;  ///< False: the place in the report is not in use.
    bool blank = false;  ///< Nothing but zeros.
    bool palm = false;   ///< On the glass, and no finger.
  };
  bool take_own(std::span<const std::byte> payload) noexcept;
  bool take_zero_count(std::span<const std::byte> payload) noexcept;
  void begin_frame(std::size_t count) noexcept;
  void note_confidence(std::span<const std::byte> payload) noexcept;
  bool read_slot(std::size_t index, std::span<const std::byte> payload,
                 Reading& reading) const noexcept;
  bool continues_frame(std::size_t count, std::span<const std::byte> payload) const noexcept;
  bool repeats_scan_time(std::span<const std::byte> payload) const noexcept;
  bool in_frame(std::uint32_t id) const noexcept;
  bool is_open() const noexcept { return received_ < expected_; }
  void add(const Reading& reading) noexcept;
  void read_uncounted_lifts(std::size_t first, std::span<const std::byte> payload) noexcept;
  void forget_missing() noexcept;
  void end_frame() noexcept;
  void merge(const Reading& reading) noexcept;
  void gather() noexcept;

  bool numbered_;
  TouchLayout layout_;
  std::array<Reading, max_contacts> frame_{};  ///< Readings of the frame being collected.
  std::size_t frame_count_ = 0;
  std::size_t received_ = 0, expected_ = 0;  ///< Places of the frame read, and promised.
  std::int64_t last_scan_time_ = -1;         ///< Of the last report that was taken.
  struct Held {
    Contact contact;
    std::uint32_t missed = 0;  ///< Frames since it was last mentioned.
  };
  std::array<Held, max_contacts> down_{};
  std::size_t down_count_ = 0;
  std::vector<ContactDecoder> others_;            ///< One for each of the layout's others.
  std::array<Contact, max_contacts> contacts_{};  ///< The contacts of down_ and others_.
  std::size_t contact_count_ = 0;
  bool is_ever_sure_ = false;  ///< Has the device ever said that a contact is a finger?
  std::array<std::uint32_t, max_contacts> palms_{};
  std::size_t palm_count_ = 0;
};

/// Compares two sets of contacts and appends Down, Move and Up events; returns how many were
/// written.
std::size_t contact_events(std::span<const Contact> before, std::span<const Contact> after,
                           std::span<InputEvent> out) noexcept;

}  // namespace docent::input

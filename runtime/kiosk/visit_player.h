#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/guide/guide.h"
#include "runtime/kiosk/visit.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// Takes what a visitor does at the glass or the keypad.
using TakeEvent = std::function<void(const input::InputEvent&)>;

/// Plays a visit: gives the kiosk the touches and keys of a visitor, before each of the guide's
/// steps.
/// Named taps look for their control as a visitor would: on this screen or up to three touches
/// away.
class VisitPlayer {
 public:
  explicit VisitPlayer(Visit visit) : visit_(std::move(visit)) {}

  /// Does what is due at `time` (seconds since the first frame). Fails when a named control cannot
  /// be reached.
  Result<void> play(double time, const guide::Guide& guide, const TakeEvent& take);

  bool wants_shot() const noexcept { return !shots_.empty(); }
  /// Pictures asked for since the last call: they show the frame about to be drawn.
  std::vector<std::filesystem::path> take_shots() { return std::exchange(shots_, {}); }
  /// Files that are to hold what is on the glass, asked for since the last call.
  std::vector<std::filesystem::path> take_lists() { return std::exchange(lists_, {}); }
  /// Files that became today.toml since the last call.
  std::vector<std::filesystem::path> take_todays() { return std::exchange(todays_, {}); }
  /// Were headphones plugged in (true) or pulled out since the last call?
  std::optional<bool> take_headphones() noexcept { return std::exchange(headphones_, {}); }
  bool has_quit() const noexcept { return quit_; }
  /// Is every command played, every finger lifted?
  bool is_over() const noexcept;

 private:
  struct Lift {
    double time = 0;
    input::Contact contact;
  };
  void play(const VisitCommand& command, double time, const TakeEvent& take);
  void tap(float x, float y, double time, const TakeEvent& take);
  Result<void> continue_named_tap(double time, const guide::Guide& guide, const TakeEvent& take);

  Visit visit_;
  std::size_t next_ = 0;
  std::deque<VisitCommand> named_;  ///< Named taps under way or waiting; the first is under way.
  std::vector<Lift> lifts_;         ///< Fingers of taps that are still down.
  std::uint32_t fingers_ = 0;
  std::vector<std::filesystem::path> shots_, lists_, todays_;
  std::optional<bool> headphones_;
  bool quit_ = false;
};

/// Mistakes that only the museum shows: names of controls that no view has.
std::vector<Diagnostic> unknown_names(const Museum& museum, const Visit& visit,
                                      std::string_view file);

}  // namespace docent::kiosk

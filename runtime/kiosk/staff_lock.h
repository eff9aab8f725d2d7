#pragma once

#include <future>
#include <optional>
#include <string>

namespace docent::kiosk {

/// Checks PINs beside the frames, and slower the more of them were wrong: after the first a second
/// goes by, then two, four, up to five minutes. Time comes in as a value, in seconds.
class StaffLock {
 public:
  static constexpr double longest_pause = 300;

  /// `hash`: what `docent pin` printed; empty: nothing opens.
  explicit StaffLock(std::string hash) : hash_(std::move(hash)) {}

  bool has_pin() const noexcept { return !hash_.empty(); }
  /// How long no PIN is taken yet.
  double pause_left(double time) const noexcept { return next_try_ > time ? next_try_ - time : 0; }
  bool is_checking() const noexcept { return checking_.valid(); }

  /// Begins to check one; nothing happens during a pause or while another is checked.
  void try_pin(std::string pin, double time);
  /// The answer, once it is there; never waits.
  std::optional<bool> answer(double time);
  /// Waits until the answer is there: for runs that must repeat exactly.
  void wait() const;

 private:
  std::string hash_;
  std::future<bool> checking_;
  int wrong_ = 0;
  double next_try_ = 0;
};

}  // namespace docent::kiosk

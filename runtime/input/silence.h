#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <span>

#include "runtime/input/contact_decoder.h"

namespace docent::input {

/// Notices that a device which reports all the time while it is touched has stopped, so that its
/// contacts can be lifted: their last report was lost, or it hangs.
///
/// What a device does is learnt from it. One with a scan time (Windows 8) has to report until the
/// last contact has gone. Any other counts as such a one once it has said `proof` times that
/// contacts rest where they were: a device that reports only changes never does. And one whose
/// contact comes back to where silence lifted it was only resting: it is left alone from then on.
///
/// Time comes in as a value: nanoseconds of any clock that only moves forward.
class Silence {
 public:
  static constexpr std::chrono::milliseconds limit{500};
  static constexpr std::uint32_t proof = 5;

  explicit Silence(bool has_scan_time) noexcept : reports_always_(has_scan_time) {}

  /// The device completed a frame with these contacts; `before` are those of the frame before.
  void heard(std::span<const Contact> before, std::span<const Contact> now,
             std::chrono::nanoseconds time) noexcept;

  /// Have contacts to be lifted now? True once; the caller lifts them.
  bool lifts(std::span<const Contact> down, std::chrono::nanoseconds time) noexcept;

  /// Does the device report all the time while it is touched, as far as is known?
  bool reports_always() const noexcept { return reports_always_ && !rests_silently_; }

 private:
  void learn_from_return(std::span<const Contact> now) noexcept;

  bool reports_always_;
  bool rests_silently_ = false;
  std::uint32_t repetitions_ = 0;
  std::chrono::nanoseconds last_{0};
  std::array<Contact, max_contacts> lifted_{};  ///< Those that silence lifted last.
  std::size_t lifted_count_ = 0;
};

}  // namespace docent::input

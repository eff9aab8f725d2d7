#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "platform/headless/headless_display.h"
#include "runtime/kiosk/options.h"
#include "runtime/kiosk/recorder.h"
#include "runtime/kiosk/state_table.h"
#include "runtime/kiosk/visit_player.h"

namespace docent::kiosk {

/// What a run does beside being a kiosk: a scripted visit is played, and what is seen is recorded.
/// Most runs do neither.
class Rehearsal {
 public:
  /// Fails, having said why, where the visit names what the museum has not, or the folder for the
  /// recording cannot be made.
  static Result<Rehearsal> open(const Options& options, const std::optional<Visit>& visit,
                                const Museum& museum);

  /// Does what is due. `time`: seconds since the first frame.
  Result<void> play(double time, const guide::Guide& guide, const TakeEvent& take);
  /// Were headphones plugged in (true) or pulled out since the last call?
  std::optional<bool> take_headphones() noexcept {
    return visit_ ? visit_->take_headphones() : std::nullopt;
  }
  /// Files that became today.toml since the last call.
  std::vector<std::filesystem::path> take_todays();
  bool has_quit() const noexcept { return visit_ && visit_->has_quit(); }
  /// Is a visit played to its end, and what it began, too?
  bool is_over(double time) const noexcept;

  /// Will the frame of this time be looked at?
  bool wants_frame(double time) const noexcept;
  /// Keeps what is due of the frame that was drawn. `screen`: null where it cannot be read.
  Result<void> record(double time, const guide::Guide& guide,
                      const headless::HeadlessDisplay* screen);
  Result<void> finish();

 private:
  std::optional<VisitPlayer> visit_;
  std::optional<Recorder> recorder_;
  std::vector<std::filesystem::path> states_files_;  ///< None: where everybody is is not written.
  StateTable states_;
  std::filesystem::path transcript_file_;  ///< Empty: what is spoken is not written down.
  std::string transcript_;
  std::uint32_t sound_ = 0;  ///< The number of the sound that plays; 0: none.
  double last_command_ = 0;
};

}  // namespace docent::kiosk

#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "platform/journal/journal.h"
#include "platform/service/status_socket.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/kiosk/kiosk_status.h"
#include "runtime/kiosk/reporter.h"
#include "runtime/kiosk/service_notice.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// Tells everybody outside what the kiosk shows and does: the journal, the service manager, who
/// asks `docent status`, and who reads the files of health and counts. For the frame thread.
class Teller {
 public:
  struct Settings {
    std::string display;                 ///< What it draws on, in words.
    std::chrono::nanoseconds started{};  ///< When the program was, by the monotonic clock.
    Reporter::Places files{};
    bool is_simulated = false;  ///< A run without a screen is nobody's news.
  };
  /// `notice` outlives it.
  Teller(Settings settings, ServiceNotice& notice);

  /// A museum is on the screen from now on: the first one, or one that was taken up.
  /// `wanted_visitors`: as many as the settings ask room for. Between frames.
  /// `glass`: as it hangs.
  void shows(const Exhibition& exhibition, int wanted_visitors,
             const interface::ScreenShape& glass);
  /// A database was not taken up. Between frames.
  void refused(const Error& why);
  /// That museum is shown no more; what its guide counted is remembered.
  void leaves(const guide::GuideCounters& counted) noexcept { of_others_ += counted; }
  /// With what was counted for the museums before this one.
  guide::GuideCounters all_of(guide::GuideCounters counted) const noexcept {
    return counted += of_others_;
  }
  /// After each frame; neither waits nor allocates.
  void frame_made(const guide::Guide& guide, const Statistics& statistics) noexcept;
  /// The frame before is on the screen, or there was nothing to draw: both are signs of life.
  void presented() noexcept;
  void rested() noexcept;
  void ends();

 private:
  void begins();
  void answer_who_asks();
  void tell_seats(const guide::Guide& guide, int wanted_visitors) const;
  static void tell_reach(const interface::ScreenShape& glass);

  Settings settings_;
  ServiceNotice& notice_;
  StatusBoard board_;
  guide::GuideCounters of_others_;
  StatusCounts counts_;
  bool was_vacant_ = true;
  bool has_begun_ = false;
  std::optional<service::StatusSocket> asked_;  ///< Its thread reads the board.
  std::unique_ptr<Reporter> reporter_;          ///< Where somebody watches over the kiosk.
};

}  // namespace docent::kiosk

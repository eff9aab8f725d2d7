#include "runtime/kiosk/teller.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "platform/clock/monotonic_clock.h"
#include "platform/terminal/command_line.h"
#include "runtime/interface/measures.h"
#include "runtime/kiosk/options.h"

namespace docent::kiosk {

Teller::Teller(Settings settings, ServiceNotice& notice)
    : settings_(std::move(settings)),
      notice_(notice),
      board_(settings_.started, settings_.display) {}

void Teller::shows(const Exhibition& exhibition, int wanted_visitors,
                   const interface::ScreenShape& glass) {
  const std::string museum = summary(exhibition.museum);
  const std::string database = exhibition.content.path.string();
  board_.shows(exhibition.content);
  notice_.shows(museum);
  if (has_begun_) {
    journal::tell(journal::Message::TakenUp,
                  fmt::format("has taken up {}, from {}", museum, database));
  } else {
    if (!settings_.is_simulated) {
      journal::tell(journal::Message::Started,
                    fmt::format("version {}, on {}", terminal::version(), settings_.display));
      journal::tell(journal::Message::Shows, fmt::format("shows {}, from {}", museum, database));
    }
    begins();
  }
  tell_seats(*exhibition.guide, wanted_visitors);
  tell_reach(glass);
  if (reporter_) reporter_->shows(*exhibition.guide);
}

void Teller::begins() {
  has_begun_ = true;
  answer_who_asks();
  if (!settings_.files.health.empty() || !settings_.files.counts.empty())
    reporter_ = std::make_unique<Reporter>(settings_.files, board_);
}

/// Makes the socket at which `docent status` asks. A kiosk by hand beside another goes without.
void Teller::answer_who_asks() {
  const std::filesystem::path path = status_socket();
  if (path.empty()) return;
  auto opened = service::StatusSocket::open(path, [&board = board_](std::string_view question) {
    KioskStatus status = board.read();
    status.devices = devices_now();
    return question == "text" ? to_text(status) : to_json(status);
  });
  if (opened)
    asked_.emplace(std::move(*opened));
  else if (notice_.has_manager())
    journal::tell(journal::Message::NoStatus, opened.error().what);
}

/// Fewer can be served than was asked for: somebody will wonder why.
void Teller::tell_seats(const guide::Guide& guide, int wanted_visitors) const {
  const std::size_t seats = guide.seats();
  if (seats >= static_cast<std::size_t>(wanted_visitors)) return;
  journal::tell(journal::Message::FewerVisitors,
                fmt::format("{} of {} visitors can use the glass at the same time: it has room for "
                            "no more cards, or the floor about the kiosk for no more guides",
                            seats, wanted_visitors));
}

void Teller::tell_reach(const interface::ScreenShape& glass) {
  const std::optional<float> most = interface::mount_within_reach(glass);
  if (!most) return;
  journal::tell(journal::Message::HangsHigh,
                fmt::format("the glass hangs {} mm above the floor: from a wheelchair not all "
                            "controls can be reached unless it hangs {} mm high or less",
                            std::lround(glass.mount_mm), std::lround(*most)));
}

void Teller::refused(const Error& why) {
  say(why, journal::Message::Refused);
  board_.refused(why.code);
}

void Teller::frame_made(const guide::Guide& guide, const Statistics& statistics) noexcept {
  const bool is_vacant = guide.is_vacant();
  if (std::exchange(was_vacant_, is_vacant) && !is_vacant) ++counts_.visits;
  const guide::GuideCounters counters = all_of(guide.counters());
  counts_.frames = statistics.frames;
  counts_.dropped_frames = statistics.dropped_frames;
  counts_.touches = counters.touches;
  counts_.routes = counters.routes;
  counts_.last_frame = time_now();
  board_.counts(counts_);
  if (reporter_) reporter_->frame_made(guide);
}

void Teller::presented() noexcept {
  notice_.frame_presented(clock::monotonic_now());
}

void Teller::rested() noexcept {
  notice_.idle(clock::monotonic_now());
}

void Teller::ends() {
  notice_.ends();
  if (!settings_.is_simulated) journal::tell(journal::Message::Ended, "ends, as it was asked to");
}

}  // namespace docent::kiosk

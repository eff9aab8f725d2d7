#include "runtime/kiosk/rehearsal.h"

#include <utility>

#include "config/diagnostic_text.h"
#include "platform/image/image.h"
#include "runtime/kiosk/control_list.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/kiosk/transcript.h"

namespace docent::kiosk {
namespace {

/// A visit that does not say when to quit is given this long after its last command.
constexpr double after_visit_seconds = 10;

}  // namespace

Result<Rehearsal> Rehearsal::open(const Options& options, const std::optional<Visit>& visit,
                                  const Museum& museum) {
  Rehearsal rehearsal;
  if (visit) {
    const auto mistakes = unknown_names(museum, *visit, options.visit.string());
    config::tell(mistakes);
    if (!mistakes.empty())
      return std::unexpected(Error{Errc::InvalidInput, "the visit was not begun"});
    if (!visit->commands.empty()) rehearsal.last_command_ = visit->commands.back().time;
    rehearsal.visit_.emplace(*visit);
  }
  rehearsal.transcript_file_ = options.speech;
  rehearsal.transcript_ = transcript_heading;
  if (!options.states.empty()) rehearsal.states_files_.push_back(options.states);
  if (options.record.empty()) return rehearsal;
  rehearsal.states_files_.push_back(options.record / "states.csv");
  auto recorder = Recorder::open(options.record);
  if (!recorder) return std::unexpected(recorder.error());
  rehearsal.recorder_ = std::move(*recorder);
  return rehearsal;
}

Result<void> Rehearsal::play(double time, const guide::Guide& guide, const TakeEvent& take) {
  return visit_ ? visit_->play(time, guide, take) : Result<void>();
}

std::vector<std::filesystem::path> Rehearsal::take_todays() {
  return visit_ ? visit_->take_todays() : std::vector<std::filesystem::path>();
}

bool Rehearsal::is_over(double time) const noexcept {
  return visit_ && visit_->is_over() && time > last_command_ + after_visit_seconds;
}

bool Rehearsal::wants_frame(double time) const noexcept {
  return (visit_ && visit_->wants_shot()) || (recorder_ && recorder_->wants_frame(time));
}

Result<void> Rehearsal::record(double time, const guide::Guide& guide,
                               const headless::HeadlessDisplay* screen) {
  if (!states_files_.empty()) states_.add(time, guide);
  if (const guide::Saying* saying = guide.voice().saying();
      saying != nullptr && !transcript_file_.empty())
    transcript_ += transcript_line(time, *saying);
  const std::optional<guide::PlayedSound> sound = guide.sound();
  const std::uint32_t number = sound ? sound->number : 0;
  if (std::exchange(sound_, number) != number && sound && !transcript_file_.empty())
    transcript_ += transcript_line(time, *sound, guide.museum(), guide.state().language);
  if (visit_)
    for (const std::filesystem::path& list : visit_->take_lists())
      if (const Result<void> written = write_whole(list, to_json(guide.on_glass())); !written)
        return written;
  if (screen == nullptr) return {};
  const std::vector<std::filesystem::path> shots =
      visit_ ? visit_->take_shots() : std::vector<std::filesystem::path>{};
  const bool frame_due = recorder_ && recorder_->wants_frame(time);
  if (shots.empty() && !frame_due) return {};
  Pixels picture;  // not kept: it is as large as the screen
  screen->read_back(picture);
  if (frame_due)
    if (const Result<void> written = recorder_->add_frame(picture); !written) return written;
  for (const std::filesystem::path& shot : shots)
    if (const Result<void> written = image::write_png(shot, picture); !written) return written;
  return {};
}

Result<void> Rehearsal::finish() {
  if (!transcript_file_.empty())
    if (const Result<void> written = write_whole(transcript_file_, transcript_); !written)
      return written;
  for (const std::filesystem::path& file : states_files_)
    if (const Result<void> written = write_whole(file, states_.csv()); !written) return written;
  return {};
}

}  // namespace docent::kiosk

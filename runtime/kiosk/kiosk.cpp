#include "runtime/kiosk/kiosk.h"

#include <fmt/format.h>
#include <csignal>

#include <array>
#include <chrono>
#include <future>
#include <optional>
#include <thread>
#include <utility>

#include "config/diagnostic_text.h"
#include "config/kiosk_config.h"
#include "platform/clock/monotonic_clock.h"
#include "platform/file/read_file.h"
#include "platform/gles/gpu_timer.h"
#include "platform/journal/journal.h"
#include "platform/service/status_socket.h"
#include "platform/terminal/command_line.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/edges.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/kiosk/frame_guard.h"
#include "runtime/kiosk/frame_watch.h"
#include "runtime/kiosk/heat_watch.h"
#include "runtime/kiosk/hid_command.h"
#include "runtime/kiosk/kiosk_status.h"
#include "runtime/kiosk/recorder.h"
#include "runtime/kiosk/reporter.h"
#include "runtime/kiosk/screen_hours.h"
#include "runtime/kiosk/service_notice.h"
#include "runtime/kiosk/setup_screen.h"
#include "runtime/kiosk/signals.h"
#include "runtime/kiosk/staff.h"
#include "runtime/kiosk/start_code.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/kiosk/visit_player.h"
#include "runtime/model/last_catch.h"
#include "runtime/scene/shown_list.h"

namespace docent::kiosk {
namespace {

constexpr double frame_seconds = 1.0 / 60;
/// After a debugger's pause or a suspended machine the guide does not leap.
constexpr guide::Seconds longest_step{0.1F};
/// A headless visit that does not say when to quit is given this long after its last command.
constexpr double after_visit_seconds = 10;
/// A new museum waits for visitors no longer than this.
constexpr double longest_wait_to_change = 300;

/// Until here nothing would be left behind, and a signal ends the program by itself.
void expect_end() noexcept {
  expect_signal(SIGTERM);
  expect_signal(SIGINT);
}

bool has_error(const std::vector<Diagnostic>& mistakes) {
  return std::ranges::any_of(mistakes,
                             [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

/// The command line over kiosk.toml.
EdgeSettings edge_settings(const Options& options, const config::KioskConfig& config) {
  EdgeSettings settings;
  settings.kind = options.display.value_or(config.display);
  settings.size = options.size.value_or(PixelSize{static_cast<std::uint32_t>(config.width),
                                                  static_cast<std::uint32_t>(config.height)});
  settings.rotation = options.rotation.value_or(static_cast<Rotation>(config.rotate / 90));
  settings.refresh_hz = options.size ? 0 : static_cast<std::uint32_t>(config.refresh);
  settings.output = config.output;
  settings.mirror = config.mirror;
  settings.hid = options.hid;
  settings.keypads = named_keypads(config);
  return settings;
}

interface::ScreenShape shape_of(PixelSize size, double inches,
                                const config::KioskConfig& config) noexcept {
  interface::ScreenShape shape;
  shape.width = size.width;
  shape.height = size.height;
  shape.diagonal_inches = static_cast<float>(inches);
  shape.text_scale = static_cast<float>(config.text_scale);
  return shape;
}

/// One run of the kiosk: the edges, the guide, and the loop that joins them.
class Kiosk {
 public:
  Kiosk(const Options& options, const config::KioskConfig& config, Edges& edges,
        gles::Renderer renderer, ServiceNotice& notice, std::chrono::nanoseconds started)
      : options_(options),
        config_(config),
        edges_(edges),
        renderer_(std::move(renderer)),
        notice_(notice),
        simulated_(edges_.headless != nullptr),
        hours_(config.screen_on, config.idle_reset),
        started_(started),
        status_(started, edges.display->description()),
        staff_(
            {.pin = config.staff_pin, .folder = staff_folder(), .repeats_exactly = simulated_},
            [this] { return staff_facts(); },
            [keypads = named_keypads(config)] { return device_facts(keypads); }) {
    if (!simulated_) heat_.emplace();
    database_ = options.content.value_or(config.content);
  }

  Result<void> open(const std::optional<Visit>& visit);
  Result<void> run(FrameGuard& guard);
  /// Have staff ended it, not to be started again?
  bool was_ended_by_staff() const noexcept { return staff_.wants_exit(); }
  bool has_museum() const noexcept { return exhibition_ != nullptr; }

 private:
  guide::GuideSettings guide_settings() const {
    return {.shape = shape(target_of(edges_)),
            .idle_reset = config_.idle_reset,
            .visitors = static_cast<std::uint32_t>(config::visitors(config_, inches())),
            .reduced_motion = config_.reduced_motion};
  }
  double inches() const noexcept {
    return config::screen_inches(config_, edges_.display->diagonal_inches());
  }
  interface::ScreenShape shape(const RenderTarget& target) const noexcept {
    return shape_of(target.size, inches(), config_);
  }
  /// On a screen of its own a kiosk says what is missing; a person at a desk is told at once.
  bool waits_for_content() const noexcept {
    return !simulated_ && (edges_.window == nullptr || !options_.content);
  }
  guide::Guide& guide() noexcept { return *exhibition_->guide; }
  guide::GuideCounters guide_counters() const {
    guide::GuideCounters counters = exhibition_->guide->counters();
    counters += counted_;
    return counters;
  }

  guide::Seconds since_last_frame() noexcept;
  void take(const input::InputEvent& event) noexcept;
  void take_input() noexcept;
  std::vector<StaffFact> staff_facts() const;
  void make_frame(guide::Seconds passed) noexcept;
  void show(const scene::DrawList& list, const RenderTarget& target) noexcept;
  void keep_hours(guide::Seconds passed) noexcept;
  void give_sign_of_life() noexcept;
  bool is_seen() const noexcept;
  bool would_change(const scene::DrawList& list, const RenderTarget& target) const noexcept;
  void tell_museum(journal::Message message, std::string_view what);
  void tell_seats();
  void answer_for_itself();
  void count() noexcept;
  Result<void> frame();
  Result<void> record();
  bool is_a_moment_to_change() noexcept;
  void take_up_content();
  bool is_over() const noexcept;

  const Options& options_;
  const config::KioskConfig& config_;
  Edges& edges_;
  gles::Renderer renderer_;
  gles::GpuTimer gpu_timer_;
  ServiceNotice& notice_;
  bool simulated_;
  ScreenHours hours_;
  std::chrono::nanoseconds started_;
  StatusBoard status_;
  Staff staff_;
  std::filesystem::path database_;
  Selection selection_;
  std::unique_ptr<Exhibition> exhibition_;
  std::future<Result<std::unique_ptr<Exhibition>>> loading_;
  std::optional<VisitPlayer> visit_;
  std::optional<Recorder> recorder_;
  std::unique_ptr<Reporter> reporter_;  ///< Where somebody watches over the kiosk.
  Statistics statistics_;
  guide::GuideCounters counted_;  ///< Of guides that databases taken up have replaced.
  clock::FrameClock clock_;
  PixelShift shift_;
  std::optional<HeatWatch> heat_;  ///< Of a display that shows something.
  std::array<input::InputEvent, 256> events_{};
  double time_ = 0;  ///< Of the frame being made: the first frame is at 0.
  double last_command_ = 0;
  scene::ShownList shown_;  ///< On the display.
  RenderTarget shown_on_;
  bool could_show_ = false;                          ///< In the frame before.
  bool was_drawn_ = false;                           ///< The frame before.
  bool entered_view_ = false;                        ///< In this frame.
  StatusCounts counts_;                              ///< For `docent status`.
  bool is_vacant_ = true;                            ///< Was nobody being guided in the last frame?
  double asked_to_change_ = 0;                       ///< When a new database was last asked for.
  std::uint64_t view_ = 0;                           ///< For noticing the first frame of a view.
  std::optional<std::chrono::nanoseconds> touched_;  ///< When input of this frame was taken.
  std::optional<service::StatusSocket> asked_;       ///< The last: its thread reads `status_`.
};

Result<void> Kiosk::open(const std::optional<Visit>& visit) {
  Result<Selection> selection = selection_of(config_);
  if (!selection) return std::unexpected(selection.error());
  selection_ = std::move(*selection);
  notice_.starts("reads the database");
  const auto load = [this] { return load_exhibition(database_, selection_, guide_settings()); };
  auto exhibition = load();
  if (!exhibition && waits_for_content())
    exhibition = wait_for_content(edges_, renderer_, notice_, database_, exhibition.error(), load);
  if (!exhibition) return std::unexpected(exhibition.error());
  exhibition_ = std::move(*exhibition);
  if (!exhibition_) return {};  // it was told to end
  if (visit) {
    const auto mistakes = unknown_names(exhibition_->museum, *visit, options_.visit.string());
    config::tell(mistakes);
    if (!mistakes.empty())
      return std::unexpected(Error{Errc::InvalidInput, "the visit was not begun"});
    if (!visit->commands.empty()) last_command_ = visit->commands.back().time;
    visit_.emplace(*visit);
  }
  if (!options_.record.empty()) {
    auto recorder = Recorder::open(options_.record);
    if (!recorder) return std::unexpected(recorder.error());
    recorder_ = std::move(*recorder);
  }
  if (!simulated_)
    journal::tell(journal::Message::Started, fmt::format("version {}, on {}", terminal::version(),
                                                         edges_.display->description()));
  notice_.starts("draws the first frame");
  tell_museum(journal::Message::Shows, "shows");
  tell_seats();
  answer_for_itself();
  if (!options_.health.empty() || !options_.counts.empty()) {
    reporter_ =
        std::make_unique<Reporter>(Reporter::Places{options_.health, options_.counts, database_});
    reporter_->shows(guide());
  }
  upload(*exhibition_, renderer_);
  renderer_.warm_up(target_of(edges_));
  prepare_allocator_for(Phase::Frames);
  return {};
}

/// What the journal and the service manager are told of the museum on the screen. A visit without a
/// screen says nothing of its beginning.
void Kiosk::tell_museum(journal::Message message, std::string_view what) {
  const std::string museum = summary(exhibition_->museum);
  status_.shows(exhibition_->content);
  notice_.shows(museum);
  if (!simulated_ || message != journal::Message::Shows)
    journal::tell(message, fmt::format("{} {}, from {}", what, museum, database_.string()));
}

/// Makes the socket at which `docent status` asks. A kiosk by hand beside another goes without.
void Kiosk::answer_for_itself() {
  const std::filesystem::path path = status_socket();
  if (path.empty()) return;
  auto opened = service::StatusSocket::open(path, [&board = status_](std::string_view question) {
    const KioskStatus status = board.read();
    return question == "text" ? to_text(status) : to_json(status);
  });
  if (opened)
    asked_.emplace(std::move(*opened));
  else if (notice_.has_manager())
    journal::tell(journal::Message::NoStatus, opened.error().what);
}

/// Fewer can be served than was asked for: somebody will wonder why.
void Kiosk::tell_seats() {
  const std::size_t seats = guide().seats();
  const int wanted = config::visitors(config_, inches());
  if (seats >= static_cast<std::size_t>(wanted)) return;
  journal::tell(journal::Message::FewerVisitors,
                fmt::format("{} of {} visitors can use the glass at the same time: it has room for "
                            "no more cards, or the floor about the kiosk for no more guides",
                            seats, wanted));
}

bool Kiosk::is_over() const noexcept {
  if (take_signal(SIGTERM) || take_signal(SIGINT) || (visit_ && visit_->has_quit())) return true;
  if (staff_.wants_exit()) return true;
  if (options_.seconds) return time_ >= *options_.seconds;
  return simulated_ && visit_ && visit_->is_over() && time_ > last_command_ + after_visit_seconds;
}

/// For the service manager's watchdog: a frame that the display could not take is none.
void Kiosk::give_sign_of_life() noexcept {
  if (statistics_.frames == 0) return;
  if (!was_drawn_)
    notice_.idle(clock::monotonic_now());
  else if (!edges_.display->wants_frame())
    notice_.frame_presented(clock::monotonic_now());
}

Result<void> Kiosk::run(FrameGuard& guard) {
  while (!is_over()) {
    const DisplayState display = edges_.display->wait_for_page_flip();
    if (display == DisplayState::Closed) break;
    if (display == DisplayState::Lost)
      return std::unexpected(Error{Errc::Environment, std::string(edges_.display->loss())});
    give_sign_of_life();
    if (const Result<void> made = frame(); !made) return made;
    guard.frame_made();
  }
  notice_.ends();
  if (!simulated_) journal::tell(journal::Message::Ended, "ends, as it was asked to");

  const guide::GuideCounters counters = guide_counters();
  statistics_.touches = counters.touches;
  statistics_.routes = counters.routes;
  statistics_.collisions = counters.collisions;
  if (recorder_)
    if (const Result<void> finished = recorder_->finish(); !finished) return finished;
  if (!options_.stats.empty()) return write_whole(options_.stats, to_json(statistics_));
  return {};
}

guide::Seconds Kiosk::since_last_frame() noexcept {
  if (simulated_) return guide::Seconds(statistics_.frames == 0 ? 0 : frame_seconds);
  const std::chrono::nanoseconds passed = clock_.since_last_frame();
  // While there is no screen, frames come seldom, and nobody misses them.
  if (std::exchange(could_show_, edges_.display->can_show()) && could_show_ &&
      statistics_.frames > 0)
    statistics_.dropped_frames += missed_frames(passed, 1 / frame_seconds);
  return std::min(guide::Seconds(passed), longest_step);
}

/// The staff's screens come first; what is not theirs is the visitors'.
void Kiosk::take(const input::InputEvent& event) noexcept {
  if (!staff_.take(event, time_)) guide().touch(staff_.corrected(event));
}

/// What staff are told of this kiosk.
std::vector<StaffFact> Kiosk::staff_facts() const {
  return {
      {"Version", std::string(terminal::version())},
      {"Shows", summary(exhibition_->museum)},
      {"Database", database_.string()},
      {"Screen", std::string(edges_.display->description())},
      {"Frames", fmt::format("{} made, {} late", statistics_.frames, statistics_.dropped_frames)},
      {"A frame takes", fmt::format("{:.1f} ms, {:.1f} ms at most, and {:.1f} ms of drawing",
                                    statistics_.frame_cpu.milliseconds_at(0.5),
                                    statistics_.frame_cpu.longest_milliseconds(),
                                    statistics_.gl.milliseconds_at(0.5))},
      {"Touches", fmt::format("{} since it began", guide_counters().touches)}};
}

void Kiosk::take_input() noexcept {
  // Bounded, so that a device gone mad costs a frame and no more: four of 1,000 reports a second
  // with ten fingers each make 670 events a frame.
  constexpr int most_batches = 8;
  for (int batch = 0; batch < most_batches; ++batch) {
    const std::size_t count = arrived(edges_, events_);
    for (const input::InputEvent& event : std::span(events_).first(count)) take(event);
    if (count > 0) touched_ = clock::monotonic_now();
    if (count < events_.size()) break;
  }
}

Result<void> Kiosk::frame() {
  take_up_content();
  const guide::Seconds passed = since_last_frame();
  time_ = simulated_ ? static_cast<double>(statistics_.frames) * frame_seconds
                     : time_ + static_cast<double>(passed.count());
  const std::uint64_t touches = guide().counters().touches;
  if (visit_)
    if (const Result<void> played =
            visit_->play(time_, guide(), [this](const input::InputEvent& e) { take(e); });
        !played)
      return played;
  touched_.reset();
  if (guide().counters().touches != touches) touched_ = clock::monotonic_now();

  make_frame(passed);
  keep_hours(passed);
  if (statistics_.frames++ == 0)
    statistics_.start_to_first_frame = clock::monotonic_now() - started_;
  if (touched_) statistics_.input_to_frame.add(clock::monotonic_now() - *touched_);
  count();
  if (reporter_) reporter_->frame_made(guide(), statistics_.dropped_frames);
  return record();
}

/// Leaves what `docent status` tells; who asks is on another thread.
void Kiosk::count() noexcept {
  const bool was_vacant = std::exchange(is_vacant_, guide().is_vacant());
  if (was_vacant && !is_vacant_) ++counts_.visits;
  if (statistics_.frames == 1 || (is_vacant_ && !was_vacant)) give_back_code_of_start();
  guide::GuideCounters counters = guide().counters();
  counters += counted_;
  counts_.frames = statistics_.frames;
  counts_.dropped_frames = statistics_.dropped_frames;
  counts_.touches = counters.touches;
  counts_.routes = counters.routes;
  status_.counts(counts_);
}

/// A screen shows every frame that differs from the one before. In memory only those are drawn that
/// somebody will look at, and two a second for the statistics: a visit of minutes then takes
/// seconds.
bool Kiosk::is_seen() const noexcept {
  constexpr std::uint64_t sampled_every = 30;
  const bool rests = heat_ && heat_->is_too_hot() && statistics_.frames % 2 == 1;
  if (edges_.headless == nullptr) return edges_.display->can_show() && !rests;
  return touched_ || (visit_ && visit_->wants_shot()) ||
         (recorder_ && recorder_->wants_frame(time_)) || statistics_.frames % sampled_every == 0;
}

/// The screen's hours, and where the picture is on it.
void Kiosk::keep_hours(guide::Seconds passed) noexcept {
  if (simulated_) return;
  if (hours_.are_set())
    edges_.display->light(
        hours_.is_lit(local_minute(), static_cast<double>(passed.count()), touched_.has_value()));
  if (!config_.pixel_shift) return;
  shift_.advance(static_cast<double>(passed.count()), entered_view_);
  edges_.shift = shift_.at();
}

/// Would a screen that was drawn to before look different?
bool Kiosk::would_change(const scene::DrawList& list, const RenderTarget& target) const noexcept {
  return simulated_ || edges_.display->wants_frame() || target != shown_on_ ||
         shown_.differs(list, static_cast<float>(target.size.height));
}

/// The frame itself: nothing in it allocates, throws or waits, but for the driver's own affairs.
void Kiosk::make_frame(guide::Seconds passed) noexcept {
  const RenderTarget target = target_of(edges_);
  FrameWatch watch;
  take_input();
  guide().resize(shape(target));
  if (simulated_) exhibition_->planner->wait();  // so that runs repeat exactly
  guide().step(passed);
  watch.stepped();
  if (apply_pieces(guide(), renderer_)) shown_.forget();
  watch.uploaded();
  staff_.step(time_, shape(target), renderer_);
  const scene::DrawList& list = staff_.over(guide().draw_list());
  watch.listed();
  const bool seen = is_seen() && would_change(list, target);
  if (seen) show(list, target);
  was_drawn_ = seen;
  // The first frame of a view may take memory.
  const std::uint64_t views = guide().counters().views;
  entered_view_ = views != std::exchange(view_, views);
  watch.end(seen, !entered_view_, statistics_);
}

void Kiosk::show(const scene::DrawList& list, const RenderTarget& target) noexcept {
  gpu_timer_.begin();
  renderer_.draw(list, target);
  gpu_timer_.end();
  edges_.display->present();
  if (!simulated_) shown_.keep(list);
  shown_on_ = target;
  while (const auto gpu = gpu_timer_.take()) statistics_.gpu.add(*gpu);
}

Result<void> Kiosk::record() {
  if (recorder_) recorder_->add_states(time_, guide());
  if (edges_.headless == nullptr) return {};
  const std::vector<std::filesystem::path> shots =
      visit_ ? visit_->take_shots() : std::vector<std::filesystem::path>{};
  const bool frame_due = recorder_ && recorder_->wants_frame(time_);
  if (shots.empty() && !frame_due) return {};
  Pixels picture;  // not kept: it is as large as the screen
  edges_.headless->read_back(picture);
  if (frame_due)
    if (const Result<void> written = recorder_->add_frame(picture); !written) return written;
  for (const std::filesystem::path& shot : shots)
    if (const Result<void> written = image::write_png(shot, picture); !written) return written;
  return {};
}

/// Nobody is in the middle of something; or somebody always is.
bool Kiosk::is_a_moment_to_change() noexcept {
  return guide().is_vacant() || time_ - asked_to_change_ > longest_wait_to_change;
}

/// SIGHUP takes up a new database: it is read beside the frames and changed to while nobody is
/// being guided, after five minutes in any case. A database that cannot be read changes nothing.
void Kiosk::take_up_content() {
  if (!loading_.valid() && take_signal(SIGHUP)) {
    asked_to_change_ = time_;
    loading_ = std::async(std::launch::async, [file = database_, selection = selection_,
                                               settings = guide_settings()] {
      Result<std::unique_ptr<Exhibition>> loaded = std::unexpected(Error{
          Errc::Environment, file.string() + ": was not taken up; the one before it is shown"});
      guarded("reading a database", [&] { loaded = load_exhibition(file, selection, settings); });
      return loaded;
    });
  }
  if (!loading_.valid() || !is_a_moment_to_change()) return;
  if (!simulated_ && loading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return;
  Result<std::unique_ptr<Exhibition>> next = loading_.get();
  if (!next) {
    say(next.error(), journal::Message::Refused);
    if (reporter_) reporter_->refused(next.error().code);
    return;
  }
  renderer_.release_textures();
  staff_.lost_textures();
  counted_ += guide().counters();
  exhibition_ = std::move(*next);
  tell_museum(journal::Message::TakenUp, "has taken up");
  tell_seats();
  if (reporter_) reporter_->shows(guide());
  upload(*exhibition_, renderer_);
  shown_.forget();
  prepare_allocator_for(Phase::Frames);
  view_ = 0;
}

}  // namespace

void expect_reloads() noexcept {
  expect_signal(SIGHUP);
}

namespace {

/// The manager starts it again at once, for ever; what cannot start needs that no ten times a
/// second, nor the journal the same line. Nobody who asks it to end waits for that.
void wait_for_next_start() {
  constexpr auto step = std::chrono::milliseconds(50);
  for (int i = 0; i < 40 && !is_signal_waiting(SIGTERM); ++i) std::this_thread::sleep_for(step);
}

/// Opens everything and runs it; whether that was asked for or not, it has said why it ends.
int open_and_run(const Options& options, const config::KioskConfig& config,
                 const std::optional<Visit>& visit, ServiceNotice& notice,
                 std::chrono::nanoseconds started) {
  notice.starts("opens the screen");
  Result<Edges> edges = open_edges(edge_settings(options, config));
  if (!edges) return say(edges.error());
  FrameGuard guard(*edges->display,
                   edges->headless ? FrameGuard::in_memory : FrameGuard::on_screen);
  Result<gles::Renderer> renderer = gles::make_renderer();
  if (!renderer) return say(renderer.error());
  Kiosk kiosk(options, config, *edges, std::move(*renderer), notice, started);
  if (const Result<void> opened = kiosk.open(visit); !opened) return say(opened.error());
  if (!kiosk.has_museum()) return 0;
  if (const Result<void> ended = kiosk.run(guard); !ended)
    return say(ended.error(), journal::Message::ScreenLost);
  return kiosk.was_ended_by_staff() ? ended_by_staff : 0;
}

}  // namespace

int run_kiosk(const Options& options, std::chrono::nanoseconds started) {
  std::optional<Visit> visit;
  if (!options.visit.empty()) {
    visit = load_visit(options.visit);
    config::tell(visit->mistakes);
    if (!visit->mistakes.empty()) return 1;
  }
  if (options.config && !file::is_there(*options.config))
    return say({Errc::NotFound, options.config->string() + ": there is no such settings file"});
  const config::Loaded<config::KioskConfig> config =
      config::load_kiosk_config(options.config.value_or(default_config));
  config::tell(config.diagnostics);
  if (has_error(config.diagnostics) || !config.value) return 1;

  expect_end();
  ServiceNotice notice = ServiceNotice::of_environment(started);
  const int exit_code = open_and_run(options, *config.value, visit, notice, started);
  if (exit_code != 0 && notice.has_manager() && !notice.was_ready()) wait_for_next_start();
  return exit_code;
}

}  // namespace docent::kiosk

#include "runtime/kiosk/kiosk.h"

#include <fmt/format.h>
#include <csignal>

#include <array>
#include <chrono>
#include <future>
#include <optional>
#include <utility>

#include "config/diagnostic_text.h"
#include "config/kiosk_config.h"
#include "platform/clock/monotonic_clock.h"
#include "platform/file/read_file.h"
#include "platform/gles/gpu_timer.h"
#include "platform/terminal/command_line.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/edges.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/kiosk/frame_guard.h"
#include "runtime/kiosk/frame_watch.h"
#include "runtime/kiosk/recorder.h"
#include "runtime/kiosk/setup_screen.h"
#include "runtime/kiosk/signals.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/kiosk/visit_player.h"
#include "runtime/model/last_catch.h"

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
  settings.hid = options.hid;
  return settings;
}

interface::ScreenShape shape_of(PixelSize size, const config::KioskConfig& config) {
  interface::ScreenShape shape;
  shape.width = size.width;
  shape.height = size.height;
  shape.diagonal_inches = static_cast<float>(config.screen_inches);
  shape.text_scale = static_cast<float>(config.text_scale);
  return shape;
}

/// One run of the kiosk: the edges, the guide, and the loop that joins them.
class Kiosk {
 public:
  Kiosk(const Options& options, const config::KioskConfig& config, Edges& edges,
        gles::Renderer renderer, std::chrono::nanoseconds started)
      : options_(options),
        config_(config),
        edges_(edges),
        renderer_(std::move(renderer)),
        simulated_(edges_.headless != nullptr),
        started_(started) {
    database_ = options.content.value_or(config.content);
  }

  Result<void> open(const std::optional<Visit>& visit);
  Result<void> run(FrameGuard& guard);
  bool has_museum() const noexcept { return exhibition_ != nullptr; }

 private:
  guide::GuideSettings guide_settings() const {
    return {.shape = shape_of(target_of(edges_).size, config_),
            .idle_reset = config_.idle_reset,
            .visitors = static_cast<std::uint32_t>(config_.visitors)};
  }
  /// On a screen of its own a kiosk says what is missing; a person at a desk is told at once.
  bool waits_for_content() const noexcept {
    return !simulated_ && (edges_.window == nullptr || !options_.content);
  }
  guide::Guide& guide() noexcept { return *exhibition_->guide; }

  guide::Seconds since_last_frame() noexcept;
  void take_input() noexcept;
  void make_frame(guide::Seconds passed) noexcept;
  void show(const scene::DrawList& list, const RenderTarget& target) noexcept;
  bool is_seen() const noexcept;
  void tell_museum(std::string_view what) const;
  void tell_seats();
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
  bool simulated_;
  std::chrono::nanoseconds started_;
  std::filesystem::path database_;
  Selection selection_;
  std::unique_ptr<Exhibition> exhibition_;
  std::future<Result<std::unique_ptr<Exhibition>>> loading_;
  std::optional<VisitPlayer> visit_;
  std::optional<Recorder> recorder_;
  Statistics statistics_;
  guide::GuideCounters counted_;  ///< Of guides that databases taken up have replaced.
  clock::FrameClock clock_;
  std::array<input::InputEvent, 256> events_{};
  double time_ = 0;  ///< Of the frame being made: the first frame is at 0.
  double last_command_ = 0;
  double asked_to_change_ = 0;                       ///< When a new database was last asked for.
  std::uint64_t view_ = 0;                           ///< For noticing the first frame of a view.
  std::optional<std::chrono::nanoseconds> touched_;  ///< When input of this frame was taken.
};

Result<void> Kiosk::open(const std::optional<Visit>& visit) {
  Result<Selection> selection = selection_of(config_);
  if (!selection) return std::unexpected(selection.error());
  selection_ = std::move(*selection);
  const auto load = [this] { return load_exhibition(database_, selection_, guide_settings()); };
  auto exhibition = load();
  if (!exhibition && waits_for_content())
    exhibition = wait_for_content(edges_, renderer_, database_, exhibition.error(), load);
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
  if (!simulated_) {
    fmt::print(stderr, "docent: version {}, on {}\n", terminal::version(),
               edges_.display->description());
    tell_museum("shows");
  }
  tell_seats();
  upload(*exhibition_, renderer_);
  renderer_.warm_up(target_of(edges_));
  prepare_allocator_for(Phase::Frames);
  return {};
}

/// What the journal is told of the museum on the screen.
void Kiosk::tell_museum(std::string_view what) const {
  fmt::print(stderr, "docent: {} {}, from {}\n", what, summary(exhibition_->museum),
             database_.string());
}

/// Fewer can be served than was asked for: somebody will wonder why.
void Kiosk::tell_seats() {
  const std::size_t seats = guide().seats();
  if (seats >= static_cast<std::size_t>(config_.visitors)) return;
  fmt::print(stderr,
             "docent: {} of {} visitors can use the glass at the same time: it has room for no "
             "more cards, or the floor about the kiosk for no more guides\n",
             seats, config_.visitors);
}

bool Kiosk::is_over() const noexcept {
  if (take_signal(SIGTERM) || take_signal(SIGINT) || (visit_ && visit_->has_quit())) return true;
  if (options_.seconds) return time_ >= *options_.seconds;
  return simulated_ && visit_ && visit_->is_over() && time_ > last_command_ + after_visit_seconds;
}

Result<void> Kiosk::run(FrameGuard& guard) {
  while (!is_over()) {
    const DisplayState display = edges_.display->wait_for_page_flip();
    if (display == DisplayState::Closed) break;
    if (display == DisplayState::Lost)
      return std::unexpected(Error{Errc::Environment, std::string(edges_.display->loss())});
    if (const Result<void> made = frame(); !made) return made;
    guard.frame_made();
  }

  guide::GuideCounters counters = guide().counters();
  counters += counted_;
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
  if (statistics_.frames > 0)
    statistics_.dropped_frames += missed_frames(passed, 1 / frame_seconds);
  return std::min(guide::Seconds(passed), longest_step);
}

void Kiosk::take_input() noexcept {
  const std::size_t count = arrived(edges_, events_);
  for (const input::InputEvent& event : std::span(events_).first(count)) guide().touch(event);
  if (count > 0) touched_ = clock::monotonic_now();
}

Result<void> Kiosk::frame() {
  take_up_content();
  const guide::Seconds passed = since_last_frame();
  time_ = simulated_ ? static_cast<double>(statistics_.frames) * frame_seconds
                     : time_ + static_cast<double>(passed.count());
  const std::uint64_t touches = guide().counters().touches;
  if (visit_)
    if (const Result<void> played = visit_->play(time_, guide()); !played) return played;
  touched_.reset();
  if (guide().counters().touches != touches) touched_ = clock::monotonic_now();

  make_frame(passed);
  if (statistics_.frames++ == 0)
    statistics_.start_to_first_frame = clock::monotonic_now() - started_;
  if (touched_) statistics_.input_to_frame.add(clock::monotonic_now() - *touched_);
  return record();
}

/// A screen shows every frame. In memory only those are drawn that somebody will look at, and two a
/// second for the statistics: a visit of minutes then takes seconds.
bool Kiosk::is_seen() const noexcept {
  constexpr std::uint64_t sampled_every = 30;
  return edges_.headless == nullptr || touched_ || (visit_ && visit_->wants_shot()) ||
         (recorder_ && recorder_->wants_frame(time_)) || statistics_.frames % sampled_every == 0;
}

/// The frame itself: nothing in it allocates, throws or waits, but for the driver's own affairs.
void Kiosk::make_frame(guide::Seconds passed) noexcept {
  const RenderTarget target = target_of(edges_);
  FrameWatch watch;
  take_input();
  guide().resize(shape_of(target.size, config_));
  if (simulated_) exhibition_->planner->wait();  // so that runs repeat exactly
  guide().step(passed);
  watch.stepped();
  apply_pieces(guide(), renderer_);
  watch.uploaded();
  const scene::DrawList& list = guide().draw_list();
  watch.listed();
  const bool seen = is_seen();
  if (seen) show(list, target);
  // The first frame of a view may take memory.
  const std::uint64_t views = guide().counters().views;
  watch.end(seen, views == std::exchange(view_, views), statistics_);
}

void Kiosk::show(const scene::DrawList& list, const RenderTarget& target) noexcept {
  gpu_timer_.begin();
  renderer_.draw(list, target);
  gpu_timer_.end();
  edges_.display->present();
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
    say(next.error());
    return;
  }
  renderer_.release_textures();
  counted_ += guide().counters();
  exhibition_ = std::move(*next);
  tell_museum("has taken up");
  tell_seats();
  upload(*exhibition_, renderer_);
  prepare_allocator_for(Phase::Frames);
  view_ = 0;
}

}  // namespace

void expect_reloads() noexcept {
  expect_signal(SIGHUP);
}

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
  Result<Edges> edges = open_edges(edge_settings(options, *config.value));
  if (!edges) return say(edges.error());
  FrameGuard guard(*edges->display,
                   edges->headless ? FrameGuard::in_memory : FrameGuard::on_screen);
  Result<gles::Renderer> renderer = gles::make_renderer();
  if (!renderer) return say(renderer.error());
  Kiosk kiosk(options, *config.value, *edges, std::move(*renderer), started);
  if (const Result<void> opened = kiosk.open(visit); !opened) return say(opened.error());
  if (!kiosk.has_museum()) return 0;
  if (const Result<void> ended = kiosk.run(guard); !ended) return say(ended.error());
  return 0;
}

}  // namespace docent::kiosk

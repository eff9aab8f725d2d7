#include "runtime/kiosk/kiosk.h"

#include <fmt/format.h>
#include <csignal>
#include <ctime>

#include <array>
#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <thread>
#include <utility>

#include "config/diagnostic_text.h"
#include "config/kiosk_config.h"
#include "platform/clock/monotonic_clock.h"
#include "platform/file/read_file.h"
#include "platform/gles/renderer.h"
#include "platform/journal/journal.h"
#include "platform/terminal/command_line.h"
#include "runtime/input/same_key.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/change_over.h"
#include "runtime/kiosk/edges.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/kiosk/frame_guard.h"
#include "runtime/kiosk/frame_watch.h"
#include "runtime/kiosk/hid_command.h"
#include "runtime/kiosk/poster.h"
#include "runtime/kiosk/presenter.h"
#include "runtime/kiosk/rehearsal.h"
#include "runtime/kiosk/screen_hours.h"
#include "runtime/kiosk/service_notice.h"
#include "runtime/kiosk/setup_screen.h"
#include "runtime/kiosk/signals.h"
#include "runtime/kiosk/speaker.h"
#include "runtime/kiosk/staff.h"
#include "runtime/kiosk/staff_facts.h"
#include "runtime/kiosk/staff_words.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/kiosk/teller.h"
#include "runtime/model/last_catch.h"

namespace docent::kiosk {
namespace {

constexpr double frame_seconds = 1.0 / 60;
/// After a debugger's pause or a suspended machine the guide does not leap.
constexpr guide::Seconds longest_step{0.1F};

/// Until here nothing would be left behind, and a signal ends the program by itself.
void expect_end() noexcept {
  expect_signal(SIGTERM);
  expect_signal(SIGINT);
}

bool has_error(const std::vector<Diagnostic>& mistakes) {
  return std::ranges::any_of(mistakes,
                             [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

scene::Side side_of(config::GlassEdge edge) noexcept {
  switch (edge) {
    case config::GlassEdge::Bottom:
      return scene::Side::Bottom;
    case config::GlassEdge::Left:
      return scene::Side::Left;
    case config::GlassEdge::Top:
      return scene::Side::Top;
    case config::GlassEdge::Right:
      return scene::Side::Right;
  }
  return scene::Side::Bottom;
}

interface::ScreenShape shape_of(PixelSize size, double inches,
                                const config::KioskConfig& config) noexcept {
  interface::ScreenShape shape;
  shape.width = size.width;
  shape.height = size.height;
  shape.diagonal_inches = static_cast<float>(inches);
  shape.text_scale = static_cast<float>(config.text_scale);
  shape.mount_mm = static_cast<float>(config.mount_height);
  for (const config::GlassEdge edge : config.sides) shape.sides.add(side_of(edge));
  return shape;
}

/// One run of the kiosk: the edges, the guide, and the loop that joins them.
class Kiosk {
 public:
  Kiosk(const Options& options, const config::KioskConfig& config, Edges& edges,
        Presenter& presenter, ServiceNotice& notice, std::chrono::nanoseconds started)
      : options_(options),
        config_(config),
        edges_(edges),
        presenter_(presenter),
        notice_(notice),
        simulated_(edges_.headless != nullptr),
        started_(started),
        teller_({.display = std::string(edges.display->description()),
                 .started = started,
                 .files = {options.health, options.counts},
                 .is_simulated = simulated_},
                notice),
        change_(simulated_),
        staff_(
            {.pin = config.staff_pin, .folder = staff_folder(), .repeats_exactly = simulated_},
            [this] { return staff_words(exhibition_->museum, guide().language()); },
            [this] { return StaffLook{exhibition_->museum.livery, exhibition_->set_text}; },
            [this](const StaffWords& words) { return staff_facts(words); },
            [keypads = named_keypads(config)](const StaffWords& words) {
              return device_facts(keypads, words);
            }),
        same_key_(config.same_key_delay),
        speaker_(config, simulated_) {
    database_ = options.content.value_or(config.content);
  }

  /// `reading`: the database, which was begun before there was a screen.
  Result<void> open(const std::optional<Visit>& visit, std::future<Result<ReadMuseum>> reading);
  Result<void> run(FrameGuard& guard);
  /// Have staff ended it, not to be started again?
  bool was_ended_by_staff() const noexcept { return staff_.wants_exit(); }
  bool has_museum() const noexcept { return exhibition_ != nullptr; }

 private:
  guide::GuideSettings guide_settings() const {
    return {.shape = shape(presenter_.target()),
            .idle_reset = config_.idle_reset,
            .visitors = static_cast<std::uint32_t>(wanted_visitors()),
            .reduced_motion = config_.reduced_motion,
            .can_sound = simulated_ && Speaker::is_wanted(config_)};
  }
  double inches() const noexcept {
    return config::screen_inches(config_, edges_.display->diagonal_inches());
  }
  interface::ScreenShape shape(const RenderTarget& target) const noexcept {
    interface::ScreenShape shape = shape_of(target.size, inches(), config_);
    shape.is_night = is_night();
    return shape;
  }
  bool is_night() const noexcept { return config_.is_night || is_in_night_hours(); }
  bool is_in_night_hours() const noexcept {
    if (!config_.night) return false;
    const LocalMinute now = local_minute();
    return config::holds(*config_.night, now.weekday, now.minute);
  }
  /// On a screen of its own a kiosk says what is missing; a person at a desk is told at once.
  bool waits_for_content() const noexcept {
    return !simulated_ && (edges_.window == nullptr || !options_.content);
  }
  guide::Guide& guide() noexcept { return *exhibition_->guide; }

  guide::Seconds since_last_frame() noexcept;
  void take(const input::InputEvent& event) noexcept;
  void take_input() noexcept;
  std::vector<StaffFact> staff_facts(const StaffWords& words) const;
  void make_frame(guide::Seconds passed) noexcept;
  void give_sign_of_life() noexcept;
  int wanted_visitors() const noexcept { return config::visitors(config_, inches()); }
  FrameFacts facts_of_frame(guide::Seconds passed) noexcept;
  Result<void> frame();
  void heed_closures();
  using Read = std::function<Result<ReadMuseum>()>;
  ChangeOver::Load loader(Read read) const;
  /// Reads the database, and that.
  ChangeOver::Load loader() const;
  void take_up_content();
  void change_to(std::unique_ptr<Exhibition> next);
  bool is_over() const noexcept;

  const Options& options_;
  const config::KioskConfig& config_;
  Edges& edges_;
  Presenter& presenter_;
  ServiceNotice& notice_;
  bool simulated_;
  std::chrono::nanoseconds started_;
  Teller teller_;
  ChangeOver change_;
  Staff staff_;
  input::SameKey same_key_;
  std::filesystem::path database_;
  Selection selection_;
  std::unique_ptr<Exhibition> exhibition_;
  Rehearsal rehearsal_;
  Speaker speaker_;
  Statistics statistics_;
  clock::FrameClock clock_;
  std::array<input::InputEvent, 256> events_{};
  double time_ = 0;  ///< Of the frame being made: the first frame is at 0.
  bool has_headphones_ = false;
  bool could_show_ = false;                          ///< In the frame before.
  std::uint64_t closures_ = 0;                       ///< Changes of them that the guide knows.
  std::uint64_t view_ = 0;                           ///< For noticing the first frame of a view.
  std::optional<std::chrono::nanoseconds> touched_;  ///< When input of this frame was taken.
};

Result<void> Kiosk::open(const std::optional<Visit>& visit,
                         std::future<Result<ReadMuseum>> reading) {
  Result<Selection> selection = selection_of(config_);
  if (!selection) return std::unexpected(selection.error());
  selection_ = std::move(*selection);
  selection_.today = options_.today.value_or(database_.parent_path() / "today.toml");
  selection_.is_simulated = simulated_;
  notice_.starts("reads the database");
  auto loading = std::async(std::launch::async, loader([&] { return reading.get(); }));
  presenter_.renderer().warm_up(presenter_.target());
  auto exhibition = loading.get();
  if (!exhibition && waits_for_content())
    exhibition = wait_for_content(
        edges_, presenter_.renderer(), notice_, database_, exhibition.error(),
        [this] { return is_night(); }, loader());
  if (!exhibition) return std::unexpected(exhibition.error());
  exhibition_ = std::move(*exhibition);
  if (!exhibition_) return {};  // it was told to end
  Result<Rehearsal> rehearsal = Rehearsal::open(options_, visit, exhibition_->museum);
  if (!rehearsal) return std::unexpected(rehearsal.error());
  rehearsal_ = std::move(*rehearsal);
  notice_.starts("draws the first frame");
  teller_.shows(*exhibition_, wanted_visitors(), shape(presenter_.target()));
  upload(*exhibition_);
  if (config_.night) tzset();  // takes memory, which a frame may not
  prepare_allocator_for(Phase::Frames);
  return {};
}

bool Kiosk::is_over() const noexcept {
  if (take_signal(SIGTERM) || take_signal(SIGINT)) return true;
  if (rehearsal_.has_quit() || staff_.wants_exit()) return true;
  if (options_.seconds) return time_ >= *options_.seconds;
  return simulated_ && rehearsal_.is_over(time_);
}

/// For the service manager's watchdog: a frame that the display could not take is none.
void Kiosk::give_sign_of_life() noexcept {
  if (statistics_.frames == 0) return;
  if (!presenter_.has_drawn())
    teller_.rested();
  else if (edges_.display->has_shown())
    teller_.presented();
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
  teller_.ends();

  const guide::GuideCounters counters = teller_.all_of(guide().counters());
  statistics_.touches = counters.touches;
  statistics_.routes = counters.routes;
  statistics_.collisions = counters.collisions;
  statistics_.video = video_counters(*exhibition_);
  if (const Result<void> finished = rehearsal_.finish(); !finished) return finished;
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
  if (!same_key_.takes(event, time_)) return;
  if (!staff_.take(event, time_)) guide().touch(staff_.corrected(event));
}

std::vector<StaffFact> Kiosk::staff_facts(const StaffWords& words) const {
  return facts_of({.museum = exhibition_->museum,
                   .statistics = statistics_,
                   .database = database_,
                   .screen = std::string(edges_.display->description()),
                   .touches = teller_.all_of(exhibition_->guide->counters()).touches},
                  words);
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
  if (const Result<void> played =
          rehearsal_.play(time_, guide(), [this](const input::InputEvent& e) { take(e); });
      !played)
    return played;
  for (const std::optional<bool> are_in : {rehearsal_.take_headphones(), speaker_.headphones()})
    if (are_in) {
      has_headphones_ = *are_in;
      guide().headphones(has_headphones_);
    }
  heed_closures();
  touched_.reset();
  if (guide().counters().touches != touches) touched_ = clock::monotonic_now();

  make_frame(passed);
  speaker_.heed(guide(), exhibition_->museum, exhibition_->sounds);
  if (statistics_.frames++ == 0)
    statistics_.start_to_first_frame = clock::monotonic_now() - started_;
  if (touched_) statistics_.input_to_frame.add(clock::monotonic_now() - *touched_);
  teller_.frame_made(guide(), statistics_);
  return rehearsal_.record(time_, guide(), edges_.headless);
}

/// Who is under way asks for a new way when something has been closed or opened, and the glass says
/// so.
void Kiosk::heed_closures() {
  for (const std::filesystem::path& file : rehearsal_.take_todays())
    exhibition_->today->take_up(file);
  if (exhibition_->today->changes() == closures_) return;
  closures_ = exhibition_->today->changes();
  guide().heed_closures();
}

FrameFacts Kiosk::facts_of_frame(guide::Seconds passed) noexcept {
  const std::uint64_t views = guide().counters().views;
  return {.number = statistics_.frames,
          .passed = static_cast<double>(passed.count()),
          .is_asked_for = rehearsal_.wants_frame(time_),
          .is_touched = touched_.has_value(),
          .is_vacant = guide().is_vacant(),
          .is_new_view = views != std::exchange(view_, views),
          .is_first_picture = guide().is_vacant() && !guide().is_attracting() &&
                              guide().is_settled() && !staff_.is_open()};
}

/// The frame itself: nothing in it allocates, throws or waits, but for the driver's own affairs.
void Kiosk::make_frame(guide::Seconds passed) noexcept {
  const interface::ScreenShape glass = shape(presenter_.target());
  FrameWatch watch;
  take_input();
  guide().resize(glass);
  if (simulated_) exhibition_->planner->wait();  // so that runs repeat exactly
  guide().spare_videos(presenter_.lacks_time_for_video());
  guide().step(passed);
  watch.stepped();
  if (apply_pieces(*exhibition_)) presenter_.forget();
  watch.uploaded();
  staff_.step(time_, glass, exhibition_->holdings);
  const scene::DrawList& drawn = guide().draw_list();
  if (look_at_object(*exhibition_, drawn.near_object, simulated_)) presenter_.forget();
  for (const scene::TextureId changed : play_videos(*exhibition_, simulated_))
    presenter_.forget(changed);
  const scene::DrawList& list = staff_.over(drawn);
  watch.listed();
  const FrameFacts facts = facts_of_frame(passed);
  const bool is_drawn = presenter_.show(list, exhibition_->holdings, facts, statistics_);
  // The first frame of a view may take memory.
  watch.end(is_drawn, !facts.is_new_view, statistics_);
  presenter_.keep(facts);
}

/// Makes ready what was read, as this device shows it.
ChangeOver::Load Kiosk::loader(Read read) const {
  return [read = std::move(read), file = database_, selection = selection_,
          settings = guide_settings()] {
    Result<std::unique_ptr<Exhibition>> loaded = std::unexpected(
        Error{Errc::Environment, file.string() + ": was not taken up; the one before it is shown"});
    guarded("reading a database", [&] {
      Result<ReadMuseum> museum = read();
      if (museum)
        loaded = make_exhibition(std::move(*museum), selection, settings);
      else
        loaded = std::unexpected(museum.error());
    });
    return loaded;
  };
}

ChangeOver::Load Kiosk::loader() const {
  return loader(
      [file = database_, selection = selection_] { return read_museum(file, selection); });
}

/// SIGHUP takes up a new database, which is made ready beside the frames. One that cannot be read
/// changes nothing.
void Kiosk::take_up_content() {
  // The guide's own time stands still where frames are slow.
  const double now =
      simulated_ ? time_ : std::chrono::duration<double>(clock::monotonic_now()).count();
  if (change_.state() == ChangeOver::State::Idle && take_signal(SIGHUP))
    change_.begin(loader(), now);
  change_.step(shape(presenter_.target()));
  if (change_.state() == ChangeOver::State::Refused) teller_.refused(change_.take().error());
  if (change_.is_due(guide().is_vacant(), now)) change_to(std::move(*change_.take()));
}

void Kiosk::change_to(std::unique_ptr<Exhibition> next) {
  teller_.leaves(guide().counters());
  change_.retire(std::exchange(exhibition_, std::move(next)));
  staff_.lost_textures();
  teller_.shows(*exhibition_, wanted_visitors(), shape(presenter_.target()));
  presenter_.forget();
  guide().headphones(has_headphones_);
  closures_ = exhibition_->today->changes();
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

/// What is shown until the first frame; nothing while the screen is to be dark.
PosterFile poster_of(const Options& options, const config::KioskConfig& config,
                     const EdgeSettings& settings) {
  if (!ScreenHours(config.screen_on, config.idle_reset).is_lit(local_minute(), 0, false)) return {};
  return poster_file(options.content.value_or(config.content),
                     options.config.value_or(default_config), settings.rotation);
}

/// Opens everything and runs it; whether that was asked for or not, it has said why it ends.
int open_and_run(const Options& options, const config::KioskConfig& config,
                 const std::optional<Visit>& visit, ServiceNotice& notice,
                 std::chrono::nanoseconds started) {
  notice.starts("opens the screen");
  auto reading = std::async(std::launch::async, [&]() -> Result<ReadMuseum> {
    const Result<Selection> selection = selection_of(config);
    if (!selection) return std::unexpected(selection.error());
    return read_museum(options.content.value_or(config.content), *selection);
  });
  EdgeSettings settings = edge_settings(options, config);
  const PosterFile poster = poster_of(options, config, settings);
  bool has_poster = false;
  settings.find_poster = [&](PixelSize size) {
    auto picture = load_poster(poster, size);
    has_poster = picture.has_value();
    return picture;
  };
  Result<Edges> edges = open_edges(settings);
  if (!edges) return say(edges.error());
  FrameGuard guard(*edges->display,
                   edges->headless ? FrameGuard::in_memory : FrameGuard::on_screen);
  Result<gles::Renderer> renderer = gles::make_renderer();
  if (!renderer) return say(renderer.error());
  Presenter presenter(config, *edges, std::move(*renderer),
                      edges->is_own_screen() ? poster : PosterFile{}, has_poster);
  Kiosk kiosk(options, config, *edges, presenter, notice, started);
  if (const Result<void> opened = kiosk.open(visit, std::move(reading)); !opened)
    return say(opened.error());
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

#include <GLES3/gl3.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "content/compile/load_video.h"
#include "content/content_error.h"
#include "content/write/content_writer.h"
#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/kiosk/time_for_video.h"
#include "runtime/scene/shown_list.h"
#include "tests/bench/measure.h"
#include "tests/support/temporary_folder.h"

namespace docent::bench {
namespace {

constexpr PixelSize full_hd{1920, 1080};

[[noreturn]] void give_up(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::exit(1);
}

template <typename T>
T value_of(Result<T> result) {
  if (!result) give_up(result.error().what);
  return std::move(*result);
}

/// The museum with the film as a picture of the exhibit that is nearest to the kiosk.
struct MuseumWithFilm {
  MuseumWithFilm(const std::string& database, const std::string& film) {
    Museum museum = value_of(sqlite::load_museum(database));
    compile::LoadedVideo video = compile::load_video(film, "film.webm");
    const auto nearest = std::ranges::min_element(museum.exhibits, {}, [&](const Exhibit& one) {
      return one.floor != museum.kiosk_floor
                 ? 1e9
                 : glm::distance(one.viewing_point.position, museum.kiosk.position);
    });
    exhibit = nearest->id;
    const auto index = static_cast<std::uint32_t>(nearest - museum.exhibits.begin());
    std::erase_if(museum.pictures, [&](const FurtherPicture& one) { return one.exhibit == index; });
    museum.pictures.insert(
        std::ranges::upper_bound(museum.pictures, index, {}, &FurtherPicture::exhibit),
        {.exhibit = index, .image = static_cast<std::uint32_t>(museum.images.size())});
    museum.images.push_back(std::move(video.image));
    write::write_museum(museum, file);
  }
  test::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "museum.db";
  std::string exhibit;
};

/// Megabytes of the process that are no file's.
double own_megabytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0, resident = 0, of_files = 0;
  statm >> total >> resident >> of_files;
  return (resident - of_files) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

double processor_milliseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// What some seconds of frames took: milliseconds each.
struct Measured {
  std::vector<double> step, upload, draw;
  std::size_t frames = 0, drawn = 0, whole = 0, late = 0, bodies = 0;
  double processors = 0;  ///< How many were busy.
  double own = 0;         ///< Megabytes, the most.
};

class Kiosk {
 public:
  explicit Kiosk(const std::filesystem::path& database)
      : display_(value_of(headless::open_headless(full_hd))),
        renderer_(value_of(gles::make_renderer())),
        exhibition_(value_of(kiosk::load_exhibition(
            database, kiosk::Selection{},
            {.shape = {.width = full_hd.width, .height = full_hd.height}}))) {
    kiosk::upload(*exhibition_);
    renderer_.warm_up(display_->target());
    kiosk::prepare_allocator_for(kiosk::Phase::Frames);
  }

  /// In simulated time, without a picture.
  void run(double seconds) {
    for (int frame = 0; frame < std::lround(60 * seconds); ++frame) {
      exhibition_->planner->wait();
      exhibition_->guide->step(guide::Seconds{1.0F / 60});
      kiosk::apply_pieces(*exhibition_);
    }
  }
  void touch(const std::string& name) {
    const auto& controls = exhibition_->guide->view()->controls;
    const auto at = std::ranges::find(controls, name, &interface::Control::name);
    if (at == controls.end()) give_up(name + " is not on the glass");
    const scene::Rect& r = at->rect;
    const input::Contact finger{1, r.x + r.width / 2, r.y + r.height / 2};
    for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
      exhibition_->guide->touch({.kind = kind, .contact = finger});
      run(0.05);
    }
  }
  /// Does the guide keep still while a video plays?
  enum class KeepsStill { Never, Always, WhereTimeIsShort };
  void spare_videos(KeepsStill when) {
    when_ = when;
    exhibition_->guide->spare_videos(when == KeepsStill::Always);
  }
  const guide::Guide& guide() const { return *exhibition_->guide; }
  kiosk::VideoCounters counters() { return kiosk::video_counters(*exhibition_); }

  /// In real time, sixty frames a second or as many as there is time for.
  Measured play(double seconds) {
    using Clock = std::chrono::steady_clock;
    constexpr auto frame = std::chrono::nanoseconds(1'000'000'000 / 60);
    Measured all;
    const double worked = processor_milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    const auto begun = Clock::now();
    auto due = begun, before = begun;
    while (Clock::now() - begun < std::chrono::duration<double>(seconds)) {
      due += frame;
      std::this_thread::sleep_until(due);
      const auto now = Clock::now();
      if (now - due > frame) {
        ++all.late;
        due = now;
      }
      const auto passed = std::chrono::duration<float>(now - before);
      if (has_drawn_bodies_) time_.took(static_cast<double>(passed.count()));
      if (when_ == KeepsStill::WhereTimeIsShort) exhibition_->guide->spare_videos(time_.is_short());
      make_frame(passed.count(), all);
      before = now;
      all.own = std::max(all.own, own_megabytes());
    }
    const double took = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    all.processors = (processor_milliseconds(CLOCK_PROCESS_CPUTIME_ID) - worked) / took;
    return all;
  }

  /// Processor time of the whole program, whatever else the machine does: simulated frames, so many
  /// a second, of which each waits for its video's. Milliseconds.
  struct Cost {
    std::vector<double> upload, draw;
  };
  Cost cost_of(int frames, float a_second) {
    Cost all;
    for (int frame = 0; frame < frames; ++frame) {
      exhibition_->planner->wait();
      exhibition_->guide->step(guide::Seconds{1 / a_second});
      if (kiosk::apply_pieces(*exhibition_)) shown_.forget();
      for (const auto& player : exhibition_->videos) player->wait();
      const double began = processor_milliseconds(CLOCK_THREAD_CPUTIME_ID);
      shown_.forget(kiosk::play_videos(*exhibition_, true).front());
      all.upload.push_back(processor_milliseconds(CLOCK_THREAD_CPUTIME_ID) - began);
      for (const auto& player : exhibition_->videos) player->wait();
      const scene::DrawList& list = exhibition_->guide->draw_list();
      const scene::Change change = shown_.change(list, static_cast<float>(full_hd.height));
      if (change.nothing()) continue;
      const double drawing = processor_milliseconds(CLOCK_PROCESS_CPUTIME_ID);
      renderer_.draw(list, exhibition_->holdings, display_->target(), change);
      glFinish();
      all.draw.push_back(processor_milliseconds(CLOCK_PROCESS_CPUTIME_ID) - drawing);
      shown_.keep(list, change);
    }
    return all;
  }

 private:
  void make_frame(float passed, Measured& all) {
    double began = now();
    const auto lap = [&](std::vector<double>& into) {
      const double end = now();
      into.push_back(1e3 * (end - began));
      began = end;
    };
    exhibition_->guide->step(guide::Seconds{passed});
    if (kiosk::apply_pieces(*exhibition_)) shown_.forget();
    const scene::DrawList& list = exhibition_->guide->draw_list();
    lap(all.step);
    const scene::TextureId changed = kiosk::play_videos(*exhibition_, false).front();
    shown_.forget(changed);
    if (changed != scene::TextureId::None) lap(all.upload);
    began = now();
    ++all.frames;
    const scene::Change change = shown_.change(list, static_cast<float>(full_hd.height));
    has_drawn_bodies_ = false;
    if (change.nothing()) return;
    renderer_.draw(list, exhibition_->holdings, display_->target(), change);
    glFinish();
    shown_.keep(list, change);
    has_drawn_bodies_ = !change.everything && !change.model && change.bodies.any();
    all.bodies += change.bodies.any() ? 1 : 0;
    ++all.drawn;
    all.whole += change.everything ? 1 : 0;
    lap(all.draw);
  }

  std::unique_ptr<headless::HeadlessDisplay> display_;
  gles::Renderer renderer_;
  std::unique_ptr<kiosk::Exhibition> exhibition_;
  scene::ShownList shown_;
  kiosk::TimeForVideo time_;
  bool has_drawn_bodies_ = false;
  KeepsStill when_ = KeepsStill::Never;
};

void tell(const char* name, const Measured& all, double seconds) {
  const auto times = [](const std::vector<double>& of_it) {
    return of_it.empty() ? std::string("-")
                         : fmt::format("{:.1f} / {:.1f}", median(of_it), quantile(of_it, 0.99));
  };
  std::printf("%-11s %8.1f %8.1f %6zu %6zu %6zu %14s %14s %14s %10.2f %8.1f\n", name,
              static_cast<double>(all.frames) / seconds, static_cast<double>(all.drawn) / seconds,
              all.late, all.whole, all.bodies, times(all.step).c_str(), times(all.upload).c_str(),
              times(all.draw).c_str(), all.processors, all.own);
}

int measure(const std::string& database, const std::string& film, double seconds) {
  const MuseumWithFilm museum(database, film);
  Kiosk kiosk(museum.file);
  kiosk.run(1);
  kiosk.touch("begin");
  kiosk.touch("exhibit:" + museum.exhibit);
  for (int second = 0; second < 200 && !kiosk.guide().state().arrived; ++second) kiosk.run(1);
  kiosk.run(3);
  kiosk.play(2);  // what the first frames make

  std::printf("%-11s %8s %8s %6s %6s %6s %14s %14s %14s %10s %8s\n", "1920x1080", "steps/s",
              "drawn/s", "late", "whole", "bodies", "step ms", "upload ms", "draw ms", "processors",
              "own MB");
  tell("idle", kiosk.play(seconds), seconds);
  const Kiosk::Cost idle = kiosk.cost_of(24, 24);
  kiosk.touch("picture:next");
  kiosk.run(1);     // the view comes, and settles
  kiosk.play(0.5);  // all of it is drawn, and the decoder is opened
  const auto tell_video = [&](const char* name) {
    const kiosk::VideoCounters before = kiosk.counters();
    tell(name, kiosk.play(seconds), seconds);
    const kiosk::VideoCounters after = kiosk.counters();
    std::printf("  %.1f frames of the video a second seen, %llu left out (median / 99 %% above)\n",
                static_cast<double>(after.shown - before.shown) / seconds,
                static_cast<unsigned long long>(after.dropped - before.dropped));
  };
  tell_video("guide lives");
  kiosk.spare_videos(Kiosk::KeepsStill::WhereTimeIsShort);
  kiosk.play(2);  // the guide comes to rest, where it has to
  tell_video("as a kiosk");
  kiosk.spare_videos(Kiosk::KeepsStill::Never);
  kiosk.touch("picture:next");
  kiosk.run(0.5);
  kiosk.play(1);  // the exhibit's own picture
  const double own_before = own_megabytes();
  kiosk.touch("picture:next");
  kiosk.run(1);
  kiosk.cost_of(6, 24);
  const kiosk::VideoCounters begun = kiosk.counters();
  const Kiosk::Cost video = kiosk.cost_of(72, 24);
  const kiosk::VideoCounters ended = kiosk.counters();
  kiosk.spare_videos(Kiosk::KeepsStill::Always);
  kiosk.cost_of(36, 24);
  const Kiosk::Cost still = kiosk.cost_of(72, 24);
  const double own_playing = own_megabytes();
  kiosk.touch("picture:next");
  kiosk.run(1);
  kiosk.play(1);
  std::printf(
      "processor time of a frame, 24 a second: idle %.1f ms to draw; with the video %.1f ms to "
      "draw, %.1f ms while the guide keeps still; %.2f ms to upload, %.1f ms to decode\n"
      "own memory: %.1f MB before it plays, %.1f MB while it does, %.1f MB afterwards\n",
      median(idle.draw), median(video.draw), median(still.draw), median(video.upload),
      static_cast<double>((ended.decoding - begun.decoding).count()) / 1e6 /
          std::max(1.0, static_cast<double>(ended.decoded - begun.decoded)),
      own_before, own_playing, own_megabytes());
  return 0;
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  CLI::App app(
      "Does a video play at its frames a second beside the idle screen at 1920 x 1080, on the "
      "processors that this program may use (taskset -c 0,1)?");
  std::string database, film;
  double seconds = 8;
  app.add_option("database", database, "A museum, compiled")->required();
  app.add_option("film", film,
                 "A WebM video that docent-content takes, longer than 3 + 2 times --seconds")
      ->required();
  app.add_option("--seconds", seconds, "Of each picture")->check(CLI::Range(1.0, 28.0));
  CLI11_PARSE(app, argc, argv);
  try {
    return docent::bench::measure(database, film, seconds);
  } catch (const docent::content::ContentError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

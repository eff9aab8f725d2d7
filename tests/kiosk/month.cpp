// Many days of one kiosk: visits, gaps, hotplugs, other sizes of the screen, other databases, heat.
// The guide, its planner, the decoder of the glass, the renderer and the counts are the kiosk's
// own; only the clock is not: a visit is stepped sixty times a second, a gap in one step, and of
// the frames every hundredth is drawn. Says what it saw, and ends with 1 where that is not as it
// should be.
//
// docent_month DB [DAYS [VISITS_A_DAY [DRAWN_EVERY]]]; DAYS may be a fraction. With DRAWN_EVERY 0
// only the visits that are compared are drawn: what the program itself keeps, without its graphics
// driver.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <malloc.h>
#include <unistd.h>

#include "content/write/content_writer.h"
#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "platform/journal/journal.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/guide/guide.h"
#include "runtime/input/contact_decoder.h"
#include "runtime/input/hid_device_kind.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/counts_folder.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/kiosk/frame_watch.h"
#include "runtime/kiosk/heat_watch.h"
#include "runtime/kiosk/visit_counter.h"
#include "runtime/kiosk/visit_player.h"
#include "tests/runtime/input/hid_bytes.h"
#include "tests/support/temporary_folder.h"

using namespace docent;

namespace {

constexpr double frame_seconds = 1.0 / 60;
constexpr double opening_hours = 8;
constexpr PixelSize framebuffer{320, 320};
constexpr std::array<PixelSize, 4> sizes{{framebuffer, {320, 180}, {180, 320}, {256, 144}}};

[[noreturn]] void give_up(const std::string& why) {
  fmt::print(stderr, "month: {}\n", why);
  std::exit(3);
}

template <typename T>
T value_of(Result<T> result) {
  if (!result) give_up(result.error().what);
  return std::move(*result);
}

/// Resident, in MB. `own` is the program's alone; the rest are pages of files (libraries, fonts),
/// which come with the first letter that needs them and which the system takes back as it likes.
struct Memory {
  double own = 0, all = 0;
};

Memory memory() {
  std::ifstream statm("/proc/self/statm");
  double total = 0, resident = 0, of_files = 0;
  statm >> total >> resident >> of_files;
  const double page_mb = static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
  return {.own = (resident - of_files) * page_mb, .all = resident * page_mb};
}

/// Into which of two arenas a thread that reads a museum puts it is chance, and how much of that
/// goes back when it is freed differs by 4 MB: growth is looked for in one. glibc counts when the
/// first thread asks for memory.
void take_one_arena() {
  mallopt(M_ARENA_MAX, 1);
  std::jthread([] { std::free(std::malloc(1 << 16)); });
}

/// A quarter of the values are smaller.
double lower_quartile(std::vector<double> values) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::ranges::nth_element(values, place);
  return *place;
}

/// The program's own memory at the end of each visit, when the glass is nobody's. A single look
/// says little: what is in use goes up and down by 2 MB with the way and the view that were there
/// last, and by more while the next museum is made beside this one. What is kept is what is in use
/// at the quieter times.
class MemoryWatch {
 public:
  /// What was freed is no growth, whether or not the system has it back already.
  void look(double time) {
    kiosk::give_back_freed_memory();
    own_.push_back(memory().own);
    if (time <= first_hour) after_first_hour_ = own_.size();
  }
  bool can_tell() const { return own_.size() >= after_first_hour_ + few; }
  /// In MB, in the last half of the first hour: what a museum takes once it is known.
  double after_first_hour() const { return lower_quartile(last(after_first_hour_, few)); }
  /// In MB, in the last visits, of which there are at most as many as in half a day.
  double at_end() const {
    return lower_quartile(last(own_.size(), std::min(many, own_.size() - after_first_hour_)));
  }

 private:
  std::vector<double> last(std::size_t end, std::size_t count) const {
    const std::size_t begin = end - std::min(count, end);
    return {own_.begin() + static_cast<std::ptrdiff_t>(begin),
            own_.begin() + static_cast<std::ptrdiff_t>(end)};
  }

  static constexpr double first_hour = 3600;
  static constexpr std::size_t few = 24, many = 200;

  std::vector<double> own_;
  std::size_t after_first_hour_ = 0;
};

/// The same museum under another title: what an update brings.
std::filesystem::path another_museum(const std::filesystem::path& database,
                                     const std::filesystem::path& folder) {
  Museum museum = value_of(sqlite::load_museum(database));
  for (auto& [language, title] : museum.title) title += " II";
  std::swap(museum.exhibits.front(), museum.exhibits.back());
  write::write_museum(museum, folder / "other.db");
  return folder / "other.db";
}

interface::ScreenShape shape_of(PixelSize size) {
  interface::ScreenShape shape;
  shape.width = size.width;
  shape.height = size.height;
  return shape;
}

/// How warm the machine is, and the kiosk's own watch over that.
class Heat {
 public:
  Heat() {
    std::filesystem::create_directories(zone_);
    std::ofstream(zone_ / "trip_point_0_type") << "passive\n";
    std::ofstream(zone_ / "trip_point_0_temp") << "85000\n";
    std::ofstream(zone_ / "temp") << "40000\n";
    watch_.emplace(folder_.path(), std::chrono::milliseconds(20));
  }
  void set(bool too_hot) {
    using namespace std::chrono_literals;
    std::ofstream(zone_ / "temp") << (too_hot ? "90000\n" : "40000\n");
    for (int i = 0; watch_->is_too_hot() != too_hot; ++i) {
      if (i == 60000) give_up("nobody watches the temperature");
      std::this_thread::sleep_for(1ms);
    }
  }
  const kiosk::HeatWatch& watch() const { return *watch_; }

 private:
  test::TemporaryFolder folder_;
  std::filesystem::path zone_ = folder_.path() / "thermal_zone0";
  std::optional<kiosk::HeatWatch> watch_;
};

/// The kiosk without main(): one exhibition after the other, on one display with one renderer.
class Kiosk {
 public:
  Kiosk(std::uint64_t drawn_every, const Heat& heat)
      : drawn_every_(drawn_every),
        heat_(heat),
        display_(value_of(headless::open_headless(framebuffer))),
        renderer_(value_of(gles::make_renderer())) {}

  void take_up(const std::filesystem::path& database) {
    exhibition_ = value_of(
        kiosk::load_exhibition(database, kiosk::Selection{},
                               {.shape = shape_of(size_), .idle_reset = guide::Seconds{20}}));
    kiosk::upload(*exhibition_);
    if (frames_ == 0) renderer_.warm_up(display_->target());
    kiosk::prepare_allocator_for(kiosk::Phase::Frames);
    if (counter_) counted_ += kiosk::counts_of(counter_->tally(), counter_->cells());
    counter_.emplace(guide());
    collisions_ += std::exchange(collisions_seen_, 0);
    clock_ = 0;
    view_ = 0;
  }

  guide::Guide& guide() { return *exhibition_->guide; }
  /// Where a visit's touches go.
  kiosk::TakeEvent take() {
    return [this](const input::InputEvent& event) { guide().touch(event); };
  }
  void resize(PixelSize size) { size_ = size; }

  /// One frame, which takes so long; drawn where `drawn` says so, and every hundredth.
  void frame(double seconds, bool drawn = false) {
    const guide::Seconds passed(seconds);
    RenderTarget target = display_->target();
    target.size = size_;
    kiosk::FrameWatch watch;
    guide().resize(shape_of(size_));
    exhibition_->planner->wait();
    const double before = guide().crowd().clock();
    guide().step(passed);
    watch.stepped();
    // Who walks along at twice or four times the pace lets the crowd step as often.
    const double steps = std::round((guide().crowd().clock() - before) / seconds);
    clock_ += (seconds > 0 ? std::max(1.0, steps) : 0) * static_cast<double>(passed.count());
    kiosk::apply_pieces(*exhibition_);
    watch.uploaded();
    const scene::DrawList& list = guide().draw_list();
    watch.listed();
    shown_ += heat_.watch().lets_show(frames_) ? 1 : 0;
    ++frames_;
    const bool seen = drawn || (drawn_every_ > 0 && frames_ % drawn_every_ == 0);
    if (seen) {
      renderer_.draw(list, exhibition_->holdings, target);
      display_->present();
      ++drawn_;
    }
    counter_->follow(guide());
    collisions_seen_ = guide().counters().collisions;
    const std::uint64_t views = guide().counters().views;
    watch.end(seen, views == std::exchange(view_, views), statistics_);
  }

  Pixels picture() {
    frame(0, true);
    Pixels pixels;
    display_->read_back(pixels);
    return pixels;
  }

  /// What was counted since the last call.
  kiosk::DailyCounts counted() {
    kiosk::VisitTally& tally = counter_->tally();
    kiosk::DailyCounts counts = std::exchange(counted_, {});
    counts += kiosk::counts_of(tally, counter_->cells());
    tally.touches = 0;
    std::ranges::fill(tally.visits, 0);
    return counts;
  }

  /// How far the guide's clock is from the sum of its steps: it must not drift.
  double drift() { return std::abs(guide().crowd().clock() - clock_); }
  std::uint64_t frames() const { return frames_; }
  /// Those that a screen would have been given.
  std::uint64_t shown() const { return shown_; }
  std::uint64_t drawn() const { return drawn_; }
  std::uint64_t collisions() const { return collisions_ + collisions_seen_; }
  std::uint64_t allocations() const { return statistics_.allocations_in_frames; }

 private:
  std::uint64_t drawn_every_;
  const Heat& heat_;
  std::unique_ptr<headless::HeadlessDisplay> display_;
  gles::Renderer renderer_;
  std::unique_ptr<kiosk::Exhibition> exhibition_;
  std::optional<kiosk::VisitCounter> counter_;
  kiosk::DailyCounts counted_;
  kiosk::Statistics statistics_;
  PixelSize size_ = framebuffer;
  double clock_ = 0;
  std::uint64_t frames_ = 0, shown_ = 0, drawn_ = 0, view_ = 0, collisions_ = 0,
                collisions_seen_ = 0;
};

/// A touch screen of two fingers, from its reports on.
class Glass {
 public:
  void touch(guide::Guide& guide, std::uint32_t finger, bool down, double x, double y) {
    const auto word = [](double share) { return static_cast<int>(share * 32767); };
    const int at_x = word(x), at_y = word(y);
    send(guide, test::bytes({1, down ? 1 : 0, static_cast<int>(finger), at_x & 255, at_x >> 8,
                             at_y & 255, at_y >> 8, 0, 0, 0, 0, 0, 0, 1}));
  }
  /// It is pulled out, whatever lies on it, and put back.
  void replug(guide::Guide& guide) {
    decoder_.reset();
    tell(guide);
  }

 private:
  static input::ContactDecoder make_decoder() {
    const auto descriptor = input::parse_report_descriptor(
        test::join({test::begin_touch_screen(1), test::finger(), test::finger(),
                    test::contact_count(), test::end_collection()}));
    if (!descriptor) give_up("the touch screen's descriptor is broken");
    return {*descriptor, *input::classify(*descriptor).touch};
  }
  void send(guide::Guide& guide, const std::vector<std::byte>& report) {
    if (decoder_.take(report)) tell(guide);
  }
  void tell(guide::Guide& guide) {
    std::array<input::InputEvent, 2 * input::max_contacts> events;
    const auto now = decoder_.contacts();
    const std::size_t count = input::contact_events(before_, now, events);
    for (const input::InputEvent& event : std::span(events).first(count)) guide.touch(event);
    before_.assign(now.begin(), now.end());
  }

  input::ContactDecoder decoder_ = make_decoder();
  std::vector<input::Contact> before_;
};

/// What a visitor is seen to do, always the same.
struct Reference {
  std::vector<Pixels> pictures;
  double flow_a_second = 0;  ///< Metres, of the way's pattern.
  double walk_seconds = 0;   ///< From the touch to the exhibit.
};

Reference reference_visit(Kiosk& kiosk) {
  constexpr double flow_wraps = 7.2, most_seconds = 90;
  kiosk.resize(framebuffer);
  kiosk::VisitPlayer player(kiosk::parse_visit(
      "1 tap @exhibit:tripod-ding\n7 tap @language:ar\n60 tap @route:offset\n61 tap @home\n", ""));
  Reference seen;
  std::optional<double> flow_at_4;
  for (int i = 0; i * frame_seconds < most_seconds; ++i) {
    const double time = i * frame_seconds;
    if (const auto played = player.play(time, kiosk.guide(), kiosk.take()); !played)
      give_up(played.error().what);
    kiosk.frame(frame_seconds);
    if (seen.walk_seconds == 0 && kiosk.guide().state().arrived) seen.walk_seconds = time - 1;
    const auto& ribbons = kiosk.guide().draw_list().ribbons;
    if (i == 240 && !ribbons.empty()) flow_at_4 = ribbons.front().flow;
    if (i == 300 && !ribbons.empty() && flow_at_4)
      seen.flow_a_second = std::fmod(ribbons.front().flow - *flow_at_4 + flow_wraps, flow_wraps);
    if (i % 600 == 599) seen.pictures.push_back(kiosk.picture());
  }
  return seen;
}

struct Doings {
  std::uint64_t visits = 0, unreached = 0, hotplugs = 0, resizes = 0, take_ups = 0;
};

/// What a visitor of a machine that is too hot is shown.
struct HotVisits {
  std::uint64_t visits = 0, frames = 0, shown = 0;
};

class Month {
 public:
  Month(std::filesystem::path database, double days, int visits_a_day, std::uint64_t drawn_every)
      : databases_{database, another_museum(database, folder_.path())},
        days_(days),
        gap_(opening_hours * 3600 / visits_a_day),
        kiosk_(drawn_every, heat_) {
    kiosk_.take_up(databases_[0]);
  }

  bool run() {
    const Reference first = reference_visit(kiosk_);
    const Reference second = fresh_reference();
    const double end = days_ * 86400;
    for (next_take_up_ = 3600; time_ < end;) {
      if (one_in(20))
        hot_visit();
      else
        visit();
      memory_.look(time_);
      if (time_ >= next_take_up_) update();
      if (time_ >= next_hour_) tell_hour();
      if (std::fmod(time_, 86400) > opening_hours * 3600) night();
    }
    const double drift = kiosk_.drift();
    for (int i = 0; i < 1200; ++i) kiosk_.frame(0.1);  // whoever led the last visitor walks home
    const Reference old = reference_visit(kiosk_);     // of the guide that has been there for long
    const Reference last = fresh_reference();
    return judge(first, second, old, last, drift);
  }

 private:
  Reference fresh_reference() {
    kiosk_.take_up(databases_[0]);
    return reference_visit(kiosk_);
  }

  int below(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }
  double share() { return std::uniform_real_distribution(0.0, 1.0)(random_); }
  bool one_in(int count) { return below(count) == 0; }

  /// A name that a visitor could touch: mostly exhibits.
  std::string some_name() {
    const Museum& museum = kiosk_.guide().museum();
    const auto of = [&](const auto& all) {
      return static_cast<std::size_t>(below(static_cast<int>(all.size())));
    };
    switch (below(8)) {
      case 0:
        return "language:" + museum.languages[of(museum.languages)].tag;
      case 1:
        return fmt::format("route:{}", route_kinds[of(route_kinds)].name);
      case 2:
        return "home";
      default:
        return "exhibit:" + museum.exhibits[of(museum.exhibits)].id;
    }
  }

  /// A visit begins with a touch, goes on at random and is left in the middle, or by the button.
  kiosk::Visit some_visit(double seconds) {
    std::string text = fmt::format("0 tap {:.3f} {:.3f}\n", share(), share());
    for (double at = 2; at < seconds; at += 2 + 6 * share()) {
      if (one_in(3))
        text += fmt::format("{:.2f} tap {:.3f} {:.3f}\n", at, share(), share());
      else if (one_in(6))
        text += fmt::format("{:.2f} key {}\n", at, one_in(2) ? "DOWN" : "ENTER");
      else
        text += fmt::format("{:.2f} tap @{}\n", at, some_name());
    }
    kiosk::Visit visit = kiosk::parse_visit(text, "visit");
    if (!visit.mistakes.empty()) give_up(visit.mistakes.front().message + " in\n" + text);
    return visit;
  }

  void scribble() {
    if (!one_in(40)) return;
    glass_.touch(kiosk_.guide(), static_cast<std::uint32_t>(below(2)), !one_in(3), share(),
                 share());
    if (!one_in(50)) return;
    glass_.replug(kiosk_.guide());
    ++doings_.hotplugs;
  }

  void hot_visit() {
    heat_.set(true);
    const std::uint64_t frames = kiosk_.frames(), shown = kiosk_.shown();
    visit();
    hot_.frames += kiosk_.frames() - frames;
    hot_.shown += kiosk_.shown() - shown;
    ++hot_.visits;
    heat_.set(false);
  }

  void visit() {
    if (one_in(20)) {
      kiosk_.resize(sizes[static_cast<std::size_t>(below(sizes.size()))]);
      ++doings_.resizes;
    }
    ++doings_.visits;
    const double seconds = 5 + 25 * share();
    const bool scribbles = one_in(5);
    kiosk::VisitPlayer player(some_visit(seconds));
    double at = 0;
    for (; at < seconds; at += frame_seconds) {
      if (scribbles) scribble();
      if (!player.play(at, kiosk_.guide(), kiosk_.take())) {  // it was scribbled away from
        ++doings_.unreached;
        break;
      }
      kiosk_.frame(frame_seconds);
    }
    glass_.replug(kiosk_.guide());
    // Whoever leaves lifts all their fingers; ten frames a second are enough for nobody.
    for (int i = 0; i < 60 && !player.is_over(); ++i, at += frame_seconds)
      if (player.play(at, kiosk_.guide(), kiosk_.take())) kiosk_.frame(frame_seconds);
    at += empty_the_glass();
    time_ += at;
    wait_for(gap_ * (0.5 + share()) - at);
  }

  /// Nobody touches the glass again: who left is noticed a minute after the guide stands and what
  /// is read aloud has ended, however long it still walks, rides and waits for a lift. In seconds.
  double empty_the_glass() {
    constexpr double longest_walk = 1800, notices_after = 60 + 6;
    double seconds = 0;
    for (double stood = 0; !kiosk_.guide().is_vacant(); seconds += 0.1) {
      const bool rests =
          guide::stands(kiosk_.guide().crowd()[0].avatar) && !kiosk_.guide().voice().is_busy();
      stood = rests ? stood + 0.1 : 0;
      if (stood > notices_after || seconds > longest_walk) {
        ++never_vacant_;
        break;
      }
      kiosk_.frame(0.1);
    }
    longest_leave_ = std::max(longest_leave_, seconds);
    return seconds;
  }

  /// Nobody is there: the clock alone goes on.
  void wait_for(double seconds) {
    if (seconds <= 0) return;
    kiosk_.frame(seconds);
    time_ += seconds;
  }

  void tell_hour() {
    const Memory now = memory();
    fmt::print("{:5.0f} h: {} visits, {} frames, {:.1f} MB of its own, {:.1f} with files\n",
               time_ / 3600, doings_.visits, kiosk_.frames(), now.own, now.all);
    std::fflush(stdout);
    next_hour_ = time_ + 3600;
  }

  void night() {
    const double today = std::floor(time_ / 86400);
    std::string day = fmt::format("2026-11-{:02}", 1 + static_cast<int>(today) % 30);
    if (const auto taken = counts_.take(day, kiosk_.counted()); !taken) give_up(taken.error().what);
    for (const double morning = 86400 * (today + 1); time_ < morning;)
      wait_for(std::min(3600.0, morning - time_));
  }

  /// Often after the first hour, then rarely: the last guide is to grow old.
  void update() {
    kiosk_.take_up(databases_[++doings_.take_ups % 2]);
    next_take_up_ = time_ * 1.5;
  }

  bool judge(const Reference& first, const Reference& second, const Reference& old,
             const Reference& last, double drift) const;

  test::TemporaryFolder folder_;
  std::array<std::filesystem::path, 2> databases_;
  double days_, gap_;
  Heat heat_;
  Kiosk kiosk_;
  Glass glass_;
  kiosk::CountsFolder counts_{folder_.path()};
  std::mt19937 random_{20261123};
  double time_ = 0, next_take_up_ = 0, next_hour_ = 3600;
  MemoryWatch memory_;
  Doings doings_;
  HotVisits hot_;
  std::uint64_t never_vacant_ = 0;
  double longest_leave_ = 0;
};

/// Says whether something holds.
class Verdict {
 public:
  void expect(bool is_so, const std::string& what) {
    fmt::print("{}: {}\n", is_so ? "ok  " : "FAIL", what);
    all_ = all_ && is_so;
  }
  bool all() const { return all_; }

 private:
  bool all_ = true;
};

std::size_t unlike(const Reference& one, const Reference& other) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(one.pictures.size(), other.pictures.size()); ++i)
    count += one.pictures[i].rgba == other.pictures[i].rgba ? 0 : 1;
  return count;
}

bool Month::judge(const Reference& first, const Reference& second, const Reference& old,
                  const Reference& last, double drift) const {
  fmt::print(
      "{:.2f} days: {} visits, {} frames ({} drawn), {} databases taken up, {} hotplugs, {} other "
      "sizes, {} visits scribbled away\n",
      time_ / 86400, doings_.visits, kiosk_.frames(), kiosk_.drawn(), doings_.take_ups,
      doings_.hotplugs, doings_.resizes, doings_.unreached);
  Verdict verdict;
  verdict.expect(unlike(first, second) == 0, "the same visit twice shows the same frames");
  verdict.expect(unlike(first, last) == 0, "the same visit at the end shows the same frames");
  verdict.expect(std::abs(old.flow_a_second - 0.35) < 0.001 && first.flow_a_second > 0,
                 fmt::format("an old guide's way flows {:.4f} m a second, a new one's {:.4f}",
                             old.flow_a_second, first.flow_a_second));
  verdict.expect(std::abs(old.walk_seconds - first.walk_seconds) < 1 && first.walk_seconds > 0,
                 fmt::format("an old guide walks for {:.2f} s, a new one for {:.2f}",
                             old.walk_seconds, first.walk_seconds));
  verdict.expect(drift < 1e-6, fmt::format("the guide's clock is off by {:.1e} s", drift));
  verdict.expect(kiosk_.allocations() == 0,
                 fmt::format("{} allocations in frames", kiosk_.allocations()));
  verdict.expect(never_vacant_ == 0,
                 fmt::format("{} visitors left a screen that did not notice, which it did after at "
                             "most {:.0f} s",
                             never_vacant_, longest_leave_));
  verdict.expect(kiosk_.collisions() == 0, fmt::format("{} collisions", kiosk_.collisions()));
  const bool was_said = journal::last_problem().contains("too hot");
  const auto of_60 = [](std::uint64_t shown, std::uint64_t all) {
    return 60 * static_cast<double>(shown) / static_cast<double>(std::max<std::uint64_t>(all, 1));
  };
  const double when_hot = of_60(hot_.shown, hot_.frames);
  const double else_shown = of_60(kiosk_.shown() - hot_.shown, kiosk_.frames() - hot_.frames);
  if (hot_.visits > 0)
    verdict.expect(
        was_said && std::abs(when_hot - 30) < 0.1 && else_shown == 60,
        fmt::format("{} visits in the heat, which {}: {:.1f} frames a second, else {}", hot_.visits,
                    was_said ? "the journal told" : "nobody told", when_hot, else_shown));
  if (memory_.can_tell())
    verdict.expect(memory_.at_end() - memory_.after_first_hour() <= 1,
                   fmt::format("{:.1f} MB of its own after the first hour, {:.1f} at the end",
                               memory_.after_first_hour(), memory_.at_end()));
  return verdict.all();
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2 || count > 5) {
    fmt::print(stderr, "usage: docent_month DB [DAYS [VISITS_A_DAY [DRAWN_EVERY]]]\n");
    return 2;
  }
  kiosk::prepare_allocator_for(kiosk::Phase::Start);
  take_one_arena();
  const double days = count > 2 ? std::strtod(arguments[2], nullptr) : 30;
  const int visits = count > 3 ? std::atoi(arguments[3]) : 400;
  if (!(days > 0) || visits < 1) return 2;
  const int drawn_every = count > 4 ? std::atoi(arguments[4]) : 100;
  if (drawn_every < 0) return 2;
  return Month(arguments[1], days, visits, static_cast<std::uint64_t>(drawn_every)).run() ? 0 : 1;
}

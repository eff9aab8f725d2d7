#include "runtime/kiosk/reporter.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <system_error>
#include <utility>

#include "platform/file/read_file.h"
#include "platform/journal/journal.h"
#include "runtime/interface/control.h"
#include "runtime/model/last_catch.h"

namespace docent::kiosk {
namespace {

constexpr std::chrono::seconds write_every{15};
constexpr std::size_t largest_text = std::size_t{1} << 20U;

double since_1970(std::chrono::system_clock::time_point time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}
double now() {
  return since_1970(std::chrono::system_clock::now());
}

double written_at(const std::filesystem::path& file) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  return error ? 0 : since_1970(std::chrono::file_clock::to_sys(time));
}

std::optional<double> free_bytes_beside(const std::filesystem::path& file) {
  std::error_code error;
  const auto space = std::filesystem::space(file, error);
  return error ? std::nullopt : std::optional(static_cast<double>(space.available));
}

void clear(VisitTally& tally) noexcept {
  tally.touches = 0;
  std::ranges::fill(tally.visits, 0);
}

}  // namespace

Reporter::Reporter(const Places& places) : places_(places), started_(now()) {
  if (const auto before = file::read_file(places_.health, largest_text))
    starts_ = starts_told_in(*before) + 1;
  if (!places_.counts.empty()) folder_.emplace(places_.counts);
  thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

Reporter::~Reporter() {
  if (counting_) {
    const std::lock_guard lock(mutex_);
    hand_over();
  }
  thread_.request_stop();
}

void Reporter::shows(const guide::Guide& guide) {
  VisitCounter counting(guide);
  const double content_time = written_at(places_.database);
  const std::lock_guard lock(mutex_);
  if (counting_) hand_over();
  of_others_ += counts_of(handed_over_, cells_);
  cells_ = counting.cells();
  handed_over_ = counting.tally();
  museum_ = interface::in_language(guide.museum(), 0, guide.museum().title);
  content_time_ = content_time;
  counting_.emplace(std::move(counting));
}

void Reporter::refused(Errc error) noexcept {
  refused_.fetch_add(1, std::memory_order_relaxed);
  const std::lock_guard lock(mutex_);
  last_error_ = error;
}

void Reporter::frame_made(const guide::Guide& guide, std::uint64_t dropped_frames) noexcept {
  frames_.fetch_add(1, std::memory_order_relaxed);
  dropped_frames_.store(dropped_frames, std::memory_order_relaxed);
  last_frame_.store(now(), std::memory_order_relaxed);
  if (!counting_) return;
  counting_->follow(guide);
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock.owns_lock()) hand_over();
}

void Reporter::hand_over() noexcept {
  VisitTally& tally = counting_->tally();
  handed_over_.touches += tally.touches;
  for (std::size_t i = 0; i < tally.visits.size(); ++i) handed_over_.visits[i] += tally.visits[i];
  clear(tally);
}

/// All that was handed over since the last call.
DailyCounts Reporter::counted() {
  const std::lock_guard lock(mutex_);
  DailyCounts counts = std::exchange(of_others_, {});
  counts += counts_of(handed_over_, cells_);
  clear(handed_over_);
  return counts;
}

Health Reporter::health() {
  Health health{.starts = starts_,
                .frames = frames_,
                .dropped_frames = dropped_frames_,
                .refused_databases = refused_,
                .started = started_,
                .last_frame = last_frame_,
                .museum = {},
                .content_time = 0,
                .last_error = {},
                .free_bytes = free_bytes_beside(places_.database),
                .temperature = hottest_sensor()};
  const std::lock_guard lock(mutex_);
  health.museum = museum_;
  health.content_time = content_time_;
  health.last_error = last_error_;
  return health;
}

void Reporter::write(bool is_up) {
  Result<void> written;
  if (folder_) written = folder_->take(today(), counted());
  if (!places_.health.empty()) {
    Health now_doing = health();
    now_doing.is_up = is_up;
    const Result<void> told = replace_text(
        places_.health, to_prometheus(now_doing, folder_ ? folder_->last_day() : std::nullopt),
        Readers::Everybody);
    if (!told) written = told;
  }
  const std::string complaint = written ? std::string() : written.error().what;
  if (!complaint.empty() && complaint != said_)
    journal::tell(journal::Message::ReportUnwritten, complaint);
  said_ = complaint;
}

void Reporter::work(const std::stop_token& stop) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any stopped;
  while (!stop.stop_requested()) {
    guarded("telling how the kiosk is doing", [&] { write(true); });
    stopped.wait_for(lock, stop, write_every, [] { return false; });
  }
  guarded("telling how the kiosk is doing", [&] { write(false); });
}

}  // namespace docent::kiosk

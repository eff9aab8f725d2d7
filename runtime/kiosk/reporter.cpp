#include "runtime/kiosk/reporter.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <utility>

#include "platform/file/read_file.h"
#include "platform/journal/journal.h"
#include "runtime/kiosk/health.h"
#include "runtime/model/last_catch.h"

namespace docent::kiosk {
namespace {

constexpr std::chrono::seconds write_every{15};
constexpr std::size_t largest_text = std::size_t{1} << 20U;

void clear(VisitTally& tally) noexcept {
  tally.touches = 0;
  std::ranges::fill(tally.visits, 0);
}

}  // namespace

Reporter::Reporter(const Places& places, StatusBoard& board) : places_(places), board_(board) {
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
  const std::lock_guard lock(mutex_);
  if (counting_) hand_over();
  of_others_ += counts_of(handed_over_, cells_);
  cells_ = counting.cells();
  handed_over_ = counting.tally();
  counting_.emplace(std::move(counting));
}

void Reporter::frame_made(const guide::Guide& guide) noexcept {
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

void Reporter::write(bool is_up) {
  Result<void> written;
  if (folder_) written = folder_->take(today(), counted());
  if (!places_.health.empty()) {
    const Health now_doing{.status = board_.read(),
                           .is_up = is_up,
                           .starts = starts_,
                           .temperature = hottest_sensor()};
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

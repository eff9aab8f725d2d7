#include "runtime/kiosk/today_watch.h"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <system_error>
#include <utility>

#include "config/today.h"
#include "platform/journal/journal.h"
#include "runtime/model/last_catch.h"

namespace docent::kiosk {
namespace {

namespace chr = std::chrono;

constexpr chr::milliseconds between_looks{250};

/// The minute on the kiosk's own clock.
::docent::LocalMinute minute_here() noexcept {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return chr::local_days(chr::year(local.tm_year + 1900) /
                         chr::month(static_cast<unsigned>(local.tm_mon) + 1) /
                         chr::day(static_cast<unsigned>(local.tm_mday))) +
         chr::hours(local.tm_hour) + chr::minutes(local.tm_min);
}

void refuse(const Diagnostic& first) {
  journal::tell(journal::Message::TodayRefused,
                fmt::format("{}:{}: {}; what was closed before stays closed", first.file,
                            first.line, first.message));
}

}  // namespace

TodayWatch::TodayWatch(const Museum& museum, Close close, std::filesystem::path file,
                       bool is_simulated)
    : museum_(museum),
      close_(std::move(close)),
      file_(std::move(file)),
      is_simulated_(is_simulated),
      rules_(museum),
      zone_(parse_time_zone(museum.time_zone)),
      closed_(rules_.at({}, {})) {
  close_(closed_);
  look();
  if (!is_simulated_) thread_ = std::thread([this] { watch(); });
}

TodayWatch::~TodayWatch() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

TodayWatch::Stamp TodayWatch::stamp_of(const std::filesystem::path& file) {
  std::error_code failed;
  Stamp stamp{.written = std::filesystem::last_write_time(file, failed)};
  if (failed) return {};
  stamp.size = std::filesystem::file_size(file, failed);
  stamp.is_there = !failed;
  return failed ? Stamp{} : stamp;
}

void TodayWatch::watch() {
  std::unique_lock lock(mutex_);
  while (!stop_) {
    wake_.wait_for(lock, between_looks, [this] { return stop_; });
    if (stop_) return;
    lock.unlock();
    guarded("looking what is closed", [this] { look(); });
    lock.lock();
  }
}

void TodayWatch::look() {
  const std::lock_guard lock(mutex_);
  if (file_.empty()) return close_what_is_closed();
  const Stamp stamp = stamp_of(file_);
  if (stamp != stamp_) {
    stamp_ = stamp;
    if (stamp.is_there)
      read(file_);
    else
      today_ = {};
  }
  close_what_is_closed();
}

void TodayWatch::take_up(const std::filesystem::path& file) {
  const std::lock_guard lock(mutex_);
  read(file);
  close_what_is_closed();
}

void TodayWatch::read(const std::filesystem::path& file) {
  config::Loaded<Today> loaded = config::load_today(file, museum_);
  if (!loaded.value) return refuse(loaded.diagnostics.front());
  today_ = std::move(*loaded.value);
  journal::tell(
      journal::Message::TodayTakenUp,
      fmt::format("{}: {} closed", file.string(),
                  today_.closed.empty() ? std::string("nothing is")
                                        : fmt::format("{} entries are", today_.closed.size())));
}

std::optional<::docent::LocalMinute> TodayWatch::now() const {
  if (is_simulated_) return {};
  if (!zone_) return minute_here();
  return ::docent::local_minute(*zone_, chr::floor<chr::seconds>(chr::system_clock::now()));
}

void TodayWatch::close_what_is_closed() {
  Closures closures = rules_.at(now(), today_);
  if (closures == closed_) return;
  closed_ = std::move(closures);
  close_(closed_);
  changes_.fetch_add(1, std::memory_order_release);
}

}  // namespace docent::kiosk

#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "runtime/model/closures.h"
#include "runtime/model/hours/time_zone.h"

namespace docent::kiosk {

/// What is closed just now: today.toml, and the hours of the museum. A thread looks four times a
/// second whether either has changed, makes what is closed ready and tells the building, so that no
/// frame waits for it. A file in which anything is wrong is refused with a sentence, and the last
/// good one stays; one that is not there closes nothing.
///
/// In a simulated run there is no thread and no clock: what hours close is open, and the file is
/// read when the run begins and when a visit says so.
class TodayWatch {
 public:
  /// Told what is closed whenever that has changed: by the constructor, by take_up() and by the
  /// thread, one at a time.
  using Close = std::function<void(const Closures&)>;

  /// Borrows the museum.
  TodayWatch(const Museum& museum, Close close, std::filesystem::path file, bool is_simulated);
  ~TodayWatch();
  TodayWatch(const TodayWatch&) = delete;
  TodayWatch& operator=(const TodayWatch&) = delete;

  /// Takes that file up as today.toml. Reads it at once.
  void take_up(const std::filesystem::path& file);

  /// How often what is closed has changed. Any thread; for the frame, which then lets those who are
  /// under way ask anew.
  std::uint64_t changes() const noexcept { return changes_.load(std::memory_order_acquire); }

 private:
  /// By what a file is known to have been replaced.
  struct Stamp {
    std::filesystem::file_time_type written{};
    std::uintmax_t size = 0;
    bool is_there = false;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  static Stamp stamp_of(const std::filesystem::path& file);

  void watch();
  void look();
  void read(const std::filesystem::path& file);
  void close_what_is_closed();
  std::optional<::docent::LocalMinute> now() const;

  const Museum& museum_;
  const Close close_;
  const std::filesystem::path file_;
  const bool is_simulated_;
  ClosureRules rules_;
  std::optional<TimeZone> zone_;  ///< Of the museum; none: the kiosk's own.
  std::atomic<std::uint64_t> changes_{0};
  std::mutex mutex_;  ///< Of what follows.
  Stamp stamp_;
  Today today_;
  Closures closed_;
  bool stop_ = false;
  std::condition_variable wake_;
  std::thread thread_;  ///< Last: it uses all of the above.
};

}  // namespace docent::kiosk

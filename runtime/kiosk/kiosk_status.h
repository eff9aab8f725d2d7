#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/result.h"
#include "runtime/plan/triple_buffer.h"

namespace docent::kiosk {

/// Which database is shown.
struct ContentFacts {
  std::filesystem::path path;
  std::string museum{};    ///< Its title in its first language.
  std::string checksum{};  ///< Of the whole database, in hexadecimal.
  std::uint32_t schema = 0;
  std::string signature = "none";  ///< Whose key signed it.
  double written = 0;              ///< When its file was.
};

/// What the frame loop counts.
struct StatusCounts {
  std::uint64_t frames = 0, dropped_frames = 0, touches = 0, routes = 0;
  std::uint64_t visits = 0;  ///< How often somebody began while nobody was being guided.
  double last_frame = 0;
};

/// Databases that were not taken up.
struct Refusals {
  std::uint64_t count = 0;
  std::optional<Errc> last;
};

/// An input device as it is now.
struct DeviceFacts {
  std::string path, name, kind;
  bool is_used = false;
};

/// How a running kiosk is: what `docent status` and the health file tell of. Times are seconds
/// since 1970.
struct KioskStatus {
  std::string version;
  double started = 0;
  double uptime_seconds = 0;
  std::optional<std::uint64_t> restarts;  ///< Since the machine or an operator started it.
  std::string display;
  ContentFacts content;
  StatusCounts counts;
  Refusals refusals;
  std::vector<DeviceFacts> devices;
  std::string last_error;
  std::optional<double> free_bytes;  ///< Where the database lies.
};

/// One object, as docent(1) lists its keys. Keys are added, never changed.
std::string to_json(const KioskStatus& status);
/// A line for each, for people.
std::string to_text(const KioskStatus& status);

/// The devices of visitors that are plugged in now. Looks at all of them.
std::vector<DeviceFacts> devices_now();

/// Where the frame loop leaves how it is, and other threads find it.
class StatusBoard {
 public:
  StatusBoard(std::chrono::nanoseconds started, std::string display);

  /// The frame thread, as often as it likes: neither waits nor allocates.
  void counts(const StatusCounts& counts) noexcept { counts_.put(counts); }
  /// The frame thread, between frames: a database was taken up, or was not.
  void shows(ContentFacts content);
  void refused(Errc why);

  /// How the kiosk is now, but for its devices. Any other thread; looks at the disk.
  KioskStatus read();

 private:
  std::chrono::nanoseconds begun_;  ///< Of the monotonic clock.
  double started_;
  std::string display_;
  std::optional<std::uint64_t> restarts_;
  plan::TripleBuffer<StatusCounts> counts_;
  std::mutex reading_;        ///< One reader after the other.
  StatusCounts last_counts_;  ///< The readers'.
  std::mutex mutex_;          ///< Of what follows.
  ContentFacts content_;
  Refusals refusals_;
};

/// Seconds since 1970.
double time_now();

/// Where the running kiosk is asked: in the folder that the service manager makes for it
/// (RUNTIME_DIRECTORY), else in that of the user (XDG_RUNTIME_DIR); empty where there is neither.
std::filesystem::path status_socket();

/// Counts the starts of the service in a file of its runtime folder, which the manager removes when
/// it is stopped; how many there were before this one. Empty where there is no such folder.
std::optional<std::uint64_t> count_start(const char* runtime_directory);

}  // namespace docent::kiosk

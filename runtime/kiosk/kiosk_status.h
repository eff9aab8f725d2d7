#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/plan/triple_buffer.h"

namespace docent::kiosk {

/// Which database is shown.
struct ContentFacts {
  std::filesystem::path path;
  std::string museum{};    ///< Its title in its first language.
  std::string checksum{};  ///< Of the whole database, in hexadecimal.
  std::uint32_t schema = 0;
  std::string signature = "none";  ///< Whose key signed it.
};

/// What the frame loop counts.
struct StatusCounts {
  std::uint64_t frames = 0, dropped_frames = 0, touches = 0, routes = 0;
  std::uint64_t visits = 0;  ///< How often somebody began while nobody was being guided.
};

/// An input device as it is now.
struct DeviceFacts {
  std::string path, name, kind;
  bool is_used = false;
};

/// How a running kiosk is: the answer of `docent status`.
struct KioskStatus {
  std::string version;
  double uptime_seconds = 0;
  std::optional<std::uint64_t> restarts;  ///< Since the machine or an operator started it.
  std::string display;
  ContentFacts content;
  StatusCounts counts;
  std::vector<DeviceFacts> devices;
  std::string last_error;
  std::uint64_t free_bytes = 0;  ///< Where the database lies.
};

/// One object, as docent(1) lists its keys. Keys are added, never changed.
std::string to_json(const KioskStatus& status);
/// A line for each, for people.
std::string to_text(const KioskStatus& status);

/// Where the frame loop leaves how it is, and another thread finds it.
class StatusBoard {
 public:
  StatusBoard(std::chrono::nanoseconds started, std::string display);

  /// The frame thread, as often as it likes: neither waits nor allocates.
  void counts(const StatusCounts& counts) noexcept { counts_.put(counts); }
  /// The frame thread, when a database is taken up.
  void shows(ContentFacts content);

  /// How the kiosk is now. One other thread; looks at the devices and the disk too.
  KioskStatus read();

 private:
  std::chrono::nanoseconds started_;
  std::string display_;
  std::optional<std::uint64_t> restarts_;
  plan::TripleBuffer<StatusCounts> counts_;
  StatusCounts last_counts_;  ///< The reader's.
  std::mutex mutex_;          ///< Of `content_`.
  ContentFacts content_;
};

/// Where the running kiosk is asked: in the folder that the service manager makes for it
/// (RUNTIME_DIRECTORY), else in that of the user (XDG_RUNTIME_DIR); empty where there is neither.
std::filesystem::path status_socket();

/// Counts the starts of the service in a file of its runtime folder, which the manager removes when
/// it is stopped; how many there were before this one. Empty where there is no such folder.
std::optional<std::uint64_t> count_start(const char* runtime_directory);

}  // namespace docent::kiosk

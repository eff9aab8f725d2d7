#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "runtime/guide/guide.h"
#include "runtime/kiosk/counts_folder.h"
#include "runtime/kiosk/kiosk_status.h"
#include "runtime/kiosk/visit_counter.h"

namespace docent::kiosk {

/// Tells those who watch over a kiosk how it is doing, and keeps its anonymous counts. A thread of
/// its own reads the board and writes the files; the frame thread leaves it what it counted, and
/// never waits for it.
class Reporter {
 public:
  struct Places {
    std::filesystem::path health;  ///< node_exporter's text file; empty: none.
    std::filesystem::path counts;  ///< The folder of counts; empty: none are kept.
  };

  /// `board` outlives it.
  Reporter(const Places& places, StatusBoard& board);
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;
  /// Writes for the last time. A visit under way is not counted.
  ~Reporter();

  /// The museum of this guide is on the screen from now on. Between frames: allocates.
  void shows(const guide::Guide& guide);
  /// After each frame. Does not allocate, nor wait.
  void frame_made(const guide::Guide& guide) noexcept;

 private:
  void hand_over() noexcept;
  /// `is_up`: the kiosk goes on.
  void write(bool is_up);
  void work(const std::stop_token& stop);
  DailyCounts counted();

  Places places_;
  StatusBoard& board_;
  std::uint64_t starts_ = 1;
  std::optional<CountsFolder> folder_;    ///< Of the writing thread, as is `said_`.
  std::string said_;                      ///< The last complaint: the journal is told once.
  std::optional<VisitCounter> counting_;  ///< Of the frame thread.

  std::mutex mutex_;  ///< Of what follows. The frame thread takes it only where it is free.
  VisitTally handed_over_;
  std::vector<CountedCell> cells_;
  DailyCounts of_others_;  ///< Of museums that were on the screen before.
  std::jthread thread_;
};

}  // namespace docent::kiosk

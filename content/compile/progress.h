#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace docent::compile {

/// What a compilation is doing. A terminal sees a bar with the stage's name and the time left, a
/// log one line a stage. Any thread may start and finish stages.
class Progress {
 public:
  enum class Output { Bar, Lines, Nothing };

  /// How long a stage took.
  struct Stage {
    std::string name;
    double seconds = 0;
  };

  explicit Progress(Output output);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Announces a stage and about how much work it is, compared with the others.
  void plan(std::string_view stage, double work);

  /// A stage that is under way; it is finished when this goes.
  class Running {
   public:
    Running(Progress& progress, std::size_t stage) : progress_(progress), stage_(stage) {}
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() { progress_.finish(stage_); }

   private:
    Progress& progress_;
    std::size_t stage_;
  };

  /// Starts a stage that was planned; a stage may be started again, and its times add up.
  [[nodiscard]] Running start(std::string_view stage);

  /// Takes the bar off the terminal, for what is to be said meanwhile; the next stage draws it
  /// anew.
  void clear();

  /// Seconds since this was made.
  [[nodiscard]] double seconds() const;

  /// The stages that were run, in the order in which they were planned.
  [[nodiscard]] std::vector<Stage> stages() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Entry {
    std::string name;
    double work = 1;
    enum class State : std::uint8_t { Planned, Running, Done } state = State::Planned;
    Clock::time_point begin{};
    double seconds = 0;
  };

  void finish(std::size_t stage);
  void draw_bar();
  void erase_bar();

  mutable std::mutex mutex_;
  Output output_;
  Clock::time_point begin_ = Clock::now();
  std::vector<Entry> entries_;
};

/// The way to show progress where standard error leads.
Progress::Output progress_output(bool quiet);

}  // namespace docent::compile

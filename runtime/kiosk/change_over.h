#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>

#include "runtime/interface/layout.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// Makes a new exhibition ready beside the one that is shown, so that changing to it takes no
/// longer than any frame: a thread reads it, and between frames its pictures and buildings are
/// carried into texture memory, a few at a time, and its guide sets its first view. The exhibition
/// before it is taken apart on a thread as well.
///
/// For the frame thread, between frames.
class ChangeOver {
 public:
  using Load = std::function<Result<std::unique_ptr<Exhibition>>()>;
  enum class State : std::uint8_t {
    Idle,
    Reading,
    Preparing,
    Ready,   ///< take() gives the exhibition.
    Refused  ///< take() gives the reason.
  };

  /// How long a step may take: a quarter of a frame, within these bounds. A machine that draws
  /// slowly has slower frames, and as many of them.
  struct Pace {
    std::chrono::nanoseconds least = std::chrono::milliseconds(4);
    std::chrono::nanoseconds most = std::chrono::milliseconds(250);
  };

  /// `repeats_exactly`: a simulated run, which waits for what is read and prepares it in one step.
  explicit ChangeOver(bool repeats_exactly) noexcept : ChangeOver(repeats_exactly, Pace{}) {}
  ChangeOver(bool repeats_exactly, Pace pace) noexcept
      : repeats_exactly_(repeats_exactly), pace_(pace) {}

  State state() const noexcept { return state_; }
  /// Begins to read, on a thread. `time`: now, in seconds. State: Idle.
  void begin(Load load, double time);
  /// One step, as long as its pace allows and one picture or megabyte more. `shape`: of the
  /// screen.
  void step(const interface::ScreenShape& shape);
  /// Is what is ready to be shown now? While nobody is in the middle of something; somebody always
  /// may be, so five minutes after it was asked for in any case.
  bool is_due(bool is_vacant, double time) const noexcept;
  /// State: Ready or Refused; Idle afterwards.
  Result<std::unique_ptr<Exhibition>> take();
  /// Takes apart what is shown no more.
  void retire(std::unique_ptr<Exhibition> old);

 private:
  void take_what_was_read();
  void prepare(const interface::ScreenShape& shape, std::chrono::nanoseconds most);

  bool repeats_exactly_;
  Pace pace_;
  State state_ = State::Idle;
  double begun_ = 0;
  std::future<Result<std::unique_ptr<Exhibition>>> reading_;
  Result<std::unique_ptr<Exhibition>> next_;
  int rehearsals_ = 0;                  ///< Steps of the next guide.
  std::chrono::nanoseconds stepped_{};  ///< When the last step was.
  std::future<void> retiring_;
};

}  // namespace docent::kiosk

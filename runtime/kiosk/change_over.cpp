#include "runtime/kiosk/change_over.h"

#include <algorithm>
#include <utility>

#include "platform/clock/monotonic_clock.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/model/last_catch.h"

namespace docent::kiosk {
namespace {

constexpr double longest_wait = 300;  // seconds
/// A guide that has not set its first view after so many frames sets it on the screen.
constexpr int most_rehearsals = 600;

bool is_done(const std::future<Result<std::unique_ptr<Exhibition>>>& reading) {
  return reading.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

void ChangeOver::begin(Load load, double time) {
  begun_ = time;
  state_ = State::Reading;
  reading_ = std::async(std::launch::async,
                        [load = std::move(load), before = std::move(retiring_)]() mutable {
                          if (before.valid()) before.get();
                          return load();
                        });
}

void ChangeOver::step(const interface::ScreenShape& shape) {
  if (state_ == State::Reading && (repeats_exactly_ || is_done(reading_))) take_what_was_read();
  const std::chrono::nanoseconds now = clock::monotonic_now();
  const std::chrono::nanoseconds frame = now - std::exchange(stepped_, now);
  if (state_ != State::Preparing) return;
  const auto most = std::clamp<std::chrono::nanoseconds>(frame / 4, pace_.least, pace_.most);
  do prepare(shape, most);
  while (repeats_exactly_ && state_ == State::Preparing);
}

void ChangeOver::take_what_was_read() {
  next_ = reading_.get();
  state_ = next_ ? State::Preparing : State::Refused;
  rehearsals_ = 0;
}

void ChangeOver::prepare(const interface::ScreenShape& shape, std::chrono::nanoseconds most) {
  Exhibition& next = **next_;
  const std::chrono::nanoseconds begun = clock::monotonic_now();
  while (upload_next(next))
    if (clock::monotonic_now() - begun > most) return;
  if (repeats_exactly_) next.planner->wait();
  next.guide->resize(shape);
  next.guide->step(guide::Seconds{0});
  apply_pieces(next);
  if (next.guide->shows_its_state() || ++rehearsals_ == most_rehearsals) state_ = State::Ready;
}

bool ChangeOver::is_due(bool is_vacant, double time) const noexcept {
  return state_ == State::Ready && (is_vacant || time - begun_ >= longest_wait);
}

Result<std::unique_ptr<Exhibition>> ChangeOver::take() {
  state_ = State::Idle;
  return std::exchange(next_, nullptr);
}

void ChangeOver::retire(std::unique_ptr<Exhibition> old) {
  old->holdings = {};  // texture memory is this thread's
  retiring_ = std::async(std::launch::async, [old = std::move(old)]() mutable {
    old.reset();
    prepare_allocator_for(Phase::Frames);
  });
}

}  // namespace docent::kiosk

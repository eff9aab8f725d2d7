#include "platform/kms/scanout.h"

#include <algorithm>
#include <cerrno>

namespace docent::kms {
namespace {

using std::chrono::nanoseconds;
using namespace std::chrono_literals;

constexpr nanoseconds busy_pause = 5ms;
constexpr nanoseconds refused_pause = 250ms;
/// From here on a refused commit is repeated in a more forceful way.
constexpr nanoseconds patience = 1000ms;
constexpr nanoseconds long_time = 1000ms;

bool is_refused_for(const Scanout& scanout, nanoseconds time, nanoseconds now) noexcept {
  return scanout.refused_since && now - *scanout.refused_since >= time;
}

}  // namespace

CommitResult result_of(int error) noexcept {
  switch (error) {
    case 0:
      return CommitResult::Taken;
    case EBUSY:
    case EINTR:
    case EAGAIN:
      return CommitResult::Busy;
    case EACCES:
    case EPERM:
      return CommitResult::NoMaster;
    default:
      return CommitResult::Refused;
  }
}

ScanoutStep next_step(const Scanout& s, nanoseconds now) noexcept {
  if (s.is_flipping)
    return now - s.flip_begun < longest_flip ? ScanoutStep::AwaitFlip : ScanoutStep::GiveUpFlip;
  if (!s.is_here) return ScanoutStep::Rest;
  if (now < s.next_try) return ScanoutStep::Rest;
  if (!s.is_master) return ScanoutStep::TakeCard;
  if (s.looks_again || !s.has_screen)
    return now < s.next_look ? ScanoutStep::Rest : ScanoutStep::LookAgain;
  if (!s.is_wanted) return s.is_lit ? ScanoutStep::TurnOff : ScanoutStep::Rest;
  return ScanoutStep::Draw;
}

nanoseconds resume_at(const Scanout& s, nanoseconds now) noexcept {
  if (s.is_flipping) return s.flip_begun + longest_flip;
  if (!s.is_here) return now + long_time;
  if (now < s.next_try) return s.next_try;
  if (s.looks_again || !s.has_screen) return std::max(now, s.next_look);
  return now + long_time;
}

CommitKind commit_kind(const Scanout& s, nanoseconds now) noexcept {
  if (is_refused_for(s, patience, now)) return CommitKind::SetModePatient;
  return s.is_mode_set ? CommitKind::Flip : CommitKind::SetMode;
}

void committed(Scanout& s, CommitResult result, nanoseconds now) noexcept {
  if (result == CommitResult::Taken) {
    s.is_flipping = s.is_mode_set = s.is_lit = true;
    s.flip_begun = now;
    s.refused_since.reset();
    return;
  }
  if (!s.refused_since) s.refused_since = now;
  switch (result) {
    case CommitResult::Busy:
      s.next_try = now + busy_pause;
      break;
    case CommitResult::NoMaster:
      s.is_master = s.is_mode_set = false;
      s.next_try = now;
      s.refused_since.reset();
      break;
    default: {
      // The first time at once: a screen with another mode may have taken the old one's place.
      const bool first = *s.refused_since == now;
      s.is_mode_set = false;
      s.looks_again = true;
      s.next_try = s.next_look = first ? now : now + refused_pause;
      break;
    }
  }
}

void flipped(Scanout& s) noexcept {
  s.is_flipping = false;
}

void gave_up_flip(Scanout& s) noexcept {
  s.is_flipping = s.is_mode_set = false;
}

void heard_hotplug(Scanout& s) noexcept {
  s.looks_again = true;
  s.next_look = nanoseconds{0};
}

void looked(Scanout& s, bool has_screen, nanoseconds now) noexcept {
  s.has_screen = has_screen;
  s.looks_again = s.is_mode_set = false;
  s.next_look = now + look_every;
}

void asked_for_card(Scanout& s, bool is_granted, nanoseconds now) noexcept {
  s.is_master = is_granted;
  s.is_mode_set = false;
  if (is_granted)
    heard_hotplug(s);  // nobody told us meanwhile
  else
    s.next_try = now + ask_every;
}

void left_console(Scanout& s) noexcept {
  s.is_here = s.is_master = s.is_mode_set = s.is_flipping = false;
}

void returned_to_console(Scanout& s, nanoseconds now) noexcept {
  s.is_here = true;
  s.next_try = now;
}

void want_screen(Scanout& s, bool is_wanted) noexcept {
  s.is_wanted = is_wanted;
}

void turned_off(Scanout& s, CommitResult result, nanoseconds now) noexcept {
  s.is_mode_set = false;
  switch (result) {
    case CommitResult::Busy:
      s.next_try = now + busy_pause;
      return;
    case CommitResult::NoMaster:
      s.is_master = false;
      return;
    default:  // where it cannot be turned off there is nothing more to be done
      s.is_lit = false;
  }
}

}  // namespace docent::kms

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "runtime/input/contact.h"
#include "runtime/interface/view.h"

namespace docent::guide {

/// What begins to be said; what was being said ends. Borrowed from the view: valid until the next
/// step.
struct Saying {
  const interface::Utterance* utterance = nullptr;  ///< Null: silence from now on.
  std::string_view control;                         ///< The name of the one it is about; or empty.
};

/// Reads the glass aloud to one visitor: says what a screen is, and then reads on from control to
/// control, so that a single key chooses what has just been heard. Whoever moves the focus by
/// themselves is read to no further than that. What is left of a way is said as it gets shorter.
///
/// For the frame thread; nothing allocates or throws. It owns no focus: its session moves that.
class Voice {
 public:
  /// A view has come on the glass. True where it is something new, which is said from its
  /// beginning: nothing has the focus then. `focus` as below.
  bool enter(const interface::View& view, std::int32_t focus) noexcept;
  /// A key that is the voice's own: volume, again, speed. False where it is not.
  bool press_key(input::Key key) noexcept;
  void help() noexcept;
  /// The visitor listens to a sound, or no longer: meanwhile nothing is read on by itself. Where it
  /// `has_ended` by itself, they are told where they are.
  void listens(bool does_listen, bool has_ended, std::int32_t focus) noexcept;
  /// Louder or quieter without a word: what plays is heard to be so.
  void turn_volume(input::Key key) noexcept;
  /// A control has been pressed: whatever is being said, it has been heard.
  void pressed() noexcept;
  /// The visitor has moved the focus by themselves.
  void moved_to(std::int32_t focus) noexcept;

  /// `remaining`: metres of the visitor's way; none where nobody is on one. True where the focus is
  /// to move on: read() is then told where it has come from, and come to.
  bool step(float seconds, const interface::View* view, std::optional<float> remaining) noexcept;
  void read(std::int32_t from, std::int32_t to) noexcept;
  /// Is the sound edge still playing? Until somebody says so, time is estimated.
  void heard(bool is_speaking) noexcept { heard_ = is_speaking; }
  /// Volume and speed for the next visitor.
  void reset() noexcept;

  /// What began in the last step; null where nothing did.
  const Saying* saying() const noexcept { return is_new_ ? &saying_ : nullptr; }
  /// Is somebody being read to?
  bool is_busy() const noexcept { return is_on_ && (is_speaking() || reads_on_); }
  /// What is being said; Nothing in silence.
  interface::SpeechPart now() const noexcept {
    return is_speaking() ? now_ : interface::SpeechPart{};
  }
  /// About which share of it is still to be said.
  float share_left() const noexcept {
    return whole_ > 0 ? std::clamp(left_ / whole_, 0.0F, 1.0F) : 0;
  }
  std::size_t volume() const noexcept { return volume_; }  ///< 0 to interface::loudest.
  float speed() const noexcept { return interface::speech_speeds[speed_]; }

 private:
  /// What is to be said, found in whatever view is shown when that begins.
  using What = interface::SpeechPart;
  void begin(const interface::View& view, const What& what) noexcept;
  bool is_speaking() const noexcept { return heard_ ? *heard_ : left_ > 0; }
  void say(const What& what, bool waits = false) noexcept;
  void read_on() noexcept;
  std::optional<What> milestone(const interface::View& view, float remaining) noexcept;

  bool is_on_ = false;
  What next_, last_;    ///< Nothing: none. `last_` is what can be said again.
  bool waits_ = false;  ///< `next_` is said when that before it has ended.
  Saying saying_;
  bool is_new_ = false;
  bool reads_on_ = false, was_pressed_ = false;
  bool listens_ = false;       ///< To a sound.
  int rounds_ = 0;             ///< How often the controls are still read from first to last.
  std::uint64_t opening_ = 0;  ///< Tells what was said last of a view from what is new.
  What now_;                   ///< What was begun last.
  float whole_ = 0;            ///< Seconds that saying it takes.
  float left_ = 0;             ///< Seconds that saying it still takes.
  float silence_ = 0;          ///< Seconds since it was said.
  float told_ = std::numeric_limits<float>::max();  ///< Metres that were said to remain.
  std::optional<bool> heard_;
  std::size_t volume_ = interface::usual_volume, speed_ = interface::usual_speed;
};

}  // namespace docent::guide

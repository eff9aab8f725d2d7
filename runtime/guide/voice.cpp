#include "runtime/guide/voice.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace docent::guide {
namespace {

/// In which a visitor presses the key for what they have just heard, before the next is read.
constexpr float pause = 1.2F;
/// All is read twice, and then the voice waits for the visitor.
constexpr int rounds = 2;

std::uint64_t print_of(const interface::Utterance& utterance) noexcept {
  std::uint64_t print = 14695981039346656037ULL;  // FNV-1a
  const auto add = [&print](std::string_view text) {
    for (const char c : text) print = (print ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    print = (print ^ 0xFFU) * 1099511628211ULL;
  };
  add(utterance.language);
  for (const interface::SpokenPiece& piece : utterance.pieces) add(piece.text);
  return print;
}

}  // namespace

bool Voice::enter(const interface::View& view, std::int32_t focus) noexcept {
  const bool was_pressed = was_pressed_;
  was_pressed_ = false;
  if (!view.state.speaks) {
    if (is_on_) say({What::Kind::Ended});
    is_on_ = reads_on_ = false;
    return false;
  }
  const std::uint64_t opening = print_of(view.speech.opening);
  const bool is_new = !is_on_ || opening != opening_;
  is_on_ = true;
  if (is_new) {
    opening_ = opening;
    told_ = std::numeric_limits<float>::max();
    // What comes by itself, such as an arrival, waits until the visitor has heard what was before.
    say({What::Kind::Opening}, !was_pressed && is_speaking());
    if (view.speech.keeps_focus && focus >= 0) {
      reads_on_ = false;
      return false;
    }
    read_on();
  } else if (was_pressed && focus >= 0 && !view.state.sound) {  // else that is heard
    say({What::Kind::Control, static_cast<std::size_t>(focus)});
  }
  return is_new;
}

void Voice::say(const What& what, bool waits) noexcept {
  next_ = what;
  waits_ = waits;
}

void Voice::read_on() noexcept {
  reads_on_ = true;
  rounds_ = rounds;
}

void Voice::listens(bool does_listen, bool has_ended, std::int32_t focus) noexcept {
  if (!std::exchange(listens_, does_listen) || does_listen || !is_on_) return;
  silence_ = 0;
  if (has_ended && focus >= 0) say({What::Kind::Control, static_cast<std::size_t>(focus)});
}

void Voice::turn_volume(input::Key key) noexcept {
  if (key == input::Key::VolumeUp) volume_ = std::min(volume_ + 1, interface::loudest);
  if (key == input::Key::VolumeDown) volume_ -= volume_ > 0 ? 1 : 0;
}

bool Voice::press_key(input::Key key) noexcept {
  if (!is_on_) return false;
  switch (key) {
    case input::Key::VolumeUp:
    case input::Key::VolumeDown:
      turn_volume(key);
      say({What::Kind::Volume, volume_});
      return true;
    case input::Key::Left:
      say(last_);
      return true;
    case input::Key::Right:
      speed_ = (speed_ + 1) % interface::speech_speeds.size();
      say({What::Kind::Speed, speed_});
      return true;
    default:
      return false;
  }
}

void Voice::help() noexcept {
  say({What::Kind::Help});
  read_on();
}

void Voice::pressed() noexcept {
  if (!is_on_) return;
  was_pressed_ = true;
  say({What::Kind::Silence});
}

void Voice::moved_to(std::int32_t focus) noexcept {
  if (!is_on_ || focus < 0) return;
  reads_on_ = false;
  say({What::Kind::Control, static_cast<std::size_t>(focus)});
}

void Voice::read(std::int32_t from, std::int32_t to) noexcept {
  const bool is_round = from >= 0 && to <= from;
  if (is_round) --rounds_;
  reads_on_ = to >= 0 && rounds_ > 0;
  if (reads_on_) say({What::Kind::Control, static_cast<std::size_t>(to)});
}

void Voice::begin(const interface::View& view, const What& what) noexcept {
  const interface::Utterance* utterance = interface::said_in(view.speech, what);
  is_new_ = utterance != nullptr || what.kind == What::Kind::Silence;
  if (!is_new_) return;
  saying_ = {utterance, {}};
  if (what.kind == What::Kind::Control) saying_.control = view.controls[what.index].name;
  now_ = what;
  whole_ = left_ = utterance == nullptr ? 0 : interface::seconds_of(*utterance) / speed();
  silence_ = 0;
  heard_ = heard_ ? std::optional(utterance != nullptr) : std::nullopt;
  const bool can_be_repeated = what.kind == What::Kind::Opening || what.kind == What::Kind::Help ||
                               what.kind == What::Kind::Control ||
                               what.kind == What::Kind::Remaining;
  if (can_be_repeated) last_ = what;
}

/// The least of the distances that the way has come down to, where that was not said.
std::optional<Voice::What> Voice::milestone(const interface::View& view, float remaining) noexcept {
  const auto& all = view.speech.remaining;
  const auto less = std::ranges::find_if(
      all, [&](const interface::CountedUtterance& one) { return one.metres < remaining; });
  if (less == all.begin() || std::prev(less)->metres >= told_) return {};
  told_ = std::prev(less)->metres;
  return What{What::Kind::Remaining, static_cast<std::size_t>(less - all.begin() - 1)};
}

bool Voice::step(float seconds, const interface::View* view,
                 std::optional<float> remaining) noexcept {
  is_new_ = false;
  if (view == nullptr) return false;
  left_ -= seconds;
  if (next_.kind != What::Kind::Nothing) {
    if (!waits_ || !is_speaking()) begin(*view, std::exchange(next_, {}));
    return false;
  }
  if (!is_on_ || is_speaking() || listens_) return false;
  silence_ += seconds;
  if (remaining) {
    if (const std::optional<What> what = milestone(*view, *remaining)) {
      begin(*view, *what);
      return false;
    }
  }
  return reads_on_ && silence_ >= pause;
}

void Voice::reset() noexcept {
  volume_ = interface::usual_volume;
  speed_ = interface::usual_speed;
}

}  // namespace docent::guide

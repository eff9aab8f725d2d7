/// What a visitor listens to at an exhibit.
#include <utility>

#include "runtime/guide/session.h"
#include "runtime/interface/pictures.h"

namespace docent::guide {

std::optional<PlayedSound> Session::sound() const noexcept {
  if (!sound_) return std::nullopt;
  return PlayedSound{.recording = recording_,
                     .sound = *sound_,
                     .number = sounds_begun_,
                     .seconds = sound_seconds_};
}

void Session::can_sound(bool is_there) noexcept {
  if (sound_ || state_.can_sound == is_there) return;
  interface::InterfaceState state = state_;
  state.can_sound = is_there;
  show(state);
}

void Session::stop_sound() noexcept {
  interface::InterfaceState state = state_;
  state.sound.reset();
  show(state);
}

/// What is said comes first: whoever asks for it has heard enough of a sound.
void Session::play_sound(float seconds) noexcept {
  constexpr float after_it = 0.2F;  // the loudspeaker is that much behind
  if (sound_ && voice_.saying() != nullptr && voice_.saying()->utterance != nullptr) stop_sound();
  const auto before = std::exchange(sound_, interface::shown_sound(context_.museum, state_));
  bool has_ended = false;
  if (sound_ && sound_ != before) {
    recording_ = recording_of(context_.museum, *sound_, state_.language);
    if (recording_ == nullptr) {
      sound_.reset();
      stop_sound();
    }
    ++sounds_begun_;
    sound_seconds_ = 0;
  } else if (sound_) {
    sound_seconds_ += seconds;
    const auto length = static_cast<float>(recording_->samples) / SpeechSound::rate;
    has_ended = sound_seconds_ > length + after_it;
    if (has_ended) {
      sound_.reset();
      stop_sound();
    }
  }
  voice_.listens(sound_.has_value(), has_ended, overlay_.focus());
  if (view() == nullptr || !view()->state.sound) return overlay_.listen(std::nullopt);
  const bool is_seen = sound_ && interface::shown_sound(context_.museum, view()->state) == sound_;
  const auto length = recording_ == nullptr ? 0.0F : static_cast<float>(recording_->samples);
  overlay_.watch(is_seen ? std::optional(sound_seconds_) : std::nullopt);
  overlay_.listen(is_seen ? sound_seconds_ * SpeechSound::rate / length : 0.0F);
}

}  // namespace docent::guide

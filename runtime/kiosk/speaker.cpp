#include "runtime/kiosk/speaker.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "runtime/interface/speech.h"
#include "runtime/sound/speech_queue.h"

namespace docent::kiosk {

namespace {

/// The device that is played on; nothing where nobody is to hear it.
std::optional<std::string> device_of(const config::KioskConfig& config, bool is_simulated) {
  std::string device = config.sound_device.value_or("default");
  if (device == "none" || (is_simulated && !device.starts_with("file:"))) return std::nullopt;
  return device;
}

}  // namespace

Speaker::Speaker(const config::KioskConfig& config, bool is_simulated)
    : is_simulated_(is_simulated), loudest_(static_cast<float>(config.sound_volume)) {
  const std::optional<std::string> device = device_of(config, is_simulated);
  if (!device) return;
  player_ = alsa::Player::of(*device);
  if (!is_simulated) jacks_ = std::make_unique<alsa::JackWatch>();
}

bool Speaker::is_wanted(const config::KioskConfig& config) noexcept {
  return config.sound_device != "none";
}

void Speaker::heed(guide::Guide& guide, const Museum& museum,
                   const std::shared_ptr<BlobArchive>& archive) noexcept {
  if (!player_) return;
  if (archive.get() != archive_) player_->use(archive);
  archive_ = archive.get();
  const guide::Voice& voice = guide.voice();
  const bool plays = guide.sound().has_value();
  player_->set_volume(loudest_ * static_cast<float>(voice.volume()) / interface::loudest);
  player_->set_speed(plays ? 1 : voice.speed());  // an instrument has its own
  if (const guide::Saying* saying = voice.saying()) say(*saying, museum);
  play(guide);
  if (!is_simulated_) {
    guide.can_sound(player_->has_device());
    return guide.heard(player_->is_speaking() && !plays);
  }
  while (player_->is_speaking()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Begins what the visitor has begun to listen to, and ends it where they do before its end.
void Speaker::play(const guide::Guide& guide) noexcept {
  constexpr float nothing = 0.3F;  // seconds that nobody misses
  const std::optional<guide::PlayedSound> sound = guide.sound();
  if (!sound) {
    const bool is_cut = std::exchange(sound_, 0) != 0 && left_ > nothing;
    if (is_cut && guide.voice().saying() == nullptr) player_->say({});
    return;
  }
  left_ = static_cast<float>(sound->recording->samples) / SpeechSound::rate - sound->seconds;
  if (std::exchange(sound_, sound->number) == sound->number) return;
  parts_.front() = {.sound = sound->recording, .pauses = 0};
  player_->say(std::span(parts_).first(1));
}

std::optional<bool> Speaker::headphones() noexcept {
  const std::optional<bool> changed = jacks_ ? jacks_->changed() : std::nullopt;
  if (changed == true) player_->expect_device();
  return changed;
}

void Speaker::say(const guide::Saying& saying, const Museum& museum) noexcept {
  if (saying.utterance == nullptr) return player_->say({});
  player_->say(std::span(parts_).first(parts_of(*saying.utterance, museum, parts_)));
}

std::size_t parts_of(const interface::Utterance& utterance, const Museum& museum,
                     std::span<sound::SpeechPart> out) noexcept {
  const auto language = std::ranges::find(museum.languages, utterance.language, &Language::tag) -
                        museum.languages.begin();
  std::size_t count = 0;
  bool is_silent = true;
  for (const interface::SpokenPiece& piece : utterance.pieces) {
    if (count == out.size()) break;
    sound::SpeechPart& part = out[count++];
    part.sound = find_sound(museum.speech, static_cast<std::uint32_t>(language), piece.text);
    part.pauses = piece.pause ? 1 : 0;
    is_silent = is_silent && part.sound == nullptr;
  }
  if (!is_silent || out.empty()) return count;
  constexpr float pauses_a_second =
      SpeechSound::rate / static_cast<float>(sound::SpeechQueue::pause);
  const float pauses = interface::seconds_of(utterance) * pauses_a_second;
  out.front() = {.sound = nullptr, .pauses = static_cast<std::uint32_t>(pauses)};
  return 1;
}

}  // namespace docent::kiosk

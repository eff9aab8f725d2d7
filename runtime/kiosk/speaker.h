#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "config/kiosk_config.h"
#include "platform/alsa/jack_watch.h"
#include "platform/alsa/player.h"
#include "runtime/guide/guide.h"
#include "runtime/interface/utterance.h"
#include "runtime/model/museum.h"
#include "runtime/sound/speech_queue.h"

namespace docent::kiosk {

/// Lets what the guide says be heard, from the sounds of its museum, and tells it of headphones.
///
/// Simulated time is not heard, except in a file: each sentence is then written whole, whatever
/// time it would take.
class Speaker {
 public:
  Speaker(const config::KioskConfig& config, bool is_simulated);

  /// After each step of the guide: what has begun is played, and the guide knows when it has ended.
  /// Never waits where time is real, and allocates nothing.
  /// `archive`: of the museum's sounds; null where they are all in memory.
  void heed(guide::Guide& guide, const Museum& museum,
            const std::shared_ptr<BlobArchive>& archive) noexcept;

  /// Can anything be heard, as far as settings say? Simulated time is heard as a device would.
  static bool is_wanted(const config::KioskConfig& config) noexcept;

  /// Headphones that went in or out since the last call.
  std::optional<bool> headphones() noexcept;

 private:
  void play(const guide::Guide& guide) noexcept;
  void say(const guide::Saying& saying, const Museum& museum) noexcept;

  std::unique_ptr<alsa::Player> player_;    ///< Null: nothing is heard.
  std::unique_ptr<alsa::JackWatch> jacks_;  ///< Null: nobody watches.
  const BlobArchive* archive_ = nullptr;    ///< That the player has.
  std::uint32_t sound_ = 0;  ///< The number of the sound that was begun last; 0: none.
  float left_ = 0;           ///< Seconds that it still takes.
  bool is_simulated_;
  float loudest_;
  std::array<sound::SpeechPart, 512> parts_{};
};

/// What is played of an utterance, as far as `out` has room: its pieces' sounds. In a language
/// without a voice one silence, in which its captions are read in the time that they take. Returns
/// how many parts.
std::size_t parts_of(const interface::Utterance& utterance, const Museum& museum,
                     std::span<sound::SpeechPart> out) noexcept;

}  // namespace docent::kiosk

#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <semaphore>
#include <span>
#include <string>
#include <thread>

#include "platform/alsa/sound_device.h"
#include "runtime/model/blob_archive.h"
#include "runtime/model/result.h"
#include "runtime/sound/speech_queue.h"

namespace docent::alsa {

/// Says sentences, on a thread of its own. A device that is not there, is taken, or goes in
/// mid-sentence is told once in the journal, by a sentence that nobody hears, and tried again every
/// two seconds; meanwhile sentences
/// take their time and nobody hears them.
class Player {
 public:
  using Open = std::function<Result<std::unique_ptr<SoundDevice>>()>;

  /// `is_paced`: sentences that nobody hears take the time that they would.
  explicit Player(Open open, bool is_paced = true);
  /// A device by its name, as open_device() takes it.
  static std::unique_ptr<Player> of(const std::string& device);
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;
  ~Player();  ///< Ends in mid-sentence, within a second.

  // For the frame thread; none of these waits or allocates.

  /// Where the packets of archived sounds are read from now on; whatever is being said ends.
  void use(std::shared_ptr<BlobArchive> archive) noexcept;
  /// Says a sentence; the one before ends at once. Without parts it is silent.
  void say(std::span<const sound::SpeechPart> parts) noexcept;
  /// From 0 to 1, and how many times as fast as usual: from now on, in mid-sentence too.
  void set_volume(float volume) noexcept { volume_ = volume; }
  void set_speed(float speed) noexcept { speed_ = speed; }
  /// Headphones have come: where there is no device yet it is looked for again and again, and for a
  /// second and a half what is to be said waits for it.
  void expect_device() noexcept;
  [[nodiscard]] bool is_speaking() const noexcept { return ended_ != queue_.sentence(); }
  [[nodiscard]] bool has_device() const noexcept { return has_device_; }

 private:
  struct Work;
  void play(const std::stop_token& stop);

  sound::SpeechQueue queue_;
  std::atomic<float> volume_{0.5F}, speed_{1};
  std::atomic<std::uint32_t> ended_{0};  ///< The last sentence that was said to its end.
  std::atomic<bool> has_device_{false};
  std::atomic<std::chrono::steady_clock::time_point> expected_until_{};
  std::atomic<std::shared_ptr<BlobArchive>> archive_{};
  std::counting_semaphore<> awake_{0};
  Open open_;
  bool is_paced_;
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace docent::alsa

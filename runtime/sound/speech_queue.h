#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "runtime/model/speech.h"

namespace docent::sound {

/// A part of a sentence: a sound, if there is one for it, and the silence that follows.
struct SpeechPart {
  const SpeechSound* sound = nullptr;
  std::uint32_t pauses = 0;  ///< So many of SpeechQueue::pause.
};

/// Sentences on their way from the frame thread to the player's: one thread pushes, one pops;
/// neither waits for the other and nothing allocates. Packets are copied, so that sounds may go
/// away as soon as they are queued; of those in an archive their numbers. What one sentence holds
/// beyond `capacity` is left out.
class SpeechQueue {
 public:
  static constexpr std::size_t capacity = std::size_t{1} << 20U;  ///< Bytes: some 6 minutes.
  static constexpr std::uint32_t pause = SpeechSound::rate / 4;   ///< Samples of a silence.

  /// What the player gets.
  struct Item {
    std::uint32_t sentence = 0;  ///< Grows.
    bool begins = false;         ///< A sound begins: the decoder forgets what was before.
    std::uint32_t skip = 0;      ///< Samples to leave out, where it begins.
    std::uint32_t samples = 0;   ///< Of the sound that begins, or of silence where nothing follows.
    std::span<const std::byte> packet;      ///< Valid until the next pop. Empty: silence.
    std::optional<std::uint32_t> archived;  ///< Instead of a packet: all of an archive's sound.
  };

  /// Begins a sentence, which ends the one before; without parts there is silence. For the thread
  /// that pushes.
  void say(std::span<const SpeechPart> parts) noexcept;
  /// The last sentence that was begun. Any thread.
  [[nodiscard]] std::uint32_t sentence() const noexcept { return sentence_; }

  /// Is all of the last sentence queued, or popped? Any thread.
  [[nodiscard]] bool is_whole() const noexcept { return whole_ == sentence_; }

  /// Takes the next item of the last sentence, past all of those before; false where there is none.
  /// For the thread that pops.
  [[nodiscard]] bool pop(Item& item) noexcept;

 private:
  struct Header {
    std::uint32_t sentence = 0, skip = 0, samples = 0;
    std::uint16_t size = 0, begins = 0, is_archived = 0;
  };
  bool push(const Header& header, std::span<const std::byte> packet) noexcept;
  bool push(const SpeechSound& sound) noexcept;
  void push(std::span<const SpeechPart> parts) noexcept;
  void copy_in(std::size_t at, std::span<const std::byte> bytes) noexcept;
  void copy_out(std::size_t at, std::span<std::byte> bytes) const noexcept;

  std::unique_ptr<std::byte[]> ring_ = std::make_unique<std::byte[]>(capacity);
  std::array<std::byte, SpeechSound::longest_packet> packet_{};
  std::atomic<std::size_t> head_{0}, tail_{0};
  std::atomic<std::uint32_t> sentence_{0}, whole_{0};
};

}  // namespace docent::sound

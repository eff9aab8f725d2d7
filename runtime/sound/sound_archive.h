#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace docent::sound {

/// Where the packets of a museum's sounds lie that are not kept in memory (SpeechSound::archived).
class SoundArchive {
 public:
  SoundArchive() = default;
  SoundArchive(const SoundArchive&) = delete;
  SoundArchive& operator=(const SoundArchive&) = delete;
  virtual ~SoundArchive() = default;

  /// Packets as SpeechSound has them, valid until the next call; none where they cannot be read.
  /// May wait for a disk. One thread.
  virtual std::span<const std::byte> packets(std::uint32_t sound) = 0;
};

}  // namespace docent::sound

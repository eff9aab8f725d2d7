#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "runtime/model/local_text.h"

namespace docent {

/// What visitors may listen to at an exhibit: an instrument that is played, somebody who tells of
/// it. Its recordings are among Museum::speech (recording_key()).
struct ExhibitSound {
  static constexpr std::size_t most = 4;         ///< Of an exhibit.
  static constexpr std::uint32_t longest = 300;  ///< Seconds.

  std::uint32_t exhibit = 0;  ///< Index into Museum::exhibits.
  LocalText title{};          ///< What one listens to: "The bell is struck".
  LocalText description{};    ///< What is heard, for who does not hear it.

  bool operator==(const ExhibitSound&) const = default;
};

/// What is read for a part of a sound, in one of the museum's languages.
struct SoundCue {
  /// Milliseconds: no sound is longer.
  static constexpr std::uint32_t latest = 1000 * ExhibitSound::longest + 500;
  static constexpr std::size_t most = 150;  ///< Of a sound in a language.
  static constexpr std::size_t most_letters = 600;

  std::uint32_t sound = 0;           ///< Index into Museum::sounds.
  std::uint32_t language = 0;        ///< Index into Museum::languages.
  std::uint32_t begin = 0, end = 0;  ///< Milliseconds of the sound; begin < end <= latest.
  std::string text;                  ///< UTF-8, not empty; who speaks next begins a line.

  bool operator==(const SoundCue&) const = default;
};

}  // namespace docent

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace docent {

/// What is read for a part of a video, in one of the museum's languages.
struct Cue {
  static constexpr std::uint32_t latest = 60'500;  ///< Milliseconds: no video is longer.
  static constexpr std::size_t most = 100;         ///< Of a video in a language.
  static constexpr std::size_t most_letters = 600;

  std::uint32_t picture = 0;         ///< Index into Museum::pictures.
  std::uint32_t language = 0;        ///< Index into Museum::languages.
  std::uint32_t begin = 0, end = 0;  ///< Milliseconds of the video; begin < end <= latest.
  std::string text;                  ///< UTF-8, not empty; who speaks next begins a line.

  bool operator==(const Cue&) const = default;
};

}  // namespace docent

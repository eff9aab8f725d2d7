#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/diagnostic.h"

namespace docent::import {

/// One caption, and when it is read: milliseconds from the video's beginning, begin < end.
struct TimedCaption {
  std::uint32_t begin = 0, end = 0;
  std::string text;        ///< Without tags; a line of the file that goes on is joined to the next.
  std::uint32_t line = 0;  ///< Of its times in the file, from 1; 0: made of several.

  bool operator==(const TimedCaption&) const = default;
};

/// The captions of a file in its order, and what is wrong with it, each with its place.
struct CaptionFile {
  std::vector<TimedCaption> captions;
  std::vector<Diagnostic> faults;
};

/// The most letters of a caption: about what is read in ten seconds.
inline constexpr std::size_t most_caption_letters = 200;

/// Reads WebVTT (W3C, "WebVTT: The Web Video Text Tracks Format", Candidate Recommendation of
/// 2019), with any line ends and with or without a byte order mark. Times may leave out the hours.
/// What styles and places captions is left out: STYLE, REGION, NOTE, settings, tags; of ruby the
/// base is kept. Any bytes are safe: whatever would not be shown as it is written is a fault, with
/// its line and column and what to do about it, and what is right is read all the same. A file
/// without a fault has at least one caption. `file`: as it is called there.
CaptionFile read_webvtt(std::string_view text, const std::string& file);

/// The same captions as at most one at a time, in the order of time: where several are read at
/// once, they are a caption of several lines, the one that began first above.
std::vector<TimedCaption> one_at_a_time(std::vector<TimedCaption> captions);

}  // namespace docent::import

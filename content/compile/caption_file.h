#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "content/compile/report.h"
#include "content/import/caption/webvtt.h"

namespace docent::compile {

/// What is captioned, and what a kiosk can show of it.
struct Captioned {
  std::string_view what;     ///< "video" or "sound".
  std::uint32_t length = 0;  ///< Milliseconds.
  std::size_t most = 0, most_letters = 0;
};

/// The captions of a file (WebVTT), at most one at a time, each ending with what is captioned. What
/// is wrong with the file goes into the report with its place there; then there are none.
std::vector<import::TimedCaption> read_caption_file(const std::filesystem::path& file,
                                                    const Captioned& of, Report& report);

}  // namespace docent::compile

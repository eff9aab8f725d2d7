#pragma once

#include <string>
#include <string_view>

#include "runtime/guide/session.h"
#include "runtime/guide/voice.h"

namespace docent::kiosk {

/// The first line of what was said, as CSV (RFC 4180).
inline constexpr std::string_view transcript_heading = "time,control,language,text\n";

/// A line of it: when that began, what it is about, and what was said; empty for a silence.
/// `time`: seconds since the first frame.
std::string transcript_line(double time, const guide::Saying& saying);

/// The same of a sound that begins to play: what it is called, in brackets, as captions have it.
std::string transcript_line(double time, const guide::PlayedSound& sound, const Museum& museum,
                            std::uint32_t language);

}  // namespace docent::kiosk

#pragma once

#include <string>
#include <string_view>

#include "runtime/guide/voice.h"

namespace docent::kiosk {

/// The first line of what was said, as CSV (RFC 4180).
inline constexpr std::string_view transcript_heading = "time,control,language,text\n";

/// A line of it: when that began, what it is about, and what was said; empty for a silence.
/// `time`: seconds since the first frame.
std::string transcript_line(double time, const guide::Saying& saying);

}  // namespace docent::kiosk

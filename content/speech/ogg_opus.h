#pragma once

#include <string>
#include <string_view>

#include "content/speech/pcm.h"

namespace docent::speech {

/// An Opus recording in an Ogg file (RFC 3533, RFC 7845), mixed into one channel, 48,000 samples a
/// second. Throws ContentError, which names `file`, where it is something else or damaged.
Pcm read_ogg_opus(std::string_view bytes, const std::string& file);

}  // namespace docent::speech

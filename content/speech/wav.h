#pragma once

#include <string>
#include <string_view>

#include "content/speech/pcm.h"

namespace docent::speech {

/// A WAV file (RIFF): whole numbers of 8, 16, 24 or 32 bits or floats of 32, its channels mixed
/// into one. A length that a stream's header does not know is what is there. Throws ContentError,
/// which names `file`, where it is something else or cut short.
Pcm read_wav(std::string_view bytes, const std::string& file);

}  // namespace docent::speech

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "content/speech/pcm.h"

namespace docent::speech {

/// Somebody's recording, by what its bytes are and whatever its name says: WAV, Opus in Ogg, or
/// what libsndfile reads (library_sound.h).
/// Throws ContentError, whose sentence says what an unread one is.
Pcm read_sound(std::string_view bytes, const std::string& file);

}  // namespace docent::speech

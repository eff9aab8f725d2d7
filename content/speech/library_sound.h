#pragma once

#include <string>
#include <string_view>

#include "content/speech/pcm.h"

namespace docent::speech {

/// Does a file begin as one of the kinds that read_library_sound() reads: FLAC, MP3, AIFF, and
/// Vorbis or FLAC in Ogg?
bool is_library_sound(std::string_view bytes) noexcept;

/// Such a recording, by libsndfile, its channels mixed into one. Throws ContentError, which names
/// `file`, where it is something else, damaged, or too long.
Pcm read_library_sound(std::string_view bytes, const std::string& file);

}  // namespace docent::speech

#include "content/speech/recording.h"

#include <fmt/format.h>

#include <array>

#include "content/content_error.h"
#include "content/speech/library_sound.h"
#include "content/speech/ogg_opus.h"
#include "content/speech/wav.h"

namespace docent::speech {

namespace {

/// Kinds of files that people take for a recording, by how they begin.
struct Kind {
  std::size_t at;
  std::string_view begins, name;
};
constexpr std::array kinds{
    Kind{0, "\xff\xf1", "an AAC file"},
    Kind{0, "\xff\xf9", "an AAC file"},
    Kind{4, "ftyp", "an M4A or MP4 file"},
    Kind{0, "\x1a\x45\xdf\xa3", "a WebM or Matroska file"},
    Kind{0, "#!AMR", "an AMR file"},
    Kind{0, "caff", "a CAF file"},
    Kind{0, "\x30\x26\xb2\x75", "a WMA file"},
};

std::string_view name_of(std::string_view bytes) {
  for (const Kind& kind : kinds)
    if (bytes.size() > kind.at && bytes.substr(kind.at).starts_with(kind.begins)) return kind.name;
  return "no sound that docent knows";
}

}  // namespace

Pcm read_sound(std::string_view bytes, const std::string& file) {
  if (bytes.starts_with("RIFF")) return read_wav(bytes, file);
  if (is_library_sound(bytes)) return read_library_sound(bytes, file);
  if (bytes.starts_with("OggS")) return read_ogg_opus(bytes, file);
  throw content::ContentError(
      file, 0, 0, "unreadable-recording",
      fmt::format("this is {}; WAV, FLAC, AIFF, MP3, Opus and Vorbis (in Ogg) are read",
                  name_of(bytes)),
      "save it as WAV, FLAC or Opus: Audacity's File > Export does, or opusenc");
}

}  // namespace docent::speech

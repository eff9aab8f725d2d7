#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "content/speech/pcm.h"
#include "runtime/model/speech.h"

namespace docent::speech {

/// What is said in a language of the museum, by pieces.
struct WantedSpeech {
  std::uint32_t language = 0;  ///< Of museum.languages.
  std::string tag;             ///< BCP 47.
  std::vector<std::string> pieces;
};

/// How staff want a piece to be said: a recording, or else what the voice is to read for it, such
/// as kana for kanji.
struct OwnSpeech {
  std::uint32_t language = 0;
  std::string text;
  std::string digest;  ///< Of the recording's bytes.
  Pcm recording;
  std::string reading;
};

struct SpeechSources {
  std::span<const WantedSpeech> wanted;
  std::span<const OwnSpeech> own;
  std::span<const SpeechSound> before;  ///< What was made last: taken over where nothing changed.
  std::string program = "espeak-ng";
  std::string reader = "mecab";  ///< Japanese is said as it reads it.
  unsigned jobs = 1;
};

/// How a language came out.
struct LanguageSpeech {
  std::string tag;
  std::size_t pieces = 0, recorded = 0, taken_over = 0;
  double seconds = 0;  ///< Of sound.
  std::string silent;  ///< Why it is not spoken; empty where it is.
};

struct MadeSpeech {
  std::vector<SpeechSound> sounds;  ///< By language and text.
  std::vector<LanguageSpeech> languages;
};

/// Makes the sound of all that is said. A language is spoken as a whole or not at all: where its
/// voice reads it well, or staff have recorded or written out every piece. Never throws for want of
/// a voice; the same sources give the same sounds for any number of threads.
MadeSpeech make_speech(const SpeechSources& sources);

}  // namespace docent::speech

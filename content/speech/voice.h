#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "content/speech/pcm.h"

namespace docent::speech {

/// espeak-ng's name of the voice that reads a language (BCP 47).
std::string voice_name(std::string_view tag);

/// What is wrong with how a voice reads, told by its phonemes (`espeak-ng --ipa`); empty where
/// nothing is. A voice that does not know a script says "Chinese letter" for each of its letters,
/// in English, and one that has no vowels to read has words without any.
std::string reading_fault(std::string_view phonemes);

/// Of what `espeak-ng --voices` lists, the files by the names under which voices are asked for; a
/// name that two files have is left out. Given a file it looks into no other: a name has it read
/// all 130 of them, each time.
std::map<std::string, std::string> voice_files(std::string_view listed);

/// espeak-ng, run as a program of its own: it is GPL-3, and a text that ends it ends nothing else.
class Espeak {
 public:
  static constexpr std::uint32_t rate = 22'050;  ///< Of nearly all voices' sound.

  /// Looks for it. Throws ContentError where it is not there or does not say its version.
  static Espeak find(const std::string& program = "espeak-ng");

  const std::string& version() const noexcept { return version_; }

  /// How the voice reads a text, in letters of the International Phonetic Alphabet. These throw
  /// ContentError where the program fails or takes too long, or has no such voice. Any thread.
  std::string phonemes(const std::string& voice, std::string_view text) const;
  Pcm say(const std::string& voice, std::string_view text) const;

 private:
  Espeak(std::string program, std::string libraries, std::string version,
         std::map<std::string, std::string> files)
      : program_(std::move(program)),
        libraries_(std::move(libraries)),
        version_(std::move(version)),
        files_(std::move(files)) {}
  const std::string& file_of(const std::string& voice) const;
  std::string run(std::vector<std::string> arguments, std::string_view text) const;

  std::string program_, libraries_, version_;
  std::map<std::string, std::string> files_;
};

}  // namespace docent::speech

#include "content/speech/voice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "content/content_error.h"
#include "content/speech/run_program.h"
#include "content/speech/wav.h"

namespace docent::speech {

namespace {

using namespace std::chrono_literals;

/// A minute of speech is made in a third of a second.
constexpr auto patience = 60s;  // of a machine that is busy with something else
/// More words than these among a hundred, and a voice does not read its language: of Debian 12's
/// voices Japanese reads 43 in English, Hebrew 59 and Thai 15 without a vowel, and the others at
/// most 2 and 3.
constexpr double most_foreign = 0.10, most_without_vowel = 0.08;

constexpr std::array<std::string_view, 31> vowels{
    "a", "e", "i", "o", "u", "y", "ä", "ɑ", "æ", "ɐ", "ɒ", "ɔ", "ə", "ɚ", "ɛ", "ɜ",
    "ɝ", "ɞ", "ɤ", "ɘ", "ɨ", "ɪ", "ɯ", "ɵ", "ø", "œ", "ʉ", "ʊ", "ʌ", "ʏ", "ᵻ"};
constexpr std::array<std::string_view, 4> syllabic{"ɿ", "ʅ", "\u0329", "\u030d"};
constexpr std::array<std::string_view, 6> marks{"ˈ", "ˌ", "ː", "ʲ", "ʰ", "ˤ"};

bool holds_one_of(std::string_view text, auto& letters) {
  return std::ranges::any_of(
      letters, [=](std::string_view letter) { return text.find(letter) != text.npos; });
}

/// How many letters it has, without marks of stress, length and the like.
std::size_t letters_in(std::string_view word) {
  std::size_t letters = 0;
  while (!word.empty()) {
    const auto mark =
        std::ranges::find_if(marks, [=](std::string_view m) { return word.starts_with(m); });
    std::size_t length = mark == marks.end() ? 1 : mark->size();
    while (length < word.size() && (static_cast<unsigned char>(word[length]) & 0xc0U) == 0x80U)
      ++length;
    const auto first = static_cast<unsigned char>(word.front());
    if (mark == marks.end() && (first >= 0x80U || (first >= 'a' && first <= 'z'))) ++letters;
    word.remove_prefix(length);
  }
  return letters;
}

/// Reads phonemes word by word; "(en)" changes to another voice, until "(ja)" changes back.
struct Counter {
  std::size_t words = 0, foreign = 0, without_vowel = 0;
  bool in_english = false, is_english = true;  ///< English itself has no need to change.

  void take(std::string_view word) {
    std::string own;
    bool is_foreign = false;
    while (!word.empty()) {
      const std::size_t open = word.find('(');
      const std::string_view part = word.substr(0, open);
      if (in_english && !part.empty()) is_foreign = true;
      if (!in_english) own += part;
      word.remove_prefix(part.size());
      if (word.empty()) break;
      const std::size_t close = std::min(word.find(')'), word.size() - 1);
      in_english = word.starts_with("(en");
      word.remove_prefix(close + 1);
    }
    ++words;
    if (is_foreign)
      ++foreign;
    else if (letters_in(own) >= 2 && !holds_one_of(own, vowels) && !holds_one_of(own, syllabic))
      ++without_vowel;
  }
};

/// [[...]] would be read as phonemes.
std::string plain(std::string_view text) {
  std::string plain_text(text);
  for (std::size_t at = 0; (at = plain_text.find("[[", at)) != std::string::npos;)
    plain_text.replace(at, 2, "[ ");
  return plain_text + "\n";
}

[[noreturn]] void no_voice(const std::string& program, const std::string& what,
                           const std::string& hint) {
  throw content::ContentError(Errc::Environment, program, "no-voice", what, hint);
}

/// Where our library for players that play nothing lies (no_player.cpp): beside the folder of this
/// program.
std::string folder_of_no_player() {
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  return (program.parent_path().parent_path() / "lib" / "docent" / "no_player").string();
}

std::string first_line(std::string_view text) {
  return std::string(text.substr(0, text.find('\n')));
}

}  // namespace

std::string voice_name(std::string_view tag) {
  const std::string_view primary = tag.substr(0, tag.find('-'));
  // The voice "cmn" reads its own pinyin as English, at least in Debian 12 (espeak-ng 1.51).
  if (primary == "zh" || primary == "cmn") return "cmn-latn-pinyin";
  if (primary == "no") return "nb";
  return std::string(primary);
}

std::string reading_fault(std::string_view phonemes) {
  Counter counter;
  while (!phonemes.empty()) {
    const std::size_t begin = std::min(phonemes.find_first_not_of(" \n"), phonemes.size());
    phonemes.remove_prefix(begin);
    const std::string_view word = phonemes.substr(0, phonemes.find_first_of(" \n"));
    if (!word.empty()) counter.take(word);
    phonemes.remove_prefix(word.size());
  }
  const auto share = [&](std::size_t part) {
    return static_cast<double>(part) / static_cast<double>(counter.words);
  };
  if (counter.words == 0) return "its voice reads nothing of it";
  if (share(counter.foreign) > most_foreign)
    return fmt::format(
        "its voice does not know the script: it reads {:.0f} of 100 words letter by "
        "letter, in English",
        100 * share(counter.foreign));
  if (share(counter.without_vowel) > most_without_vowel)
    return fmt::format("its voice does not know the vowels: {:.0f} of 100 words have none",
                       100 * share(counter.without_vowel));
  return {};
}

std::map<std::string, std::string> voice_files(std::string_view listed) {
  constexpr int column = 4;  // after priority, language, age/gender and name
  std::map<std::string, std::string> files;
  std::set<std::string> twice;
  std::istringstream lines{std::string(listed)};
  for (std::string line, word; std::getline(lines, line);) {
    std::istringstream words(line);
    for (int i = 0; i <= column; ++i) words >> word;
    const std::size_t slash = word.rfind('/');
    if (!words || slash == std::string::npos) continue;
    std::string name = word.substr(slash + 1);
    std::ranges::transform(name, name.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (!files.emplace(name, word).second) twice.insert(name);
  }
  for (const std::string& name : twice) files.erase(name);
  return files;
}

Espeak Espeak::find(const std::string& program) {
  // All names are bound at once: one that asks more of its player than ours knows gets its own.
  std::string libraries = folder_of_no_player();
  Outcome outcome = run_program({"env", "LD_BIND_NOW=1", program, "--version"}, {}, patience,
                                most_output, libraries);
  if (outcome.kind != Outcome::Kind::Ended || outcome.status != 0) {
    libraries.clear();
    outcome = run_program({program, "--version"}, {}, patience);
  }
  const std::string line = first_line(outcome.output);
  constexpr std::string_view before = "text-to-speech: ";
  const std::size_t at = line.find(before);
  if (outcome.kind == Outcome::Kind::Missing)
    no_voice(program, "the program is not there", "install the package espeak-ng");
  if (outcome.kind != Outcome::Kind::Ended || outcome.status != 0 || at == std::string::npos)
    no_voice(program, "the program does not say its version", "install the package espeak-ng anew");
  const std::string rest = line.substr(at + before.size());
  const Outcome listed = run_program({program, "--voices"}, {}, patience);
  return {program, libraries, rest.substr(0, rest.find(' ')), voice_files(listed.output)};
}

const std::string& Espeak::file_of(const std::string& voice) const {
  const auto file = files_.find(voice);
  return file == files_.end() ? voice : file->second;
}

std::string Espeak::run(std::vector<std::string> arguments, std::string_view text) const {
  arguments.insert(arguments.begin(), program_);
  Outcome outcome = run_program(arguments, plain(text), patience, most_output, libraries_);
  switch (outcome.kind) {
    case Outcome::Kind::Missing:
      no_voice(program_, "the program is not there", "install the package espeak-ng");
    case Outcome::Kind::TooSlow:
      no_voice(program_, fmt::format("the program did not end in {} s", patience / 1s),
               "compile again when the machine has less to do");
    case Outcome::Kind::TooMuch:
      no_voice(program_, "the program makes more sound than a text can have",
               "install the package espeak-ng anew");
    case Outcome::Kind::Ended:
      break;
  }
  if (outcome.status != 0)
    no_voice(program_,
             outcome.errors.find("does not exist") != std::string::npos
                 ? "there is no voice for it"
                 : fmt::format("the program failed ({}): {}", outcome.status,
                               first_line(outcome.errors)),
             "record it yourself, in [[speech]] of museum.toml");
  return std::move(outcome.output);
}

std::string Espeak::phonemes(const std::string& voice, std::string_view text) const {
  return run({"-q", "--ipa", "-b", "1", "-v", file_of(voice), "--stdin"}, text);
}

/// espeak-ng 1.51 looks at memory that it never wrote where an Arabic number ends in nine. What
/// lies there is now and then no phoneme: it says so before its sound, and says it well the next
/// time.
Pcm Espeak::say(const std::string& voice, std::string_view text) const {
  std::string wav;
  for (int attempt = 0; attempt < 8; ++attempt) {
    wav = run({"-b", "1", "-z", "-s", "160", "-v", file_of(voice), "--stdin", "--stdout"}, text);
    if (wav.empty()) return {};
    if (wav.starts_with("RIFF")) break;
  }
  return read_wav(wav, program_);
}

}  // namespace docent::speech

#include "content/compile/compile_speech.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>

#include "content/content_error.h"
#include "content/read_source.h"
#include "content/speech/make_speech.h"
#include "content/speech/recording.h"
#include "platform/signature/digest.h"
#include "runtime/interface/utterance.h"

namespace docent::compile {

namespace {

Diagnostic with_warning(Diagnostic diagnostic) {
  diagnostic.severity = Severity::Warning;
  return diagnostic;
}

/// Reads [[speech]] of museum.toml, and says what is wrong with it.
class OwnSpeechReader {
 public:
  OwnSpeechReader(const config::MuseumConfig& config, std::span<const speech::WantedSpeech> wanted,
                  Report& report)
      : config_(config), wanted_(wanted), report_(report) {}

  std::vector<speech::OwnSpeech> read() {
    std::vector<speech::OwnSpeech> own;
    for (const config::SpeechSection& section : config_.speech) {
      const auto language =
          std::ranges::find(wanted_, section.language.value, &speech::WantedSpeech::tag);
      if (!section.language.given || !section.text.given) continue;  // already reported
      if (language == wanted_.end())
        say_unknown_language(section);
      else if (is_a_piece(section, *language))
        take(section, language->language, own);
    }
    return own;
  }

 private:
  void say_unknown_language(const config::SpeechSection& section) {
    report_.add(config::diagnostic_at(
        config_, section.language.place, "unknown-language",
        fmt::format("the museum does not speak '{}'", section.language.value), {},
        fmt::format("the languages are: {}", fmt::join(config_.languages, ", "))));
  }

  bool is_a_piece(const config::SpeechSection& section, const speech::WantedSpeech& language) {
    if (std::ranges::find(language.pieces, section.text.value) != language.pieces.end())
      return true;
    report_.add(with_warning(config::diagnostic_at(
        config_, section.text.place, "never-said",
        fmt::format("the kiosk never says '{}' by itself", section.text.value), {},
        "write a title, a text or a word of the interface as a whole, letter by letter")));
    return false;
  }

  void take(const config::SpeechSection& section, std::uint32_t language,
            std::vector<speech::OwnSpeech>& own) {
    speech::OwnSpeech piece{.language = language,
                            .text = section.text.value,
                            .digest = {},
                            .recording = {},
                            .reading = section.reading.value};
    if (section.recording.given) {
      const std::filesystem::path file = config_.folder / section.recording.value;
      try {
        const std::string bytes = content::read_source(file);
        piece.recording = speech::read_sound(bytes, file.string());
        signature::Digest digest;
        digest.add(std::as_bytes(std::span(bytes)));
        piece.digest = digest.finish();
      } catch (const content::ContentError& error) {
        return report_.add(config::diagnostic_at(
            config_, section.recording.place, error.code,
            fmt::format("'{}': {}", section.recording.value, error.what()), {}, error.hint));
      }
    }
    own.push_back(std::move(piece));
  }

  const config::MuseumConfig& config_;
  std::span<const speech::WantedSpeech> wanted_;
  Report& report_;
};

std::vector<speech::WantedSpeech> wanted_speech(const Museum& museum) {
  std::vector<speech::WantedSpeech> wanted;
  for (std::uint32_t i = 0; i < museum.languages.size(); ++i)
    wanted.push_back({.language = i,
                      .tag = museum.languages[i].tag,
                      .pieces = interface::spoken_pieces(museum, i)});
  return wanted;
}

/// Where all languages are silent for the same reason, that is told once.
void tell(const config::MuseumConfig& config, const std::vector<speech::LanguageSpeech>& languages,
          Report& report) {
  std::vector<std::string> told;
  for (const speech::LanguageSpeech& language : languages) {
    if (language.silent.empty()) continue;
    const bool is_all = std::ranges::all_of(
        languages, [&](const auto& other) { return other.silent == language.silent; });
    const std::string what =
        is_all && languages.size() > 1
            ? fmt::format("nothing is spoken: {}", language.silent)
            : fmt::format("'{}' is not spoken: {}", language.tag, language.silent);
    if (std::ranges::find(told, what) != told.end()) continue;
    told.push_back(what);
    report.add(with_warning(config::diagnostic_at(
        config, config.museum.languages.place, "not-spoken", what, {},
        "who cannot see the screen needs it: give recordings, or how it is read, in [[speech]]")));
  }
}

}  // namespace

void compile_speech(const config::MuseumConfig& config, Speech use,
                    const std::vector<SpeechSound>& before, unsigned jobs, Museum& museum,
                    Report& report) {
  const std::vector<speech::WantedSpeech> wanted = wanted_speech(museum);
  const std::vector<speech::OwnSpeech> own = OwnSpeechReader(config, wanted, report).read();
  if (use == Speech::Check || report.has_errors()) return;
  speech::MadeSpeech made =
      speech::make_speech({.wanted = wanted, .own = own, .before = before, .jobs = jobs});
  museum.speech = std::move(made.sounds);
  tell(config, made.languages, report);
}

}  // namespace docent::compile

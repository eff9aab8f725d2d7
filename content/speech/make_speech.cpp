#include "content/speech/make_speech.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "content/content_error.h"
#include "content/parallel.h"
#include "content/speech/kana.h"
#include "content/speech/level.h"
#include "content/speech/resample.h"
#include "content/speech/voice.h"
#include "platform/opus/encoder.h"
#include "platform/signature/digest.h"

namespace docent::speech {

namespace {

constexpr int bits_per_second = 24'000;
/// Raise it where the same text and voice are to sound otherwise: all is made anew then.
constexpr std::string_view manner = "3";

using Key = std::tuple<std::uint32_t, std::string_view>;

/// A piece on its way to its sound.
struct Piece {
  std::uint32_t language = 0;
  std::string text;
  std::string voice;
  const OwnSpeech* own = nullptr;
  std::string in_kana{};  ///< Of Japanese; empty where nobody could read it.

  [[nodiscard]] bool is_recorded() const { return own != nullptr && !own->digest.empty(); }
  [[nodiscard]] std::string_view read_as() const {
    if (own != nullptr && !own->reading.empty()) return own->reading;
    return in_kana.empty() ? text : in_kana;
  }
};

std::string digest_of(std::span<const std::string_view> parts) {
  signature::Digest digest;
  for (const std::string_view part : parts) {
    digest.add(std::as_bytes(std::span(part)));
    digest.add(std::as_bytes(std::span("", 1)));
  }
  return digest.finish().substr(0, 32);
}

std::string digest_of(const Piece& piece, std::string_view version) {
  if (piece.is_recorded())
    return digest_of({{manner, "recording", piece.own->digest, opus::encoder_version()}});
  return digest_of({{manner, version, piece.voice, piece.read_as(), opus::encoder_version()}});
}

/// The sound as it is stored; empty packets where there is nothing to hear. `voice`: for sounds of
/// the rate that the voices have.
void encode(const Pcm& pcm, const Resampler& voice, SpeechSound& sound) {
  if (pcm.samples.empty()) return;
  const std::vector<float> samples =
      pcm.rate == voice.from() ? voice.resample(pcm.samples) : resample(pcm, opus::encoder_rate);
  const auto heard = without_silence(samples, opus::encoder_rate);
  std::vector<float> kept(heard.begin(), heard.end());
  level(kept);
  const auto encoded = opus::encode(kept, bits_per_second);
  if (!encoded) throw content::to_content_error(encoded.error(), "Opus", "not-encoded");
  sound.skip = encoded->skip;
  sound.samples = encoded->samples;
  sound.packets = encoded->packets;
}

/// One language, with its pieces, and how far it is.
struct SpokenLanguage {
  std::vector<Piece> pieces;
  LanguageSpeech told;
  std::string no_reader{};  ///< Of Japanese: why it could not be read.
};

/// Has kanji read that neither a recording nor staff say otherwise.
void read_kanji(const std::string& reader, SpokenLanguage& language) {
  std::vector<std::string_view> texts;
  for (const Piece& piece : language.pieces) texts.push_back(piece.text);
  try {
    std::vector<std::string> said = read_in_kana(texts, reader);
    for (std::size_t i = 0; i < said.size(); ++i) language.pieces[i].in_kana = std::move(said[i]);
  } catch (const content::ContentError& error) {
    language.no_reader = fmt::format("{}: {}; {}", error.file, error.what(), error.hint);
  }
}

/// Which voice reads it, and does it read it well? A text of all that it is to read.
std::string fault_of_voice(const Espeak& espeak, const std::string& voice,
                           std::span<const Piece* const> pieces) {
  std::string text;
  for (const Piece* piece : pieces) text.append(piece->read_as()).append("\n");
  try {
    return reading_fault(espeak.phonemes(voice, text));
  } catch (const content::ContentError& error) {
    return error.what();
  }
}

class Maker {
 public:
  explicit Maker(const SpeechSources& sources) : sources_(sources) {
    for (const OwnSpeech& own : sources.own) own_[{own.language, own.text}] = &own;
    for (const SpeechSound& sound : sources.before)
      before_.emplace(std::pair<std::string_view, std::string_view>(sound.made_of, sound.text),
                      &sound);
    try {
      espeak_ = Espeak::find(sources.program);
    } catch (const content::ContentError& error) {
      no_program_ = fmt::format("{}: {}; {}", error.file, error.what(), error.hint);
    }
  }

  MadeSpeech make() {
    std::vector<SpokenLanguage> languages;
    for (const WantedSpeech& wanted : sources_.wanted) languages.push_back(begin(wanted));
    content::for_each_index(languages.size(), sources_.jobs,
                            [&](std::size_t i) { judge(languages[i]); });
    std::vector<std::pair<SpokenLanguage*, const Piece*>> wanted;
    for (SpokenLanguage& language : languages)
      if (language.told.silent.empty())
        for (const Piece& piece : language.pieces) wanted.emplace_back(&language, &piece);
    std::vector<SpeechSound> sounds(wanted.size());
    std::vector<std::string> faults(wanted.size());
    content::for_each_index(wanted.size(), sources_.jobs,
                            [&](std::size_t i) { faults[i] = fill(*wanted[i].second, sounds[i]); });
    MadeSpeech made;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (std::string& silent = wanted[i].first->told.silent; silent.empty()) silent = faults[i];
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      LanguageSpeech& told = wanted[i].first->told;
      if (!told.silent.empty() || sounds[i].samples == 0) continue;
      told.seconds += static_cast<double>(sounds[i].samples) / SpeechSound::rate;
      made.sounds.push_back(std::move(sounds[i]));
    }
    for (SpokenLanguage& language : languages) made.languages.push_back(std::move(language.told));
    return made;
  }

 private:
  SpokenLanguage begin(const WantedSpeech& wanted) const {
    SpokenLanguage language;
    language.told.tag = wanted.tag;
    for (const std::string& text : std::set(wanted.pieces.begin(), wanted.pieces.end())) {
      const auto own = own_.find(Key{wanted.language, text});
      language.pieces.push_back({.language = wanted.language,
                                 .text = text,
                                 .voice = voice_name(wanted.tag),
                                 .own = own == own_.end() ? nullptr : own->second});
    }
    language.told.pieces = language.pieces.size();
    if (wanted.tag.substr(0, wanted.tag.find('-')) == "ja") read_kanji(sources_.reader, language);
    return language;
  }

  const SpeechSound* made_before(const Piece& piece) const {
    const auto found = before_.find({digest_of(piece, version()), piece.text});
    return found == before_.end() ? nullptr : found->second;
  }

  /// Is the language spoken? What was made before has been judged before.
  void judge(SpokenLanguage& language) const {
    std::vector<const Piece*> to_read;
    bool is_known = true;
    for (const Piece& piece : language.pieces) {
      const bool is_made = made_before(piece) != nullptr;
      if (piece.is_recorded()) ++language.told.recorded;
      if (is_made) ++language.told.taken_over;
      if (piece.is_recorded()) continue;
      to_read.push_back(&piece);
      is_known = is_known && is_made;
    }
    if (to_read.empty() || is_known) return;
    std::string& silent = language.told.silent;
    silent = espeak_ ? fault_of_voice(*espeak_, to_read.front()->voice, to_read) : no_program_;
    if (!silent.empty() && !language.no_reader.empty()) silent += "; " + language.no_reader;
    if (!silent.empty() && language.told.recorded > 0)
      silent += fmt::format("; {} of {} pieces are recorded", language.told.recorded,
                            language.told.pieces);
  }

  /// Makes a sound; says what is wrong where that fails.
  std::string fill(const Piece& piece, SpeechSound& sound) const {
    if (const SpeechSound* before = made_before(piece)) {
      sound = *before;
      sound.language = piece.language;
      return {};
    }
    sound.language = piece.language;
    sound.text = piece.text;
    sound.made_of = digest_of(piece, version());
    try {
      encode(
          piece.is_recorded() ? piece.own->recording : espeak_->say(piece.voice, piece.read_as()),
          resampler_, sound);
      return {};
    } catch (const content::ContentError& error) {
      return fmt::format("'{}' cannot be said: {}", piece.text, error.what());
    }
  }

  [[nodiscard]] std::string_view version() const {
    return espeak_ ? std::string_view(espeak_->version()) : std::string_view("none");
  }

  const SpeechSources& sources_;
  std::map<Key, const OwnSpeech*> own_;
  std::map<std::pair<std::string, std::string_view>, const SpeechSound*> before_;
  std::optional<Espeak> espeak_;
  std::string no_program_;
  Resampler resampler_{Espeak::rate, opus::encoder_rate};
};

}  // namespace

MadeSpeech make_speech(const SpeechSources& sources) {
  return Maker(sources).make();
}

}  // namespace docent::speech

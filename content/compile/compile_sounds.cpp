#include "content/compile/compile_sounds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "content/compile/caption_file.h"
#include "content/content_error.h"
#include "content/read_source.h"
#include "content/speech/level.h"
#include "content/speech/recording.h"
#include "content/speech/resample.h"
#include "platform/file/read_file.h"
#include "platform/opus/encoder.h"
#include "platform/signature/digest.h"

namespace docent::compile {
namespace {

/// Bytes: five minutes of two channels of 24 bits, 96,000 a second.
constexpr std::size_t largest_recording = std::size_t{180} << 20U;
constexpr double shortest = 0.2;  // seconds
/// Raise it where the same recording is to sound otherwise: all are made anew then.
constexpr std::string_view manner = "sound 1";

std::string digest_of(std::string_view bytes) {
  signature::Digest digest;
  for (const std::string_view part : {manner, std::string_view(opus::encoder_version()), bytes}) {
    digest.add(std::as_bytes(std::span(part)));
    digest.add(std::as_bytes(std::span("", 1)));
  }
  return digest.finish().substr(0, 32);
}

/// Of one channel, at the rate of what is kept.
SpeechSound encode(const speech::Pcm& pcm) {
  std::vector<float> samples = speech::resample(pcm, SpeechSound::rate);
  speech::level(samples);
  const auto encoded = opus::encode_sound(samples);
  if (!encoded) throw content::to_content_error(encoded.error(), "Opus", "not-encoded");
  return {.language = 0,
          .text = {},
          .made_of = {},
          .skip = encoded->skip,
          .samples = encoded->samples,
          .packets = encoded->packets};
}

class SoundReader {
 public:
  SoundReader(const config::MuseumConfig& config, Sounds use,
              const std::vector<SpeechSound>& before, Museum& museum, Report& report)
      : config_(config), use_(use), before_(before), museum_(museum), report_(report) {}

  void read(const config::ExhibitSoundSection& section, std::uint32_t sound) {
    std::uint32_t length = 0;  // milliseconds, of the longest
    if (section.recording.given) length = take(section.recording, 0, sound);
    for (std::uint32_t language = 0; language < museum_.languages.size(); ++language) {
      const auto found = section.spoken.value.find(museum_.languages[language].tag);
      if (found != section.spoken.value.end() && found->second.given)
        length = std::max(length, take(found->second, language, sound));
    }
    if (length > 0) read_captions(section, sound, length);
    if (!section.spoken.value.empty()) tell_missing(section.spoken, "recording", "hear that");
  }

 private:
  /// Milliseconds; 0 where it cannot be used, which is told.
  std::uint32_t take(const config::Located<std::string>& name, std::uint32_t language,
                     std::uint32_t sound) {
    const std::filesystem::path file = config_.folder / name.value;
    if (!file::is_there(file)) return 0;  // already reported
    try {
      return take(bytes_of(file), file, language, sound);
    } catch (const content::ContentError& error) {
      report_.add(config::diagnostic_at(config_, name.place, error.code,
                                        fmt::format("'{}': {}", name.value, error.what()), {},
                                        error.hint));
      return 0;
    }
  }

  static std::string bytes_of(const std::filesystem::path& file) {
    Result<std::string> bytes = file::read_file(file, largest_recording);
    if (!bytes)
      throw content::to_content_error(
          bytes.error(), file.string(), "unreadable-recording",
          fmt::format("save it as Opus: {} minutes take 3 MB", ExhibitSound::longest / 60));
    return std::move(*bytes);
  }

  std::uint32_t take(const std::string& bytes, const std::filesystem::path& file,
                     std::uint32_t language, std::uint32_t sound) {
    const std::string made_of = digest_of(bytes);
    const auto found = std::ranges::find_if(before_, [&](const SpeechSound& one) {
      return is_recording(one) && one.made_of == made_of;
    });
    SpeechSound made;
    if (found != before_.end()) {
      made = *found;
    } else {
      const speech::Pcm pcm = speech::read_sound(bytes, file.string());
      check(pcm, file);
      if (use_ == Sounds::Check)
        return static_cast<std::uint32_t>(1000.0 * static_cast<double>(pcm.samples.size()) /
                                          pcm.rate);
      made = encode(pcm);
      made.made_of = made_of;
    }
    made.language = language;
    made.text = RecordingKey(sound).text();
    const std::uint64_t length = std::uint64_t{1000} * made.samples / SpeechSound::rate;
    museum_.speech.push_back(std::move(made));
    return static_cast<std::uint32_t>(length);
  }

  static void check(const speech::Pcm& pcm, const std::filesystem::path& file) {
    const auto refuse = [&](const char* code, const std::string& what, std::string hint) {
      throw content::ContentError(file.string(), 0, 0, code, what, std::move(hint));
    };
    const double seconds = static_cast<double>(pcm.samples.size()) / pcm.rate;
    if (seconds > ExhibitSound::longest)
      refuse("sound-too-long",
             fmt::format("it lasts {:.0f} s, and nobody stands and listens for more than {} s",
                         seconds, ExhibitSound::longest),
             "cut it, or make several of it");
    if (seconds < shortest)
      refuse("sound-too-short", fmt::format("it lasts only {:.2f} s", seconds),
             "record more of it: what is that short is taken for a fault");
    if (std::ranges::none_of(pcm.samples, [](float sample) { return std::abs(sample) > 0.003F; }))
      refuse("silent-sound", "nothing is heard in it", "record it again, louder");
  }

  void read_captions(const config::ExhibitSoundSection& section, std::uint32_t sound,
                     std::uint32_t length) {
    const auto& files = section.captions.value;
    for (std::uint32_t language = 0; language < museum_.languages.size(); ++language) {
      const auto file = files.find(museum_.languages[language].tag);
      if (file == files.end() || !file->second.given) continue;
      const Captioned captioned{.what = "sound",
                                .length = std::min(length, SoundCue::latest),
                                .most = SoundCue::most,
                                .most_letters = SoundCue::most_letters};
      const std::filesystem::path path = config_.folder / file->second.value;
      if (!file::is_there(path)) continue;  // already reported
      for (import::TimedCaption& one : read_caption_file(path, captioned, report_))
        museum_.sound_cues.push_back({.sound = sound,
                                      .language = language,
                                      .begin = one.begin,
                                      .end = one.end,
                                      .text = std::move(one.text)});
    }
    if (!files.empty()) tell_missing(section.captions, "captions", "read those");
  }

  void tell_missing(const config::Located<config::LocatedTexts>& files, std::string_view what,
                    std::string_view instead) {
    std::vector<std::string> missing;
    for (const Language& language : museum_.languages)
      if (!files.value.contains(language.tag)) missing.push_back(language.tag);
    if (missing.empty()) return;
    Diagnostic told = config::diagnostic_at(
        config_, files.place, what == "captions" ? "captions-missing" : "recording-missing",
        fmt::format("a sound has no {} in {}", what, fmt::join(missing, ", ")), {},
        fmt::format("until then visitors {} of another language", instead));
    told.severity = Severity::Warning;
    report_.add(std::move(told));
  }

  const config::MuseumConfig& config_;
  Sounds use_;
  const std::vector<SpeechSound>& before_;
  Museum& museum_;
  Report& report_;
};

}  // namespace

void compile_sounds(const config::MuseumConfig& config, Sounds use,
                    const std::vector<SpeechSound>& before, Museum& museum, Report& report) {
  SoundReader reader(config, report.has_errors() ? Sounds::Check : use, before, museum, report);
  std::uint32_t sound = 0;
  for (const config::ExhibitSection& exhibit : config.exhibits)
    for (const config::ExhibitSoundSection& section : exhibit.sounds.value)
      reader.read(section, sound++);
  std::ranges::sort(museum.speech, {}, [](const SpeechSound& one) {
    return std::tuple(one.language, std::string_view(one.text));
  });
}

}  // namespace docent::compile

#include "config/exhibit_media.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "platform/file/read_file.h"
#include "platform/file/text_encoding.h"
#include "runtime/model/exhibit/exhibit_sound.h"
#include "runtime/model/exhibit/longer_text.h"

namespace docent::config {
namespace {

/// The line ends of Windows (\r\n) and of old Macs (\r) are \n.
std::string with_plain_line_ends(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool is_pair = text.substr(at).starts_with("\r\n");
    if (!is_pair) plain += text[at] == '\r' ? '\n' : text[at];
  }
  return plain;
}

class MediaReader {
 public:
  MediaReader(MuseumConfig& config, MuseumPaths& paths, std::vector<Diagnostic>& diagnostics)
      : config_(config), paths_(paths), diagnostics_(diagnostics) {}

  /// One leafs on from the exhibit's own picture.
  void check_pictures(const ExhibitSection& exhibit) {
    const std::vector<PictureSection>& pictures = exhibit.pictures.value;
    if (pictures.empty()) return;
    if (config_.sources.empty())
      if (auto missing = missing_first_picture(config_, exhibit))
        diagnostics_.push_back(std::move(*missing));
    for (const PictureSection& picture : pictures) check_captions(picture);
    if (pictures.size() < FurtherPicture::most) return;
    error(exhibit.pictures.place, "out-of-range",
          fmt::format("exhibit '{}' has {} pictures, its own one included", exhibit.id.value,
                      pictures.size() + 1),
          {}, fmt::format("visitors leaf through at most {}", FurtherPicture::most));
  }

  /// Each is one recording for everybody, or one by language.
  void check_sounds(const ExhibitSection& exhibit) {
    const std::vector<ExhibitSoundSection>& sounds = exhibit.sounds.value;
    for (std::size_t i = 0; i < sounds.size(); ++i) {
      const ExhibitSoundSection& sound = sounds[i];
      const std::string which = fmt::format("sound {} of exhibit '{}'", i + 1, exhibit.id.value);
      if (sound.recording.given && sound.spoken.given)
        error(sound.spoken.place, "bad-value",
              which + " has both a recording for everybody and some by language", {},
              "keep 'recording', or 'spoken' by language");
      else if (sound.recording.place.range == sound.place.range &&
               sound.spoken.place.range == sound.place.range)  // neither is written
        error(sound.place, "missing-field", which + " has no recording", {},
              "write recording = \"sounds/...\", or spoken.en = \"sounds/...\" for each language");
      else if (sound.spoken.given && sound.spoken.value.empty())
        error(sound.spoken.place, "missing-field", which + " is spoken in no language", {},
              "write spoken.en = \"sounds/...\"");
      check_files(sound.spoken, "a recording is");
      check_files(sound.captions, "captions are");
    }
    if (sounds.size() > ExhibitSound::most)
      error(exhibit.sounds.place, "out-of-range",
            fmt::format("exhibit '{}' has {} sounds", exhibit.id.value, sounds.size()), {},
            fmt::format("visitors choose among at most {}", ExhibitSound::most));
  }

  /// Its own shape is told one way, and completely.
  void check_shape(const ExhibitSection& exhibit) {
    const std::array<std::pair<std::string_view, const Place*>, 3> shapes{
        {{"model", exhibit.model.given ? &exhibit.model.place : nullptr},
         {"turned", exhibit.turned.given ? &exhibit.turned.place : nullptr},
         {"relief", exhibit.relief.given ? &exhibit.relief.place : nullptr}}};
    std::string_view first;
    for (const auto& [key, place] : shapes) {
      if (place == nullptr) continue;
      if (!first.empty())
        error(*place, "bad-value",
              fmt::format("exhibit '{}' has both '{}' and '{}'", exhibit.id.value, first, key), {},
              "keep one of them: it stands there once");
      first = key;
    }
    for (const auto& [key, field] :
         {std::pair{"colour", &exhibit.colour}, std::pair{"wrapped", &exhibit.wrapped}})
      if (field->given && !is_written(exhibit, exhibit.turned))
        error(field->place, "bad-value",
              fmt::format("exhibit '{}' has '{}', which is of what is turned, and no 'turned'",
                          exhibit.id.value, key),
              {}, "write turned = [[radius, height], ...], or leave it out");
    const std::string_view made = exhibit.turned.given   ? "turned"
                                  : exhibit.relief.given ? "relief"
                                                         : "";
    if (exhibit.up.given && !made.empty() && !exhibit.model.given)
      error(exhibit.up.place, "bad-value",
            fmt::format("exhibit '{}' has 'up', which is of a 'model', and '{}', which stands "
                        "upright as it is",
                        exhibit.id.value, made),
            {}, "leave 'up' out");
    if (exhibit.relief.given && !is_written(exhibit, exhibit.height))
      error(exhibit.relief.place, "missing-field",
            fmt::format("exhibit '{}' has a relief, and no height: a picture does not tell how "
                        "large a thing is",
                        exhibit.id.value),
            {}, "write height = 0.34, in metres, as it stands");
    check_file(exhibit.wrapped);
    check_file(exhibit.relief);
  }

  /// Puts what the files of `more_file` hold among the texts of `more`.
  void read_more(ExhibitSection& exhibit) {
    for (auto& [tag, name] : exhibit.more_file.value) {
      if (!name.given) continue;
      if (exhibit.more.value.contains(tag)) {
        error(name.place, "bad-value",
              fmt::format("exhibit '{}' has both more.{} and more_file.{}", exhibit.id.value, tag,
                          tag),
              {}, "keep one of them");
        continue;
      }
      Located<std::string> text = name;
      if (!read_text(name, text.value)) continue;
      exhibit.more.value.emplace(tag, std::move(text));
      if (!exhibit.more.given) exhibit.more.place = exhibit.more_file.place;
      exhibit.more.given = true;
    }
  }

 private:
  void error(const Place& place, std::string code, std::string message, std::string label,
             std::string hint) {
    diagnostics_.push_back(diagnostic_at(config_, place, std::move(code), std::move(message),
                                         std::move(label), std::move(hint)));
  }

  /// Wrongly or rightly.
  static bool is_written(const ExhibitSection& exhibit, const auto& field) {
    return field.given || field.place.range != exhibit.place.range;
  }

  void check_file(const Located<std::string>& name) {
    if (!name.given) return;
    if (auto fault = paths_.fault(name.value))
      error(name.place, std::move(fault->code), std::move(fault->message), std::move(fault->label),
            std::move(fault->hint));
  }

  /// What is in the files is read when the museum is compiled.
  void check_captions(const PictureSection& picture) {
    if (!picture.captions.given) return;
    if (!picture.image.value.ends_with(".webm"))
      error(picture.captions.place, "bad-value",
            fmt::format("'{}' is no video, and has no time for captions", picture.image.value), {},
            "what is read below a picture is its 'caption'");
    check_files(picture.captions, "captions are");
  }

  /// Files by language: `these_are` says what they are.
  void check_files(const Located<LocatedTexts>& files, std::string_view these_are) {
    for (const auto& [tag, name] : files.value) {
      if (!name.given) continue;
      if (std::ranges::find(config_.languages, tag) == config_.languages.end())
        error({name.place.file, name.key}, "unknown-language",
              fmt::format("{} given in '{}', which the museum does not speak", these_are, tag), {},
              fmt::format("the languages are: {}", fmt::join(config_.languages, ", ")));
      else if (auto fault = paths_.fault(name.value))
        error(name.place, std::move(fault->code), std::move(fault->message),
              std::move(fault->label), std::move(fault->hint));
    }
  }

  /// The text of a file that staff name; false where it cannot be read, which is told.
  bool read_text(const Located<std::string>& name, std::string& text) {
    constexpr std::size_t largest = 4 * longest_more;  // bytes
    if (auto fault = paths_.fault(name.value)) {
      error(name.place, std::move(fault->code), std::move(fault->message), std::move(fault->label),
            std::move(fault->hint));
      return false;
    }
    Result<std::string> bytes = file::read_file(config_.folder / name.value, largest);
    if (!bytes) {
      error(name.place, "unreadable-file", bytes.error().what, {},
            fmt::format("a text for visitors has at most {} letters", longest_more));
      return false;
    }
    if (auto fault = file::encoding_fault(*bytes)) {
      const std::string where = fault->line > 0 ? fmt::format(":{}", fault->line) : "";
      error(name.place, "not-utf8", fmt::format("{}{} {}", name.value, where, fault->message), {},
            std::move(fault->hint));
      return false;
    }
    text = with_plain_line_ends(file::without_byte_order_mark(*bytes));
    while (text.ends_with('\n')) text.pop_back();
    return true;
  }

  MuseumConfig& config_;
  MuseumPaths& paths_;
  std::vector<Diagnostic>& diagnostics_;
};

}  // namespace

std::optional<Diagnostic> missing_first_picture(const MuseumConfig& config,
                                                const ExhibitSection& exhibit) {
  const std::vector<PictureSection>& pictures = exhibit.pictures.value;
  // Where it was written, it has a place of its own, and what is wrong with it is told.
  if (pictures.empty() || exhibit.image.given || !exhibit.image.value.empty() ||
      exhibit.image.place.range != exhibit.place.range)
    return {};
  return diagnostic_at(
      config, exhibit.pictures.place, "missing-field",
      fmt::format("exhibit '{}' has further pictures and no first one", exhibit.id.value), {},
      fmt::format("write image = \"{}\", and take it out of 'pictures'",
                  pictures.front().image.value));
}

void read_exhibit_media(MuseumConfig& config, MuseumPaths& paths,
                        std::vector<Diagnostic>& diagnostics) {
  MediaReader reader(config, paths, diagnostics);
  for (ExhibitSection& exhibit : config.exhibits) {
    reader.check_pictures(exhibit);
    reader.check_sounds(exhibit);
    reader.check_shape(exhibit);
    reader.read_more(exhibit);
  }
}

}  // namespace docent::config

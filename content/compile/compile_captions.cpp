#include "content/compile/compile_captions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "content/import/caption/webvtt.h"
#include "content/read_source.h"
#include "platform/file/read_file.h"
#include "runtime/model/exhibit/longer_text.h"
#include "runtime/video/webm.h"

namespace docent::compile {
namespace {

Diagnostic fault_in(const std::filesystem::path& file, std::uint32_t line, Severity severity,
                    std::string code, std::string message, std::string hint) {
  return {.file = file.string(),
          .line = line,
          .column = line > 0 ? 1U : 0U,
          .severity = severity,
          .code = std::move(code),
          .message = std::move(message),
          .hint = std::move(hint)};
}

/// Milliseconds; nothing where the video cannot be read, which is told elsewhere.
std::optional<std::uint32_t> length_of(const std::filesystem::path& file) {
  const Result<std::string> bytes = file::read_file(file);
  if (!bytes) return {};
  const auto video = video::read_webm(std::as_bytes(std::span(*bytes)));
  if (!video) return {};
  return static_cast<std::uint32_t>(video->duration().count());
}

class CaptionReader {
 public:
  CaptionReader(const config::MuseumConfig& config, Museum& museum, Report& report)
      : config_(config), museum_(museum), report_(report) {}

  void read(const config::PictureSection& section, std::uint32_t picture) {
    const auto& files = section.captions.value;
    std::optional<std::uint32_t> length;
    std::vector<std::string> missing;
    for (std::uint32_t language = 0; language < museum_.languages.size(); ++language) {
      const std::string& tag = museum_.languages[language].tag;
      const auto file = files.find(tag);
      if (file == files.end()) {
        missing.push_back(tag);
        continue;
      }
      if (!length) length = length_of(config_.folder / section.image.value).value_or(Cue::latest);
      read_file(config_.folder / file->second.value, *length, picture, language);
    }
    if (!files.empty() && !missing.empty()) tell_missing(section, missing);
  }

 private:
  void read_file(const std::filesystem::path& file, std::uint32_t length, std::uint32_t picture,
                 std::uint32_t language) {
    std::string text;
    try {
      text = content::read_text_source(file, "unreadable-captions");
    } catch (const content::ContentError& error) {
      return report_.add(content::to_diagnostic(error));
    }
    import::CaptionFile read = import::read_webvtt(text, file.string());
    report_.add(read.faults);
    if (!read.faults.empty() || !are_few(file, read.captions.size())) return;
    const auto late = std::ranges::find_if(
        read.captions, [&](const import::TimedCaption& one) { return one.begin >= length; });
    if (late != read.captions.end())
      report_.add(fault_in(file, late->line, Severity::Warning, "caption-after-end",
                           fmt::format("this caption is never read: its video ends after {:.1f} s",
                                       static_cast<double>(length) / 1000),
                           "take it out, or correct its times"));
    add(file, import::one_at_a_time(std::move(read.captions)), length, picture, language);
  }

  bool are_few(const std::filesystem::path& file, std::size_t count) {
    if (count <= Cue::most) return true;
    report_.add(fault_in(file, 0, Severity::Error, "too-many-captions",
                         fmt::format("the captions of this video change {} times, and a kiosk "
                                     "shows at most {}",
                                     count, Cue::most),
                         "make fewer and longer ones: nobody reads two in a second"));
    return false;
  }

  void add(const std::filesystem::path& file, std::vector<import::TimedCaption> captions,
           std::uint32_t length, std::uint32_t picture, std::uint32_t language) {
    std::erase_if(captions, [&](const import::TimedCaption& one) { return one.begin >= length; });
    if (!are_few(file, captions.size())) return;
    for (import::TimedCaption& one : captions) {
      if (const std::size_t letters = count_letters(one.text); letters > Cue::most_letters) {
        report_.add(
            fault_in(file, 0, Severity::Error, "caption-too-long",
                     fmt::format("at {:.1f} s several captions are read at once, with {} "
                                 "letters together; at most {} can be shown",
                                 static_cast<double>(one.begin) / 1000, letters, Cue::most_letters),
                     "let each end before the next begins"));
        return;
      }
      museum_.cues.push_back({.picture = picture,
                              .language = language,
                              .begin = one.begin,
                              .end = std::min({one.end, length, Cue::latest}),
                              .text = std::move(one.text)});
    }
  }

  void tell_missing(const config::PictureSection& section,
                    const std::vector<std::string>& missing) {
    Diagnostic told = config::diagnostic_at(
        config_, section.captions.place, "captions-missing",
        fmt::format("the video '{}' has no captions in {}", section.image.value,
                    fmt::join(missing, ", ")),
        {},
        fmt::format("write captions.{} = \"...\"; until then visitors read those of another "
                    "language",
                    missing.front()));
    told.severity = Severity::Warning;
    report_.add(std::move(told));
  }

  const config::MuseumConfig& config_;
  Museum& museum_;
  Report& report_;
};

}  // namespace

void compile_captions(const config::MuseumConfig& config, Museum& museum, Report& report) {
  CaptionReader reader(config, museum, report);
  std::uint32_t picture = 0;
  for (const config::ExhibitSection& exhibit : config.exhibits)
    for (const config::PictureSection& section : exhibit.pictures.value)
      reader.read(section, picture++);
}

}  // namespace docent::compile

#include "content/compile/compile_captions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "content/compile/caption_file.h"
#include "platform/file/read_file.h"
#include "runtime/video/webm.h"

namespace docent::compile {
namespace {

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
      add(config_.folder / file->second.value, *length, picture, language);
    }
    if (!files.empty() && !missing.empty()) tell_missing(section, missing);
  }

 private:
  void add(const std::filesystem::path& file, std::uint32_t length, std::uint32_t picture,
           std::uint32_t language) {
    const Captioned video{.what = "video",
                          .length = std::min(length, Cue::latest),
                          .most = Cue::most,
                          .most_letters = Cue::most_letters};
    for (import::TimedCaption& one : read_caption_file(file, video, report_))
      museum_.cues.push_back({.picture = picture,
                              .language = language,
                              .begin = one.begin,
                              .end = one.end,
                              .text = std::move(one.text)});
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

#include "content/compile/caption_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "content/read_source.h"
#include "runtime/model/exhibit/longer_text.h"

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

double seconds(std::uint32_t milliseconds) {
  return static_cast<double>(milliseconds) / 1000;
}

bool are_few(const std::filesystem::path& file, std::size_t count, const Captioned& of,
             Report& report) {
  if (count <= of.most) return true;
  report.add(fault_in(file, 0, Severity::Error, "too-many-captions",
                      fmt::format("the captions of this {} change {} times, and a kiosk shows at "
                                  "most {}",
                                  of.what, count, of.most),
                      "make fewer and longer ones: nobody reads two in a second"));
  return false;
}

void tell_late(const std::filesystem::path& file, const import::CaptionFile& read,
               const Captioned& of, Report& report) {
  const auto late = std::ranges::find_if(
      read.captions, [&](const import::TimedCaption& one) { return one.begin >= of.length; });
  if (late == read.captions.end()) return;
  report.add(fault_in(file, late->line, Severity::Warning, "caption-after-end",
                      fmt::format("this caption is never read: its {} ends after {:.1f} s", of.what,
                                  seconds(of.length)),
                      "take it out, or correct its times"));
}

/// Where several are read at once.
bool are_short(const std::filesystem::path& file, const std::vector<import::TimedCaption>& captions,
               const Captioned& of, Report& report) {
  for (const import::TimedCaption& one : captions)
    if (const std::size_t letters = count_letters(one.text); letters > of.most_letters) {
      report.add(fault_in(file, 0, Severity::Error, "caption-too-long",
                          fmt::format("at {:.1f} s several captions are read at once, with {} "
                                      "letters together; at most {} can be shown",
                                      seconds(one.begin), letters, of.most_letters),
                          "let each end before the next begins"));
      return false;
    }
  return true;
}

}  // namespace

std::vector<import::TimedCaption> read_caption_file(const std::filesystem::path& file,
                                                    const Captioned& of, Report& report) {
  std::string text;
  try {
    text = content::read_text_source(file, "unreadable-captions");
  } catch (const content::ContentError& error) {
    report.add(content::to_diagnostic(error));
    return {};
  }
  import::CaptionFile read = import::read_webvtt(text, file.string());
  report.add(read.faults);
  if (!read.faults.empty() || !are_few(file, read.captions.size(), of, report)) return {};
  tell_late(file, read, of, report);
  std::vector<import::TimedCaption> captions = import::one_at_a_time(std::move(read.captions));
  std::erase_if(captions, [&](const import::TimedCaption& one) { return one.begin >= of.length; });
  if (!are_few(file, captions.size(), of, report) || !are_short(file, captions, of, report))
    return {};
  for (import::TimedCaption& one : captions) one.end = std::min(one.end, of.length);
  return captions;
}

}  // namespace docent::compile

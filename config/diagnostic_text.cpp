#include "config/diagnostic_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "config/alike.h"
#include "platform/file/text_encoding.h"

namespace docent::config {

namespace {

std::string_view name_of(Severity severity) {
  return severity == Severity::Error ? "error" : "warning";
}

/// The bytes of the first `count` characters of a text (UTF-8: every byte but a continuation begins
/// one).
std::size_t bytes_of(std::string_view text, std::size_t count) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    const bool begins = (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U;
    if (begins && count-- == 0) break;
  }
  return at;
}

/// A text with a picture of each control character, so that whatever a file holds neither moves a
/// terminal's cursor nor colours it. Tabs stay, and line ends where `lines` says so.
enum class Lines : std::uint8_t { One, Several };
std::string visible(std::string_view text, Lines lines = Lines::One) {
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool is_second_set =
        c == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    const bool is_kept = c == '\t' || (c == '\n' && lines == Lines::Several);
    if (!is_kept && (c < 0x20 || c == 0x7F)) {
      shown +=
          {'\xE2', '\x90', static_cast<char>(0x80U + (c == 0x7F ? 0x21U : c))};  // U+2400 and on
    } else if (is_second_set) {
      shown += "\uFFFD";
      ++i;
    } else {
      shown += text[i];
    }
  }
  return shown;
}

/// A line of a source, as it can be shown.
struct SourceLine {
  std::string text;
  bool is_ascii = false;

  std::size_t bytes_of_first(std::size_t characters) const {
    return is_ascii ? std::min(characters, text.size()) : bytes_of(text, characters);
  }
};

std::optional<SourceLine> read_line(const std::string& file, std::uint32_t number) {
  std::ifstream in(file);
  std::string line;
  for (std::uint32_t i = 0; i < number; ++i)
    if (!std::getline(in, line)) return {};
  if (line.find('\0') != std::string::npos) return {};  // no text
  if (line.ends_with('\r')) line.pop_back();
  if (number == 1) line = file::without_byte_order_mark(line);
  SourceLine shown{.text = visible(file::shown_as_utf8(line))};
  shown.is_ascii = std::ranges::all_of(
      shown.text, [](char c) { return (static_cast<unsigned char>(c) & 0x80U) == 0; });
  return shown;
}

/// Lines of sources. The last is kept: of a generated file, which is all one line, there may be
/// thousands of things to tell.
class SourceLines {
 public:
  /// Empty where the line is no longer there.
  const std::optional<SourceLine>& line(const std::string& file, std::uint32_t number) {
    if (file != file_ || number != number_) line_ = read_line(file, number);
    file_ = file;
    number_ = number;
    return line_;
  }

 private:
  std::string file_;
  std::uint32_t number_ = 0;
  std::optional<SourceLine> line_;
};

/// Spaces (and the line's own tabs) that move the carets under the column.
std::string indentation(std::string_view line, std::uint32_t column) {
  std::string spaces;
  for (const char c : line.substr(0, bytes_of(line, column - 1)))
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) spaces += c == '\t' ? '\t' : ' ';
  return spaces;
}

/// What is shown of a line: all of it, or where it is as long as generated files have them the part
/// about a column.
struct Shown {
  std::string text;
  std::uint32_t column = 0;  ///< Where that column is in the text.
};
Shown part_about(const SourceLine& line, std::uint32_t column) {
  constexpr std::size_t longest = 200, before = 60;  // Characters.
  if (line.bytes_of_first(longest) == line.text.size()) return {line.text, column};
  const std::size_t first = column > before ? column - before : 0;
  const auto rest = std::string_view(line.text).substr(line.bytes_of_first(first));
  const std::string_view part = rest.substr(0, bytes_of(rest, longest));
  const std::string_view left = first > 0 ? "..." : "";
  const std::string_view right = part.size() < rest.size() ? "..." : "";
  const auto moved = static_cast<std::uint32_t>(left.size()) - static_cast<std::uint32_t>(first);
  return {fmt::format("{}{}{}", left, part, right), column + moved};
}

terminal::Ink ink_of(const Diagnostic& d) {
  return d.severity == Severity::Error ? terminal::Ink::Error : terminal::Ink::Warning;
}

std::string source_excerpt(const Diagnostic& d, terminal::ColourUse colour, SourceLines& sources) {
  if (d.line == 0) return {};
  const auto& line = sources.line(d.file, d.line);
  if (!line) return {};
  const auto [shown, column] = part_about(*line, d.column);
  std::string text = fmt::format("{:>6} | {}\n", d.line, shown);
  if (d.column == 0) return text;
  constexpr std::size_t longest_underline = 60;  // a paragraph is known by its beginning
  const std::string carets(std::clamp<std::size_t>(d.length, 1, longest_underline), '^');
  text += fmt::format("       | {}{}{}{}\n", indentation(shown, column),
                      terminal::painted(carets, ink_of(d), colour), d.label.empty() ? "" : " ",
                      visible(d.label));
  return text;
}

std::string text_of(const Diagnostic& d, terminal::ColourUse colour, SourceLines& sources) {
  std::string place = d.file;
  if (d.line > 0) place += fmt::format(":{}", d.line);
  if (d.line > 0 && d.column > 0) place += fmt::format(":{}", d.column);
  const std::string separator = place.empty() ? "" : ": ";
  const std::string kind = fmt::format("{}[{}]", name_of(d.severity), d.code);
  std::string text = fmt::format("{}{}{}: {}\n", visible(place), separator,
                                 terminal::painted(kind, ink_of(d), colour), visible(d.message));
  text += source_excerpt(d, colour, sources);
  if (!d.hint.empty()) text += fmt::format("   hint: {}\n", visible(d.hint, Lines::Several));
  return text;
}

}  // namespace

std::string to_text(const Diagnostic& d, terminal::ColourUse colour) {
  SourceLines sources;
  return text_of(d, colour, sources);
}

std::string to_json(const Diagnostic& d) {
  const nlohmann::ordered_json object = {{"file", d.file},
                                         {"line", d.line},
                                         {"column", d.column},
                                         {"code", d.code},
                                         {"severity", name_of(d.severity)},
                                         {"message", d.message},
                                         {"hint", d.hint}};
  // Replaces bytes that are not UTF-8, where dump() alone would throw.
  return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void tell(std::span<const Diagnostic> all, DiagnosticForm form) {
  const std::vector<Diagnostic> fewer =
      form == DiagnosticForm::Text ? without_alike(all) : std::vector<Diagnostic>{};
  const std::span<const Diagnostic> diagnostics = form == DiagnosticForm::Text ? fewer : all;
  constexpr std::size_t most_on_terminal = 20;
  const bool shortens = form == DiagnosticForm::Text && terminal::is_terminal(stderr);
  const auto shown = diagnostics.first(shortens ? std::min(diagnostics.size(), most_on_terminal)
                                                : diagnostics.size());
  const terminal::ColourUse colour = terminal::colour_use_of(stderr);
  SourceLines sources;
  for (const Diagnostic& d : shown)
    fmt::print(stderr, "{}",
               form == DiagnosticForm::Json ? to_json(d) + "\n" : text_of(d, colour, sources));
  if (shown.size() < diagnostics.size())
    fmt::print(stderr, "... and {} more; all of them with 2>FILE\n",
               diagnostics.size() - shown.size());
}

}  // namespace docent::config

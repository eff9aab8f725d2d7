#include "content/import/caption/webvtt.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "content/import/caption/caption_text.h"
#include "platform/file/text_encoding.h"
#include "runtime/model/exhibit/longer_text.h"

namespace docent::import {
namespace {

constexpr std::string_view arrow = "-->";

bool is_gap(char c) noexcept {
  return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view text) noexcept {
  while (!text.empty() && is_gap(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_gap(text.back())) text.remove_suffix(1);
  return text;
}

/// Lines end with \n, \r\n or \r.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  }
  return lines;
}

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

/// So many digits or more at the beginning of a text, which loses them.
std::optional<std::uint32_t> take_number(std::string_view& text, std::size_t least,
                                         std::size_t most) noexcept {
  std::uint32_t number = 0;
  std::size_t digits = 0;
  for (; digits < text.size() && digits < most && is_digit(text[digits]); ++digits)
    number = 10 * number + static_cast<std::uint32_t>(text[digits] - '0');
  if (digits < least) return {};
  text.remove_prefix(digits);
  return number;
}

bool take(std::string_view& text, char c) noexcept {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

/// A timestamp (section 4.3), which the text then no longer has: milliseconds.
std::optional<std::uint32_t> take_time(std::string_view& text) noexcept {
  constexpr std::uint32_t most_hours = 999;
  std::string_view rest = text;
  std::optional<std::uint32_t> hours = 0, minutes = take_number(rest, 2, 3);
  if (!minutes || !take(rest, ':')) return {};
  std::optional<std::uint32_t> seconds = take_number(rest, 2, 2);
  if (seconds && take(rest, ':')) {
    hours = std::exchange(minutes, seconds);
    seconds = take_number(rest, 2, 2);
  }
  if (!seconds || !take(rest, '.')) return {};
  const auto milliseconds = take_number(rest, 3, 3);
  if (!milliseconds || *hours > most_hours || *minutes > 59 || *seconds > 59) return {};
  if (!rest.empty() && is_digit(rest.front())) return {};
  text = rest;
  return 1000 * (60 * (60 * *hours + *minutes) + *seconds) + *milliseconds;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& file)
      : lines_(lines_of(file::without_byte_order_mark(text))), file_(file) {}

  CaptionFile read() {
    if (!read_head()) return std::move(read_);
    while (at_ < lines_.size()) read_block();
    if (read_.captions.empty() && read_.faults.empty())
      fault(0, 0, "no-captions", "this file has no captions",
            "a caption is a line with its times, 00:01.000 --> 00:04.500, and the text below it");
    return std::move(read_);
  }

 private:
  /// `line` and `column` are from 1, the column in letters.
  void fault(std::size_t line, std::size_t column, std::string code, std::string message,
             std::string hint) {
    constexpr std::size_t most_told = 20;
    if (read_.faults.size() >= most_told) return;
    read_.faults.push_back({.file = file_,
                            .line = static_cast<std::uint32_t>(line),
                            .column = static_cast<std::uint32_t>(column),
                            .code = std::move(code),
                            .message = std::move(message),
                            .hint = std::move(hint)});
  }

  bool is_at(std::string_view word) const noexcept {
    const std::string_view line = lines_[at_];
    return line.starts_with(word) && (line.size() == word.size() || is_gap(line[word.size()]));
  }
  bool has_arrow(std::size_t line) const noexcept {
    return line < lines_.size() && lines_[line].find(arrow) != std::string_view::npos;
  }
  bool is_blank() const noexcept { return trimmed(lines_[at_]).empty(); }

  bool read_head() {
    if (lines_.empty() || !is_at("WEBVTT")) {
      const bool is_subrip = has_arrow(0) || has_arrow(1);
      fault(1, 1, "unreadable-captions", "this is no WebVTT file: its first line is not WEBVTT",
            is_subrip ? "an SRT file becomes one with: ffmpeg -i NAME.srt NAME.vtt"
                      : "write WEBVTT into the first line, and leave the second one empty");
      return false;
    }
    ++at_;
    // What else stands in the head, up to an empty line, is for other programs.
    while (at_ < lines_.size() && !is_blank() && !has_arrow(at_) && !has_arrow(at_ + 1)) ++at_;
    return true;
  }

  void read_block() {
    if (is_blank()) {
      ++at_;
      return;
    }
    if (has_arrow(at_)) return read_caption();
    if (is_at("NOTE") || is_at("STYLE") || is_at("REGION")) return skip_block();
    if (has_arrow(at_ + 1)) {  // the caption's name
      ++at_;
      return read_caption();
    }
    fault(at_ + 1, 1, "untimed-caption",
          "this text has no times above it, and nobody would read it",
          "write 00:01.000 --> 00:04.500 above it; what nobody is to read begins with NOTE");
    skip_block();
  }

  void skip_block() noexcept {
    while (at_ < lines_.size() && !is_blank()) ++at_;
  }

  void read_caption() {
    const std::size_t line = at_ + 1;
    const auto times = read_times();
    ++at_;
    std::string lines;
    for (; at_ < lines_.size() && !is_blank() && !has_arrow(at_); ++at_)
      lines.append(lines_[at_]) += '\n';
    if (!times) return;
    std::string text = caption_text(lines);
    if (text.empty()) return;  // a pause
    if (const std::size_t letters = count_letters(text); letters > most_caption_letters)
      fault(line + 1, 1, "caption-too-long",
            fmt::format("this caption has {} letters, and at most {} can be read in time", letters,
                        most_caption_letters),
            "make two captions of it, each with its own times");
    else
      read_.captions.push_back({.begin = times->first,
                                .end = times->second,
                                .text = std::move(text),
                                .line = static_cast<std::uint32_t>(line)});
  }

  /// Of this line; what follows them says where a caption lies, which the kiosk decides.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> read_times() {
    const std::string_view whole = lines_[at_];
    std::string_view rest = whole;
    while (!rest.empty() && is_gap(rest.front())) rest.remove_prefix(1);
    const std::string_view first = rest;
    const auto begin = take_time(rest);
    if (!begin) return bad_time(whole, first);
    while (!rest.empty() && is_gap(rest.front())) rest.remove_prefix(1);
    if (!rest.starts_with(arrow)) return bad_time(whole, first);
    rest.remove_prefix(arrow.size());
    while (!rest.empty() && is_gap(rest.front())) rest.remove_prefix(1);
    const std::string_view second = rest;
    const auto end = take_time(rest);
    if (!end || !(rest.empty() || is_gap(rest.front()))) return bad_time(whole, second);
    if (*end <= *begin) {
      fault(at_ + 1, column_of(whole, second), "bad-caption-time",
            "this caption ends before it has begun", "write the time at which it begins first");
      return {};
    }
    return std::pair(*begin, *end);
  }

  std::nullopt_t bad_time(std::string_view line, std::string_view from) {
    const std::string_view time = from.substr(0, from.find_first_of(" \t"));
    constexpr std::size_t shown = 20;
    fault(at_ + 1, column_of(line, from), "bad-caption-time",
          time.empty() || time.starts_with(arrow)
              ? std::string("a time is missing here")
              : fmt::format("'{}' is no time", file::shown_as_utf8(time.substr(0, shown))),
          "write minutes, seconds and thousandths, 00:04.500, or hours too, 01:00:04.500");
    return std::nullopt;
  }

  static std::size_t column_of(std::string_view line, std::string_view from) {
    return 1 + static_cast<std::size_t>(std::ranges::count_if(
                   line.substr(0, line.size() - from.size()),
                   [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
  }

  std::vector<std::string_view> lines_;
  std::string file_;
  std::size_t at_ = 0;
  CaptionFile read_;
};

}  // namespace

CaptionFile read_webvtt(std::string_view text, const std::string& file) {
  return Reader(text, file).read();
}

}  // namespace docent::import

#include "content/import/motion/motion_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace docent::import {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

constexpr std::string_view line_ends = "\r\n";

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// A word as it can be shown in a sentence: short, and without bytes that a terminal would obey.
std::string shown(std::string_view word) {
  if (word.empty()) return "the end of the file";
  std::string clean;
  for (const char c : word.substr(0, 24)) clean += c >= ' ' && c <= '~' ? c : '?';
  return fmt::format("'{}{}'", clean, word.size() > 24 ? "..." : "");
}

constexpr double largest_number = 1e9;  // No body is that many millimetres away.

std::optional<double> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || status == std::errc::invalid_argument) return {};
  if (status != std::errc::result_out_of_range) return value;
  // Too small is a zero that somebody computed; too large is not a number of any recording.
  return word.contains("e-") || word.contains("E-") ? 0.0 : std::numeric_limits<double>::infinity();
}

}  // namespace

void MotionText::skip_blanks() {
  while (at_ < text_.size()) {
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (text_[at_] == '#' || text_.substr(at_, 2) == "//") {
      at_ = std::min(text_.find_first_of(line_ends, at_), text_.size());
    } else {
      return;
    }
  }
}

std::size_t MotionText::end_of_word() const {
  std::size_t end = at_;
  while (end < text_.size() && !is_blank(text_[end])) ++end;
  return end;
}

std::string_view MotionText::next_word() {
  skip_blanks();
  last_ = at_;
  at_ = end_of_word();
  return text_.substr(last_, at_ - last_);
}

std::string_view MotionText::peek_word() {
  skip_blanks();
  return text_.substr(at_, end_of_word() - at_);
}

std::string_view MotionText::rest_of_line() {
  std::size_t end = std::min(text_.find_first_of(line_ends, at_), text_.size());
  std::size_t begin = at_;
  at_ = end;
  while (begin < end && is_blank(text_[begin])) ++begin;
  while (end > begin && is_blank(text_[end - 1])) --end;
  last_ = begin;
  return text_.substr(begin, end - begin);
}

double MotionText::next_number(std::string_view what) {
  const std::string_view word = next_word();
  const auto value = number_in(word);
  if (!value)
    throw error("bad-number", fmt::format("{} should be a number, but is {}", what, shown(word)));
  if (!std::isfinite(*value) || std::abs(*value) > largest_number)
    throw error("bad-number", fmt::format("{} is {}, which no recording holds", what, shown(word)));
  return *value;
}

std::size_t MotionText::next_count(std::string_view what, std::size_t at_most) {
  const double value = next_number(what);
  if (value < 0 || value != std::floor(value) || value > static_cast<double>(at_most))
    throw error("bad-count",
                fmt::format("{} should be a whole number from 0 to {}", what, at_most));
  return static_cast<std::size_t>(value);
}

bool MotionText::accept(std::string_view word) {
  if (!same_word(peek_word(), word)) return false;
  next_word();
  return true;
}

void MotionText::expect(std::string_view word) {
  if (const std::string_view found = next_word(); !same_word(found, word))
    throw error("unexpected-word",
                fmt::format("expected '{}' here, but found {}", word, shown(found)));
}

void MotionText::expect_label(std::string_view label) {
  if (!same_word(peek_word().substr(0, label.size()), label)) return expect(label);
  last_ = at_;
  at_ += label.size();
}

bool MotionText::at_end() {
  skip_blanks();
  return at_ == text_.size();
}

bool MotionText::at_line_end() {
  const std::size_t before = at_;
  skip_blanks();
  return at_ == text_.size() ||
         text_.substr(before, at_ - before).find_first_of(line_ends) != text_.npos;
}

std::size_t MotionText::place() {
  skip_blanks();
  return at_;
}

content::ContentError MotionText::error_at(std::size_t place, std::string code,
                                           const std::string& message, std::string hint) const {
  const std::string_view before = text_.substr(0, std::min(place, text_.size()));
  std::size_t line = 1, line_start = 0;
  for (std::size_t end = 0; (end = before.find_first_of(line_ends, end)) != before.npos;) {
    end += before.substr(end).starts_with("\r\n") ? 2 : 1;
    line_start = end;
    ++line;
  }
  return {file_,
          static_cast<std::uint32_t>(line),
          static_cast<std::uint32_t>(before.size() - line_start + 1),
          std::move(code),
          message,
          std::move(hint)};
}

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace docent::import

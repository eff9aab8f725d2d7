#include "content/import/object/object_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace docent::import::object {
namespace {

constexpr std::string_view blanks = " \t\v\f";

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word.front() == '+') word.remove_prefix(1);
  return word;
}

}  // namespace

bool Lines::next() {
  if (next_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", next_), text_.size());
  line_ = text_.substr(next_, end - next_);
  next_ = std::min(end + 1, text_.size());
  if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++next_;
  at_ = 0;
  ++number_;
  return true;
}

std::string_view Lines::word() {
  const std::size_t first = line_.find_first_not_of(blanks, at_);
  if (first == std::string_view::npos) {
    at_ = line_.size();
    return {};
  }
  at_ = std::min(line_.find_first_of(blanks, first), line_.size());
  return line_.substr(first, at_ - first);
}

std::string_view Lines::rest() const {
  const std::size_t first = line_.find_first_not_of(blanks, at_);
  if (first == std::string_view::npos) return {};
  return line_.substr(first, line_.find_last_not_of(blanks) + 1 - first);
}

std::optional<float> number_of(std::string_view word) {
  constexpr float farthest = 1e6F;
  word = without_plus(word);
  float value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // What is too small to be told from 0 is 0.
  if (error == std::errc::result_out_of_range && word.contains("e-")) return 0.0F;
  if (error != std::errc{} || end != word.data() + word.size()) return {};
  if (!std::isfinite(value) || std::abs(value) > farthest) return {};
  return value;
}

std::optional<std::int64_t> whole_of(std::string_view word) {
  word = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return {};
  return value;
}

void fail(const std::string& file, std::uint32_t line, const std::string& what) {
  throw content::ContentError(file, line, line > 0 ? 1 : 0, "unreadable-model", what,
                              "export the object again, as GLB, OBJ, PLY or STL");
}

void count(const std::string& file, std::size_t have, std::size_t most, std::string_view noun) {
  if (have > most)
    fail(file, 0, fmt::format("it has more than {} {}, which is too much to be read", most, noun));
}

void Faults::add(std::uint32_t line, std::string_view what) {
  const auto known = std::ranges::find(faults_, what, &Fault::what);
  if (known != faults_.end())
    ++known->count;
  else
    faults_.push_back({std::string(what), line, 1});
}

std::vector<std::string> Faults::told() const {
  std::vector<std::string> sentences;
  for (const Fault& fault : faults_) {
    const std::string where = fault.line > 0 ? fmt::format("line {}: ", fault.line) : "";
    const std::string more = fault.count > 1 ? fmt::format(" ({} times in all)", fault.count) : "";
    sentences.push_back(fmt::format("{}{}{}", where, fault.what, more));
  }
  return sentences;
}

}  // namespace docent::import::object

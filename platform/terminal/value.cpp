#include "platform/terminal/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "platform/terminal/suggest.h"

namespace docent::terminal {
namespace {

/// "a number between 0 and 100"
std::string describe(const Limits& limits) {
  std::string kind = limits.of == Limits::Of::WholeNumbers ? "a whole number" : "a number";
  if (std::isfinite(limits.most))
    return fmt::format("{} between {} and {}", kind, limits.least, limits.most);
  if (!std::isfinite(limits.least)) return kind;
  return limits.ends == Limits::Least::Excluded
             ? fmt::format("{} of more than {}", kind, limits.least)
             : fmt::format("{} of {} or more", kind, limits.least);
}

/// "; did you mean 0.25?" of 0,25, as half of Europe writes it; else nothing.
std::string meant_by(std::string_view word, const Limits& limits) {
  std::string with_point(word);
  std::ranges::replace(with_point, ',', '.');
  if (with_point == word || !read_number(with_point, limits)) return {};
  return fmt::format("; did you mean {}?", with_point);
}

bool is_within(double value, const Limits& limits) {
  if (limits.of == Limits::Of::WholeNumbers && value != std::floor(value)) return false;
  if (limits.ends == Limits::Least::Excluded && value == limits.least) return false;
  return value >= limits.least && value <= limits.most;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<double> finite_number(std::string_view text) noexcept {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value == 0 ? 0 : value;
}

std::expected<double, std::string> read_number(std::string_view word, const Limits& limits) {
  const std::optional<double> value = finite_number(word);
  if (value && is_within(*value, limits)) return *value;
  return std::unexpected(
      fmt::format("'{}' is not {}{}", word, describe(limits), meant_by(word, limits)));
}

std::string read_numbers(Words words, Limits limits, std::vector<double>& numbers) {
  for (const std::string& word : words) {
    const std::expected<double, std::string> value = read_number(word, limits);
    if (!value) return value.error();
    numbers.push_back(*value);
  }
  return {};
}

std::string read_list(const std::string& word, std::span<double> numbers) {
  const std::vector<std::string_view> parts = split(word, ',');
  bool good = parts.size() == numbers.size();
  for (std::size_t i = 0; good && i < parts.size(); ++i) {
    const std::optional<double> value = finite_number(parts[i]);
    good = value.has_value();
    numbers[i] = value.value_or(0);
  }
  if (good) return {};
  return fmt::format("'{}' is not {} numbers with {} between", word, numbers.size(),
                     numbers.size() == 2 ? "a comma" : "commas");
}

std::expected<std::size_t, std::string> find_choice(std::string_view word,
                                                    std::span<const std::string_view> choices) {
  const auto found = std::ranges::find(choices, word);
  if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
  const std::string_view meant = closest(word, {choices.begin(), choices.end()});
  return std::unexpected(meant.empty()
                             ? fmt::format("'{}' is none of {}", word, fmt::join(choices, ", "))
                             : fmt::format("'{}' is none of {}; did you mean '{}'?", word,
                                           fmt::join(choices, ", "), meant));
}

Value list(std::string_view name, std::vector<std::string>& target) {
  return {.name = std::string(name), .take = [&target](Words words) {
            target.clear();
            for (const std::string& word : words)
              for (const std::string_view part : split(word, ',')) target.emplace_back(part);
            return std::string();
          }};
}

}  // namespace docent::terminal

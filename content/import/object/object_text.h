#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "content/content_error.h"

namespace docent::import::object {

/// What a file may hold at most: more is refused before its memory is taken.
inline constexpr std::size_t most_vertices = 4'000'000, most_triangles = 4'000'000;

/// A text, line by line. Lines end with a line feed, a carriage return or both.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_{text} {}

  /// Goes on to the next line; false where there is none.
  bool next();
  std::string_view line() const noexcept { return line_; }
  std::uint32_t number() const noexcept { return number_; }  ///< From 1.
  /// The line's next word; empty where it has no more.
  std::string_view word();
  /// What is left of the line, without blanks round it.
  std::string_view rest() const;
  /// Where the text goes on behind this line.
  std::size_t end() const noexcept { return next_; }

 private:
  std::string_view text_, line_;
  std::size_t next_ = 0, at_ = 0;
  std::uint32_t number_ = 0;
};

/// A finite number of at most a million either way; empty where the word is none.
std::optional<float> number_of(std::string_view word);
std::optional<std::int64_t> whole_of(std::string_view word);

[[noreturn]] void fail(const std::string& file, std::uint32_t line, const std::string& what);
/// Refuses what a file may not hold.
void count(const std::string& file, std::size_t have, std::size_t most, std::string_view noun);

/// What was left out of a file, told once for each kind of fault: the first with its line, and how
/// many there are.
class Faults {
 public:
  void add(std::uint32_t line, std::string_view what);
  std::vector<std::string> told() const;

 private:
  struct Fault {
    std::string what;
    std::uint32_t line = 0;
    std::size_t count = 0;
  };
  std::vector<Fault> faults_;
};

}  // namespace docent::import::object

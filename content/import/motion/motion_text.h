#pragma once

#include <string>
#include <string_view>

#include "content/read_source.h"

namespace docent::import {

/// Reads the words and numbers of a motion file (BVH, ASF, AMC) in order.
///
/// Words are parted by blanks of any kind; lines end with a line feed, a carriage return or both.
/// What follows a `#` or `//` that begins a word is a comment, up to the end of its line. Lines and
/// columns are counted only when something is wrong, so reading costs no more than finding the ends
/// of words.
class MotionText {
 public:
  MotionText(std::string_view text, std::string file)
      : text_(file::without_byte_order_mark(text)), file_(std::move(file)) {}

  /// The next word, empty at the end of the text.
  std::string_view next_word();
  /// The next word without taking it.
  std::string_view peek_word();
  /// The rest of the current line without the blanks round it; takes the line.
  std::string_view rest_of_line();
  /// A finite number of at most 1e9; throws ContentError naming `what` otherwise.
  double next_number(std::string_view what);
  /// A whole number from 0 to `at_most`.
  std::size_t next_count(std::string_view what, std::size_t at_most);
  /// Takes the next word if it is `word`, without regard to case.
  bool accept(std::string_view word);
  /// Takes `word`; throws ContentError where another word stands.
  void expect(std::string_view word);
  /// Takes `label`, with or without a blank before what it labels: "Frames: 60", "Frames:60".
  void expect_label(std::string_view label);
  bool at_end();
  /// True where the next word stands on a later line than the last one taken.
  bool at_line_end();
  /// Moves past line ends and comment lines and says where the next word begins.
  std::size_t place();
  /// Where the last word taken began.
  std::size_t last_place() const { return last_; }
  /// The text from a place to the end, comments and all.
  std::string_view text_from(std::size_t place) const { return text_.substr(place); }

  /// An error at a place of the text.
  content::ContentError error_at(std::size_t place, std::string code, const std::string& message,
                                 std::string hint = {}) const;
  /// An error at the last word taken.
  content::ContentError error(std::string code, const std::string& message,
                              std::string hint = {}) const {
    return error_at(last_, std::move(code), message, std::move(hint));
  }
  const std::string& file() const { return file_; }

 private:
  void skip_blanks();
  std::size_t end_of_word() const;

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t last_ = 0;
};

/// Are two words the same but for upper and lower case (ASCII)?
bool same_word(std::string_view a, std::string_view b);

}  // namespace docent::import

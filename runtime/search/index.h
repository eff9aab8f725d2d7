#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace docent::search {

/// A field that is written in no language, such as a number.
inline constexpr std::uint8_t no_language = 255;

/// A text that an entry is found by, and how well: 0 is best.
struct Field {
  std::uint32_t begin = 0;  ///< In Index::text.
  std::uint32_t owner = 0;  ///< An entry; or, from Index::entries on, a group of them.
  std::uint8_t language = no_language;
  std::uint8_t weight = 0;
};

/// A place in a text from which on one can begin to type: a word's first letter; where words are
/// written without spaces between them, any syllable's.
struct Start {
  std::uint32_t at = 0;  ///< In Index::text.
  std::uint32_t field = 0;
};

/// What can be found, folded and put in order. Made by an IndexBuilder; immutable, so any thread
/// may read it.
struct Index {
  std::uint32_t entries = 0;  ///< They are numbers from 0.
  std::u16string text;        ///< Fields, folded, each with a zero behind it.
  std::vector<Field> fields;  ///< Ascending `begin`.
  std::vector<Start> starts;  ///< In the order of what stands there.
  /// The first start of each different word, and how many letters that word has in common with the
  /// one before: a trie, as it lies in an array.
  std::vector<std::uint32_t> words;
  std::vector<std::uint8_t> common;
  std::vector<std::uint32_t> group_first;  ///< One a group and one more.
  std::vector<std::uint32_t> members;      ///< Entries.
};

/// Gathers what an index is made of.
class IndexBuilder {
 public:
  explicit IndexBuilder(std::uint32_t entries) { index_.entries = entries; }

  /// Entries that are found together, by a gallery's name or a tag; the answer is their owner.
  std::uint32_t add_group(std::span<const std::uint32_t> members);
  /// A text as people write it. Hangul is found by its first consonants, too.
  void add(std::uint32_t owner, std::uint8_t language, std::uint8_t weight, std::string_view text);
  /// How a text is read, in syllables with spaces between them: found with and without the spaces,
  /// from any syllable on, and by the first letters of the syllables.
  void add_reading(std::uint32_t owner, std::uint8_t language, std::uint8_t weight,
                   std::string_view syllables);
  Index build() &&;

 private:
  void begin_field(std::uint32_t owner, std::uint8_t language, std::uint8_t weight);
  void end_field();
  void add_initials(std::u16string_view initials, const Field& of);

  Index index_;
};

/// An entry that was found. Less is better.
struct Hit {
  std::uint32_t cost = 0, entry = 0;

  auto operator<=>(const Hit&) const = default;
};

/// What a search needs to write on; made once and used again.
struct SearchDesk {
  std::vector<std::uint16_t> word_cost;  ///< One an entry.
  std::vector<std::uint32_t> cost;
  std::vector<Hit> hits;
};

/// The entries that every word of the query finds, the best first: whole names, then names and
/// words that begin so, then words that hold it, then those that begin nearly so, with one letter
/// wrong from four letters on and two from eight. Of equals the visitor's own language comes first,
/// and then the lower entry. The answer lies on the desk.
std::span<const Hit> find(const Index& index, std::u16string_view query, std::uint8_t language,
                          SearchDesk& desk);

}  // namespace docent::search

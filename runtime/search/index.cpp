#include "runtime/search/index.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "runtime/search/fold.h"

namespace docent::search {
namespace {

constexpr std::size_t longest_word = 20;  ///< Letters of a word that mistakes are looked for in.

// What a hit costs; a field's weight and another language are added.
constexpr std::uint16_t whole = 0, begins = 4, whole_word = 6, word = 8, inside = 24,
                        one_mistake = 32, two_mistakes = 48, foreign = 2;
constexpr std::uint16_t not_found = std::numeric_limits<std::uint16_t>::max();

/// Scripts without spaces between words, once folded.
bool is_continuous(char32_t letter) noexcept {
  const bool is_thai = (letter >= U'ก' && letter <= U'ฮ') || (letter >= U'เ' && letter <= U'ไ');
  const bool is_kana = letter >= 0x3041 && letter <= 0x3096;
  const bool is_han = (letter >= 0x3400 && letter <= 0x9FFF) ||
                      (letter >= 0xF900 && letter <= 0xFAFF) || letter >= 0x20000;
  return is_thai || is_kana || is_han;
}

bool is_digit(char16_t letter) noexcept {
  return letter >= u'0' && letter <= u'9';
}
bool is_apostrophe(char32_t letter) noexcept {
  return letter == U'\'' || letter == U'’';
}

/// An article before the word that one looks for: Arabic's and Hebrew's.
bool is_article(std::u16string_view word_so_far) noexcept {
  return word_so_far == u"ال" || word_so_far == u"ה";
}

/// Takes a text letter by letter and notes where one can begin to type.
class FieldWriter {
 public:
  FieldWriter(Index& index, std::uint32_t field)
      : text_(index.text),
        starts_(index.starts),
        field_(field),
        begin_(text_.size()),
        word_(begin_) {}

  void take(char32_t letter) {
    const Folded folded = fold(letter);
    if (folded.count == 0) {
      is_elided_ = is_elided_ || is_apostrophe(letter);
      return;
    }
    const char16_t first = folded.letters[0];
    if (first == u' ') {
      if (text_.size() > begin_ && text_.back() != u' ') text_ += u' ';
      word_ = text_.size();
      return;
    }
    if (begins(letter, first))
      starts_.push_back({static_cast<std::uint32_t>(text_.size()), field_});
    is_elided_ = false;
    text_.append(folded.letters.data(), folded.count);
  }

 private:
  bool begins(char32_t letter, char16_t first) const noexcept {
    if (text_.size() == word_ || is_elided_) return true;
    if (is_continuous(first) || is_syllable(letter)) return true;
    if (is_digit(first) != is_digit(text_.back())) return true;
    return is_article(std::u16string_view(text_).substr(word_));
  }

  std::u16string& text_;
  std::vector<Start>& starts_;
  std::uint32_t field_;
  std::size_t begin_, word_;
  bool is_elided_ = false;  ///< What was before is an article with an apostrophe.
};

/// The word at a start, as far as mistakes in it are looked for.
std::u16string_view word_at(const Index& index, std::uint32_t at) noexcept {
  std::size_t length = 0;
  while (length < longest_word && index.text[at + length] != 0 && index.text[at + length] != u' ')
    ++length;
  return std::u16string_view(index.text).substr(at, length);
}

/// Compares a query with what stands at a start, as far as the query goes.
int compare(const Index& index, const Start& start, std::u16string_view query) noexcept {
  for (std::size_t i = 0; i < query.size(); ++i) {
    const char16_t letter = index.text[start.at + i];
    if (letter != query[i]) return letter < query[i] ? -1 : 1;
  }
  return 0;
}

std::size_t mistakes_allowed(std::size_t letters) noexcept {
  return letters >= 8 ? 2 : letters >= 4 ? 1 : 0;
}

/// Looks one word of a query up.
class WordSearch {
 public:
  WordSearch(const Index& index, std::u16string_view query, bool is_alone, std::uint8_t language,
             std::vector<std::uint16_t>& cost)
      : index_(index),
        query_(query),
        allowed_(mistakes_allowed(query.size())),
        is_alone_(is_alone),
        language_(language),
        cost_(cost) {
    std::ranges::fill(cost_, not_found);
  }

  void run() {
    if (!find_beginnings()) find_inside();
    if (allowed_ > 0) find_mistaken();
  }

 private:
  using Row = std::array<std::uint8_t, 34>;
  static constexpr std::uint8_t far = 100;

  void mark(std::uint32_t field_index, std::uint16_t cost) {
    const Field& field = index_.fields[field_index];
    const bool is_foreign = field.language != language_ && field.language != no_language;
    const auto all = static_cast<std::uint16_t>(cost + field.weight + (is_foreign ? foreign : 0));
    if (field.owner < index_.entries) return mark_entry(field.owner, all);
    const std::uint32_t group = field.owner - index_.entries;
    for (std::uint32_t i = index_.group_first[group]; i < index_.group_first[group + 1]; ++i)
      mark_entry(index_.members[i], all);
  }
  void mark_entry(std::uint32_t entry, std::uint16_t cost) {
    cost_[entry] = std::min(cost_[entry], cost);
  }

  bool find_beginnings() {
    const auto first = std::ranges::partition_point(
        index_.starts, [&](const Start& s) { return compare(index_, s, query_) < 0; });
    const auto last = std::partition_point(first, index_.starts.end(), [&](const Start& s) {
      return compare(index_, s, query_) == 0;
    });
    for (auto start = first; start != last; ++start) {
      const char16_t after = index_.text[start->at + query_.size()];
      const bool is_first = start->at == index_.fields[start->field].begin;
      const std::uint16_t cost = is_first && after == 0 && is_alone_ ? whole
                                 : is_first                          ? begins
                                 : after == 0 || after == u' '       ? whole_word
                                                                     : word;
      mark(start->field, cost);
    }
    return first != last;
  }

  void find_inside() {
    constexpr std::size_t least = 3;
    if (query_.size() < least) return;
    const std::u16string_view text = index_.text;
    for (std::size_t at = text.find(query_); at != text.npos; at = text.find(query_, at + 1)) {
      const auto after = std::ranges::upper_bound(index_.fields, at, {}, &Field::begin);
      mark(static_cast<std::uint32_t>(after - index_.fields.begin() - 1), inside);
    }
  }

  /// Optimal string alignment (Levenshtein's distance, and neighbours swapped) between the query
  /// and the beginnings of all words of its script, along the trie: what words have in common is
  /// reckoned once, and a beginning that is too far off is left with all that follows it.
  void find_mistaken() {
    const auto [first, last] = words_of_script();
    std::array<Row, longest_word + 1> rows{};
    for (Row& row : rows) row.fill(far);
    std::iota(rows[0].begin(), rows[0].begin() + allowed_ + 1, std::uint8_t{0});
    std::array<std::uint8_t, longest_word + 1> best{};  ///< Of a word's beginnings so far.
    best[0] = rows[0][query_.size()];
    std::size_t known = 0;                ///< Rows that hold for the word before.
    std::size_t dead = longest_word + 1;  ///< So many letters of the word before lead too far off.
    const std::size_t end = std::min(longest_word, query_.size() + allowed_);
    for (std::size_t i = first; i < last; ++i) {
      // The first word of the script has nothing in common with one that was looked at.
      const std::size_t common = i == first ? 0 : index_.common[i];
      if (common < dead) {
        known = std::min(known, common);
        dead = longest_word + 1;
        const char16_t* const text = index_.text.c_str() + index_.starts[index_.words[i]].at;
        while (known < end && text[known] != 0 && text[known] != u' ' && dead > longest_word) {
          const std::uint8_t least = add_row(rows, text, known);
          best[known + 1] = std::min(best[known], rows[known + 1][query_.size()]);
          ++known;
          if (least > allowed_) dead = known;
        }
      }
      if (best[known] > 0 && best[known] <= allowed_)
        mark_word(i, best[known] == 1 ? one_mistake : two_mistakes);
    }
  }

  /// The words that begin with a letter of the same 256 in Unicode as the query.
  std::pair<std::size_t, std::size_t> words_of_script() const noexcept {
    const auto page_of = [&](std::uint32_t start) {
      return index_.text[index_.starts[start].at] >> 8U;
    };
    const auto range = std::ranges::equal_range(index_.words, query_[0] >> 8U, {}, page_of);
    return {static_cast<std::size_t>(range.begin() - index_.words.begin()),
            static_cast<std::size_t>(range.end() - index_.words.begin())};
  }

  /// Reckons the row of one more letter, as far from the diagonal as mistakes are allowed; returns
  /// the least in it.
  std::uint8_t add_row(std::array<Row, longest_word + 1>& rows, const char16_t* text,
                       std::size_t t) const noexcept {
    const Row& before = rows[t];
    Row& row = rows[t + 1];
    row[0] = t + 1 <= allowed_ ? static_cast<std::uint8_t>(t + 1) : far;
    std::uint8_t least = row[0];
    const std::size_t from = t > allowed_ ? t - allowed_ : 0;
    const std::size_t to = std::min(query_.size(), t + allowed_ + 1);
    if (from > 0) row[from] = far;
    for (std::size_t q = from; q < to; ++q) {
      int value =
          std::min({before[q] + (text[t] != query_[q] ? 1 : 0), before[q + 1] + 1, row[q] + 1});
      if (t > 0 && q > 0 && text[t] == query_[q - 1] && text[t - 1] == query_[q])
        value = std::min(value, rows[t - 1][q - 1] + 1);
      row[q + 1] = static_cast<std::uint8_t>(value);
      least = std::min(least, row[q + 1]);
    }
    return least;
  }

  void mark_word(std::size_t i, std::uint16_t cost) {
    const std::size_t end =
        i + 1 < index_.words.size() ? index_.words[i + 1] : index_.starts.size();
    for (std::size_t s = index_.words[i]; s < end; ++s) mark(index_.starts[s].field, cost);
  }

  const Index& index_;
  std::u16string_view query_;
  std::size_t allowed_;  ///< Mistakes.
  bool is_alone_;
  std::uint8_t language_;
  std::vector<std::uint16_t>& cost_;
};

}  // namespace

std::uint32_t IndexBuilder::add_group(std::span<const std::uint32_t> members) {
  if (index_.group_first.empty()) index_.group_first.push_back(0);
  index_.members.insert(index_.members.end(), members.begin(), members.end());
  index_.group_first.push_back(static_cast<std::uint32_t>(index_.members.size()));
  return index_.entries + static_cast<std::uint32_t>(index_.group_first.size()) - 2;
}

void IndexBuilder::begin_field(std::uint32_t owner, std::uint8_t language, std::uint8_t weight) {
  index_.fields.push_back({.begin = static_cast<std::uint32_t>(index_.text.size()),
                           .owner = owner,
                           .language = language,
                           .weight = weight});
}

void IndexBuilder::end_field() {
  if (index_.text.size() > index_.fields.back().begin && index_.text.back() == u' ')
    index_.text.back() = 0;
  else
    index_.text += u'\0';
}

void IndexBuilder::add(std::uint32_t owner, std::uint8_t language, std::uint8_t weight,
                       std::string_view text) {
  begin_field(owner, language, weight);
  const Field field = index_.fields.back();
  FieldWriter writer(index_, static_cast<std::uint32_t>(index_.fields.size() - 1));
  std::u16string initials;
  while (!text.empty()) {
    const auto [letter, length] = decode(text);
    writer.take(letter);
    if (is_syllable(letter)) initials += fold(letter).letters[0];
    text.remove_prefix(length);
  }
  end_field();
  if (initials.size() > 1) add_initials(initials, field);
}

void IndexBuilder::add_reading(std::uint32_t owner, std::uint8_t language, std::uint8_t weight,
                               std::string_view syllables) {
  begin_field(owner, language, weight);
  const Field field = index_.fields.back();
  const auto number = static_cast<std::uint32_t>(index_.fields.size() - 1);
  const std::u16string all = folded(syllables);
  std::u16string initials;
  bool begins = true;
  for (const char16_t letter : all) {
    if (letter == u' ') {
      begins = true;
      continue;
    }
    if (begins) {
      index_.starts.push_back({static_cast<std::uint32_t>(index_.text.size()), number});
      initials += letter;
    }
    begins = false;
    index_.text += letter;
  }
  end_field();
  if (initials.size() > 1) add_initials(initials, field);
}

void IndexBuilder::add_initials(std::u16string_view initials, const Field& of) {
  begin_field(of.owner, of.language, of.weight);
  for (const char16_t letter : initials) {
    index_.starts.push_back({static_cast<std::uint32_t>(index_.text.size()),
                             static_cast<std::uint32_t>(index_.fields.size() - 1)});
    index_.text += letter;
  }
  end_field();
}

Index IndexBuilder::build() && {
  Index& index = index_;
  const char16_t* const text = index.text.c_str();
  std::ranges::sort(index.starts, [text](const Start& a, const Start& b) {
    const char16_t* left = text + a.at;
    const char16_t* right = text + b.at;
    for (; *left == *right && *left != 0; ++left) ++right;
    return *left != *right ? *left < *right : a.at < b.at;
  });
  std::u16string_view before;
  for (std::uint32_t i = 0; i < index.starts.size(); ++i) {
    const std::u16string_view word_here = word_at(index, index.starts[i].at);
    if (i > 0 && word_here == before) continue;
    const auto differs = std::ranges::mismatch(before, word_here).in1;
    index.words.push_back(i);
    index.common.push_back(static_cast<std::uint8_t>(differs - before.begin()));
    before = word_here;
  }
  index.text.shrink_to_fit();
  index.starts.shrink_to_fit();
  index.fields.shrink_to_fit();
  return std::move(index_);
}

std::span<const Hit> find(const Index& index, std::u16string_view query, std::uint8_t language,
                          SearchDesk& desk) {
  constexpr std::size_t longest = 32;  // what of a word is looked at
  constexpr auto no_hit = std::numeric_limits<std::uint32_t>::max();
  desk.hits.clear();
  desk.word_cost.resize(index.entries);
  desk.cost.assign(index.entries, 0);
  if (query.empty()) return {};
  const bool is_alone = query.find(u' ') == query.npos;
  while (!query.empty()) {
    const std::size_t end = std::min(query.find(u' '), query.size());
    WordSearch(index, query.substr(0, std::min(end, longest)), is_alone, language, desk.word_cost)
        .run();
    for (std::size_t i = 0; i < desk.cost.size(); ++i)
      desk.cost[i] = desk.word_cost[i] == not_found || desk.cost[i] == no_hit
                         ? no_hit
                         : desk.cost[i] + desk.word_cost[i];
    query.remove_prefix(std::min(end + 1, query.size()));
  }
  for (std::uint32_t i = 0; i < index.entries; ++i)
    if (desk.cost[i] != no_hit) desk.hits.push_back({desk.cost[i], i});
  std::ranges::sort(desk.hits);
  return desk.hits;
}

}  // namespace docent::search

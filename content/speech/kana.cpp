#include "content/speech/kana.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <optional>
#include <utility>

#include "content/content_error.h"
#include "content/speech/run_program.h"

namespace docent::speech {
namespace {

using namespace std::chrono_literals;
constexpr auto time_to_read = 60s;  // a thousand sentences take a tenth of a second

constexpr std::array<std::string_view, 10> kana_digits{"ゼロ", "イチ", "ニ",   "サン", "ヨン",
                                                       "ゴ",   "ロク", "ナナ", "ハチ", "キュウ"};

/// One to nine times a hundred or a thousand.
std::string hundreds(std::uint32_t count) {
  constexpr std::array<std::string_view, 10> said{
      "",         "ヒャク",     "ニヒャク",   "サンビャク", "ヨンヒャク",
      "ゴヒャク", "ロッピャク", "ナナヒャク", "ハッピャク", "キュウヒャク"};
  return std::string(said[count]);
}
std::string thousands(std::uint32_t count) {
  constexpr std::array<std::string_view, 10> said{"",         "セン",      "ニセン",   "サンゼン",
                                                  "ヨンセン", "ゴセン",    "ロクセン", "ナナセン",
                                                  "ハッセン", "キュウセン"};
  return std::string(said[count]);
}

std::string below_ten_thousand(std::uint32_t number) {
  std::string said = thousands(number / 1'000) + hundreds(number / 100 % 10);
  const std::uint32_t tens = number / 10 % 10, ones = number % 10;
  if (tens > 1) said += kana_digits[tens];
  if (tens > 0) said += "ジュウ";
  if (ones > 0) said += kana_digits[ones];
  return said;
}

/// What is counted. Before some, the last sound of a number becomes short and theirs hard; before
/// others, four, seven and nine have other names.
struct JapaneseCounter {
  std::string_view written, said, hardened, after_three{};
  std::string_view four{}, seven{}, nine{};
};
constexpr std::array<JapaneseCounter, 9> counters{
    {{"分", "フン", "プン", "プン"},
     {"階", "カイ", "カイ", "ガイ"},
     {"回", "カイ", "カイ"},
     {"か所", "カショ", "カショ"},
     {"ヶ所", "カショ", "カショ"},
     {"箇所", "カショ", "カショ"},
     {.written = "月", .said = "ガツ", .hardened = {}, .four = "シ", .seven = "シチ", .nine = "ク"},
     {.written = "時", .said = "ジ", .hardened = {}, .four = "ヨ", .seven = "シチ", .nine = "ク"},
     {.written = "年", .said = "ネン", .hardened = {}, .four = "ヨ"}}};

struct Sounds {
  std::string_view from, to;
};
constexpr std::array<Sounds, 5> shortened{{{"イチ", "イッ"},
                                           {"ロク", "ロッ"},
                                           {"ハチ", "ハッ"},
                                           {"ジュウ", "ジュッ"},
                                           {"ヒャク", "ヒャッ"}}};

/// Replaces the end of a number; false where it has another.
bool replace_end(const Sounds& sounds, std::string& said) {
  if (sounds.to.empty() || !said.ends_with(sounds.from)) return false;
  said.replace(said.size() - sounds.from.size(), sounds.from.size(), sounds.to);
  return true;
}

std::string counted(std::uint32_t number, const JapaneseCounter& counter) {
  std::string said = number_in_kana(number);
  const std::array<Sounds, 3> names{
      {{"ヨン", counter.four}, {"ナナ", counter.seven}, {"キュウ", counter.nine}}};
  for (const Sounds& name : names)
    if (replace_end(name, said)) return said.append(counter.said);
  if (!counter.hardened.empty())
    for (const Sounds& sounds : shortened)
      if (replace_end(sounds, said)) return said.append(counter.hardened);
  const bool is_after_three =
      said.ends_with("サン") || (counter.written == "分" && said.ends_with("ヨン"));
  return said.append(is_after_three && !counter.after_three.empty() ? counter.after_three
                                                                    : counter.said);
}

/// What the dictionary says otherwise than people do.
constexpr std::array<Sounds, 1> corrections{{{"出口", "デグチ"}}};

/// A word as MeCab tells it.
struct Word {
  std::string_view written, part, kind, said;
};

std::string_view take_until(char end, std::string_view& text) {
  const std::size_t at = std::min(text.find(end), text.size());
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(std::min(at + 1, text.size()));
  return part;
}

Word word_of(std::string_view line) {
  Word word;
  for (std::string_view* part : {&word.written, &word.part, &word.kind, &word.said})
    *part = take_until('\t', line);
  return word;
}

bool leans_on_the_one_before(const Word& word) {
  return word.part == "助詞" || word.part == "助動詞" || word.kind == "接尾";
}
bool is_punctuation(const Word& word) {
  return word.kind == "句点" || word.kind == "読点";
}

std::optional<std::uint32_t> number_in(std::string_view written) {
  constexpr std::size_t most_digits = 8;
  std::uint32_t number = 0;
  const char* const begin = written.data();
  const char* const end = begin + written.size();
  const auto read = std::from_chars(begin, end, number);
  if (written.empty() || written.size() > most_digits || read.ptr != end) return {};
  return number;
}

/// A text, word by word.
class Reading {
 public:
  void add(const Word& word) {
    const std::optional<std::uint32_t> number = number_in(word.written);
    if (number_ && add_counted(word)) return;
    finish_number();
    if (number) {
      number_ = number;
      return;
    }
    const auto* const other = std::ranges::find(corrections, word.written, &Sounds::from);
    const bool is_read = !word.said.empty() && word.said != "*";
    put(other != corrections.end() ? other->to
        : is_read                  ? word.said
                                   : word.written,
        leans_on_the_one_before(word) || is_punctuation(word));
  }
  std::string take() {
    finish_number();
    return std::exchange(said_, {});
  }

 private:
  bool add_counted(const Word& word) {
    const auto* const counter =
        std::ranges::find(counters, word.written, &JapaneseCounter::written);
    if (counter == counters.end()) return false;
    put(counted(*number_, *counter), false);
    number_.reset();
    return true;
  }
  void finish_number() {
    if (number_) put(number_in_kana(*number_), false);
    number_.reset();
  }
  void put(std::string_view said, bool joined) {
    if (!said_.empty() && !joined) said_ += ' ';
    said_ += said;
  }

  std::string said_;
  std::optional<std::uint32_t> number_;  ///< Not said yet: a counter may follow.
};

[[noreturn]] void no_reading(const std::string& program, const std::string& what) {
  throw content::ContentError(Errc::Environment, program, "no-reading", what,
                              "install the packages mecab and mecab-ipadic-utf8");
}

Outcome ask(const std::vector<std::string>& words, std::string_view input) {
  Outcome outcome = run_program(words, input, time_to_read);
  if (outcome.kind == Outcome::Kind::Missing)
    no_reading(words.front(), "the program that reads Japanese is not installed");
  if (outcome.kind != Outcome::Kind::Ended)
    no_reading(words.front(), "the program that reads Japanese does not end");
  return outcome;
}

}  // namespace

std::string number_in_kana(std::uint32_t number) {
  if (number == 0) return std::string(kana_digits[0]);
  const std::uint32_t ten_thousands = number / 10'000;
  std::string said;
  if (ten_thousands > 0) said = below_ten_thousand(ten_thousands) + "マン";
  return said + below_ten_thousand(number % 10'000);
}

std::string fault_of_dictionary(std::string_view told_by_mecab) {
  while (!told_by_mecab.empty()) {
    std::string line(take_until('\n', told_by_mecab));
    if (!line.starts_with("charset:")) continue;
    std::ranges::transform(line, line.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (line.find("utf8") != std::string::npos || line.find("utf-8") != std::string::npos)
      return {};
    return "its dictionary is not in UTF-8";
  }
  return "it has no dictionary";
}

std::vector<std::string> kana_of(std::string_view analysis) {
  std::vector<std::string> texts;
  Reading reading;
  while (!analysis.empty()) {
    const std::string_view line = take_until('\n', analysis);
    if (line == "EOS")
      texts.push_back(reading.take());
    else if (!line.empty())
      reading.add(word_of(line));
  }
  return texts;
}

std::vector<std::string> read_in_kana(std::span<const std::string_view> texts,
                                      const std::string& program) {
  // It ends with 1 when it has told of its dictionary.
  if (const std::string fault = fault_of_dictionary(ask({program, "-D"}, {}).output);
      !fault.empty())
    no_reading(program, fault);
  std::string input;
  for (const std::string_view text : texts) {
    const std::size_t first = input.size();
    input.append(text).append("\n");
    std::replace(input.begin() + static_cast<std::ptrdiff_t>(first), input.end() - 1, '\n', ' ');
  }
  // The fields of IPA's dictionary: part of speech, its kind, and last of all how it is said.
  const Outcome outcome =
      ask({program, "-F", "%m\t%f[0]\t%f[1]\t%f[8]\n", "-U", "%m\t\t\t\n", "-E", "EOS\n"}, input);
  std::vector<std::string> said = kana_of(outcome.output);
  if (outcome.status != 0 || said.size() != texts.size())
    no_reading(program, "it does not answer for every text");
  return said;
}

}  // namespace docent::speech

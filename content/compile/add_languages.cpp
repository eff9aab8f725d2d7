#include "content/compile/add_languages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "config/text_faults.h"
#include "content/compile/shipped_files.h"
#include "platform/terminal/suggest.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/plural.h"
#include "runtime/interface/utterance.h"

namespace docent::compile {

namespace {

using config::LocatedTexts;
using config::WordsFile;

/// What begins the words of a distance, and of a time; a plural form ends them.
constexpr std::string_view metres = "metres_", whole_minutes = "minutes_";

/// Languages that are written from right to left, whatever their script is said to be.
bool is_written_from_right_to_left(std::string_view tag) {
  constexpr std::array<std::string_view, 10> right_to_left{"ar", "fa", "he", "ur", "ps",
                                                           "sd", "ug", "yi", "dv", "ckb"};
  const std::string_view language = tag.substr(0, tag.find('-'));
  return std::ranges::find(right_to_left, language) != right_to_left.end() &&
         tag.find("-Latn") == std::string_view::npos;
}

/// How many numbers that a kiosk says take this word in a language; none where it is not said with
/// a number.
std::optional<std::size_t> numbers_of(std::string_view key, std::string_view tag) {
  const auto count = [&](long most, auto word_of) {
    std::size_t numbers = 0;
    for (long n = 1; n <= most; ++n) numbers += word_of(n) == key ? 1 : 0;
    return numbers;
  };
  if (key.starts_with(metres))
    return count(interface::farthest_spoken, [&](long n) {
      return std::string(metres).append(interface::plural_form(tag, n));
    });
  if (key.starts_with(whole_minutes))
    return count(interface::longest_spoken, [&](long n) {
      return std::string(whole_minutes).append(interface::plural_form(tag, n));
    });
  constexpr std::array<std::string_view, 5> minutes{"time_one", "time_two", "time_few", "time_many",
                                                    "time_21"};
  if (std::ranges::find(minutes, key) != minutes.end())
    return count(interface::longest_spoken, [&](long n) { return interface::time_word(tag, n); });
  return {};
}

std::size_t letters_in(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// The words of one language: the museum's own beside the shipped ones.
class LanguageAdder {
 public:
  LanguageAdder(const config::MuseumConfig& config, Museum& museum, Report& report)
      : config_(config), museum_(museum), report_(report) {
    // What the screens say is what the shipped English says.
    auto english = config::load_words(shipped_words("en"), "en");
    if (english.value) wanted_ = std::move(english.value->words.value);
  }

  void add(const std::string& tag) {
    const auto own = std::ranges::find(config_.words, tag, &WordsFile::tag);
    auto shipped = config::load_words(shipped_words(tag), tag);
    if (own == config_.words.end() && !shipped.value) {
      // Words that cannot be read are told already.
      if (std::ranges::none_of(config_.files,
                               [&](const std::string& file) { return file == file_of(tag); }))
        tell_missing_file(tag);
      return;
    }
    const WordsFile& file = own == config_.words.end() ? *shipped.value : *own;
    Language language;
    language.tag = tag;
    language.name = file.name.value.empty() ? tag : file.name.value;
    language.right_to_left = file.direction.value == "right-to-left";
    if (shipped.value) take(shipped.value->words.value, language);
    if (own != config_.words.end()) {
      check(*own, language);
      take(own->words.value, language);
    }
    museum_.languages.push_back(std::move(language));
  }

 private:
  static void take(const LocatedTexts& words, Language& language) {
    for (const auto& [key, word] : words) language.words[key] = word.value;
  }

  std::string file_of(const std::string& tag) const {
    return (config_.folder / "words" / (tag + ".toml")).string();
  }

  void tell_missing_file(const std::string& tag) {
    report_.add(
        {.file = file_of(tag),
         .code = "missing-translation",
         .message = fmt::format("there are no words of the interface in '{}'", tag),
         .hint = "write this file in the museum's folder, with the keys of another language"});
  }

  void tell(Severity severity, const config::Place& place, std::string code, std::string message,
            std::string hint) {
    Diagnostic diagnostic = config::diagnostic_at(config_, place, std::move(code),
                                                  std::move(message), {}, std::move(hint));
    diagnostic.severity = severity;
    report_.add(std::move(diagnostic));
  }

  /// `known`: what is shipped in that language.
  void check(const WordsFile& own, const Language& known) {
    check_direction(own);
    if (!own.words.given) return;  // already reported
    for (const auto& [key, word] : wanted_)
      if (!own.words.value.contains(key) && !known.words.contains(key) &&
          numbers_of(key, own.tag) != 0U)
        tell(Severity::Error, own.words.place, "missing-translation",
             fmt::format("the word '{}' is not translated into '{}'", key, own.tag),
             fmt::format("translate from 'en': {} = \"{}\"", key, word.value));
    for (const auto& [key, word] : own.words.value)
      if (word.given) check_word(key, word, own.tag);
  }

  void check_direction(const WordsFile& own) {
    if (!own.direction.given) return;
    const bool should = is_written_from_right_to_left(own.tag);
    if ((own.direction.value == "right-to-left") == should) return;
    tell(Severity::Warning, own.direction.place, "odd-direction",
         fmt::format("'{}' is written {}", own.tag,
                     should ? "from right to left" : "from left to right"),
         fmt::format("write direction = \"{}\"", should ? "right-to-left" : "left-to-right"));
  }

  void check_word(const std::string& key, const config::Located<std::string>& word,
                  const std::string& tag) {
    // English has no zero's form.
    const auto wanted =
        wanted_.find(key == "metres_zero" && numbers_of(key, tag) > 0U ? "metres_other" : key);
    if (wanted == wanted_.end()) return tell_unknown(key, word);
    if (word.value.find_first_not_of(" \t\r\n") == std::string::npos)
      return tell(Severity::Error, word.place, "empty-text",
                  fmt::format("the word '{}' is empty in '{}'", key, tag),
                  fmt::format("translate from 'en': {} = \"{}\"", key, wanted->second.value));
    if (key == "digits" && letters_in(word.value) != 10)
      tell(Severity::Error, word.place, "bad-value",
           fmt::format("'digits' holds {} figures, and there are ten", letters_in(word.value)),
           "write all of them from 0 to 9, without blanks: digits = \"0123456789\"");
    check_placeholders(key, word, wanted->second.value, tag);
    for (const config::TextFault& fault : config::faults_of(word.value, config::fonts_of(config_)))
      tell(Severity::Warning, word.place, fault.code,
           fmt::format("the word '{}' {} in '{}'{}", key, fault.what, tag, fault.why), fault.hint);
  }

  void tell_unknown(const std::string& key, const config::Located<std::string>& word) {
    std::vector<std::string_view> keys;
    for (const auto& [each, meaning] : wanted_) keys.emplace_back(each);
    const std::string_view near = terminal::closest(key, keys);
    tell(Severity::Error, {word.place.file, word.key}, "unknown-key",
         fmt::format("no screen says the word '{}'", key),
         near.empty() ? "remove it" : fmt::format("did you mean '{}'?", near));
  }

  /// What the kiosk fills in, such as {n}, is the same in every language, but for a clock of 24
  /// hours, which has no halves, and the form of a single number, which may be written out.
  void check_placeholders(const std::string& key, const config::Located<std::string>& word,
                          const std::string& english, const std::string& tag) {
    std::set<std::string> wanted = config::placeholders_of(english);
    const std::set<std::string> used = config::placeholders_of(word.value);
    if (wanted.contains("{half}") && used.contains("{hour_of_day}")) {
      wanted.erase("{half}");
      wanted.erase("{hour}");
      wanted.insert("{hour_of_day}");
    }
    const std::optional<std::size_t> numbers = numbers_of(key, tag);
    if (numbers && *numbers <= 1 && !used.contains("{n}")) wanted.erase("{n}");
    const std::string hint = fmt::format("in English it is: {}", english);
    bool is_told = false;
    for (const std::string& name : used)
      if (!wanted.contains(name)) {
        tell(Severity::Error, word.place, "wrong-placeholder",
             fmt::format("the word '{}' holds {}, which nothing fills in", key, name), hint);
        is_told = true;
      }
    for (const std::string& name : wanted)
      if (!used.contains(name) && !is_told)
        tell(Severity::Warning, word.place, "wrong-placeholder",
             fmt::format("the word '{}' lacks {}", key, name), hint);
  }

  const config::MuseumConfig& config_;
  Museum& museum_;
  Report& report_;
  LocatedTexts wanted_;
};

}  // namespace

void add_languages(const config::MuseumConfig& config, Museum& museum, Report& report) {
  LanguageAdder adder(config, museum, report);
  for (const std::string& tag : config.languages) adder.add(tag);
}

}  // namespace docent::compile

#include "config/toml_fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "config/letters.h"
#include "config/look_alike.h"

namespace docent::config {

namespace {

constexpr std::string_view bare_key_letters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
constexpr std::string_view key_letters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
constexpr std::size_t longest_line = 100;  // that a hint repeats, in bytes
constexpr std::array<std::string_view, 8> smart_quotes{"“", "”", "„", "‟", "«", "»", "‘", "’"};

// What stands for a character in the mask of a line, besides ASCII itself.
constexpr char of_text = 'x', other_letter = '\x01', smart_quote = '\x02';

/// A line of the file: its characters, and a mask with a byte for each, in which texts are
/// `of_text` within their quotation marks and comments are blank.
struct Line {
  std::vector<std::string_view> character;
  std::string mask;
  std::optional<std::size_t> unclosed;    ///< The quotation mark that nothing closes.
  std::optional<std::size_t> bad_escape;  ///< A backslash that begins no escape.
  std::size_t begins = 0;                 ///< The line in which its statement begins.

  [[nodiscard]] std::string words(std::size_t from, std::size_t to) const {
    std::string joined;
    for (std::size_t i = from; i < std::min(to, character.size()); ++i) joined += character[i];
    return joined;
  }
};

std::vector<std::string_view> characters_of(std::string_view line) {
  std::vector<std::string_view> characters;
  for (std::size_t at = 0; at < line.size();) {
    std::size_t end = at + 1;
    while (end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) ++end;
    characters.push_back(line.substr(at, end - at));
    at = end;
  }
  return characters;
}

bool is_smart_quote(std::string_view character) {
  return std::ranges::find(smart_quotes, character) != smart_quotes.end();
}

bool is_hexadecimal(std::string_view character) {
  const char c = to_lower(character.front());
  return is_digit(c) || (c >= 'a' && c <= 'f');
}

/// Does an escape begin behind the backslash at `i`? \u has four figures, and \U eight.
bool begins_escape(const std::vector<std::string_view>& character, std::size_t i) {
  const char c = character[i + 1].front();
  const std::size_t figures = c == 'u' ? 4 : c == 'U' ? 8 : 0;
  if (i + 2 + figures > character.size()) return false;
  for (std::size_t n = 0; n < figures; ++n)
    if (!is_hexadecimal(character[i + 2 + n])) return false;
  return std::string_view("btnfruU\"\\").find(c) != std::string_view::npos;
}

/// Reads the file line by line, as far as quotation marks, comments and brackets go.
class Scanner {
 public:
  explicit Scanner(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      if (line.ends_with('\r')) line.remove_suffix(1);
      scan(line);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  std::vector<Line> lines;
  std::optional<std::pair<std::size_t, std::size_t>> open_text;  ///< Line and character of `"""`.

 private:
  void scan(std::string_view text) {
    Line line;
    line.character = characters_of(text);
    line.mask.assign(line.character.size(), ' ');
    line.begins = open_text || depth_ > 0 ? begins_ : lines.size();
    begins_ = line.begins;
    for (std::size_t i = 0; i < line.character.size();)
      i = open_text ? in_long_text(line, i) : outside(line, i);
    lines.push_back(std::move(line));
  }

  static bool three_at(const Line& line, std::size_t i, char quote) {
    const std::string_view q(&quote, 1);
    return i + 2 < line.character.size() && line.character[i] == q && line.character[i + 1] == q &&
           line.character[i + 2] == q;
  }

  std::size_t in_long_text(Line& line, std::size_t i) {
    line.mask[i] = of_text;
    if (line.character[i] == "\\" && quote_ == '"') return std::min(i + 2, line.character.size());
    if (!three_at(line, i, quote_)) return i + 1;
    open_text.reset();
    line.mask.replace(i, 3, 3, quote_);
    return i + 3;
  }

  std::size_t outside(Line& line, std::size_t i) {
    const std::string_view c = line.character[i];
    if (c == "#") return line.character.size();
    if (c == "\"" || c == "'") return quoted(line, i);
    if (is_smart_quote(c))
      line.mask[i] = smart_quote;
    else
      line.mask[i] = c.size() == 1 ? c.front() : other_letter;
    if (c == "[") ++depth_;
    if (c == "]" && depth_ > 0) --depth_;
    return i + 1;
  }

  std::size_t quoted(Line& line, std::size_t i) {
    quote_ = line.character[i].front();
    if (three_at(line, i, quote_)) {
      open_text = {lines.size(), i};
      line.mask.replace(i, 3, 3, quote_);
      return i + 3;
    }
    const std::string_view q(&quote_, 1);
    line.mask[i] = quote_;
    for (std::size_t end = i + 1; end < line.character.size(); ++end) {
      if (line.character[end] == q) {
        line.mask[end] = quote_;
        return end + 1;
      }
      line.mask[end] = of_text;
      if (quote_ != '"' || line.character[end] != "\\") continue;
      if (end + 1 < line.character.size() && !begins_escape(line.character, end) &&
          !line.bad_escape)
        line.bad_escape = end;
      if (++end < line.character.size()) line.mask[end] = of_text;
    }
    line.unclosed = i;
    return line.character.size();
  }

  char quote_ = '"';
  std::size_t depth_ = 0, begins_ = 0;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// What a hint repeats of a value.
std::string_view short_enough(std::string_view value) {
  return value.size() <= longest_line ? value : std::string_view("...");
}

/// A statement `key = value` of one line, by the mask.
struct Statement {
  std::size_t equals = 0, value = 0,
              end = 0;  ///< Characters; `value` is `end` where there is none.
};

std::optional<Statement> statement_of(const Line& line) {
  const std::size_t equals = line.mask.find('=');
  if (equals == std::string::npos) return {};
  const std::size_t last = line.mask.find_last_not_of(" \t");
  const std::size_t value = line.mask.find_first_not_of(" \t", equals + 1);
  return Statement{equals, value == std::string::npos ? last + 1 : value, last + 1};
}

/// -12.5, without an exponent.
bool is_plain_number(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && is_digit(text.front()) && is_digit(text.back()) &&
         text.find_first_not_of("0123456789.") == std::string_view::npos &&
         std::ranges::count(text, '.') <= 1;
}

/// The numbers that were meant by "6,3; 14,5" or "0,0, 4,0" or "6.3, 14.5", as TOML writes them;
/// empty where that is not clear.
std::vector<std::string> numbers_meant(std::string_view text) {
  const bool by_semicolon = text.find(';') != std::string_view::npos;
  std::vector<std::string> numbers(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool blank_follows = i + 1 < text.size() && text[i + 1] == ' ';
    if (c == ';' || (c == ',' && !by_semicolon &&
                     (blank_follows || numbers.back().find('.') != std::string::npos)))
      numbers.emplace_back();
    else if (c == ',')
      numbers.back() += '.';
    else if (c != ' ')
      numbers.back() += c;
  }
  if (!std::ranges::all_of(numbers, is_plain_number)) return {};
  return numbers;
}

/// The explainer: one question after the other, the most telling first.
class Explainer {
 public:
  Explainer(std::string_view text, SourceRange noticed, bool redefines)
      : scan_(text), noticed_(noticed), redefines_(redefines) {
    if (scan_.lines.empty()) scan_.lines.emplace_back();
    at_ =
        std::min<std::size_t>(std::max<std::uint32_t>(noticed.line, 1) - 1, scan_.lines.size() - 1);
  }

  TomlFault explain() const {
    using Question = std::optional<TomlFault> (Explainer::*)() const;
    constexpr auto questions = std::to_array<Question>(
        {&Explainer::twice, &Explainer::mark_of_conflict, &Explainer::remark,
         &Explainer::smart_quotes_about, &Explainer::other_look_alike,
         &Explainer::quote_within_text, &Explainer::strange_number, &Explainer::unclosed_text,
         &Explainer::open_long_text, &Explainer::unknown_escape, &Explainer::unclosed_list,
         &Explainer::unclosed_table, &Explainer::heading, &Explainer::no_equals,
         &Explainer::strange_key, &Explainer::no_value, &Explainer::numbers_without_brackets,
         &Explainer::bare_text, &Explainer::more_than_a_value});
    for (const Question question : questions)
      if (auto fault = (this->*question)()) return *fault;
    return {noticed_, "this line cannot be understood",
            "a line is key = value, or a heading such as [[exhibit]]; compare it with the lines "
            "about it"};
  }

 private:
  [[nodiscard]] const Line& line() const { return scan_.lines[at_]; }

  static TomlFault fault(std::size_t line, std::size_t first, std::size_t end, std::string message,
                         std::string hint) {
    return {{.line = static_cast<std::uint32_t>(line + 1),
             .column = static_cast<std::uint32_t>(first + 1),
             .length = static_cast<std::uint32_t>(std::max(end, first + 1) - first)},
            std::move(message),
            std::move(hint)};
  }

  [[nodiscard]] std::string key_of(const Line& line) const {
    const std::size_t equals = std::min(line.mask.find('='), line.mask.size());
    return std::string(trimmed(line.words(0, equals)));
  }

  [[nodiscard]] std::optional<TomlFault> twice() const {
    if (!redefines_) return {};
    const bool is_heading = trimmed(line().mask).starts_with('[');
    const std::string key =
        is_heading ? std::string(trimmed(line().words(0, line().mask.find('#')))) : key_of(line());
    std::string hint = "keep one of them";
    for (std::size_t i = at_; i-- > 0;) {
      const Line& earlier = scan_.lines[i];
      const bool begins_table = trimmed(earlier.mask).starts_with('[');
      if (is_heading ? std::string(trimmed(earlier.words(0, earlier.mask.size()))) == key
                     : !begins_table && key_of(earlier) == key) {
        hint = fmt::format("the first is in line {}; keep one of them", i + 1);
        break;
      }
      if (!is_heading && begins_table) break;
    }
    if (is_heading && !key.starts_with("[["))
      hint += fmt::format(", or write [{}] above each where several are meant", key);
    const std::size_t first = line().mask.find_first_not_of(" \t");
    return fault(at_, first, first + characters_of(key).size(),
                 fmt::format("'{}' is written twice", key), hint);
  }

  [[nodiscard]] std::optional<TomlFault> smart_quotes_about() const {
    for (std::size_t i = 0; i <= at_; ++i) {
      const Line& candidate = scan_.lines[i];
      std::size_t found = candidate.mask.find(smart_quote);
      if (found == std::string::npos && candidate.unclosed)
        for (std::size_t c = *candidate.unclosed; c < candidate.character.size(); ++c)
          if (is_smart_quote(candidate.character[c])) found = c;
      if (found == std::string::npos) continue;
      return fault(
          i, found, found + 1,
          fmt::format("{} is a word processor's quotation mark", candidate.character[found]),
          "write straight ones, \"like this\"; a plain text editor makes no others");
    }
    return {};
  }

  /// The line as it was meant, with the letters of a keyboard outside of its texts.
  [[nodiscard]] static std::string as_meant(const Line& line) {
    std::string meant;
    for (std::size_t i = 0; i < line.character.size(); ++i) {
      const std::string_view c = line.character[i];
      const auto alike = line.mask[i] == of_text ? std::optional<LookAlike>{} : look_alike(c);
      meant += alike ? alike->meant : c;
    }
    return std::string(trimmed(meant));
  }

  [[nodiscard]] std::optional<TomlFault> other_look_alike() const {
    for (std::size_t i = 0; i <= at_; ++i) {
      const Line& candidate = scan_.lines[i];
      const std::size_t last =
          std::min(candidate.mask.find_last_not_of(" \t") + 1, candidate.mask.size());
      for (std::size_t c = 0; c < last; ++c) {
        if (candidate.mask[c] != other_letter) continue;
        const auto alike = look_alike(candidate.character[c]);
        if (!alike) continue;
        const std::string line = as_meant(candidate);
        const std::string written = line.size() <= longest_line
                                        ? fmt::format("write {}", line)
                                        : fmt::format("write {}", alike->meant);
        if (!alike->is_seen)
          return fault(
              i, c, c + 1,
              fmt::format("{} stands here, which {}", alike->name,
                          alike->meant.empty() ? "nobody sees" : "only looks like a blank"),
              alike->meant.empty() ? "delete it: put the cursor behind it and press backspace"
                                   : "delete it and type a blank");
        return fault(
            i, c, c + 1,
            fmt::format("{} looks like {} and is another letter", alike->name, alike->meant),
            written);
      }
    }
    return {};
  }

  [[nodiscard]] std::optional<TomlFault> mark_of_conflict() const {
    const std::string text = line().words(0, line().character.size());
    for (const std::string_view mark : {"<<<<<<<", "=======", ">>>>>>>"})
      if (text.starts_with(mark))
        return fault(
            at_, 0, line().character.size(),
            "this line is a mark of Git, where two people changed the same lines",
            "keep one of the two versions between <<<<<<< and >>>>>>>, and delete the marks");
    return {};
  }

  /// A remark as other languages write them, alone in its line or behind a value.
  [[nodiscard]] std::optional<TomlFault> remark() const {
    const std::string_view mask = line().mask;
    const std::size_t noticed = std::max<std::uint32_t>(noticed_.column, 1) - 1;
    const std::size_t begin = mask.find_first_not_of(" \t");
    if (line().begins != at_ || begin == std::string_view::npos) return {};
    for (const std::string_view mark : {"//", "<!--", "/*", "--", ";"}) {
      const bool alone = mask.substr(begin).starts_with(mark);
      const bool behind =
          mark != ";" && noticed < mask.size() && mask.substr(noticed).starts_with(mark);
      if (!alone && !behind) continue;
      const std::size_t first = alone ? begin : noticed;
      const std::string text = line().words(first + mark.size(), mask.size());
      std::string_view words = trimmed(text);
      for (const std::string_view end : {"-->", "*/"})
        if (words.ends_with(end)) words.remove_suffix(end.size());
      return fault(at_, first, mask.find_last_not_of(" \t") + 1,
                   fmt::format("a remark does not begin with {}", mark),
                   fmt::format("write # {}", short_enough(trimmed(words))));
    }
    return {};
  }

  /// A text that its own quotation mark ends too early: "The "Bronze" Tripod", 'King's'.
  [[nodiscard]] std::optional<TomlFault> quote_within_text() const {
    const auto statement = statement_of(line());
    if (!statement || line().begins != at_ || statement->value >= statement->end) return {};
    const char quote = line().mask[statement->value];
    const std::size_t close = line().mask.find(quote, statement->value + 1);
    if ((quote != '"' && quote != '\'') || close == std::string::npos ||
        close + 1 >= statement->end)
      return {};
    const char next = line().mask[close + 1];
    if (next != other_letter && !is_letter(next) && !is_digit(next)) return {};
    const std::string text = line().words(statement->value + 1, statement->end);
    const bool closes = text.ends_with(quote);
    const std::string inner = text.substr(0, text.size() - (closes ? 1 : 0));
    const bool has_double = inner.find('"') != std::string::npos,
               has_single = inner.find('\'') != std::string::npos;
    const std::string written = has_double && !has_single ? fmt::format("'{}'", inner)
                                : !has_double             ? fmt::format("\"{}\"", inner)
                                                          : "";
    return fault(at_, close, close + 1,
                 "the quotation mark here ends the text, which goes on behind it",
                 written.empty() || written.size() > longest_line
                     ? "write \\\" for a quotation mark within a text"
                     : fmt::format("write {} = {}", key_of(line()), written));
  }

  /// A number that TOML writes in another way: 090, 6., .5, 90°, 60s, 24".
  [[nodiscard]] std::optional<TomlFault> strange_number() const {
    const std::size_t column = std::max<std::uint32_t>(noticed_.column, 1) - 1;
    if (column > line().mask.size() || trimmed(line().mask).starts_with('[')) return {};
    const std::size_t from = line().begins == at_ ? line().mask.find('=') + 1 : 0;
    for (std::size_t i = from; i < line().mask.size(); ++i) {
      const char before = i == 0 ? ' ' : line().mask[i - 1];
      if (before != ' ' && before != '=' && before != '[' && before != ',' && before != '\t')
        continue;
      std::size_t end = i;
      while (end < line().mask.size() && is_of_number(line().mask[end])) ++end;
      std::size_t next = end;  // what follows a number was noticed, and not the number
      while (next < line().mask.size() && line().mask[next] == ' ') ++next;
      if (end == i || next < column || i > column) continue;
      if (auto fault = fault_of_number(i, end)) return fault;
    }
    return {};
  }

  static bool is_of_number(char c) { return is_digit(c) || c == '.' || c == '-' || c == '+'; }

  [[nodiscard]] std::optional<TomlFault> fault_of_number(std::size_t first, std::size_t end) const {
    const std::string number = line().words(first, end);
    const std::string_view sign = number.starts_with('-') ? "-" : "";
    std::string_view figures = number;
    while (!figures.empty() && (figures.front() == '-' || figures.front() == '+'))
      figures.remove_prefix(1);
    if (figures.empty() || std::ranges::count(figures, '.') > 1 ||
        figures.find_first_of("+-") != std::string_view::npos)
      return {};
    const auto written = [&](std::string_view message, std::string_view better) {
      return fault(at_, first, end, std::string(message), fmt::format("write {}{}", sign, better));
    };
    if (figures.front() == '.')
      return written("a number has figures on both sides of its full stop",
                     fmt::format("0{}", figures));
    if (figures.back() == '.')
      return written("a number has figures on both sides of its full stop",
                     fmt::format("{}0", figures));
    std::string_view rest = figures;
    while (rest.size() > 1 && rest.front() == '0' && rest[1] != '.') rest.remove_prefix(1);
    if (rest.size() < figures.size()) return written("a number does not begin with a zero", rest);
    return unit_behind(first, end, number);
  }

  [[nodiscard]] std::optional<TomlFault> unit_behind(std::size_t first, std::size_t end,
                                                     const std::string& number) const {
    const std::string_view mask = line().mask;
    const std::size_t unit = std::min(mask.find_first_not_of(' ', end), mask.size());
    std::size_t stop = unit;
    while (stop < mask.size() && (is_letter(mask[stop]) || mask[stop] == other_letter ||
                                  mask[stop] == '"' || mask[stop] == '\'' || mask[stop] == '%'))
      ++stop;
    if (stop == unit ||
        (stop < mask.size() && mask[stop] != ' ' && mask[stop] != ',' && mask[stop] != ']'))
      return {};
    const std::string name = line().words(unit, stop);
    // 1e5 is a number, and so is 0x1f.
    if (unit == end && (name == "e" || name == "x" || name == "b" || name == "o")) return {};
    const std::string key = key_of(line());
    const bool in_list =
        mask.substr(0, first).find('[') != std::string_view::npos || line().begins != at_;
    return fault(at_, unit, stop, fmt::format("'{}' is one thing too many in this line", name),
                 in_list ? fmt::format("a number stands alone: write {}", number)
                         : fmt::format("a number stands alone: write {} = {}", key, number));
  }

  [[nodiscard]] std::optional<TomlFault> unclosed_text() const {
    for (std::size_t i = 0; i <= at_; ++i)
      if (const Line& candidate = scan_.lines[i]; candidate.unclosed) {
        if (candidate.bad_escape || ends_in_backslash(candidate)) continue;
        return fault(i, *candidate.unclosed, candidate.character.size(),
                     "the text that begins here is not closed",
                     "end it with a quotation mark in the same line; a text of several lines "
                     "stands between three: \"\"\"");
      }
    return {};
  }

  static bool ends_in_backslash(const Line& line) {
    return line.character.size() > 1 && line.character[line.character.size() - 2] == "\\";
  }

  [[nodiscard]] std::optional<TomlFault> open_long_text() const {
    if (!scan_.open_text) return {};
    const auto [at, first] = *scan_.open_text;
    return fault(at, first, first + 3, "the text of several lines that begins here is never closed",
                 "end it with three quotation marks: \"\"\"");
  }

  [[nodiscard]] std::optional<TomlFault> unknown_escape() const {
    for (std::size_t i = 0; i <= at_; ++i) {
      const Line& candidate = scan_.lines[i];
      std::optional<std::size_t> bad = candidate.bad_escape;
      if (!bad && candidate.unclosed && ends_in_backslash(candidate))
        bad = candidate.character.size() - 2;
      if (bad)
        return fault(i, *bad, *bad + 2,
                     fmt::format("a backslash begins a special letter, and '{}' is none",
                                 candidate.words(*bad, *bad + 2)),
                     "write folders with a slash: images/jar.png; a backslash itself is \\\\");
    }
    return {};
  }

  [[nodiscard]] std::optional<TomlFault> unclosed_list() const {
    for (std::size_t i = 1; i < scan_.lines.size(); ++i) {
      const Line& candidate = scan_.lines[i];
      if (candidate.begins == i) continue;
      const std::string_view mask = trimmed(candidate.mask);
      const bool begins_another =
          mask.starts_with("[[") && mask.find_first_of("0123456789\"'") == std::string_view::npos;
      const bool is_last = i + 1 == scan_.lines.size() && !scan_.open_text && i == at_;
      if (!begins_another && mask.find('=') == std::string_view::npos && !is_last) continue;
      if (mask.find('{') < mask.find('=')) continue;  // an inline table, a stop of a connection
      return list_that_begins(candidate.begins);
    }
    const std::string_view mask = trimmed(line().mask);
    const auto opened = std::ranges::count(mask, '['), closed = std::ranges::count(mask, ']');
    if (!mask.starts_with('[') && opened > closed) return list_that_begins(line().begins);
    return {};
  }

  [[nodiscard]] TomlFault list_that_begins(std::size_t i) const {
    const Line& begin = scan_.lines[i];
    const std::size_t bracket = std::min(begin.mask.find('['), begin.mask.size());
    if (trimmed(begin.mask).starts_with('['))
      return fault(i, bracket, begin.mask.size(), "the heading that begins here is not closed",
                   "write as many closing brackets as opening ones: [[exhibit]]");
    return fault(i, bracket, begin.mask.size(), "the list that begins here is not closed",
                 "end it with as many closing brackets as opening ones: [1.5, 2.0]");
  }

  /// { and } stand in one line.
  [[nodiscard]] std::optional<TomlFault> unclosed_table() const {
    const std::string_view mask = line().mask;
    if (std::ranges::count(mask, '{') <= std::ranges::count(mask, '}')) return {};
    const std::size_t open = mask.rfind('{');
    return fault(at_, open, mask.size(), "the table that begins here is not closed in its line",
                 line().begins == at_ && key_of(line()).find('{') == std::string::npos
                     ? fmt::format("end it with a curly bracket, or write {}.en = \"...\" and the "
                                   "others in lines of their own",
                                   key_of(line()))
                     : "end it with a curly bracket: {floor = \"...\", position = [1.5, 2.0]}");
  }

  [[nodiscard]] std::optional<TomlFault> heading() const {
    const std::string_view mask = trimmed(line().mask);
    if (!mask.starts_with('[') || line().begins != at_) return {};
    const std::size_t first = line().mask.find('[');
    return fault(at_, first, first + mask.size(),
                 fmt::format("'{}' is no heading", trimmed(line().words(0, line().mask.size()))),
                 "a heading stands alone in its line: [museum] for what there is one of, "
                 "[[exhibit]] for each of several");
  }

  [[nodiscard]] std::optional<TomlFault> no_equals() const {
    if (line().begins != at_ || statement_of(line())) return {};
    const std::string_view mask = trimmed(line().mask);
    if (mask.empty()) return {};
    const std::size_t first = line().mask.find_first_not_of(" \t");
    if (at_ == 0 && std::ranges::count_if(mask, [](char c) { return c == ';' || c == '\t'; }) > 1)
      return fault(
          at_, first, first + mask.size(), "this is the table of a spreadsheet, and no TOML",
          "save it as CSV UTF-8 and name it in museum.toml: [source] file = \"objects.csv\"");
    if (mask.starts_with('{'))
      return fault(at_, first, first + 1, "this is JSON, and TOML belongs here",
                   "a line is key = value, or a heading such as [[exhibit]]");
    const std::size_t colon = line().mask.find(':');
    if (colon != std::string::npos)
      return fault(at_, colon, colon + 1, "a colon stands where an equals sign belongs",
                   fmt::format("write {} = ...", trimmed(line().words(0, colon))));
    const std::size_t end =
        std::min(line().mask.find_first_not_of(key_letters, first), line().mask.size());
    const std::size_t value =
        std::min(line().mask.find_first_not_of(" \t", end), line().mask.size());
    if (end > first && value > end && value < line().mask.size() &&
        std::string_view("\"'[-0123456789").find(line().mask[value]) != std::string_view::npos)
      return fault(at_, end, value,
                   fmt::format("an equals sign is missing behind '{}'", line().words(first, end)),
                   fmt::format("write {} = {}", line().words(first, end),
                               short_enough(trimmed(line().words(value, line().mask.size())))));
    return fault(at_, first, first + mask.size(), "this line is neither key = value nor a heading",
                 "a remark begins with #; a text of several lines stands between three quotation "
                 "marks: \"\"\"");
  }

  [[nodiscard]] std::optional<TomlFault> strange_key() const {
    const auto statement = statement_of(line());
    if (!statement || line().begins != at_) return {};
    const std::string_view key =
        trimmed(std::string_view(line().mask).substr(0, statement->equals));
    const std::size_t first = line().mask.find_first_not_of(" \t");
    if (key.empty() || first >= statement->equals)
      return fault(at_, statement->equals, statement->equals + 1,
                   "nothing stands before the equals sign", "write key = value");
    for (std::size_t i = first; i < first + key.size(); ++i) {
      const char c = line().mask[i];
      if (c == '.' || c == '"' || c == '\'' || bare_key_letters.find(c) != std::string_view::npos)
        continue;
      if (key.find('"') != std::string_view::npos || key.find('\'') != std::string_view::npos)
        return {};
      if (c == ':' || c == '{')
        return fault(at_, i, i + 1, fmt::format("'{}' does not belong here", c),
                     "write key = value");
      return fault(at_, first, first + key.size(),
                   fmt::format("'{}' cannot be a key: it holds {}",
                               trimmed(line().words(0, statement->equals)),
                               c == ' ' ? "a blank" : fmt::format("'{}'", line().character[i])),
                   hint_for_key(key));
    }
    return {};
  }

  /// "title en" is meant as title.en, and "looking seconds" as looking_seconds.
  [[nodiscard]] static std::string hint_for_key(std::string_view key) {
    const std::size_t blank = key.find(' ');
    const bool plain =
        key.find_first_not_of(std::string(key_letters) + ' ') == std::string_view::npos;
    if (blank == std::string_view::npos || !plain)
      return "keys are written in plain letters, digits, hyphens and full stops";
    std::string joined(key);
    const bool is_language = key.size() - blank <= 4;
    std::ranges::replace(joined, ' ', is_language ? '.' : '_');
    return fmt::format("write {} = ...", joined);
  }

  [[nodiscard]] std::optional<TomlFault> no_value() const {
    const auto statement = statement_of(line());
    if (!statement || line().begins != at_ || statement->value < statement->end) return {};
    return fault(at_, statement->equals, statement->equals + 1,
                 fmt::format("'{}' has no value", key_of(line())),
                 "write one behind the equals sign, or remove the line");
  }

  /// 12,5 and 0,0, 4,0 and 6.3, 14.5
  [[nodiscard]] std::optional<TomlFault> numbers_without_brackets() const {
    const auto statement = statement_of(line());
    if (!statement || line().begins != at_ || statement->value >= statement->end) return {};
    const std::string value(trimmed(line().words(statement->value, statement->end)));
    if (value.find_first_not_of("0123456789.,;- ") != std::string::npos ||
        value.find_first_of(",;") == std::string::npos)
      return {};
    const std::vector<std::string> numbers = numbers_meant(value);
    if (numbers.empty()) return {};
    const std::string key = key_of(line());
    if (numbers.size() == 1)
      return fault(at_, statement->value, statement->end,
                   "a comma stands in a number where a full stop belongs",
                   fmt::format("write {} = {}", key, numbers.front()));
    return fault(at_, statement->value, statement->end,
                 value.find('.') == std::string::npos
                     ? "a comma stands in a number where a full stop belongs"
                     : "several numbers stand here without brackets",
                 fmt::format("write {} = [{}]", key, fmt::join(numbers, ", ")));
  }

  [[nodiscard]] std::optional<TomlFault> bare_text() const {
    const auto statement = statement_of(line());
    if (!statement || line().begins != at_ || statement->value >= line().mask.size()) return {};
    const char first = line().mask[statement->value];
    if (!is_letter(first) && first != other_letter) return {};
    const std::string value(trimmed(line().words(statement->value, statement->end)));
    if (value.starts_with("true") || value.starts_with("false")) return {};
    for (const std::string_view word : {"True", "TRUE", "yes", "Yes", "on", "wahr", "oui", "ja"})
      if (value == word)
        return fault(at_, statement->value, statement->end,
                     fmt::format("'{}' is not how yes is written", value), "write true");
    for (const std::string_view word : {"False", "FALSE", "no", "No", "off", "falsch", "non"})
      if (value == word)
        return fault(at_, statement->value, statement->end,
                     fmt::format("'{}' is not how no is written", value), "write false");
    return fault(at_, statement->value, statement->end, "this text is not in quotation marks",
                 fmt::format("write {} = \"{}\"", key_of(line()), value));
  }

  [[nodiscard]] std::optional<TomlFault> more_than_a_value() const {
    const std::size_t column = std::max<std::uint32_t>(noticed_.column, 1) - 1;
    if (column >= line().mask.size()) return {};
    const bool in_list =
        line().begins != at_ || std::ranges::count(line().mask.substr(0, column), '[') >
                                    std::ranges::count(line().mask.substr(0, column), ']');
    if (in_list) return in_list_at(column);
    const std::string_view rest = trimmed(std::string_view(line().mask).substr(column));
    if (rest.starts_with('='))
      return fault(
          at_, column, column + 1, "two equals signs stand in this line",
          fmt::format("write {} = {}", key_of(line()),
                      short_enough(trimmed(line().words(column + 1, line().mask.size())))));
    if (rest == "," || rest == ";" || rest == ".")
      return fault(at_, column, column + 1,
                   fmt::format("'{}' is one thing too many in this line", rest),
                   fmt::format("remove the {} at the end", rest == ","   ? "comma"
                                                           : rest == ";" ? "semicolon"
                                                                         : "full stop"));
    return fault(at_, column, line().mask.find_last_not_of(" \t") + 1,
                 fmt::format("'{}' is one thing too many in this line",
                             trimmed(line().words(column, line().mask.size()))),
                 "write each key = value in a line of its own; a remark begins with #");
  }

  /// What is wrong inside a list, from its beginning to the place that was noticed.
  [[nodiscard]] TomlFault in_list_at(std::size_t column) const {
    const std::string_view mask = line().mask;
    const char c = mask[column];
    const std::string_view commas = "things of a list have a comma between them: [1.5, 2.0]";
    if (c == ':')
      return fault(at_, column, column + 1, "a colon stands where an equals sign belongs",
                   "write {floor = \"...\", position = [1.5, 2.0]}");
    if (c == '(' || c == ')')
      return fault(at_, column, column + 1, fmt::format("'{}' does not belong in a list here", c),
                   "points are written in square brackets: [[1.5, 2.0], [3.5, 2.0]]");
    if (c == ';') {
      const std::size_t open = mask.rfind('[', column), close = mask.find(']', column);
      if (open != std::string_view::npos && close != std::string_view::npos)
        if (const auto numbers = numbers_meant(line().words(open + 1, close)); numbers.size() > 1)
          return fault(at_, column, column + 1, "a semicolon stands where a comma belongs",
                       fmt::format("write [{}]", fmt::join(numbers, ", ")));
      return fault(at_, column, column + 1, "a semicolon stands where a comma belongs",
                   std::string(commas));
    }
    if (is_letter(c) || c == other_letter) {
      std::size_t end = column;
      while (end < mask.size() &&
             (is_letter(mask[end]) || mask[end] == other_letter || mask[end] == '-'))
        ++end;
      const std::string word = line().words(column, end);
      return fault(at_, column, end, fmt::format("'{}' is not in quotation marks", word),
                   fmt::format("write \"{}\"", word));
    }
    const std::size_t before =
        column == 0 ? std::string_view::npos : mask.find_last_not_of(" \t", column - 1);
    const bool ends_before =
        before == std::string_view::npos
            ? line().begins != at_
            : is_digit(mask[before]) ||
                  std::string_view("\"']}").find(mask[before]) != std::string_view::npos;
    if (ends_before &&
        (is_digit(c) || std::string_view("\"'[{-").find(c) != std::string_view::npos))
      return fault(at_, column, column + 1, "a comma is missing in front of this",
                   std::string(commas));
    return fault(at_, column, column + 1,
                 fmt::format("'{}' does not belong in a list here", line().character[column]),
                 std::string(commas));
  }

  Scanner scan_;
  SourceRange noticed_;
  bool redefines_;
  std::size_t at_ = 0;
};

}  // namespace

TomlFault explain_toml_fault(std::string_view text, SourceRange noticed, bool redefines) {
  return Explainer(text, noticed, redefines).explain();
}

}  // namespace docent::config

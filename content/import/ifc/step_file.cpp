#include "content/import/ifc/step_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "content/content_error.h"
#include "platform/file/text_encoding.h"

namespace docent::import {
namespace {

constexpr int deepest = 64;
const StepValue absent_value{};
const StepRecord no_record{};

class StepReader {
 public:
  StepReader(const std::string& file, std::string_view bytes) : file_(file), rest_(bytes) {}

  StepFile read() {
    if (!take("ISO-10303-21")) fail("does not begin with ISO-10303-21");
    read_header();
    while (!rest_.empty()) {
      skip_blanks();
      if (take("END-ISO-10303-21")) break;
      if (rest_.empty()) break;
      if (take("ENDSEC")) {
        ended_ = true;
        expect(';');
      } else if (rest_.front() == '#') {
        read_record();
      } else {
        skip_statement();
      }
    }
    if (!ended_) fail("ends before its data does (ENDSEC)");
    for (auto& [type, numbers] : out_.by_type) std::ranges::sort(numbers);
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const {
    throw content::ContentError(file_, line_, 0, "unreadable-ifc", "this IFC file " + sentence,
                                "save the model again as IFC (STEP), IFC2x3 or IFC4");
  }

  void advance(std::size_t count) {
    line_ += static_cast<std::uint32_t>(std::ranges::count(rest_.substr(0, count), '\n'));
    rest_.remove_prefix(std::min(count, rest_.size()));
  }

  void skip_blanks() {
    while (!rest_.empty()) {
      if (std::isspace(static_cast<unsigned char>(rest_.front()))) {
        advance(1);
      } else if (rest_.starts_with("/*")) {
        const std::size_t end = rest_.find("*/");
        if (end == std::string_view::npos) fail("has a comment that does not end");
        advance(end + 2);
      } else {
        return;
      }
    }
  }

  bool take(std::string_view word) {
    skip_blanks();
    if (!rest_.starts_with(word)) return false;
    advance(word.size());
    return true;
  }

  void expect(char c) {
    skip_blanks();
    if (rest_.empty()) fail(fmt::format("ends where '{}' belongs", c));
    if (rest_.front() != c) fail(fmt::format("lacks '{}' here", c));
    advance(1);
  }

  /// To behind the next semicolon that is in no string.
  std::string_view skip_statement() {
    const std::string_view begin = rest_;
    std::size_t at = 0;
    bool quoted = false;
    for (; at < rest_.size() && (quoted || rest_[at] != ';'); ++at)
      if (rest_[at] == '\'') quoted = !quoted;
    if (at == rest_.size()) fail("ends within a statement");
    advance(at + 1);
    return begin.substr(0, at);
  }

  void read_header() {
    for (;;) {
      skip_blanks();
      if (rest_.empty()) fail("has no DATA section");
      const std::string_view statement = skip_statement();
      if (statement.starts_with("FILE_SCHEMA")) {
        const std::size_t open = statement.find('\''), close = statement.rfind('\'');
        if (open != std::string_view::npos && close > open)
          out_.schema = std::string(statement.substr(open + 1, close - open - 1));
      }
      if (statement.starts_with("DATA")) return;
    }
  }

  std::uint64_t number_of_record() {
    advance(1);  // The '#'.
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (error != std::errc{}) fail("has '#' without a number");
    advance(static_cast<std::size_t>(end - rest_.data()));
    return number;
  }

  std::string word() {
    std::size_t length = 0;
    while (length < rest_.size() && (std::isalnum(static_cast<unsigned char>(rest_[length])) ||
                                     rest_[length] == '_' || rest_[length] == '-'))
      ++length;
    std::string out(rest_.substr(0, length));
    for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    advance(length);
    return out;
  }

  void read_record() {
    StepRecord record;
    record.line = line_;
    const std::uint64_t number = number_of_record();
    expect('=');
    skip_blanks();
    if (rest_.starts_with('(')) {  // A record of several types: none that we look at.
      skip_statement();
      return;
    }
    record.type = word();
    if (record.type.empty()) fail("has a record without a type");
    record.arguments = read_list(0);
    expect(';');
    out_.by_type[record.type].push_back(number);
    out_.records.insert_or_assign(number, std::move(record));
  }

  std::vector<StepValue> read_list(int depth) {
    if (depth > deepest) fail(fmt::format("nests lists deeper than {}", deepest));
    expect('(');
    std::vector<StepValue> items;
    skip_blanks();
    if (rest_.starts_with(')')) {
      advance(1);
      return items;
    }
    for (;;) {
      items.push_back(read_value(depth));
      skip_blanks();
      if (rest_.starts_with(',')) {
        advance(1);
        continue;
      }
      expect(')');
      return items;
    }
  }

  StepValue read_value(int depth) {
    skip_blanks();
    if (rest_.empty()) fail("ends within a record");
    StepValue value;
    const char c = rest_.front();
    if (c == '$' || c == '*') {
      advance(1);
    } else if (c == '#') {
      value.kind = StepValue::Kind::Reference;
      value.reference = number_of_record();
    } else if (c == '\'') {
      value.kind = StepValue::Kind::Text;
      value.text = read_text();
    } else if (c == '(') {
      value.kind = StepValue::Kind::List;
      value.items = read_list(depth + 1);
    } else if (c == '.') {
      advance(1);
      value.kind = StepValue::Kind::Word;
      value.text = word();
      expect('.');
    } else if (c == '"') {
      const std::size_t end = rest_.find('"', 1);
      if (end == std::string_view::npos) fail("has bits that do not end");
      advance(end + 1);
    } else if (std::isalpha(static_cast<unsigned char>(c))) {
      const std::string type = word();
      std::vector<StepValue> held = read_list(depth + 1);
      if (held.empty()) return value;
      if (held.front().kind == StepValue::Kind::List) held.front().text = type;
      return std::move(held.front());
    } else {
      read_number(value);
    }
    return value;
  }

  void read_number(StepValue& value) {
    if (rest_.starts_with('+')) advance(1);
    const auto [end, error] =
        std::from_chars(rest_.data(), rest_.data() + rest_.size(), value.number);
    if (error == std::errc::invalid_argument)
      fail(fmt::format("has '{}' where a value belongs", file::shown_as_utf8(rest_.substr(0, 1))));
    if (!std::isfinite(value.number)) value.number = 0;
    value.kind = StepValue::Kind::Number;
    advance(static_cast<std::size_t>(end - rest_.data()));
  }

  std::string read_text() {
    std::size_t at = 1;
    while (at < rest_.size() && (rest_[at] != '\'' || rest_.substr(at).starts_with("''")))
      at += rest_[at] == '\'' ? 2 : 1;
    if (at >= rest_.size()) fail("has a text that does not end");
    std::string text = decoded_step_text(rest_.substr(1, at - 1));
    advance(at + 1);
    return text;
  }

  std::string file_;
  std::string_view rest_;
  std::uint32_t line_ = 1;
  bool ended_ = false;
  StepFile out_;
};

void append_letter(std::string& out, std::uint32_t code) {
  if (code < 0x20 || (code >= 0xd800 && code < 0xe000) || code > 0x10ffff) return;
  if (code < 0x80) {
    out += static_cast<char>(code);
    return;
  }
  if (code < 0x800) {
    out += static_cast<char>(0xc0 | (code >> 6));
  } else if (code < 0x10000) {
    out += static_cast<char>(0xe0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
  } else {
    out += static_cast<char>(0xf0 | (code >> 18));
    out += static_cast<char>(0x80 | ((code >> 12) & 0x3f));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
  }
  out += static_cast<char>(0x80 | (code & 0x3f));
}

std::uint32_t hexadecimal(std::string_view digits) {
  std::uint32_t code = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
  return code;
}

}  // namespace

const StepValue& StepRecord::operator[](std::size_t index) const noexcept {
  return index < arguments.size() ? arguments[index] : absent_value;
}
const StepRecord& StepFile::at(const StepValue& value) const noexcept {
  return value.kind == StepValue::Kind::Reference ? at(value.reference) : no_record;
}
const StepRecord& StepFile::at(std::uint64_t number) const noexcept {
  const auto found = records.find(number);
  return found == records.end() ? no_record : found->second;
}
const std::vector<std::uint64_t>& StepFile::all(const std::string& type) const noexcept {
  static const std::vector<std::uint64_t> none;
  const auto found = by_type.find(type);
  return found == by_type.end() ? none : found->second;
}

StepFile parse_step(const std::string& file, std::string_view bytes) {
  return StepReader(file, file::without_byte_order_mark(bytes)).read();
}

std::string decoded_step_text(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    if (text.starts_with("''")) {
      out += '\'';
      text.remove_prefix(2);
    } else if (text.starts_with("\\\\")) {
      out += '\\';
      text.remove_prefix(2);
    } else if (text.starts_with("\\X2\\") || text.starts_with("\\X4\\")) {
      const std::size_t width = text[2] == '2' ? 4 : 8;
      text.remove_prefix(4);
      while (text.size() >= width && !text.starts_with("\\X0\\")) {
        append_letter(out, hexadecimal(text.substr(0, width)));
        text.remove_prefix(width);
      }
      if (text.starts_with("\\X0\\")) text.remove_prefix(4);
    } else if (text.starts_with("\\X\\") && text.size() >= 5) {
      append_letter(out, hexadecimal(text.substr(3, 2)));
      text.remove_prefix(5);
    } else if (text.starts_with("\\S\\") && text.size() >= 4) {
      append_letter(out, static_cast<unsigned char>(text[3]) + 0x80U);
      text.remove_prefix(4);
    } else if (text.starts_with("\\P") && text.size() >= 4 && text[3] == '\\') {
      text.remove_prefix(4);
    } else {
      out += text.front();
      text.remove_prefix(1);
    }
  }
  // Some writers put Windows-1252 bytes there.
  if (!file::encoding_fault(out)) return out;
  std::string letters;
  for (const char c : out) append_letter(letters, static_cast<unsigned char>(c));
  return letters;
}

}  // namespace docent::import

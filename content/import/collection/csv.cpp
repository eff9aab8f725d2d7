#include "content/import/collection/csv.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "content/import/collection/decode_text.h"

namespace docent::import {

namespace {

std::string trimmed(std::string_view cell) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = cell.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(cell.substr(first, cell.find_last_not_of(blanks) - first + 1));
}

/// The separator that the header holds most of, outside of quotation marks.
char likely_separator(std::string_view text) {
  constexpr std::array<char, 4> separators{',', ';', '\t', '|'};
  std::array<std::size_t, 4> count{};
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '\n' || c == '\r')) break;
    for (std::size_t i = 0; i < separators.size(); ++i)
      if (!quoted && c == separators[i]) ++count[i];
  }
  return separators[static_cast<std::size_t>(std::ranges::max_element(count) - count.begin())];
}

/// Takes rows off a text.
class CsvScanner {
 public:
  CsvScanner(std::string_view text, char separator, std::vector<CsvDoubt>& doubts)
      : text_(text), separator_(separator), doubts_(doubts) {}

  [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }

  CsvRecord take_record() {
    CsvRecord record{.line = line_, .cell = {}};
    do record.cell.push_back(take_cell());
    while (take_separator());
    take_line_end();
    return record;
  }

 private:
  [[nodiscard]] char here() const { return at_ < text_.size() ? text_[at_] : '\n'; }
  [[nodiscard]] bool at_line_end() const { return here() == '\n' || here() == '\r'; }

  bool take_separator() {
    if (at_end() || here() != separator_) return false;
    ++at_;
    return true;
  }

  void take_line_end() {
    if (!at_end() && here() == '\r')
      ++at_;
    else if (!at_end() && here() == '\n') {
      ++at_;
      ++line_;
      return;
    } else
      return;
    if (!at_end() && here() == '\n') ++at_;
    ++line_;
  }

  std::string take_cell() {
    while (here() == ' ' && !at_end()) ++at_;
    if (!at_end() && here() == '"') return take_quoted();
    return take_bare();
  }

  std::string take_bare() {
    const std::size_t first = at_;
    while (!at_end() && !at_line_end() && here() != separator_) ++at_;
    return trimmed(text_.substr(first, at_ - first));
  }

  std::string take_quoted() {
    const std::size_t opening = at_;
    const std::uint32_t opening_line = line_;
    std::string cell;
    for (++at_; !at_end(); ++at_) {
      const char c = here();
      const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : '\n';
      if (c == '"' && next == '"') {
        cell += '"';
        ++at_;
      } else if (c == '"') {
        ++at_;
        return trimmed(cell + take_bare());  // what stands behind the closing mark is kept
      } else if (c == '\r') {
        if (next != '\n') cell += '\n', ++line_;
      } else {
        cell += c;
        if (c == '\n') ++line_;
      }
    }
    doubts_.push_back({opening_line, "a quotation mark opens a text here that is never closed",
                       "the file was cut short, or a mark is missing; the rest of the line is "
                       "taken as it is"});
    at_ = opening + 1;
    line_ = opening_line;
    return take_bare();
  }

  std::string_view text_;
  char separator_;
  std::vector<CsvDoubt>& doubts_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
};

bool is_blank(const CsvRecord& record) {
  return std::ranges::all_of(record.cell, [](const std::string& cell) { return cell.empty(); });
}

void fit_to_columns(CsvTable& table, CsvRecord& record) {
  if (record.cell.size() > table.column.size())
    table.doubts.push_back({record.line,
                            fmt::format("this row has {} cells, and the header {}",
                                        record.cell.size(), table.column.size()),
                            "a text that holds the separator stands in quotation marks"});
  record.cell.resize(table.column.size());
}

}  // namespace

CsvTable read_csv(std::string_view bytes, const CsvForm& form) {
  CsvTable table;
  const DecodedText decoded = decode_text(bytes, form.encoding);
  table.encoding = decoded.encoding;
  table.separator = form.separator != '\0' ? form.separator : likely_separator(decoded.text);
  CsvScanner scanner(decoded.text, table.separator, table.doubts);
  if (scanner.at_end()) {
    table.doubts.push_back({0, "the file is empty", "save it again"});
    return table;
  }
  table.column = scanner.take_record().cell;
  while (!scanner.at_end()) {
    CsvRecord record = scanner.take_record();
    if (is_blank(record)) continue;
    fit_to_columns(table, record);
    table.record.push_back(std::move(record));
  }
  return table;
}

std::string csv_cell(std::string_view text, char separator) {
  if (text.find_first_of("\"\r\n") == std::string_view::npos &&
      text.find(separator) == std::string_view::npos && trimmed(text) == text)
    return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + '"';
}

}  // namespace docent::import

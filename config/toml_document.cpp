#include "config/toml_document.h"

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace docent {

namespace {

SourceRange range_of(const toml::source_region& region) {
  const auto& [begin, end] = std::pair(region.begin, region.end);
  const bool on_one_line = begin.line == end.line && end.column > begin.column;
  return {.line = std::max<std::uint32_t>(begin.line, 1),
          .column = std::max<std::uint32_t>(begin.column, 1),
          .length = on_one_line ? end.column - begin.column : 1};
}

TomlNode convert(const toml::node& node);

void convert_entries(const toml::table& table, TomlNode& out) {
  for (const auto& [key, value] : table)
    out.entries.push_back({.key = std::string(key.str()),
                           .key_range = range_of(key.source()),
                           .value = convert(value)});
  std::ranges::sort(out.entries, {}, [](const TomlEntry& entry) {
    return std::pair(entry.key_range.line, entry.key_range.column);
  });
}

TomlNode convert(const toml::node& node) {
  TomlNode out;
  out.range = range_of(node.source());
  if (const auto* table = node.as_table()) {
    convert_entries(*table, out);
  } else if (const auto* array = node.as_array()) {
    out.kind = TomlNode::Kind::Array;
    for (const toml::node& item : *array) out.items.push_back(convert(item));
  } else if (const auto* text = node.as_string()) {
    out.kind = TomlNode::Kind::Text;
    out.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    out.kind = TomlNode::Kind::Integer;
    out.integer = integer->get();
    out.number = static_cast<double>(out.integer);
  } else if (const auto* number = node.as_floating_point()) {
    out.kind = TomlNode::Kind::Number;
    out.number = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    out.kind = TomlNode::Kind::Boolean;
    out.boolean = boolean->get();
  } else {
    out.kind = TomlNode::Kind::Date;
  }
  return out;
}

/// toml++ begins its sentences with what it was doing: "Error while parsing key: expected ...".
std::string sentence_of(std::string_view description) {
  constexpr std::string_view prefix = "Error while ";
  if (description.starts_with(prefix)) description.remove_prefix(prefix.size());
  return "cannot be read as TOML: while " + std::string(description);
}

}  // namespace

std::string_view name_of(TomlNode::Kind kind) noexcept {
  switch (kind) {
    case TomlNode::Kind::Table:
      return "a table";
    case TomlNode::Kind::Array:
      return "a list";
    case TomlNode::Kind::Text:
      return "a text";
    case TomlNode::Kind::Integer:
      return "a whole number";
    case TomlNode::Kind::Number:
      return "a number";
    case TomlNode::Kind::Boolean:
      return "true or false";
    case TomlNode::Kind::Date:
      break;
  }
  return "a date or time";
}

TomlFile parse_toml(std::string_view text, const std::string& name) {
  const toml::parse_result result = toml::parse(text, name);
  if (result) return {.root = convert(result.table())};
  const toml::parse_error& error = result.error();
  const SourceRange range = range_of(error.source());
  return {.root = std::nullopt,
          .diagnostics = {{.file = name,
                           .line = range.line,
                           .column = range.column,
                           .length = range.length,
                           .code = "unreadable-toml",
                           .message = sentence_of(error.description()),
                           .hint = "nothing of this file was used; mend this line first"}}};
}

TomlFile read_toml(const std::filesystem::path& file, const std::string& name) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in && !in.eof())
    return {.root = std::nullopt,
            .diagnostics = {{.file = name,
                             .code = "missing-file",
                             .message = "cannot be opened",
                             .hint = "check that it exists and may be read"}}};
  return parse_toml(text, name);
}

}  // namespace docent

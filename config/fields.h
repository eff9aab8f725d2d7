#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "config/located.h"
#include "config/toml_document.h"
#include "runtime/model/geometry/vec2.h"

/// Tables of fields: what a section of a file may hold, said once, for the loader that checks it
/// and the schema that describes it. Internal to config.
namespace docent::config {

enum class Presence : std::uint8_t {
  Optional,
  Required,
  UnlessSource,  ///< Required of an exhibit that no [source] and no case completes.
};

/// What a text has to look like.
enum class Form : std::uint8_t {
  Free,
  Name,        ///< Not empty.
  Identifier,  ///< Letters, digits, hyphens, dots and underscores.
  File,        ///< A path relative to the museum's folder.
  OneOf,       ///< One of the field's choices.
  Keys,        ///< Texts by key rather than by language.
  Colour,      ///< "#RRGGBB".
};

/// The range that a number has to lie in, ends included. Where `most` is infinite, the
/// content compiler knows the limit.
struct FieldLimits {
  double least = -1e5, most = 1e5;
};

struct StopSection;
struct PictureSection;
struct ExhibitSoundSection;

/// A field of the section T. The type of `member`, where its value goes, is the field's type.
template <typename T>
struct Field {
  std::string_view key;
  std::variant<Located<std::string> T::*, Located<double> T::*, Located<std::int64_t> T::*,
               Located<bool> T::*, Located<Vec2> T::*, Located<std::vector<Vec2>> T::*,
               Located<LocatedPoints> T::*, Located<Outline> T::*, Located<Range> T::*,
               Located<Size> T::*, Located<LocatedList> T::*, Located<LocatedNumbers> T::*,
               Located<std::vector<StopSection>> T::*, Located<std::vector<PictureSection>> T::*,
               Located<std::vector<ExhibitSoundSection>> T::*, Located<LocatedTexts> T::*>
      member;
  Presence presence = Presence::Optional;
  std::string_view manual;  ///< For staff and their editors.
  FieldLimits limits{};
  Form form = Form::Free;
  std::span<const std::string_view> choices{};  ///< Of Form::OneOf.
};

/// Reads TOML tables into sections by their tables of fields, noting everything that is wrong.
class SectionReader {
 public:
  SectionReader(FileIndex file, std::string file_name, std::vector<Diagnostic>& diagnostics)
      : file_(file), file_name_(std::move(file_name)), diagnostics_(diagnostics) {}

  /// Fills `section` from a table; `name` is what sentences call it.
  template <typename T>
  void read(const TomlNode& table, std::string_view name, std::span<const Field<T>> fields,
            T& section);

  /// Says that the table holds a key that it should not, and which known one it may be.
  void unknown_key(const TomlEntry& entry, std::string_view section,
                   const std::vector<std::string_view>& known);
  /// `example` is what a value looks like: "[6.3, 14.5]".
  void missing(const Place& place, std::string_view section, std::string_view key,
               std::string_view manual, std::string_view example);
  bool wrong_type(const TomlNode& node, std::string_view key, std::string_view expected);

  [[nodiscard]] Place place(SourceRange range) const { return {file_, range}; }

 private:
  /// A field's key and what its value must keep to, whatever its type.
  struct Rules {
    std::string_view key;
    FieldLimits limits;
    Form form;
    std::span<const std::string_view> choices{};
  };
  /// These fill the value, or report why they cannot and return false.
  bool read_value(const TomlNode& node, const Rules& rules, std::string& value);
  bool read_value(const TomlNode& node, const Rules& rules, double& value);
  bool read_value(const TomlNode& node, const Rules& rules, std::int64_t& value);
  bool read_value(const TomlNode& node, const Rules& rules, bool& value);
  bool read_value(const TomlNode& node, const Rules& rules, Vec2& value);
  bool read_value(const TomlNode& node, const Rules& rules, std::vector<Vec2>& value);
  bool read_value(const TomlNode& node, const Rules& rules, LocatedPoints& value);
  bool read_value(const TomlNode& node, const Rules& rules, Outline& value);
  bool read_value(const TomlNode& node, const Rules& rules, Range& value);
  bool read_value(const TomlNode& node, const Rules& rules, Size& value);
  bool read_value(const TomlNode& node, const Rules& rules, LocatedList& value);
  bool read_value(const TomlNode& node, const Rules& rules, LocatedNumbers& value);
  bool read_value(const TomlNode& node, const Rules& rules, std::vector<StopSection>& value);
  bool read_value(const TomlNode& node, const Rules& rules, std::vector<PictureSection>& value);
  bool read_value(const TomlNode& node, const Rules& rules,
                  std::vector<ExhibitSoundSection>& value);
  bool read_value(const TomlNode& node, const Rules& rules, LocatedTexts& value);
  bool in_range(const TomlNode& node, const Rules& rules);
  void report(SourceRange range, std::string code, std::string message, std::string label = {},
              std::string hint = {});

  FileIndex file_;
  std::string file_name_;
  std::vector<Diagnostic>& diagnostics_;
};

/// What to write for a field: "position = [6.3, 14.5]" without its key.
template <typename T>
std::string example_of(const Field<T>& field);

template <typename T>
void SectionReader::read(const TomlNode& table, std::string_view name,
                         std::span<const Field<T>> fields, T& section) {
  if (table.kind != TomlNode::Kind::Table) {
    wrong_type(table, name, "a table");
    return;
  }
  std::vector<std::string_view> known;
  for (const Field<T>& field : fields) {
    known.push_back(field.key);
    std::visit([&](auto member) { (section.*member).place = place(table.range); }, field.member);
  }
  for (const TomlEntry& entry : table.entries) {
    const auto field =
        std::ranges::find(fields, std::string_view(entry.key), [](const auto& f) { return f.key; });
    if (field == fields.end()) {
      unknown_key(entry, name, known);
      continue;
    }
    std::visit(
        [&](auto member) {
          auto& located = section.*member;
          located.place = place(entry.value.range);
          located.key = entry.key_range;
          located.given = read_value(
              entry.value, {field->key, field->limits, field->form, field->choices}, located.value);
        },
        field->member);
  }
  for (const Field<T>& field : fields) {
    const bool written =
        std::ranges::find(table.entries, field.key, &TomlEntry::key) != table.entries.end();
    if (!written && field.presence == Presence::Required)
      missing(place(table.range), name, field.key, field.manual, example_of(field));
  }
}

template <typename T>
std::string example_of(const Field<T>& field) {
  const auto example = [&]<typename Value>(Located<Value> T::* /*member*/) -> std::string {
    if constexpr (std::is_same_v<Value, std::string>)
      return field.choices.empty() ? "= \"...\""
                                   : "= \"" + std::string(field.choices.front()) + "\"";
    else if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::int64_t>)
      return "= " + std::to_string(static_cast<long>(std::max(field.limits.least, 0.0)));
    else if constexpr (std::is_same_v<Value, bool>)
      return "= true";
    else if constexpr (std::is_same_v<Value, Vec2> || std::is_same_v<Value, LocatedPoints>)
      return "= [12.5, 4.0]";
    else if constexpr (std::is_same_v<Value, std::vector<Vec2>>)
      return "= [[0, 0], [10, 0], [10, 8]]";
    else if constexpr (std::is_same_v<Value, Outline>)
      return "= [[0.10, 0], [0.18, 0.2], [0.08, 0.4]]";
    else if constexpr (std::is_same_v<Value, Range>)
      return "= [6, 20]";
    else if constexpr (std::is_same_v<Value, Size>)
      return "= [1.2, 0.6]";
    else if constexpr (std::is_same_v<Value, LocatedList>)
      return "= [\"...\", \"...\"]";
    else if constexpr (std::is_same_v<Value, LocatedNumbers>)
      return "= [15, 30]";
    else if constexpr (std::is_same_v<Value, std::vector<StopSection>>)
      return "= [{floor = \"...\", position = [12.5, 4.0]}, {floor = \"...\", position = [12.5, "
             "4.0]}]";
    else if constexpr (std::is_same_v<Value, std::vector<PictureSection>>)
      return "= [{image = \"images/...\"}]";
    else if constexpr (std::is_same_v<Value, std::vector<ExhibitSoundSection>>)
      return "= [{recording = \"sounds/...\"}]";
    else
      return field.form == Form::Keys ? ".begin = \"...\"" : ".en = \"...\"";
  };
  return std::visit(example, field.member);
}

}  // namespace docent::config

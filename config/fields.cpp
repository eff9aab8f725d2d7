#include "config/fields.h"

#include <fmt/format.h>

#include <cmath>

#include "config/colour.h"
#include "config/field_hints.h"
#include "config/museum_fields.h"
#include "platform/terminal/suggest.h"

namespace docent::config {

namespace {

bool has_form(Form form, std::span<const std::string_view> choices, std::string_view text) {
  switch (form) {
    case Form::Free:
    case Form::Keys:
      return true;
    case Form::Name:
    case Form::File:
      return !text.empty();
    case Form::Identifier:
      return is_identifier(text);
    case Form::Colour:
      return parse_colour(text).has_value();
    case Form::OneOf:
      return std::ranges::find(choices, text) != choices.end();
  }
  return false;
}

}  // namespace

void SectionReader::report(SourceRange range, std::string code, std::string message,
                           std::string label, std::string hint) {
  diagnostics_.push_back({.file = file_name_,
                          .line = range.line,
                          .column = range.column,
                          .length = range.length,
                          .severity = Severity::Error,
                          .code = std::move(code),
                          .message = std::move(message),
                          .label = std::move(label),
                          .hint = std::move(hint)});
}

void SectionReader::unknown_key(const TomlEntry& entry, std::string_view section,
                                const std::vector<std::string_view>& known) {
  report(entry.key_range, "unknown-key", fmt::format("{} has no '{}'", section, entry.key),
         "not known here",
         section == "museum.toml" && terminal::edit_distance(entry.key, "exhibit") < 2
             ? "exhibits are written in files of their own: exhibits/NAME.toml"
             : key_hint(entry.key, section, known));
}

void SectionReader::missing(const Place& place, std::string_view section, std::string_view key,
                            std::string_view manual, std::string_view example) {
  report(
      place.range, "missing-field", fmt::format("{} lacks '{}'", section, key), {},
      fmt::format("write {}{}{}: {}", key, example.starts_with('.') ? "" : " ", example, manual));
}

bool SectionReader::wrong_type(const TomlNode& node, std::string_view key,
                               std::string_view expected) {
  report(node.range, "wrong-type", fmt::format("'{}' should be {}", key, expected),
         fmt::format("this is {}", name_of(node.kind)), type_hint(node, key, expected));
  return false;
}

bool SectionReader::in_range(const TomlNode& node, const Rules& rules) {
  // Written so that a value that is not a number fails too.
  if (node.number >= rules.limits.least && node.number <= rules.limits.most) return true;
  const auto& [least, most] = rules.limits;
  report(node.range, "out-of-range",
         std::isinf(most) ? fmt::format("'{}' should be at least {}", rules.key, least)
                          : fmt::format("'{}' should be from {} to {}", rules.key, least, most),
         fmt::format("this is {}", node.number),
         node.number > rules.limits.most
             ? fmt::format("write {} or less; is it in the right unit, and the point in its place?",
                           rules.limits.most)
             : fmt::format("write {} or more", rules.limits.least));
  return false;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, std::string& value) {
  if (node.kind != TomlNode::Kind::Text)
    return wrong_type(node, rules.key, "a text in quotation marks");
  if (!has_form(rules.form, rules.choices, node.text)) {
    report(node.range, "bad-value", fmt::format("'{}' cannot be \"{}\"", rules.key, node.text),
           form_label(rules.form, node.text),
           form_hint(rules.key, rules.form, rules.choices, node.text));
    return false;
  }
  value = node.text;
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, double& value) {
  if (!is_number(node)) return wrong_type(node, rules.key, "a number");
  if (!in_range(node, rules)) return false;
  value = node.number;
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, std::int64_t& value) {
  if (node.kind != TomlNode::Kind::Integer) return wrong_type(node, rules.key, "a whole number");
  if (!in_range(node, rules)) return false;
  value = node.integer;
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, bool& value) {
  if (node.kind != TomlNode::Kind::Boolean) return wrong_type(node, rules.key, "true or false");
  value = node.boolean;
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, Vec2& value) {
  if (!is_pair_of_numbers(node))
    return wrong_type(node, rules.key, "a point: [east, north] in metres");
  if (!in_range(node.items[0], rules) || !in_range(node.items[1], rules)) return false;
  value = {node.items[0].number, node.items[1].number};
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, std::vector<Vec2>& value) {
  if (node.kind != TomlNode::Kind::Array || !std::ranges::all_of(node.items, is_pair_of_numbers))
    return wrong_type(node, rules.key, "a list of points: [[east, north], ...] in metres");
  return std::ranges::all_of(node.items, [&](const TomlNode& point) {
    return read_value(point, rules, value.emplace_back());
  });
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, LocatedPoints& value) {
  const auto add = [&](const TomlNode& point) {
    Located<Vec2>& added = value.emplace_back();
    added.place = place(point.range);
    return added.given = read_value(point, rules, added.value);
  };
  if (is_pair_of_numbers(node)) return add(node);
  if (node.kind != TomlNode::Kind::Array || node.items.empty() ||
      !std::ranges::all_of(node.items, is_pair_of_numbers))
    return wrong_type(node, rules.key,
                      "a point or several: [east, north] or [[east, north], ...] in metres");
  return std::ranges::all_of(node.items, add);
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, Outline& value) {
  if (node.kind != TomlNode::Kind::Array || !std::ranges::all_of(node.items, is_pair_of_numbers))
    return wrong_type(node, rules.key,
                      "a list of points from the foot up: [[radius, height], ...] in metres");
  bool is_right = true;
  for (const TomlNode& point : node.items) {
    is_right &= in_range(point.items[0], rules) && in_range(point.items[1], rules);
    value.points.push_back(
        {{point.items[0].number, point.items[1].number}, place(point.range), true});
  }
  return is_right;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, Range& value) {
  if (!is_pair_of_numbers(node)) return wrong_type(node, rules.key, "two numbers: [least, most]");
  if (!in_range(node.items[0], rules) || !in_range(node.items[1], rules)) return false;
  const Range read{.least = node.items[0].number, .most = node.items[1].number};
  if (read.least > read.most) {
    report(node.range, "bad-value", fmt::format("the least of '{}' is above its most", rules.key),
           {}, fmt::format("write {} = [{}, {}]", rules.key, read.most, read.least));
    return false;
  }
  value = read;
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, Size& value) {
  if (is_number(node)) {
    if (!in_range(node, rules)) return false;
    value = {.across = node.number, .deep = node.number};
    return true;
  }
  if (!is_pair_of_numbers(node))
    return wrong_type(node, rules.key, "a number of metres, or two: [across its front, deep]");
  if (!in_range(node.items[0], rules) || !in_range(node.items[1], rules)) return false;
  value = {.across = node.items[0].number, .deep = node.items[1].number};
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, LocatedList& value) {
  const auto is_text = [](const TomlNode& item) { return item.kind == TomlNode::Kind::Text; };
  if (node.kind != TomlNode::Kind::Array || !std::ranges::all_of(node.items, is_text))
    return wrong_type(node, rules.key, "a list of texts: [\"...\", \"...\"]");
  for (const TomlNode& item : node.items) value.push_back({item.text, place(item.range), true});
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, LocatedNumbers& value) {
  if (node.kind != TomlNode::Kind::Array || !std::ranges::all_of(node.items, is_number))
    return wrong_type(node, rules.key, "a list of numbers: [15, 30]");
  return std::ranges::all_of(node.items, [&](const TomlNode& item) {
    value.push_back({item.number, place(item.range), true});
    return in_range(item, rules);
  });
}

namespace {

bool is_list_of_tables(const TomlNode& node) {
  return node.kind == TomlNode::Kind::Array &&
         std::ranges::all_of(
             node.items, [](const TomlNode& item) { return item.kind == TomlNode::Kind::Table; });
}

}  // namespace

bool SectionReader::read_value(const TomlNode& node, const Rules& rules,
                               std::vector<PictureSection>& value) {
  if (!is_list_of_tables(node))
    return wrong_type(node, rules.key,
                      "a list of pictures: [{image = \"images/...\", caption.en = \"...\"}, ...]");
  for (const TomlNode& item : node.items) {
    PictureSection& picture = value.emplace_back();
    picture.place = place(item.range);
    read<PictureSection>(item, fmt::format("an item of '{}'", rules.key), picture_fields, picture);
  }
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules,
                               std::vector<ExhibitSoundSection>& value) {
  if (!is_list_of_tables(node))
    return wrong_type(node, rules.key,
                      "a list of sounds: [{recording = \"sounds/...\", title.en = \"...\"}, ...]");
  for (const TomlNode& item : node.items) {
    ExhibitSoundSection& sound = value.emplace_back();
    sound.place = place(item.range);
    read<ExhibitSoundSection>(item, fmt::format("an item of '{}'", rules.key), exhibit_sound_fields,
                              sound);
  }
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules,
                               std::vector<StopSection>& value) {
  if (!is_list_of_tables(node))
    return wrong_type(node, rules.key,
                      "a list of places: [{floor = \"...\", position = [east, north]}, ...]");
  for (const TomlNode& item : node.items) {
    StopSection& stop = value.emplace_back();
    stop.place = place(item.range);
    read<StopSection>(item, fmt::format("an item of '{}'", rules.key), stop_fields, stop);
  }
  return true;
}

bool SectionReader::read_value(const TomlNode& node, const Rules& rules, LocatedTexts& value) {
  if (node.kind != TomlNode::Kind::Table)
    return wrong_type(node, rules.key,
                      rules.form == Form::Keys
                          ? fmt::format("given by key: {}.KEY = \"...\"", rules.key)
                          : fmt::format("given by language: {}.en = \"...\"", rules.key));
  for (const TomlEntry& entry : node.entries) {
    if (entry.value.kind == TomlNode::Kind::Table) {
      report(
          entry.key_range, "wrong-type",
          fmt::format("'{}.{}' should be a text in quotation marks", rules.key, entry.key),
          "this is a table",
          fmt::format("write {}.en = \"...\" and no heading for it, which takes all lines below it",
                      rules.key));
      continue;
    }
    Located<std::string>& text = value[entry.key];
    text.place = place(entry.value.range);
    text.key = entry.key_range;
    text.given = read_value(
        entry.value, {fmt::format("{}.{}", rules.key, entry.key), {}, Form::Free}, text.value);
  }
  return true;
}

}  // namespace docent::config

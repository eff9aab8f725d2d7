#include "config/field_hints.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/letters.h"
#include "config/look_alike.h"
#include "config/museum_fields.h"
#include "platform/terminal/suggest.h"

namespace docent::config {

bool is_identifier(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  });
}

bool is_number(const TomlNode& node) {
  return node.kind == TomlNode::Kind::Integer || node.kind == TomlNode::Kind::Number;
}

bool is_pair_of_numbers(const TomlNode& node) {
  return node.kind == TomlNode::Kind::Array && node.items.size() == 2 && is_number(node.items[0]) &&
         is_number(node.items[1]);
}

namespace {

std::string manual_of(Form form, std::span<const std::string_view> choices) {
  switch (form) {
    case Form::Identifier:
      return "use letters, digits and hyphens, without spaces";
    case Form::OneOf:
      return fmt::format("write \"{}\"", fmt::join(choices, "\" or \""));
    case Form::Colour:
      return "write it as the web does: \"#D2452D\"";
    case Form::Free:
    case Form::Keys:
    case Form::Name:
    case Form::File:
      break;
  }
  return "it should not be empty";
}

/// A number as it was written, nearly.
std::string text_of(const TomlNode& number) {
  return number.kind == TomlNode::Kind::Integer ? std::to_string(number.integer)
                                                : fmt::format("{}", number.number);
}

bool is_flat_list(const TomlNode& node) {
  return node.kind == TomlNode::Kind::Array && std::ranges::all_of(node.items, is_number);
}

/// The point that was meant by [6, 3, 14, 5], which is [6.3, 14.5] with decimal commas; by
/// [6, 3, 14.5], and by "6.3, 14.5". Empty where that is not clear.
std::string point_meant(const TomlNode& node) {
  if (node.kind == TomlNode::Kind::Text) {
    const bool is_plain = !node.text.empty() &&
                          node.text.find_first_not_of("0123456789.,- []") == std::string::npos &&
                          std::ranges::count(node.text, ',') == 1;
    const std::size_t first = node.text.find_first_not_of(" ["),
                      last = node.text.find_last_not_of(" ]");
    return is_plain && first < last ? fmt::format("[{}]", node.text.substr(first, last - first + 1))
                                    : "";
  }
  if (!is_flat_list(node)) return {};
  const auto whole = [&](std::size_t i) { return node.items[i].kind == TomlNode::Kind::Integer; };
  const auto text = [&](std::size_t i) { return text_of(node.items[i]); };
  if (node.items.size() == 4 && whole(0) && whole(1) && whole(2) && whole(3))
    return fmt::format("[{}.{}, {}.{}]", text(0), text(1), text(2), text(3));
  if (node.items.size() != 3) return {};
  if (whole(0) && whole(1) && !whole(2))
    return fmt::format("[{}.{}, {}]", text(0), text(1), text(2));
  if (!whole(0) && whole(1) && whole(2))
    return fmt::format("[{}, {}.{}]", text(0), text(1), text(2));
  return {};
}

/// The same of a list of points; of [0, 0, 10, 0, 10, 8] and [[[0, 0], [10, 0], [10, 8]]], too.
std::string points_meant(const TomlNode& node) {
  if (node.kind != TomlNode::Kind::Array || node.items.empty()) return {};
  std::vector<std::string> points;
  if (node.items.size() == 1 && node.items[0].kind == TomlNode::Kind::Array &&
      !node.items[0].items.empty() && std::ranges::all_of(node.items[0].items, is_pair_of_numbers))
    return points_meant(node.items[0]);
  if (is_flat_list(node) && node.items.size() % 2 == 0 && node.items.size() >= 6) {
    for (std::size_t i = 0; i < node.items.size(); i += 2)
      points.push_back(fmt::format("[{}, {}]", text_of(node.items[i]), text_of(node.items[i + 1])));
  } else {
    for (const TomlNode& item : node.items) {
      points.push_back(is_pair_of_numbers(item)
                           ? fmt::format("[{}, {}]", text_of(item.items[0]), text_of(item.items[1]))
                           : point_meant(item));
      if (points.back().empty()) return {};
    }
  }
  constexpr std::size_t most = 6;
  const bool is_long = points.size() > most;
  if (is_long) points.resize(most);
  return fmt::format("[{}{}]", fmt::join(points, ", "), is_long ? ", ..." : "");
}

/// A value as it would be written.
std::string written(const TomlNode& node) {
  switch (node.kind) {
    case TomlNode::Kind::Text:
      return node.text;
    case TomlNode::Kind::Integer:
    case TomlNode::Kind::Number:
      return text_of(node);
    case TomlNode::Kind::Boolean:
      return node.boolean ? "true" : "false";
    case TomlNode::Kind::Array:
      return node.items.size() == 1 && node.items[0].kind == TomlNode::Kind::Text
                 ? node.items[0].text
                 : "";
    case TomlNode::Kind::Table:
    case TomlNode::Kind::Date:
      break;
  }
  return {};
}

/// The words of "en, zh, ar", in quotation marks.
std::string listed(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(",;"), text.size());
    std::string_view word = text.substr(0, end);
    while (word.starts_with(' ')) word.remove_prefix(1);
    while (word.ends_with(' ')) word.remove_suffix(1);
    if (!word.empty()) words.push_back(fmt::format("\"{}\"", word));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return fmt::format("[{}]", fmt::join(words, ", "));
}

/// The number that a text begins with: "12 min", "1.5"; empty where it is none.
std::string number_in(std::string_view text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789.-"), text.size());
  const std::string_view number = text.substr(0, end);
  const bool is_one =
      !number.empty() && is_digit(number.back()) && std::ranges::count(number, '.') <= 1;
  return is_one ? std::string(number) : "";
}

/// A choice that a word was meant as: "Lift", "elevator", "toilet".
std::string_view choice_meant(std::string_view text, std::span<const std::string_view> choices) {
  struct Nickname {
    std::string_view name, choice;
  };
  constexpr std::array<Nickname, 15> nicknames{{{"elevator", "lift"},
                                                {"staircase", "stairs"},
                                                {"steps", "stairs"},
                                                {"wc", "toilets"},
                                                {"restroom", "toilets"},
                                                {"bathroom", "toilets"},
                                                {"café", "cafe"},
                                                {"coffee", "cafe"},
                                                {"cloakrooms", "cloakroom"},
                                                {"wardrobe", "cloakroom"},
                                                {"aed", "defibrillator"},
                                                {"info", "information"},
                                                {"rtl", "right-to-left"},
                                                {"ltr", "left-to-right"},
                                                {"wood", "oak"}}};
  const std::string small = in_small_letters(std::string(text));
  const std::vector<std::string_view> known(choices.begin(), choices.end());
  for (const Nickname& nickname : nicknames)
    if (nickname.name == small && std::ranges::find(known, nickname.choice) != known.end())
      return nickname.choice;
  for (const std::string_view choice : known)
    if (small.size() >= 2 && (choice.starts_with(small) || small.starts_with(choice)))
      return choice;
  return terminal::closest(small, known);
}

/// An identifier made of what was written: "my portrait" becomes "my-portrait".
std::string identifier_meant(std::string_view text) {
  std::string meant;
  while (!text.empty()) {
    const std::string_view character = first_character_of(text);
    const auto alike = look_alike(character);
    if (is_identifier(character))
      meant += character;
    else if (alike && alike->meant.empty())
      ;  // nobody saw it
    else if (!meant.empty() && meant.back() != '-')
      meant += '-';
    text.remove_prefix(character.size());
  }
  while (meant.ends_with('-')) meant.pop_back();
  return meant;
}

/// Where a key of museum.toml belongs that a section does not know: "[avatar]"; empty where it is
/// known nowhere.
struct KeyFinder {
  std::string_view key;
  std::string found{};

  void look(std::string heading, const auto& fields) {
    if (found.empty() && std::ranges::any_of(fields, [&](const auto& f) { return f.key == key; }))
      found = std::move(heading);
  }
  void one(std::string_view name, std::string_view /*manual*/, const auto& fields,
           const auto& /*section*/) {
    look(fmt::format("[{}]", name), fields);
  }
  void many(std::string_view name, std::string_view /*manual*/, const auto& fields,
            const auto& /*sections*/) {
    look(fmt::format("[[{}]]", name), fields);
  }
  void one_or_many(std::string_view name, std::string_view manual, const auto& fields,
                   const auto& sections) {
    one(name, manual, fields, sections);
  }
};

}  // namespace

std::string type_hint(const TomlNode& node, std::string_view key, std::string_view expected) {
  const bool is_text = node.kind == TomlNode::Kind::Text;
  const auto write = [&](std::string_view value) {
    return fmt::format("write {} = {}", key, value);
  };
  if (expected.starts_with("a point") || expected.starts_with("a list of points")) {
    const std::string meant =
        expected.starts_with("a list") ? points_meant(node) : point_meant(node);
    const bool is_nested_wrongly = is_text || (expected.starts_with("a list") &&
                                               (is_flat_list(node) || node.items.size() == 1));
    if (!meant.empty())
      return is_nested_wrongly ? write(meant)
                               : fmt::format("decimals are written with a full stop: {}", meant);
  }
  if (expected.starts_with("a text in")) {
    const std::string value = written(node);
    return write(value.empty() ? "\"...\"" : fmt::format("\"{}\"", value));
  }
  if (expected.starts_with("given by language") && is_text)
    return fmt::format("write {}.en = \"{}\", and the same in each other language", key, node.text);
  if (expected.starts_with("written [["))
    return fmt::format("write [[{}]], with two brackets", key);
  if (expected.starts_with("a list of texts"))
    return write(is_text ? listed(node.text) : "[\"...\", \"...\"]");
  if (expected == "true or false") {
    const std::string small = in_small_letters(node.text);
    const bool is_no = small == "false" || small == "no" || small == "nein" || small == "non" ||
                       (node.kind == TomlNode::Kind::Integer && node.integer == 0);
    return fmt::format("write {} = {}, without quotation marks", key, is_no ? "false" : "true");
  }
  if (is_text) {
    const std::string number = number_in(node.text);
    return number.empty() ? fmt::format("write {} = ... without quotation marks", key)
                          : write(number);
  }
  if (expected == "a whole number" && node.kind == TomlNode::Kind::Number)
    return write(fmt::format("{:.0f}", std::clamp(node.number, -1e15, 1e15)));
  return fmt::format("it is {}", expected);
}

std::string form_hint(std::string_view key, Form form, std::span<const std::string_view> choices,
                      std::string_view text) {
  if (form == Form::OneOf) {
    const std::string_view meant = choice_meant(text, choices);
    const std::string all = manual_of(form, choices);
    return meant.empty() ? all : fmt::format("did you mean \"{}\"? Otherwise {}", meant, all);
  }
  if (form == Form::Identifier)
    if (const std::string meant = identifier_meant(text); !meant.empty())
      return fmt::format("{}: {} = \"{}\"", manual_of(form, choices), key, meant);
  if (form == Form::Colour)
    if (const std::string meant = colour_meant(text); !meant.empty())
      return fmt::format("write {} = \"{}\"", key, meant);
  if (form == Form::File || form == Form::Name)
    return fmt::format("write {} = \"...\", or remove the line", key);
  return manual_of(form, choices);
}

std::string form_label(Form form, std::string_view text) {
  if (form != Form::Identifier) return {};
  if (const auto unseen = unseen_character(text)) return fmt::format("it holds {}", unseen->name);
  while (!text.empty()) {
    const std::string_view character = first_character_of(text);
    if (!is_identifier(character))
      return character == " " ? "it holds a blank" : fmt::format("it holds '{}'", character);
    text.remove_prefix(character.size());
  }
  return {};
}

std::string key_hint(std::string_view key, std::string_view section,
                     const std::vector<std::string_view>& known) {
  const std::string small = in_small_letters(std::string(key));
  for (const std::string_view each : known)
    if (in_small_letters(std::string(each)) == small)
      return fmt::format("did you mean '{}'?", each);
  for (const std::string_view each : known)  // title_en, title-en
    if (small.size() > each.size() + 2 && small.size() <= each.size() + 4 &&
        small.starts_with(each) && (small[each.size()] == '_' || small[each.size()] == '-'))
      return fmt::format("did you mean '{}.{}'?", each, small.substr(each.size() + 1));
  if (const std::string_view near = terminal::closest(key, known); !near.empty())
    return fmt::format("did you mean '{}'?", near);
  for (const std::string_view each : known)
    if (small.size() > 3 && (each.starts_with(small + '_') || each.ends_with('_' + small)))
      return fmt::format("did you mean '{}'?", each);
  if (section.starts_with('[')) {
    const MuseumConfig any;
    KeyFinder finder{.key = key};
    museum_sections(finder, any);
    exhibit_sections(finder, any);
    if (!finder.found.empty())
      return fmt::format("it belongs under {}; {} may hold {}", finder.found, section,
                         fmt::join(known, ", "));
  }
  return known.empty() ? "remove it" : fmt::format("it may hold {}", fmt::join(known, ", "));
}

}  // namespace docent::config

#include "content/import/drawing/label.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "content/import/drawing/lower_case.h"

namespace docent::import {
namespace {

std::string without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

/// `71.25 m2`, `S = 12,4 m²`, `12.6 qm`.
std::optional<double> area_in(std::string_view text) {
  const std::string small = lower_case(text);
  std::size_t unit = std::string::npos;
  for (const std::string_view name : {"m2", "m²", "qm", "м2", "м²", "㎡", "sqm", "sq m"})
    unit = std::min(unit, small.find(name));
  if (unit == std::string::npos) return std::nullopt;
  std::size_t end = unit;
  while (end > 0 && small[end - 1] == ' ') --end;
  std::size_t begin = end;
  const auto part_of_number = [&](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == ',';
  };
  while (begin > 0 && part_of_number(small[begin - 1])) --begin;
  std::string digits = small.substr(begin, end - begin);
  std::ranges::replace(digits, ',', '.');
  const double area = std::strtod(digits.c_str(), nullptr);
  if (area < 0.3 || area > 1e6) return std::nullopt;
  return area;
}

/// Are there three letters in a row, or two that are all? `2668`, `A`, `5050 XO`, `+3.00` name no
/// room; `WC`, `101` and `A 002` do.
bool names_a_room(std::string_view line) {
  int letters = 0, digits = 0, others = 0, longest = 0, run = 0;
  for (const char c : line) {
    const auto u = static_cast<unsigned char>(c);
    if (std::isalpha(u) || u >= 0x80) {
      ++letters;
      longest = std::max(longest, ++run);
    } else {
      run = 0;
      if (std::isdigit(u))
        ++digits;
      else if (c != ' ' && c != '-' && c != '.')
        ++others;
    }
  }
  if (line.size() > 60 || line.find('"') != std::string_view::npos) return false;
  if (line.find('=') != std::string_view::npos || line.find('+') == 0) return false;
  if (letters == 0) return digits == 3 && others == 0 && line.find('.') == std::string_view::npos;
  if (letters == 1 && digits == 0) return false;
  if (digits >= 4 && letters <= 3 && line.find(' ') != std::string_view::npos) return false;
  return longest >= 2 || (letters >= 1 && digits >= 2);
}

std::string kind_by_words(std::string_view name,
                          const std::vector<std::pair<std::string_view, std::string_view>>& words) {
  const std::string small = " " + lower_case(name) + " ";
  for (const auto& [word, kind] : words)
    if (small.find(word) != std::string::npos) return std::string(kind);
  return {};
}

}  // namespace

RoomLabel label_of(std::vector<DrawnText> texts) {
  std::ranges::stable_sort(texts, [](const DrawnText& a, const DrawnText& b) {
    return a.at.y != b.at.y ? a.at.y > b.at.y : a.at.x < b.at.x;
  });
  RoomLabel label;
  double tallest = 0;  // Notes are written smaller than names.
  for (const DrawnText& text : texts)
    if (const std::string first = text.text.substr(0, text.text.find('\n'));
        names_a_room(first) && !area_in(first))
      tallest = std::max(tallest, text.height);
  for (const DrawnText& text : texts) {
    std::string_view rest = text.text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      const std::string line = without_blanks(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (const auto area = area_in(line)) {
        if (!label.area) label.area = area;
      } else if (names_a_room(line) && text.height >= 0.7 * tallest && label.name.size() < 120 &&
                 label.name.find(line) == std::string::npos) {
        label.name += (label.name.empty() ? "" : " ") + line;
      }
    }
  }
  return label;
}

std::string kind_of_room(std::string_view name) {
  return kind_by_words(name, {{"corridor", "corridor"},
                              {"hallway", "corridor"},
                              {"korridor", "corridor"},
                              {" flur", "corridor"},
                              {"gang ", "corridor"},
                              {"couloir", "corridor"},
                              {"circulation", "corridor"},
                              {"d\xc3\xa9gagement", "corridor"},
                              {"pasillo", "corridor"},
                              {"corridoio", "corridor"},
                              {"passage", "corridor"},
                              {"коридор", "corridor"},
                              {"走廊", "corridor"},
                              {"廊下", "corridor"}});
}

std::string connection_of_room(std::string_view name) {
  return kind_by_words(name, {{"stair", "stairs"},
                              {"trepp", "stairs"},
                              {"escalier", "stairs"},
                              {"escalera", "stairs"},
                              {" scala", "stairs"},
                              {" scale ", "stairs"},
                              {"trappe", "stairs"},
                              {"лестни", "stairs"},
                              {"楼梯", "stairs"},
                              {"階段", "stairs"},
                              {" lift", "lift"},
                              {"elevator", "lift"},
                              {"aufzug", "lift"},
                              {"ascenseur", "lift"},
                              {"ascensor", "lift"},
                              {"лифт", "lift"},
                              {" ramp", "ramp"}});
}

std::string place_of_room(std::string_view name) {
  return kind_by_words(name, {{" wc", "toilets"},
                              {"toilet", "toilets"},
                              {"toilette", "toilets"},
                              {"sanitair", "toilets"},
                              {"restroom", "toilets"},
                              {" h.c.", "toilets"},
                              {"cloakroom", "cloakroom"},
                              {"garderobe", "cloakroom"},
                              {"vestiaire", "cloakroom"},
                              {" caf\xc3\xa9", "cafe"},
                              {" cafe", "cafe"},
                              {"cafeteria", "cafe"},
                              {" shop", "shop"},
                              {"boutique", "shop"}});
}

}  // namespace docent::import

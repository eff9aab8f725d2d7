#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "config/fields.h"
#include "config/manual.h"

/// Turns tables of fields into what a manual tells. Internal to config.
namespace docent::config {

/// "whole number from 1 to 8"
std::string kind_of_number(std::string_view kind, FieldLimits limits);
std::string kind_of_text(Form form, std::span<const std::string_view> choices);

template <typename T, typename Value>
std::string kind_of(const Field<T>& field, Located<Value> T::* /*member*/) {
  if constexpr (std::is_same_v<Value, std::string>)
    return kind_of_text(field.form, field.choices);
  else if constexpr (std::is_same_v<Value, double>)
    return kind_of_number("number", field.limits);
  else if constexpr (std::is_same_v<Value, std::int64_t>)
    return kind_of_number("whole number", field.limits);
  else if constexpr (std::is_same_v<Value, bool>)
    return "true or false";
  else if constexpr (std::is_same_v<Value, Vec2>)
    return "[x, y]";
  else if constexpr (std::is_same_v<Value, std::vector<Vec2>>)
    return "[[x, y], ...]";
  else if constexpr (std::is_same_v<Value, LocatedPoints>)
    return "[x, y] or [[x, y], ...]";
  else if constexpr (std::is_same_v<Value, Outline>)
    return "[[radius, height], ...]";
  else if constexpr (std::is_same_v<Value, Range>)
    return "[least, most]";
  else if constexpr (std::is_same_v<Value, Size>)
    return "number or [across, deep]";
  else if constexpr (std::is_same_v<Value, LocatedList>)
    return "list of texts";
  else if constexpr (std::is_same_v<Value, LocatedNumbers>)
    return "[" + kind_of_number("number", field.limits) + ", ...]";
  else if constexpr (std::is_same_v<Value, std::vector<StopSection>>)
    return "[{floor, position, facing}, ...]";
  else if constexpr (std::is_same_v<Value, std::vector<PictureSection>>)
    return "[{image, caption, description}, ...]";
  else
    return "text by key";
}

template <typename T>
std::vector<FieldManual> manual_of(std::span<const Field<T>> fields) {
  std::vector<FieldManual> manual;
  for (const Field<T>& field : fields)
    manual.push_back({field.key,
                      std::visit([&](auto member) { return kind_of(field, member); }, field.member),
                      field.manual, field.presence == Presence::Required});
  return manual;
}

}  // namespace docent::config

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "config/museum_fields.h"

namespace docent::config {

namespace {

using Json = nlohmann::ordered_json;

Json texts_by_language() {
  return {{"type", "object"}, {"additionalProperties", {{"type", "string"}}}};
}

Json pair(Json item) {
  return {{"type", "array"}, {"items", std::move(item)}, {"minItems", 2}, {"maxItems", 2}};
}

Json point() {
  return pair({{"type", "number"}});
}

Json number(std::string_view type, FieldLimits limits) {
  Json schema = {{"type", type}, {"minimum", limits.least}};
  if (std::isfinite(limits.most)) schema["maximum"] = limits.most;
  return schema;
}

Json text(Form form, std::span<const std::string_view> choices) {
  Json schema = {{"type", "string"}};
  if (form == Form::Name || form == Form::File) schema["minLength"] = 1;
  if (form == Form::Identifier) schema["pattern"] = "^[A-Za-z0-9._-]+$";
  if (form == Form::Colour) schema["pattern"] = "^#[0-9A-Fa-f]{6}$";
  if (form == Form::OneOf) schema["enum"] = choices;
  return schema;
}

template <typename T, std::size_t n>
Json section_schema(std::string_view manual, const std::array<Field<T>, n>& fields);

/// The schema of a field's type, told by the type of the value that it goes into.
template <typename T, typename Value>
Json schema_of(const Field<T>& field, Located<Value> T::* /*member*/) {
  if constexpr (std::is_same_v<Value, std::string>)
    return text(field.form, field.choices);
  else if constexpr (std::is_same_v<Value, double>)
    return number("number", field.limits);
  else if constexpr (std::is_same_v<Value, std::int64_t>)
    return number("integer", field.limits);
  else if constexpr (std::is_same_v<Value, bool>)
    return {{"type", "boolean"}};
  else if constexpr (std::is_same_v<Value, Vec2>)
    return point();
  else if constexpr (std::is_same_v<Value, std::vector<Vec2>>)
    return {{"type", "array"}, {"items", point()}};
  else if constexpr (std::is_same_v<Value, LocatedPoints>)
    return {{"anyOf", {point(), {{"type", "array"}, {"items", point()}, {"minItems", 1}}}}};
  else if constexpr (std::is_same_v<Value, Outline>)
    return {{"type", "array"}, {"items", pair(number("number", field.limits))}, {"minItems", 2}};
  else if constexpr (std::is_same_v<Value, Range>)
    return pair(number("number", field.limits));
  else if constexpr (std::is_same_v<Value, Size>)
    return {{"anyOf", {number("number", field.limits), pair(number("number", field.limits))}}};
  else if constexpr (std::is_same_v<Value, LocatedList>)
    return {{"type", "array"}, {"items", {{"type", "string"}}}};
  else if constexpr (std::is_same_v<Value, LocatedNumbers>)
    return {{"type", "array"}, {"items", number("number", field.limits)}};
  else if constexpr (std::is_same_v<Value, std::vector<StopSection>>)
    return {{"type", "array"}, {"items", section_schema("", stop_fields)}, {"minItems", 2}};
  else if constexpr (std::is_same_v<Value, std::vector<PictureSection>>)
    return {{"type", "array"},
            {"items", section_schema("", picture_fields)},
            {"maxItems", FurtherPicture::most - 1}};
  else if constexpr (std::is_same_v<Value, std::vector<ExhibitSoundSection>>)
    return {{"type", "array"},
            {"items", section_schema("", exhibit_sound_fields)},
            {"maxItems", ExhibitSound::most}};
  else
    return texts_by_language();
}

template <typename T, std::size_t n>
Json section_schema(std::string_view manual, const std::array<Field<T>, n>& fields) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const Field<T>& field : fields) {
    Json schema = std::visit([&](auto member) { return schema_of(field, member); }, field.member);
    schema["description"] = field.manual;
    properties[std::string(field.key)] = std::move(schema);
    if (field.presence == Presence::Required) required.push_back(field.key);
  }
  return {{"type", "object"},
          {"description", manual},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

/// Collects the sections of a file.
struct SchemaVisitor {
  Json properties = Json::object();

  template <typename T, std::size_t n>
  void one(std::string_view name, std::string_view manual, const std::array<Field<T>, n>& fields,
           const T& /*section*/) {
    properties[std::string(name)] = section_schema(manual, fields);
  }
  template <typename T, std::size_t n>
  void many(std::string_view name, std::string_view manual, const std::array<Field<T>, n>& fields,
            const std::vector<T>& /*sections*/) {
    properties[std::string(name)] = {{"type", "array"}, {"items", section_schema(manual, fields)}};
  }
  template <typename T, std::size_t n>
  void one_or_many(std::string_view name, std::string_view manual,
                   const std::array<Field<T>, n>& fields, const std::vector<T>& /*sections*/) {
    const Json section = section_schema(manual, fields);
    properties[std::string(name)] = {
        {"anyOf", {section, {{"type", "array"}, {"items", section}, {"minItems", 1}}}}};
  }
};

Json file_schema(const SchemaVisitor& sections) {
  return {{"type", "object"}, {"properties", sections.properties}, {"additionalProperties", false}};
}

}  // namespace

std::string museum_schema() {
  const MuseumConfig any;
  SchemaVisitor museum;
  museum_sections(museum, any);
  SchemaVisitor exhibits;
  exhibit_sections(exhibits, any);
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "A museum for docent: museum.toml"},
                 {"description",
                  "Files of exhibits/ are described by #/$defs/exhibits, those of words/ by "
                  "#/$defs/words."}};
  schema.update(file_schema(museum));
  schema["$defs"] = {
      {"exhibits", file_schema(exhibits)},
      {"words", section_schema("The interface's words in one language", words_fields)}};
  return schema.dump(2) + "\n";
}

}  // namespace docent::config

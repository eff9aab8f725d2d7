#include "config/manual.h"

#include <fmt/format.h>

#include "config/field_manual.h"
#include "config/museum_fields.h"

namespace docent::config {
namespace {

/// Collects the sections of a file.
struct ManualVisitor {
  std::vector<SectionManual> sections;

  template <typename T, std::size_t n>
  void one(std::string_view name, std::string_view manual, const std::array<Field<T>, n>& fields,
           const T& /*section*/) {
    sections.push_back({fmt::format("[{}]", name), manual, manual_of<T>(fields)});
  }
  template <typename T, std::size_t n>
  void many(std::string_view name, std::string_view manual, const std::array<Field<T>, n>& fields,
            const std::vector<T>& /*sections*/) {
    sections.push_back({fmt::format("[[{}]]", name), manual, manual_of<T>(fields)});
  }
  template <typename T, std::size_t n>
  void one_or_many(std::string_view name, std::string_view manual,
                   const std::array<Field<T>, n>& fields, const std::vector<T>& /*sections*/) {
    sections.push_back({fmt::format("[{}]", name), manual, manual_of<T>(fields)});
  }
};

}  // namespace

std::string kind_of_number(std::string_view kind, FieldLimits limits) {
  // Coordinates and the like are limited only so that nothing overflows.
  if (limits.least == FieldLimits{}.least) return std::string(kind);
  return std::isinf(limits.most) ? fmt::format("{} of at least {}", kind, limits.least)
                                 : fmt::format("{} from {} to {}", kind, limits.least, limits.most);
}

std::string kind_of_text(Form form, std::span<const std::string_view> choices) {
  switch (form) {
    case Form::Identifier:
      return "identifier";
    case Form::File:
      return "file";
    case Form::Colour:
      return "colour";
    case Form::OneOf:
      return fmt::format("{}", fmt::join(choices, " or "));
    case Form::Free:
    case Form::Keys:
    case Form::Name:
      break;
  }
  return "text";
}

std::vector<SectionManual> museum_manual() {
  const MuseumConfig any;
  ManualVisitor visitor;
  museum_sections(visitor, any);
  return std::move(visitor.sections);
}

std::vector<SectionManual> exhibit_manual() {
  const MuseumConfig any;
  ManualVisitor visitor;
  exhibit_sections(visitor, any);
  return std::move(visitor.sections);
}

std::vector<SectionManual> words_manual() {
  return {{.heading = {}, .manual = {}, .fields = manual_of<WordsFile>(words_fields)}};
}

}  // namespace docent::config

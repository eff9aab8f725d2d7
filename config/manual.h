#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The fields of the files that staff write, as a manual page tells of them: made from the tables
/// that the loaders check.
namespace docent::config {

struct FieldManual {
  std::string_view key;
  std::string kind;         ///< "number from 10 to 600", "[x, y]".
  std::string_view manual;  ///< A sentence without a full stop.
  bool is_needed = false;
};

struct SectionManual {
  std::string heading;  ///< "[kiosk]", "[[room]]"; empty for fields outside of any section.
  std::string_view manual;
  std::vector<FieldManual> fields;
};

std::vector<SectionManual> museum_manual();   ///< museum.toml
std::vector<SectionManual> exhibit_manual();  ///< exhibits/*.toml
std::vector<SectionManual> words_manual();    ///< words/LANGUAGE.toml
std::vector<SectionManual> kiosk_manual();    ///< kiosk.toml

}  // namespace docent::config

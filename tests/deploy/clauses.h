#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What docent does about each clause of EN 301 549 that has to do with a kiosk: chapter 5 (generic
/// requirements) and chapter 8 (hardware), by the numbers of V3.2.1. The page
/// deploy/ACCESSIBILITY.md is made of this table, so that nobody claims there what no test proves.
namespace docent::test {

struct Clause {
  enum class State : std::uint8_t {
    Met,          ///< Tests prove it.
    InPart,       ///< Tests prove some of it; `says` tells what is open.
    Open,         ///< Not done.
    TheMuseums,   ///< A matter of the cabinet, the keypad or the place where it stands.
    NotConcerned  ///< Nothing of docent is meant.
  };
  std::string_view number, title;
  State state;
  std::string_view says;
  std::vector<std::string_view> tests;  ///< Their names, "Suite.Name".
};

std::span<const Clause> clauses();

/// The page.
std::string accessibility_page();

}  // namespace docent::test

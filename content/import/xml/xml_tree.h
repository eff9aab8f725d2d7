#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace docent::import {

/// An element of an XML text, with the place where it begins. Names are without their prefix:
/// `gml:pos` is `pos`.
struct XmlElement {
  std::string name{};
  std::vector<std::pair<std::string, std::string>> attributes{};
  std::string text{};  ///< All characters directly inside, blanks about them taken off.
  std::vector<XmlElement> children{};
  std::uint32_t line = 0, column = 0;  ///< From 1.

  /// An attribute's value by its name without prefix; empty where there is none.
  [[nodiscard]] std::string_view attribute(std::string_view wanted) const noexcept;
  /// The first child of that name; null where there is none.
  [[nodiscard]] const XmlElement* child(std::string_view wanted) const noexcept;
};

/// All elements of a name in or under `root`, in the order of the text.
std::vector<const XmlElement*> find_all(const XmlElement& root, std::string_view name);

/// Parses one XML text (expat; no entities beyond XML's own, nothing is fetched). Throws
/// ContentError with the place for text that is not XML and nesting deeper than 200.
XmlElement parse_xml(const std::string& file, std::string_view text);

}  // namespace docent::import

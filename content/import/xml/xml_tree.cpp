#include "content/import/xml/xml_tree.h"

#include <expat.h>

#include <algorithm>
#include <climits>
#include <memory>

#include "content/content_error.h"

namespace docent::import {
namespace {

constexpr std::size_t deepest = 200;

std::string_view without_prefix(std::string_view name) noexcept {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

struct FreeParser {
  void operator()(XML_Parser parser) const noexcept { XML_ParserFree(parser); }
};
using Parser = std::unique_ptr<std::remove_pointer_t<XML_Parser>, FreeParser>;

/// Builds the tree from expat's events.
struct Builder {
  XML_Parser parser = nullptr;
  XmlElement root{};  ///< Holds the document's element.
  std::vector<XmlElement*> open{};
  bool too_deep = false;

  static void start(void* self, const XML_Char* name, const XML_Char** attributes) {
    auto& builder = *static_cast<Builder*>(self);
    if (builder.open.size() > deepest) {
      builder.too_deep = true;
      XML_StopParser(builder.parser, XML_FALSE);
      return;
    }
    // An element's children are complete before the next is added: pointers to open ones stay good.
    XmlElement& element = builder.open.back()->children.emplace_back();
    element.name = without_prefix(name);
    for (; *attributes != nullptr; attributes += 2)
      element.attributes.emplace_back(without_prefix(attributes[0]), attributes[1]);
    element.line = static_cast<std::uint32_t>(XML_GetCurrentLineNumber(builder.parser));
    element.column = static_cast<std::uint32_t>(XML_GetCurrentColumnNumber(builder.parser)) + 1;
    builder.open.push_back(&element);
  }
  static void end(void* self, const XML_Char* /*name*/) {
    auto& builder = *static_cast<Builder*>(self);
    std::string& text = builder.open.back()->text;
    constexpr const char* blanks = " \t\r\n";
    text.erase(0, std::min(text.find_first_not_of(blanks), text.size()));
    text.erase(text.find_last_not_of(blanks) + 1);
    builder.open.pop_back();
  }
  static void characters(void* self, const XML_Char* text, int length) {
    auto& builder = *static_cast<Builder*>(self);
    builder.open.back()->text.append(text, static_cast<std::size_t>(length));
  }
};

}  // namespace

std::string_view XmlElement::attribute(std::string_view wanted) const noexcept {
  const auto found =
      std::ranges::find(attributes, wanted, &std::pair<std::string, std::string>::first);
  return found == attributes.end() ? std::string_view{} : std::string_view(found->second);
}

const XmlElement* XmlElement::child(std::string_view wanted) const noexcept {
  const auto found = std::ranges::find(children, wanted, &XmlElement::name);
  return found == children.end() ? nullptr : &*found;
}

std::vector<const XmlElement*> find_all(const XmlElement& root, std::string_view name) {
  std::vector<const XmlElement*> found;
  if (root.name == name) found.push_back(&root);
  for (const XmlElement& child : root.children)
    for (const XmlElement* element : find_all(child, name)) found.push_back(element);
  return found;
}

XmlElement parse_xml(const std::string& file, std::string_view text) {
  const Parser parser(XML_ParserCreate(nullptr));
  if (!parser) throw std::bad_alloc();
  Builder builder{.parser = parser.get()};
  builder.open.push_back(&builder.root);
  XML_SetUserData(parser.get(), &builder);
  XML_SetElementHandler(parser.get(), Builder::start, Builder::end);
  XML_SetCharacterDataHandler(parser.get(), Builder::characters);
  bool good = true;
  while (good) {
    const std::size_t piece = std::min<std::size_t>(text.size(), INT_MAX / 4);
    const bool last = piece == text.size();
    // NOLINTNEXTLINE(bugprone-suspicious-stringview-data-usage): the size is the next argument
    good = XML_Parse(parser.get(), text.data(), static_cast<int>(piece), last) == XML_STATUS_OK;
    text.remove_prefix(piece);
    if (last) break;
  }
  if (!good || builder.root.children.empty()) {
    const auto line = static_cast<std::uint32_t>(XML_GetCurrentLineNumber(parser.get()));
    const auto column = static_cast<std::uint32_t>(XML_GetCurrentColumnNumber(parser.get())) + 1;
    throw content::ContentError(
        file, line, column, "unreadable-xml",
        builder.too_deep ? "the elements are nested too deeply"
                         : "this is not XML: an element is cut short, unclosed or not well formed",
        "export the file again; an editor for XML shows the place");
  }
  return std::move(builder.root.children.front());
}

}  // namespace docent::import

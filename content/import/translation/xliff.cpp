#include <algorithm>
#include <cstdlib>
#include <pugixml.hpp>
#include <sstream>

#include "content/content_error.h"
#include "content/import/collection/utf8.h"
#include "content/import/translation/translation.h"

namespace docent::import {

namespace {

constexpr int deepest = 64;

/// An element's name without its namespace's prefix.
std::string_view local_name(pugi::xml_node node) {
  std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

class XliffReader {
 public:
  XliffReader(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  Translation read() {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(
        text_.data(), text_.size(), pugi::parse_default | pugi::parse_ws_pcdata);
    if (!parsed) fail(parsed.offset, "this is not XML: it is damaged or cut short about here");
    const pugi::xml_node root = document.document_element();
    if (local_name(root) != "xliff") fail(0, "this is XML, and no XLIFF");
    const std::string version = root.attribute("version").value();
    if (version.starts_with("2"))
      read_2(root);
    else if (version.starts_with("1"))
      read_1(root);
    else
      fail(0, "the version of this XLIFF is not said, or neither 1.2 nor 2");
    return std::move(translation_);
  }

 private:
  [[nodiscard]] std::uint32_t line_at(std::ptrdiff_t offset) const {
    const auto end =
        std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
    return static_cast<std::uint32_t>(1 + std::count(text_.begin(), text_.begin() + end, '\n'));
  }

  [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& message) const {
    throw content::ContentError(file_, line_at(offset), 1, "unreadable-xliff", message,
                                "ask for the file again as XLIFF 2.0");
  }

  void read_2(pugi::xml_node root) {
    translation_.from = root.attribute("srcLang").value();
    translation_.to = root.attribute("trgLang").value();
    if (translation_.from.empty())
      fail(root.offset_debug(), "this XLIFF lacks srcLang, its language");
    walk(root, 0);
  }

  void read_1(pugi::xml_node root) {
    for (const pugi::xml_node file : root.children())
      if (local_name(file) == "file") {
        if (translation_.from.empty())
          translation_.from = file.attribute("source-language").value();
        if (translation_.to.empty()) translation_.to = file.attribute("target-language").value();
      }
    walk(root, 0);
  }

  void walk(pugi::xml_node node, int depth) {
    if (depth > deepest) fail(node.offset_debug(), "its elements are nested too deeply");
    for (const pugi::xml_node child : node.children()) {
      const std::string_view name = local_name(child);
      if (name == "unit" || name == "trans-unit")
        read_unit(child, name == "trans-unit");
      else if (name == "file" || name == "group" || name == "body")
        walk(child, depth + 1);
    }
  }

  void read_unit(pugi::xml_node node, bool is_1) {
    TranslationUnit unit;
    unit.line = line_at(node.offset_debug());
    unit.id = node.attribute("id").value();
    if (unit.id.empty()) fail(node.offset_debug(), "a unit lacks its id");
    if (is_1) {
      add_segment(node, true, unit);
    } else {
      for (const pugi::xml_node part : node.children())
        if (local_name(part) == "segment" || local_name(part) == "ignorable")
          add_segment(part, local_name(part) == "segment", unit);
    }
    if (unit.is_partial && unit.target.find_first_not_of(" \t\r\n") == std::string::npos) {
      unit.target.clear();
      unit.is_partial = false;
    }
    translation_.units.push_back(std::move(unit));
  }

  static void add_segment(pugi::xml_node segment, bool is_text, TranslationUnit& unit) {
    pugi::xml_node source, target;
    for (const pugi::xml_node child : segment.children()) {
      if (local_name(child) == "source") source = child;
      if (local_name(child) == "target") target = child;
    }
    std::string text;
    add_text(source, 0, text);
    unit.source += text;
    if (target)
      add_text(target, 0, unit.target);
    else if (is_text)
      unit.is_partial = true;
    else
      unit.target += text;  // what stands between sentences is the same in every language
  }

  static void add_text(pugi::xml_node node, int depth, std::string& out) {
    if (depth > deepest) return;
    for (const pugi::xml_node child : node.children()) {
      if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
        out += child.value();
      } else if (local_name(child) == "cp") {
        const unsigned long code = std::strtoul(child.attribute("hex").value(), nullptr, 16);
        if (code > 0 && code <= 0x10FFFF) append_utf8(out, static_cast<std::uint32_t>(code));
      } else {
        add_text(child, depth + 1, out);
      }
    }
  }

  const std::string& file_;
  std::string_view text_;
  Translation translation_;
};

void add_element(pugi::xml_node segment, const char* name, const std::string& text) {
  pugi::xml_node element = segment.append_child(name);
  if (text.find('\n') != std::string::npos) element.append_attribute("xml:space") = "preserve";
  element.append_child(pugi::node_pcdata).set_value(text.c_str());
}

}  // namespace

Translation read_xliff(const std::string& file, std::string_view text) {
  return XliffReader(file, text).read();
}

std::string write_xliff(const Translation& translation) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("xliff");
  root.append_attribute("xmlns") = "urn:oasis:names:tc:xliff:document:2.0";
  root.append_attribute("version") = "2.0";
  root.append_attribute("srcLang") = translation.from.c_str();
  root.append_attribute("trgLang") = translation.to.c_str();
  pugi::xml_node file = root.append_child("file");
  file.append_attribute("id") = "museum";
  for (const TranslationUnit& each : translation.units) {
    pugi::xml_node unit = file.append_child("unit");
    unit.append_attribute("id") = each.id.c_str();
    pugi::xml_node segment = unit.append_child("segment");
    segment.append_attribute("state") = each.target.empty() ? "initial" : "translated";
    add_element(segment, "source", each.source);
    if (!each.target.empty()) add_element(segment, "target", each.target);
  }
  std::ostringstream out;
  document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

}  // namespace docent::import

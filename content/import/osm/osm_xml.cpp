#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "content/content_error.h"
#include "content/import/osm/osm_data.h"
#include "content/import/xml/xml_tree.h"

namespace docent::import {
namespace {

class OsmXmlReader {
 public:
  explicit OsmXmlReader(const std::string& file) : file_(file) {}

  OsmData read(const XmlElement& root) {
    if (root.name != "osm")
      fail(root, "this XML is not OpenStreetMap's: it begins with <" + root.name + ">");
    for (const XmlElement& element : root.children) {
      if (element.attribute("action") == "delete") continue;
      if (element.name == "node") read_node(element);
      if (element.name == "way") read_way(element);
      if (element.name == "relation") read_relation(element);
    }
    return std::move(data_);
  }

 private:
  [[noreturn]] void fail(const XmlElement& at, const std::string& message) const {
    throw content::ContentError(file_, at.line, at.column, "invalid-osm", message,
                                "download or export the extract again");
  }

  template <typename Number>
  Number number(const XmlElement& element, std::string_view name) const {
    const std::string_view text = element.attribute(name);
    Number value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size())
      fail(element, fmt::format("this {} has no {} that is a number", element.name, name));
    return value;
  }

  Placed place(const XmlElement& element) const { return {file_, element.line, element.column}; }

  static OsmTags tags_of(const XmlElement& element) {
    OsmTags tags;
    for (const XmlElement& child : element.children)
      if (child.name == "tag") tags[std::string(child.attribute("k"))] = child.attribute("v");
    return tags;
  }

  void read_node(const XmlElement& element) {
    if (element.attribute("visible") == "false" || element.attribute("lat").empty()) return;
    const Vec2 at{number<double>(element, "lon"), number<double>(element, "lat")};
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || std::abs(at.x) > 180 || std::abs(at.y) > 90)
      fail(element, "this node lies on no globe: its latitude or longitude is out of range");
    data_.nodes[number<std::int64_t>(element, "id")] = {at, tags_of(element), place(element)};
  }

  void read_way(const XmlElement& element) {
    OsmWay way{.id = number<std::int64_t>(element, "id"),
               .tags = tags_of(element),
               .placed = place(element)};
    for (const XmlElement& child : element.children)
      if (child.name == "nd") way.nodes.push_back(number<std::int64_t>(child, "ref"));
    data_.ways.push_back(std::move(way));
  }

  void read_relation(const XmlElement& element) {
    OsmRelation relation{.id = number<std::int64_t>(element, "id"),
                         .tags = tags_of(element),
                         .placed = place(element)};
    for (const XmlElement& child : element.children)
      if (child.name == "member" && child.attribute("type") == "way")
        relation.members.push_back(
            {number<std::int64_t>(child, "ref"), child.attribute("role") == "inner"});
    data_.relations.push_back(std::move(relation));
  }

  const std::string& file_;
  OsmData data_;
};

}  // namespace

OsmData read_osm_xml(const std::string& file, std::string_view text) {
  return OsmXmlReader(file).read(parse_xml(file, text));
}

}  // namespace docent::import

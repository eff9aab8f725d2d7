#include "content/import/drawing/svg.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <optional>

#include "content/content_error.h"
#include "content/import/drawing/read_drawing.h"
#include "content/import/drawing/svg_path.h"
#include "content/import/xml/xml_tree.h"

namespace docent::import {
namespace {

constexpr std::size_t most_svg_strokes = 2'000'000;

/// x' = a x + c y + e, y' = b x + d y + f.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  Affine operator*(const Affine& o) const {
    return {a * o.a + c * o.b, b * o.a + d * o.b,     a * o.c + c * o.d,
            b * o.c + d * o.d, a * o.e + c * o.f + e, b * o.e + d * o.f + f};
  }
  double scale() const { return std::sqrt(std::abs(a * d - b * c)); }
};

/// `translate(1,2) rotate(90)`: applied from the right.
Affine parse_transform(std::string_view text) {
  Affine out;
  while (!text.empty()) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) break;
    const std::string_view name = text.substr(0, open);
    const std::vector<double> n = parse_numbers(text.substr(open + 1, close - open - 1));
    const auto at = [&](std::size_t i, double otherwise) {
      return i < n.size() ? n[i] : otherwise;
    };
    Affine own;
    if (name.find("matrix") != std::string_view::npos && n.size() == 6)
      own = {n[0], n[1], n[2], n[3], n[4], n[5]};
    else if (name.find("translate") != std::string_view::npos)
      own = {1, 0, 0, 1, at(0, 0), at(1, 0)};
    else if (name.find("scale") != std::string_view::npos)
      own = {at(0, 1), 0, 0, at(1, at(0, 1)), 0, 0};
    else if (name.find("rotate") != std::string_view::npos) {
      const double turn = at(0, 0) * std::numbers::pi / 180;
      const Affine to{1, 0, 0, 1, at(1, 0), at(2, 0)}, back{1, 0, 0, 1, -at(1, 0), -at(2, 0)};
      own =
          to * Affine{std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn), 0, 0} * back;
    } else if (name.find("skewX") != std::string_view::npos)
      own = {1, 0, std::tan(at(0, 0) * std::numbers::pi / 180), 1, 0, 0};
    else if (name.find("skewY") != std::string_view::npos)
      own = {1, std::tan(at(0, 0) * std::numbers::pi / 180), 0, 1, 0, 0};
    out = out * own;
    text.remove_prefix(close + 1);
  }
  return out;
}

class SvgReader {
 public:
  explicit SvgReader(const std::string& file) : file_(file) {}

  Drawing read(const XmlElement& root) {
    drawing_.layers.emplace_back("picture");
    walk(root, {1, 0, 0, -1, 0, 0}, 0);  // y runs down in pictures and up in plans.
    find_scale(root);
    return std::move(drawing_);
  }

 private:
  static bool only_defines(const std::string& name) {
    static constexpr std::array names = {"defs",   "clipPath", "mask",      "pattern", "marker",
                                         "symbol", "metadata", "namedview", "style",   "script",
                                         "filter", "title",    "desc"};
    return std::ranges::find(names, name) != names.end();
  }

  static bool is_hidden(const XmlElement& element) {
    const std::string_view style = element.attribute("style");
    return element.attribute("display") == "none" ||
           style.find("display:none") != std::string_view::npos ||
           style.find("display: none") != std::string_view::npos ||
           element.attribute("visibility") == "hidden" ||
           style.find("visibility:hidden") != std::string_view::npos;
  }

  std::uint32_t layer_of(const std::string& name) {
    const auto [found, fresh] =
        layers_.try_emplace(name, static_cast<std::uint32_t>(drawing_.layers.size()));
    if (fresh) drawing_.layers.push_back(name);
    return found->second;
  }

  double length(const XmlElement& element, const char* name) const {
    const std::vector<double> numbers = parse_numbers(element.attribute(name));
    return numbers.empty() ? 0 : numbers.front();
  }

  void walk(const XmlElement& element, const Affine& outer, std::uint32_t layer) {
    if (only_defines(element.name)) return;
    if (is_hidden(element)) {
      ++drawing_.left_out["hidden elements"];
      return;
    }
    const Affine place = outer * parse_transform(element.attribute("transform"));
    if (element.name == "g") {
      const std::string_view label = element.attribute("label"), id = element.attribute("id");
      if (!label.empty() || !id.empty()) layer = layer_of(std::string(label.empty() ? id : label));
    }
    draw(element, place, layer);
    if (element.name == "text") return;
    for (const XmlElement& child : element.children) walk(child, place, layer);
  }

  void draw(const XmlElement& element, const Affine& place, std::uint32_t layer) {
    const std::string& name = element.name;
    if (name == "line") {
      strokes({{{length(element, "x1"), length(element, "y1")},
                {length(element, "x2"), length(element, "y2")}},
               false},
              element, place, layer);
    } else if (name == "rect") {
      const Vec2 at{length(element, "x"), length(element, "y")};
      const double w = length(element, "width"), h = length(element, "height");
      if (w > 0 && h > 0)
        strokes({{at, at + Vec2{w, 0}, at + Vec2{w, h}, at + Vec2{0, h}}, true}, element, place,
                layer);
    } else if (name == "polygon" || name == "polyline") {
      const std::vector<double> numbers = parse_numbers(element.attribute("points"));
      SubPath path{{}, name == "polygon"};
      for (std::size_t i = 1; i < numbers.size(); i += 2)
        path.points.push_back({numbers[i - 1], numbers[i]});
      strokes(path, element, place, layer);
    } else if (name == "circle" || name == "ellipse") {
      const Vec2 centre{length(element, "cx"), length(element, "cy")};
      const double rx = length(element, name == "circle" ? "r" : "rx"),
                   ry = length(element, name == "circle" ? "r" : "ry");
      SubPath path{{}, true};
      for (int i = 0; i < 48; ++i)
        path.points.push_back(centre + Vec2{rx * std::cos(i * std::numbers::pi / 24),
                                            ry * std::sin(i * std::numbers::pi / 24)});
      if (rx > 0 && ry > 0) strokes(path, element, place, layer);
    } else if (name == "path") {
      for (const SubPath& path : parse_path(element.attribute("d")))
        strokes(path, element, place, layer);
    } else if (name == "text") {
      write(element, place, layer);
    } else if (name == "image" || name == "use" || name == "foreignObject") {
      ++drawing_.left_out[name == "image" ? "pictures (<image>)" : "<" + name + ">"];
    }
  }

  void strokes(const SubPath& path, const XmlElement& element, const Affine& place,
               std::uint32_t layer) {
    std::vector<Vec2> points;
    for (const Vec2 p : path.points) points.push_back(place(p));
    if (std::ranges::any_of(points, [](Vec2 p) { return !std::isfinite(p.x + p.y); })) return;
    if (drawing_.segments.size() + points.size() > most_svg_strokes)
      throw content::ContentError(
          file_, element.line, element.column, "unreadable-svg",
          fmt::format("this SVG holds more than {} strokes", most_svg_strokes),
          "save only the floor plan");
    for (std::size_t i = 1; i < points.size(); ++i)
      drawing_.segments.push_back({points[i - 1], points[i], layer});
    if (points.size() > 2 && points.front() == points.back()) points.pop_back();
    const bool meets =
        path.closed || (path.points.size() > 3 && path.points.front() == path.points.back());
    if (!meets || points.size() < 3) return;
    drawing_.segments.push_back({points.back(), points.front(), layer});
    drawing_.rings.push_back({std::move(points), layer, element.line});
  }

  static void gather(const XmlElement& element, std::string& text) {
    text += element.text;
    for (const XmlElement& child : element.children) {
      if (!text.empty() && text.back() != '\n') text += '\n';
      gather(child, text);
    }
  }

  /// The place of the first letter, moved to the middle of the word.
  void write(const XmlElement& element, const Affine& place, std::uint32_t layer) {
    std::string text;
    gather(element, text);
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    if (text.empty()) return;
    const XmlElement* span = element.child("tspan");
    const bool own = !element.attribute("x").empty() || span == nullptr;
    const XmlElement& at = own ? element : *span;
    double size = 12;
    for (const XmlElement* each : {&element, span}) {
      if (each == nullptr) continue;
      const std::string_view style = each->attribute("style");
      const std::size_t found = style.find("font-size:");
      const std::vector<double> numbers =
          parse_numbers(found != std::string_view::npos ? style.substr(found + 10)
                                                        : each->attribute("font-size"));
      if (!numbers.empty() && numbers.front() > 0) size = numbers.front();
    }
    const std::size_t letters = std::min(text.find('\n'), text.size());
    const bool centred =
        element.attribute("text-anchor") == "middle" ||
        at.attribute("style").find("text-anchor:middle") != std::string_view::npos ||
        element.attribute("style").find("text-anchor:middle") != std::string_view::npos;
    const Vec2 middle{length(at, "x") + (centred ? 0 : 0.28 * size * static_cast<double>(letters)),
                      length(at, "y") - 0.35 * size};
    const Vec2 placed = place(middle);
    if (std::isfinite(placed.x + placed.y))
      drawing_.texts.push_back({text, placed, size * place.scale(), layer});
  }

  /// Paper has a size in millimetres, and a text may say how much smaller it is than the building.
  void find_scale(const XmlElement& root) {
    static const std::map<std::string, double> paper = {
        {"mm", 0.001}, {"cm", 0.01}, {"in", 0.0254}, {"pt", 0.0254 / 72}};
    const std::string width(root.attribute("width"));
    const std::vector<double> box = parse_numbers(root.attribute("viewBox")),
                              number = parse_numbers(width);
    const std::size_t unit = width.find_first_of("cimp");
    if (box.size() != 4 || number.empty() || unit == std::string::npos || !(box[2] > 0)) return;
    const auto metres = paper.find(width.substr(unit, 2));
    if (metres == paper.end()) return;
    for (const DrawnText& text : drawing_.texts) {
      const std::size_t at = text.text.find("1:");
      if (at == std::string::npos) continue;
      const double scale = std::strtod(text.text.c_str() + at + 2, nullptr);
      if (scale < 10 || scale > 5000) continue;
      drawing_.metres_per_unit = number.front() * metres->second / box[2] * scale;
      drawing_.unit = fmt::format("1:{:g} on paper", scale);
      return;
    }
  }

  const std::string& file_;
  Drawing drawing_;
  std::map<std::string, std::uint32_t> layers_;
};

}  // namespace

Drawing parse_svg(const std::string& file, std::string_view text) {
  return SvgReader(file).read(parse_xml(file, text));
}

bool looks_isometric(const Drawing& drawing) {
  constexpr int bins = 60;  // Of three degrees.
  std::array<double, bins> along{};
  double all = 0;
  for (const DrawnSegment& segment : drawing.segments) {
    const Vec2 d = segment.b - segment.a;
    const double length = glm::length(d);
    if (!(length > 0)) continue;
    const double turn = std::fmod(std::atan2(d.y, d.x) + 2 * std::numbers::pi, std::numbers::pi);
    along[static_cast<std::size_t>(std::lround(turn / std::numbers::pi * bins)) % bins] += length;
    all += length;
  }
  if (drawing.segments.size() < 20) return false;
  const auto near = [&](int bin) {
    double sum = 0;
    for (int i = bin - 1; i <= bin + 1; ++i)
      sum += along[static_cast<std::size_t>((i + bins) % bins)];
    return sum / all;
  };
  // 30 and 150 degrees from the right, whatever of it is upright.
  return near(10) > 0.2 && near(50) > 0.2 && near(10) + near(50) + near(30) > 0.75;
}

BuildingOrDiagnostics read_svg(const BuildingSource& source, const ImportOptions& options) {
  Drawing drawing = parse_svg(source.file, source.bytes);
  if (looks_isometric(drawing))
    return std::unexpected(
        Diagnostics{{.file = source.file,
                     .code = "no-plan",
                     .message = "this picture is an isometric view, in which lengths and angles "
                                "are not the building's",
                     .hint = "ask for the plan seen from above, or draw one over it"}});
  if (options.unit.empty() && !drawing.metres_per_unit)
    return std::unexpected(Diagnostics{
        {.file = source.file,
         .code = "unknown-unit",
         .message =
             "the picture does not say how large the building is: one of its units is any length",
         .hint = "measure one wall in the picture and in the building, and say --unit with metres "
                 "a unit, "
                 "such as --unit 0.05"}});
  return read_drawing(std::move(drawing), source, options);
}

}  // namespace docent::import

#include "content/import/drawing/dxf.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "content/content_error.h"
#include "content/import/drawing/code_page.h"
#include "content/import/drawing/dxf_text.h"

namespace docent::import {
namespace {

constexpr std::size_t most_strokes = 2'000'000;
constexpr int deepest_block = 16;
constexpr double pi = std::numbers::pi;

/// One pair of lines: what the value is, and the value.
struct Group {
  int code = 0;
  std::string_view value;
  std::uint32_t line = 0;
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
    text.remove_suffix(1);
  return text;
}

double number(std::string_view text, double otherwise = 0) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = otherwise;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && std::isfinite(value) ? value : otherwise;
}

/// The groups of one entity, its name first.
struct Entity {
  std::string_view type;
  std::span<const Group> groups;

  const Group* find(int code) const {
    const auto found = std::ranges::find(groups, code, &Group::code);
    return found == groups.end() ? nullptr : &*found;
  }
  double real(int code, double otherwise = 0) const {
    const Group* group = find(code);
    return group == nullptr ? otherwise : number(group->value, otherwise);
  }
  int whole(int code, int otherwise = 0) const {
    return static_cast<int>(std::clamp(real(code, otherwise), -1e9, 1e9));
  }
  std::string_view text(int code) const {
    const Group* group = find(code);
    return group == nullptr ? std::string_view{} : group->value;
  }
  Vec2 point(int code) const { return {real(code), real(code + 10)}; }
  std::uint32_t line() const { return groups.empty() ? 0 : groups.front().line; }
};

struct Block {
  Vec2 base{};
  std::vector<Entity> entities;
};

/// Where a block's strokes go: a matrix by its columns, and an offset.
struct Transform {
  Vec2 x{1, 0}, y{0, 1}, offset{0, 0};
  Vec2 operator()(Vec2 p) const { return offset + p.x * x + p.y * y; }
  Transform operator*(const Transform& first) const {
    const auto turned = [&](Vec2 v) { return v.x * x + v.y * y; };
    return {turned(first.x), turned(first.y), (*this)(first.offset)};
  }
  double scale() const { return std::sqrt(std::abs(cross(x, y))); }
  /// Do circles stay circles?
  bool keeps_circles() const {
    const double length = glm::length(x);
    return std::abs(glm::length(y) - length) < 1e-3 * length &&
           std::abs(dot(x, y)) < 1e-3 * length * length;
  }
};

/// Entities of extrusion (0, 0, -1) lie in a mirrored frame (the arbitrary axis algorithm).
Transform object_frame(const Entity& entity) {
  return entity.real(230, 1) < 0 ? Transform{.x = {-1, 0}} : Transform{};
}

class DxfReader {
 public:
  DxfReader(const std::string& file, std::string_view bytes) : file_(file) { split(bytes); }

  Drawing read() {
    read_sections();
    if (!entities_found_) throw error_at(0, "has no ENTITIES section, so nothing is drawn in it");
    for (const Entity& entity : model_) draw(entity, {}, nullptr, 0);
    return std::move(drawing_);
  }

 private:
  content::ContentError error_at(std::uint32_t line, const std::string& sentence,
                                 const std::string& hint = "save the drawing again as DXF") {
    return {file_, line, 0, "unreadable-dxf", "this DXF " + sentence, hint};
  }

  /// The file's lines in pairs.
  void split(std::string_view bytes) {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    std::uint32_t line = 1;
    const auto next_line = [&]() -> std::optional<std::string_view> {
      if (bytes.empty()) return std::nullopt;
      const std::size_t end = std::min(bytes.find('\n'), bytes.size());
      std::string_view text = bytes.substr(0, end);
      bytes.remove_prefix(std::min(end + 1, bytes.size()));
      if (text.ends_with('\r')) text.remove_suffix(1);
      return text;
    };
    while (const auto code_text = next_line()) {
      const std::string_view digits = trimmed(*code_text);
      if (digits.empty() && bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) break;
      int code = 0;
      const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code);
      if (error != std::errc{} || end != digits.data() + digits.size())
        throw error_at(line, fmt::format("has '{}' where a group code belongs, a number",
                                         to_utf8(digits.substr(0, 40), "")));
      const auto value = next_line();
      if (!value) throw error_at(line, "ends after a group code without its value");
      if (code != 999) groups_.push_back({code, *value, line});
      line += 2;
      if (code == 0 && trimmed(*value) == "EOF") break;
    }
  }

  /// From a group 0 to the one before the next.
  Entity entity_at(std::size_t& at) const {
    const std::size_t begin = at++;
    while (at < groups_.size() && groups_[at].code != 0) ++at;
    return {trimmed(groups_[begin].value), std::span(groups_).subspan(begin, at - begin)};
  }

  void read_sections() {
    std::size_t at = 0;
    std::string_view section;
    Block* block = nullptr;
    while (at < groups_.size()) {
      if (groups_[at].code != 0) {
        ++at;
        continue;
      }
      const Entity entity = entity_at(at);
      if (entity.type == "SECTION") {
        section = trimmed(entity.text(2));
        if (section == "HEADER") read_header(entity.groups);
        if (section == "ENTITIES") entities_found_ = true;
      } else if (entity.type == "ENDSEC") {
        section = {};
      } else if (section == "TABLES" && entity.type == "LAYER") {
        read_layer(entity);
      } else if (section == "BLOCKS") {
        if (entity.type == "BLOCK") {
          block = &blocks_[std::string(trimmed(entity.text(2)))];
          block->base = entity.point(10);
        } else if (entity.type == "ENDBLK") {
          block = nullptr;
        } else if (block != nullptr) {
          add(block->entities, entity);
        }
      } else if (section == "ENTITIES") {
        add(model_, entity);
      }
    }
  }

  /// Parts of polylines and inserts go with their heads.
  static void add(std::vector<Entity>& entities, const Entity& entity) {
    if ((entity.type == "VERTEX" || entity.type == "SEQEND") && !entities.empty() &&
        entities.back().type == "POLYLINE") {
      Entity& head = entities.back();
      head.groups = {head.groups.data(),
                     static_cast<std::size_t>(entity.groups.data() + entity.groups.size() -
                                              head.groups.data())};
      return;
    }
    entities.push_back(entity);
  }

  void read_header(std::span<const Group> groups) {
    std::string_view variable, version, stated_page;
    for (const Group& group : groups) {
      if (group.code == 9)
        variable = trimmed(group.value);
      else if (variable == "$DWGCODEPAGE")
        stated_page = trimmed(group.value);
      else if (variable == "$ACADVER")
        version = trimmed(group.value);
      else if (variable == "$INSUNITS")
        set_unit(static_cast<int>(std::clamp(number(group.value), -1.0, 1e3)));
    }
    if (version < "AC1021") code_page_ = std::string(stated_page);  // From 2007 on it is UTF-8.
  }

  /// $INSUNITS of the DXF reference; what is no unit of buildings counts as nothing stated.
  void set_unit(int unit) {
    static const std::map<int, std::pair<const char*, double>> units = {
        {1, {"inch", 0.0254}}, {2, {"foot", 0.3048}},  {4, {"mm", 0.001}}, {5, {"cm", 0.01}},
        {6, {"m", 1}},         {10, {"yard", 0.9144}}, {14, {"dm", 0.1}}};
    const auto found = units.find(unit);
    if (found == units.end()) return;
    drawing_.unit = found->second.first;
    drawing_.metres_per_unit = found->second.second;
  }

  void read_layer(const Entity& entity) {
    const bool off = entity.real(62, 7) < 0, frozen = (entity.whole(70) & 1) != 0;
    const std::string name(trimmed(entity.text(2)));
    if (off || frozen) hidden_.insert_or_assign(name, true);
    if (is_dashed(trimmed(entity.text(6)))) dashed_layers_.insert(name);
  }

  /// Axes, what lies above or below, and limits are drawn in dashes and dots; walls are not.
  static bool is_dashed(std::string_view line_type) {
    static constexpr std::string_view dashed[] = {
        "CENTER", "CENTRE",    "DASH",  "DOT",   "HIDDEN", "PHANTOM", "DIVIDE",
        "BORDER", "ACAD_ISO0", "JIS_0", "ACHSE", "STRICH", "AXE",     "AXES"};
    std::string name(line_type.substr(line_type.find_last_of("$|") + 1));
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return std::ranges::any_of(dashed,
                               [&](std::string_view each) { return name.starts_with(each); }) &&
           name != "ACAD_ISO01W100";
  }

  bool is_dashed(const Entity& entity, std::string_view layer) const {
    const Group* own = entity.find(6);
    if (own == nullptr || trimmed(own->value) == "BYLAYER" || trimmed(own->value) == "ByLayer")
      return dashed_layers_.contains(std::string(layer));
    return is_dashed(trimmed(own->value));
  }

  std::uint32_t layer_of(std::string_view name) {
    const auto [found, fresh] = layer_index_.try_emplace(
        std::string(name), static_cast<std::uint32_t>(drawing_.layers.size()));
    if (fresh) drawing_.layers.push_back(to_utf8(name, code_page_));
    return found->second;
  }

  /// A block's entities on layer 0 lie on the layer of the INSERT.
  struct Inserted {
    std::string_view layer;
  };

  void draw(const Entity& entity, const Transform& outer, const Inserted* inserted, int depth) {
    if (entity.whole(67) == 1) return;  // Paper space.
    if (entity.whole(60) == 1) return;  // Invisible.
    std::string_view layer = trimmed(entity.text(8));
    if (inserted != nullptr && (layer.empty() || layer == "0")) layer = inserted->layer;
    if (hidden_.contains(std::string(layer))) {
      ++drawing_.left_out["entities on layers that are off or frozen"];
      return;
    }
    layer_ = layer_of(layer);
    dashed_ = is_dashed(entity, layer);
    of_block_ = inserted != nullptr;
    const std::string_view type = entity.type;
    if (type == "LINE")
      stroke(outer(entity.point(10)), outer(entity.point(11)));
    else if (type == "LWPOLYLINE")
      draw_light_polyline(entity, outer * object_frame(entity));
    else if (type == "POLYLINE")
      draw_polyline(entity, outer * object_frame(entity));
    else if (type == "ARC" || type == "CIRCLE")
      draw_arc(entity, outer * object_frame(entity));
    else if (type == "ELLIPSE")
      draw_ellipse(entity, outer);
    else if (type == "SPLINE")
      draw_spline(entity, outer);
    else if (type == "TEXT" || type == "MTEXT" || type == "ATTRIB")
      write_text(entity, type == "MTEXT" ? outer : outer * object_frame(entity));
    else if (type == "INSERT")
      insert(entity, outer * object_frame(entity), layer, depth);
    else if (type != "SEQEND" && type != "VERTEX")
      ++drawing_.left_out[to_utf8(type.substr(0, 40), "")];
  }

  void stroke(Vec2 a, Vec2 b, bool of_curve = false) {
    if (drawing_.segments.size() >= most_strokes)
      throw error_at(0, fmt::format("holds more than {} strokes", most_strokes),
                     "save only the floor plan's layers");
    if (!std::isfinite(a.x + a.y + b.x + b.y)) {
      ++drawing_.left_out["strokes without an end"];
      return;
    }
    if (a != b) drawing_.segments.push_back({a, b, layer_, of_curve, arc_, of_block_, dashed_});
  }

  /// `at(t)`, t from 0 to 1, in equal steps.
  template <typename Curve>
  void strokes(const Curve& at, int steps) {
    Vec2 last = at(0.0);
    for (int i = 1; i <= steps; ++i) {
      const Vec2 next = at(static_cast<double>(i) / steps);
      stroke(last, next, true);
      last = next;
    }
  }

  /// Steps of about six degrees: a round room of 10 m keeps its area to 0.2 %.
  static int steps_of(double sweep) {
    return std::clamp(static_cast<int>(std::ceil(std::abs(sweep) / (pi / 30))), 1, 240);
  }

  void draw_circle_part(Vec2 centre, double radius, double from, double sweep,
                        const Transform& place) {
    const auto at = [&](double t) {
      const double angle = from + t * sweep;
      return place(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    };
    const double scaled = radius * place.scale();
    const bool is_arc = place.keeps_circles() && std::isfinite(scaled) && scaled > 0 &&
                        std::abs(sweep) < 2 * pi - 1e-9;
    if (is_arc) {
      arc_ = static_cast<std::uint32_t>(drawing_.arcs.size());
      drawing_.arcs.push_back({place(centre), at(0), at(1), scaled, std::abs(sweep), layer_});
    }
    strokes(at, steps_of(sweep));
    arc_ = no_arc;
  }

  void draw_arc(const Entity& entity, const Transform& place) {
    double from = 0, sweep = 2 * pi;
    if (entity.type == "ARC") {
      from = entity.real(50) * pi / 180;
      sweep = std::fmod(entity.real(51) * pi / 180 - from, 2 * pi);
      if (sweep <= 0) sweep += 2 * pi;
    }
    draw_circle_part(entity.point(10), entity.real(40), from, sweep, place);
  }

  void draw_ellipse(const Entity& entity, const Transform& place) {
    const Vec2 centre = entity.point(10), major = entity.point(11);
    const double ratio = entity.real(40, 1), from = entity.real(41, 0);
    double sweep = std::fmod(entity.real(42, 2 * pi) - from, 2 * pi);
    if (sweep <= 1e-9) sweep += 2 * pi;
    const Vec2 minor = ratio * left_of(major) * (entity.real(230, 1) < 0 ? -1.0 : 1.0);
    strokes(
        [&](double t) {
          const double angle = from + t * sweep;
          return place(centre + std::cos(angle) * major + std::sin(angle) * minor);
        },
        steps_of(sweep));
  }

  /// A B-spline by its control points (de Boor), or through its fit points where it has no others.
  void draw_spline(const Entity& entity, const Transform& place) {
    std::vector<double> knots, weights;
    std::vector<Vec2> control, fit;
    for (const Group& group : entity.groups) {
      if (group.code == 40) knots.push_back(number(group.value));
      if (group.code == 41) weights.push_back(number(group.value, 1));
      if (group.code == 10) control.push_back({number(group.value), 0});
      if (group.code == 20 && !control.empty()) control.back().y = number(group.value);
      if (group.code == 11) fit.push_back({number(group.value), 0});
      if (group.code == 21 && !fit.empty()) fit.back().y = number(group.value);
    }
    const std::size_t degree = static_cast<std::size_t>(std::clamp(entity.whole(71, 3), 1, 10));
    if (control.size() <= degree || knots.size() != control.size() + degree + 1 ||
        !std::ranges::is_sorted(knots)) {
      const std::vector<Vec2>& through = fit.size() > 1 ? fit : control;
      for (std::size_t i = 1; i < through.size(); ++i)
        stroke(place(through[i - 1]), place(through[i]), true);
      return;
    }
    weights.resize(control.size(), 1);
    const double begin = knots[degree], end = knots[control.size()];
    strokes(
        [&](double t) {
          return place(spline_at(begin + t * (end - begin), degree, knots, control, weights));
        },
        static_cast<int>(std::min<std::size_t>(8 * control.size(), 2000)));
  }

  static Vec2 spline_at(double u, std::size_t degree, const std::vector<double>& knots,
                        const std::vector<Vec2>& control, const std::vector<double>& weights) {
    std::size_t span = degree;
    while (span + 1 < control.size() && u >= knots[span + 1]) ++span;
    std::vector<glm::dvec3> d;
    for (std::size_t j = 0; j <= degree; ++j) {
      const std::size_t i = span - degree + j;
      d.emplace_back(weights[i] * control[i].x, weights[i] * control[i].y, weights[i]);
    }
    for (std::size_t r = 1; r <= degree; ++r)
      for (std::size_t j = degree; j >= r; --j) {
        const std::size_t i = span - degree + j;
        const double width = knots[i + degree - r + 1] - knots[i];
        const double a = width > 0 ? (u - knots[i]) / width : 0;
        d[j] = (1 - a) * d[j - 1] + a * d[j];
      }
    const double w = d[degree].z;
    return w != 0 ? Vec2{d[degree].x / w, d[degree].y / w} : control[span];
  }

  struct BulgedCorner {
    Vec2 at{};
    double bulge = 0;  ///< The tangent of a quarter of the sweep of the arc to the next corner.
  };

  void draw_light_polyline(const Entity& entity, const Transform& place) {
    std::vector<BulgedCorner> corners;
    for (const Group& group : entity.groups) {
      if (group.code == 10) corners.push_back({{number(group.value), 0}, 0});
      if (corners.empty()) continue;
      if (group.code == 20) corners.back().at.y = number(group.value);
      if (group.code == 42) corners.back().bulge = number(group.value);
    }
    draw_corners(corners, (entity.whole(70) & 1) != 0, entity.line(), place);
  }

  void draw_polyline(const Entity& entity, const Transform& place) {
    std::vector<BulgedCorner> corners;
    bool in_vertex = false, meshed = (entity.whole(70) & (16 | 64)) != 0;
    const bool closed = (entity.whole(70) & 1) != 0;
    if (meshed) {
      ++drawing_.left_out["meshes"];
      return;
    }
    for (const Group& group : entity.groups) {
      if (group.code == 0) {
        in_vertex = trimmed(group.value) == "VERTEX";
        if (in_vertex) corners.emplace_back();
      }
      if (!in_vertex) continue;
      if (group.code == 10) corners.back().at.x = number(group.value);
      if (group.code == 20) corners.back().at.y = number(group.value);
      if (group.code == 42) corners.back().bulge = number(group.value);
    }
    draw_corners(corners, closed, entity.line(), place);
  }

  void draw_corners(std::vector<BulgedCorner>& corners, bool closed, std::uint32_t line,
                    const Transform& place) {
    if (corners.size() < 2) return;
    // Many programs close a polyline by drawing its first corner again.
    if (corners.size() > 3 && corners.front().at == corners.back().at) {
      corners.pop_back();
      closed = true;
    }
    const std::size_t first_stroke = drawing_.segments.size();
    const std::size_t count = corners.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i)
      draw_bulge(corners[i], corners[(i + 1) % corners.size()].at, place);
    if (!closed) return;
    DrawnRing ring{{}, layer_, line};
    for (std::size_t i = first_stroke; i < drawing_.segments.size(); ++i)
      ring.corners.push_back(drawing_.segments[i].a);
    if (ring.corners.size() >= 3) drawing_.rings.push_back(std::move(ring));
  }

  void draw_bulge(const BulgedCorner& from, Vec2 to, const Transform& place) {
    if (std::abs(from.bulge) < 1e-6 || from.at == to) {
      stroke(place(from.at), place(to));
      return;
    }
    const double sweep = 4 * std::atan(from.bulge);
    const Vec2 chord = to - from.at;
    const Vec2 centre =
        from.at + 0.5 * chord + left_of(chord) * (1 - from.bulge * from.bulge) / (4 * from.bulge);
    const Vec2 arm = from.at - centre;
    draw_circle_part(centre, glm::length(arm), std::atan2(arm.y, arm.x), sweep, place);
  }

  void write_text(const Entity& entity, const Transform& place) {
    std::string raw;
    for (const Group& group : entity.groups)
      if (group.code == 3 && entity.type == "MTEXT") raw += group.value;
    raw += entity.text(1);
    if (entity.type == "ATTRIB" && (entity.whole(70) & 1) != 0) return;  // Invisible.
    const std::string text = entity.type == "MTEXT" ? without_formatting(to_utf8(raw, code_page_))
                                                    : without_controls(to_utf8(raw, code_page_));
    if (text.find_first_not_of(" \n") == std::string::npos) return;
    drawing_.texts.push_back(
        {text, place(middle_of(entity, text)), entity.real(40) * place.scale(), layer_});
  }

  /// The middle of the letters, at 0.6 of their height a letter: the point that must lie in the
  /// room.
  static Vec2 middle_of(const Entity& entity, const std::string& text) {
    const double height = entity.real(40, 1);
    const TextExtent extent = extent_of(text);
    const double width = 0.6 * height * extent.columns;
    const double angle = entity.type == "MTEXT" && entity.find(11) != nullptr
                             ? std::atan2(entity.real(21), entity.real(11))
                             : entity.real(50) * (entity.type == "MTEXT" ? 1 : pi / 180);
    double across = 0.5, up = 0.5;  // From the anchor to the middle, in widths and heights.
    Vec2 anchor = entity.point(10);
    double tall = height;
    if (entity.type == "MTEXT") {
      const int attachment = std::clamp(entity.whole(71, 1), 1, 9) - 1;
      across = 0.5 - 0.5 * (attachment % 3);
      up = 0.5 * std::floor(attachment / 3.0) - 0.5;
      tall = 1.5 * height * extent.lines;
    } else if (const int justified = entity.whole(72);
               (justified != 0 || entity.whole(73) != 0) && entity.find(11) != nullptr) {
      if (justified == 1 || justified == 4) across = 0;
      if (justified == 2) across = -0.5;
      if (justified == 3 || justified == 5) return 0.5 * (anchor + entity.point(11));
      if (justified == 4 || entity.whole(73) == 2) up = 0;
      if (entity.whole(73) == 3) up = -0.5;
      anchor = entity.point(11);
    }
    const Vec2 along{std::cos(angle), std::sin(angle)};
    return anchor + across * width * along + up * tall * left_of(along);
  }

  void insert(const Entity& entity, const Transform& place, std::string_view layer, int depth) {
    const auto found = blocks_.find(std::string(trimmed(entity.text(2))));
    if (found == blocks_.end() || depth >= deepest_block) {
      ++drawing_.left_out["inserts of blocks that are not there or too deep"];
      return;
    }
    const Block& block = found->second;
    const double angle = entity.real(50) * pi / 180;
    const Vec2 along{std::cos(angle), std::sin(angle)};
    const double sx = entity.real(41, 1), sy = entity.real(42, 1);
    const int columns = std::clamp(entity.whole(70, 1), 1, 1000);
    const int rows = std::clamp(entity.whole(71, 1), 1, 1000);
    const Inserted inserted{layer};
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        Transform own{sx * along, sy * left_of(along), entity.point(10)};
        own.offset += column * entity.real(44) * along + row * entity.real(45) * left_of(along);
        own.offset = own(-block.base);
        // Each drawn entity costs, even one that draws nothing: blocks in blocks grow beyond use.
        for (const Entity& part : block.entities) {
          if (++inserted_parts_ > most_strokes)
            throw error_at(entity.line(), "puts blocks into blocks without end",
                           "explode the blocks, or save only the floor plan's layers");
          if (part.type != "ATTDEF") draw(part, place * own, &inserted, depth + 1);
        }
      }
  }

  std::string file_;
  std::vector<Group> groups_;
  std::unordered_map<std::string, Block> blocks_;
  std::vector<Entity> model_;
  std::unordered_map<std::string, bool> hidden_;
  std::unordered_set<std::string> dashed_layers_;
  std::unordered_map<std::string, std::uint32_t> layer_index_;
  std::string code_page_;
  Drawing drawing_;
  std::uint32_t layer_ = 0;
  std::uint32_t arc_ = no_arc;
  bool of_block_ = false, dashed_ = false;
  bool entities_found_ = false;
  std::size_t inserted_parts_ = 0;
};

bool is_binary(std::string_view bytes) {
  return bytes.starts_with("AutoCAD Binary DXF");
}
bool is_dwg(std::string_view bytes) {
  return bytes.size() > 6 && bytes.starts_with("AC10") &&
         std::isdigit(static_cast<unsigned char>(bytes[4])) &&
         std::isdigit(static_cast<unsigned char>(bytes[5]));
}

}  // namespace

bool looks_like_dxf(std::string_view bytes) {
  if (is_binary(bytes) || is_dwg(bytes)) return true;
  const std::string_view head = bytes.substr(0, 4096);
  const std::size_t section = head.find("SECTION");
  if (section == std::string_view::npos) return false;
  const std::string_view before = trimmed(head.substr(0, head.find_first_of("\r\n")));
  return before == "0" || before == "999" ||
         before ==
             "\xef\xbb\xbf"
             "0";
}

Drawing parse_dxf(const std::string& file, std::string_view bytes) {
  if (is_dwg(bytes))
    throw content::ContentError(
        file, 0, 0, "unreadable-dxf",
        "this is a DWG drawing, which only AutoCAD's own makers document",
        "save it as DXF in the program that made it, or ask the architect for the DXF");
  if (is_binary(bytes))
    throw content::ContentError(file, 0, 0, "unreadable-dxf", "this is a DXF in its binary form",
                                "save it as DXF in its text form (ASCII)");
  return DxfReader(file, bytes).read();
}

}  // namespace docent::import

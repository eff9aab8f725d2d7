#pragma once

#include <string>
#include <string_view>

#include "runtime/model/geometry/vec2.h"

namespace docent::draw {

/// The house's colours (sRGB), for drawings of what the database knows.
namespace ink {
inline constexpr std::string_view paper = "#F5F1E8";
inline constexpr std::string_view floor = "#FBF8F1";
inline constexpr std::string_view plaster = "#E9E3D7";
inline constexpr std::string_view cut_face = "#3A3632";
inline constexpr std::string_view oak = "#B98F62";
inline constexpr std::string_view stone = "#BDB6A8";
inline constexpr std::string_view black = "#1E1C1A";
inline constexpr std::string_view quiet = "#544D46";
inline constexpr std::string_view vermilion = "#D2452D";
inline constexpr std::string_view teal = "#1D7874";
inline constexpr std::string_view ochre = "#C0841A";
}  // namespace ink

/// A colour between `from` (`part` 0) and `to` (`part` 1); all are "#RRGGBB".
std::string mixed(std::string_view from, std::string_view to, double part);

/// The data of an SVG path, in pixels.
class PathData {
 public:
  PathData& move_to(Vec2 p);
  PathData& line_to(Vec2 p);
  PathData& curve_to(Vec2 control, Vec2 p);  ///< A quadratic Bezier curve.
  PathData& close();

  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
};

/// A drawing of a given size in pixels. Things drawn later lie on top.
class Svg {
 public:
  Svg(double width, double height);

  /// `style` is a row of presentation attributes: `fill="none" stroke="#1E1C1A"`.
  void path(const PathData& data, std::string_view style);
  void circle(Vec2 centre, double radius, std::string_view style);
  void rectangle(Vec2 corner, Vec2 size, std::string_view style);
  /// Defines a calm pattern of slanting lines, which `fill="url(#name)"` fills with.
  void hatch(std::string_view name, std::string_view ground, std::string_view line);
  void text(Vec2 at, std::string_view words, std::string_view style);
  /// The whole of another drawing, its upper left corner at `corner`.
  void embed(const Svg& drawing, Vec2 corner);
  /// Until the matching end_group, everything has these attributes.
  void begin_group(std::string_view attributes);
  void end_group();

  [[nodiscard]] Vec2 size() const noexcept { return {width_, height_}; }
  /// The whole document.
  [[nodiscard]] std::string document() const;

 private:
  double width_, height_;
  std::string body_;
};

}  // namespace docent::draw

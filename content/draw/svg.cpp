#include "content/draw/svg.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

namespace docent::draw {
namespace {

/// Red, green and blue, 0 to 255.
std::array<int, 3> channels_of(std::string_view colour) {
  std::array<int, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view digits = colour.substr(1 + 2 * i, 2);
    std::from_chars(digits.data(), digits.data() + digits.size(), channels[i], 16);
  }
  return channels;
}

std::string escaped(std::string_view words) {
  std::string result;
  for (const char c : words) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace

std::string mixed(std::string_view from, std::string_view to, double part) {
  const auto a = channels_of(from), b = channels_of(to);
  std::array<long, 3> c{};
  for (std::size_t i = 0; i < 3; ++i) c[i] = std::lround(std::lerp(a[i], b[i], part));
  return fmt::format("#{:02X}{:02X}{:02X}", c[0], c[1], c[2]);
}

PathData& PathData::move_to(Vec2 p) {
  fmt::format_to(std::back_inserter(text_), "M{:.2f} {:.2f}", p.x, p.y);
  return *this;
}
PathData& PathData::line_to(Vec2 p) {
  fmt::format_to(std::back_inserter(text_), "L{:.2f} {:.2f}", p.x, p.y);
  return *this;
}
PathData& PathData::curve_to(Vec2 control, Vec2 p) {
  fmt::format_to(std::back_inserter(text_), "Q{:.2f} {:.2f} {:.2f} {:.2f}", control.x, control.y,
                 p.x, p.y);
  return *this;
}
PathData& PathData::close() {
  text_ += 'Z';
  return *this;
}

Svg::Svg(double width, double height) : width_(width), height_(height) {}

void Svg::path(const PathData& data, std::string_view style) {
  fmt::format_to(std::back_inserter(body_), "<path d=\"{}\" {}/>\n", data.text(), style);
}
void Svg::circle(Vec2 centre, double radius, std::string_view style) {
  fmt::format_to(std::back_inserter(body_),
                 "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", centre.x, centre.y,
                 radius, style);
}
void Svg::rectangle(Vec2 corner, Vec2 size, std::string_view style) {
  fmt::format_to(std::back_inserter(body_),
                 "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n",
                 corner.x, corner.y, size.x, size.y, style);
}
void Svg::hatch(std::string_view name, std::string_view ground, std::string_view line) {
  fmt::format_to(std::back_inserter(body_),
                 "<defs><pattern id=\"{}\" patternUnits=\"userSpaceOnUse\" width=\"10\" "
                 "height=\"10\" patternTransform=\"rotate(45)\"><rect width=\"10\" height=\"10\" "
                 "fill=\"{}\"/><rect width=\"1.4\" height=\"10\" fill=\"{}\"/></pattern></defs>\n",
                 name, ground, line);
}
void Svg::text(Vec2 at, std::string_view words, std::string_view style) {
  fmt::format_to(std::back_inserter(body_), "<text x=\"{:.2f}\" y=\"{:.2f}\" {}>{}</text>\n", at.x,
                 at.y, style, escaped(words));
}
void Svg::begin_group(std::string_view attributes) {
  fmt::format_to(std::back_inserter(body_), "<g {}>\n", attributes);
}
void Svg::end_group() {
  body_ += "</g>\n";
}

void Svg::embed(const Svg& drawing, Vec2 corner) {
  begin_group(fmt::format("transform=\"translate({:.2f} {:.2f})\"", corner.x, corner.y));
  body_ += drawing.body_;
  end_group();
}

std::string Svg::document() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\">\n{2}</svg>\n",
      width_, height_, body_);
}

}  // namespace docent::draw

#include "content/draw/plan/plan_signs.h"

#include <fmt/format.h>

#include <span>
#include <vector>

namespace docent::draw {
namespace {

/// Lines in a box from (-1, -1) to (1, 1), y down.
using Strokes = std::vector<std::vector<Vec2>>;

Strokes strokes_of(ConnectionKind kind) {
  switch (kind) {
    case ConnectionKind::Stairs:
      return {{{-0.65, 0.5},
               {-0.25, 0.5},
               {-0.25, 0.17},
               {0.1, 0.17},
               {0.1, -0.16},
               {0.45, -0.16},
               {0.45, -0.5},
               {0.7, -0.5}}};
    case ConnectionKind::Escalator:
      return {{{-0.7, 0.5}, {-0.4, 0.5}, {0.4, -0.4}, {0.7, -0.4}},
              {{-0.6, 0.1}, {0.1, -0.7}},
              {{0.1, -0.3}, {0.1, -0.7}, {-0.3, -0.66}}};
    case ConnectionKind::Lift:
      return {{{-0.55, -0.65}, {0.55, -0.65}, {0.55, 0.65}, {-0.55, 0.65}, {-0.55, -0.65}},
              {{-0.3, -0.12}, {0, -0.42}, {0.3, -0.12}},
              {{-0.3, 0.12}, {0, 0.42}, {0.3, 0.12}}};
    case ConnectionKind::Ramp:
      return {{{-0.7, 0.4}, {0.7, -0.4}, {0.7, 0.4}, {-0.7, 0.4}}};
  }
  return {};
}

bool leads(const Connection& connection, std::size_t from, std::size_t to) {
  return connection.direction == ConnectionDirection::Both ||
         (connection.direction == ConnectionDirection::Up) == (from < to);
}

}  // namespace

void draw_sign(Svg& svg, const Connection& connection, Vec2 at, double size) {
  const double half = size / 2;
  const std::string_view ground = connection.closed ? ink::vermilion : ink::teal;
  svg.rectangle(at - Vec2{half, half}, {size, size},
                fmt::format(R"(rx="{:.1f}" fill="{}" stroke="{}" stroke-width="2")", 0.2 * size,
                            ground, ink::floor));
  Strokes strokes = strokes_of(connection.kind);
  if (connection.closed) strokes.push_back({{-0.8, -0.8}, {0.8, 0.8}});
  for (const std::vector<Vec2>& stroke : strokes) {
    PathData path;
    path.move_to(at + half * stroke.front());
    for (const Vec2 p : std::span(stroke).subspan(1)) path.line_to(at + half * p);
    svg.path(path, fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.1f}" )"
                               R"(stroke-linejoin="round" stroke-linecap="round")",
                               ink::floor, 0.1 * size));
  }
}

std::string words_at_stop(const Museum& museum, const Connection& connection, std::size_t stop) {
  std::string to, from;
  for (std::size_t i = 0; i < connection.stops.size(); ++i) {
    if (i == stop) continue;
    std::string& list = leads(connection, stop, i) ? to : from;
    if (!list.empty()) list += ", ";
    list += museum.floors[connection.stops[i].floor].plan.short_name;
  }
  std::string words = connection.id;
  if (!to.empty()) words += " to " + to;
  if (!from.empty()) words += " from " + from;
  return connection.closed ? words + ", closed" : words;
}

}  // namespace docent::draw

#include "content/draw/plan/plan_legend.h"

#include <fmt/format.h>

#include <algorithm>

#include "content/draw/plan/plan_rings.h"
#include "content/draw/plan/plan_signs.h"
#include "content/draw/plan/plan_style.h"

namespace docent::draw {
namespace {

// Pixels.
constexpr double row = 36;
constexpr double symbol_width = 52;
constexpr double gap = 12;
constexpr double between = 34;
constexpr double legend_letter = 18;
constexpr double width_per_letter = 0.54 * legend_letter;  // Of a sans in lower case.

double width_of(const std::string& words) {
  return symbol_width + gap + width_per_letter * static_cast<double>(words.size());
}

}  // namespace

PlanLegend::PlanLegend(const FloorPlan& plan, const PlanLayers& layers,
                       const std::vector<DrawnLine>& lines) {
  if (layers.walls) add_walls(plan);
  if (layers.regions) entries_.push_back({Symbol::Regions, "Voronoi regions"});
  if (layers.skeleton) entries_.push_back({Symbol::MedialAxis, "medial axis, narrow to wide"});
  if (layers.sites) {
    entries_.push_back({Symbol::WallSites, "walls as sites, in turn"});
    entries_.push_back({Symbol::Corner, "reflex corner"});
  }
  if (layers.connections) entries_.push_back({Symbol::Stop, "way to other floors, and to which"});
  add_lines(lines);
}

void PlanLegend::add_walls(const FloorPlan& plan) {
  entries_.push_back({Symbol::Wall, "wall, cut through"});
  if (has_role(plan, RingRole::Case)) entries_.push_back({Symbol::Case, "case, plinth or column"});
  if (has_role(plan, RingRole::Block)) entries_.push_back({Symbol::Block, "closed block"});
  if (!std::ranges::all_of(plan.doors, &Door::closed))
    entries_.push_back({Symbol::OpenDoor, "door"});
  if (std::ranges::any_of(plan.doors, &Door::closed))
    entries_.push_back({Symbol::ClosedDoor, "closed door"});
}

void PlanLegend::add_lines(const std::vector<DrawnLine>& lines) {
  const auto first = [&lines](std::optional<RouteKind> kind, bool closed) {
    return std::ranges::find_if(lines, [kind, closed](const DrawnLine& line) {
      return line.kind == kind && line.closed == closed;
    });
  };
  if (const auto level = first({}, true); level != lines.end())
    entries_.push_back({Symbol::Levels, fmt::format("clearance, every {:g} m", level->clearance)});
  for (const RouteKindInfo& info : route_kinds)
    if (first(info.kind, false) != lines.end())
      entries_.push_back({Symbol::Way, std::string(info.legend), info.kind});
  if (const auto curve = first(RouteKind::Offset, true); curve != lines.end())
    entries_.push_back(
        {Symbol::OffsetCurve, fmt::format("{:g} m from the walls", curve->clearance)});
}

std::vector<Vec2> PlanLegend::places(double width) const {
  std::vector<Vec2> places;
  Vec2 at{0, 0};
  for (const Entry& entry : entries_) {
    if (at.x > 0 && at.x + width_of(entry.words) > width) at = {0, at.y + row};
    places.push_back(at);
    at.x += width_of(entry.words) + between;
  }
  return places;
}

double PlanLegend::height(double width) const {
  const std::vector<Vec2> all = places(width);
  return all.empty() ? 0 : all.back().y + row;
}

void PlanLegend::draw_symbol(Svg& svg, const Entry& entry, Vec2 at) {
  const Vec2 left = at + Vec2{0, row / 2}, right = left + Vec2{symbol_width, 0};
  const auto line = [&](const std::string& style) {
    svg.path(PathData().move_to(left + Vec2{4, 0}).line_to(right - Vec2{4, 0}), style);
  };
  const auto swatch = [&](std::string_view fill, double edge) {
    svg.rectangle(
        left + Vec2{4, -9}, {symbol_width - 8, 18},
        fmt::format(R"(fill="{}" stroke="{}" stroke-width="{}")", fill, ink::cut_face, edge));
  };
  switch (entry.symbol) {
    case Symbol::Wall:
      swatch(ink::cut_face, 1.6);
      break;
    case Symbol::Case:
      swatch(ink::plaster, 1.6);
      break;
    case Symbol::Block:
      swatch(fmt::format("url(#{})", block_hatch), 3);
      break;
    case Symbol::OpenDoor:
    case Symbol::ClosedDoor: {
      Door door;
      door.closed = entry.symbol == Symbol::ClosedDoor;
      line(door_stroke(door));
      break;
    }
    case Symbol::WallSites:
      for (std::size_t i = 0; i < 3; ++i)
        svg.path(PathData()
                     .move_to(left + Vec2{static_cast<double>(i) * symbol_width / 3, 0})
                     .line_to(left + Vec2{static_cast<double>(i + 1) * symbol_width / 3, 0}),
                 wall_site_stroke(i));
      break;
    case Symbol::Regions:
      for (std::size_t i = 0; i < 4; ++i)
        svg.rectangle(left + Vec2{static_cast<double>(i) * symbol_width / 4, -9},
                      {symbol_width / 4, 18}, fmt::format(R"(fill="{}")", region_colour(i)));
      break;
    case Symbol::MedialAxis:
      for (int i = 0; i < 4; ++i)
        svg.path(PathData()
                     .move_to(left + Vec2{i * symbol_width / 4, 0})
                     .line_to(left + Vec2{(i + 1) * symbol_width / 4, 0}),
                 axis_stroke(0.1 + 0.3 * i));
      break;
    case Symbol::Levels:
      for (const double inset : {0.0, 6.0, 12.0})
        svg.rectangle(left + Vec2{inset, inset / 2 - 9}, Vec2{symbol_width - 2 * inset, 18 - inset},
                      level_style(3));
      break;
    case Symbol::Corner:
      svg.circle(left + Vec2{symbol_width / 2, 0}, 4, fmt::format(R"(fill="{}")", ink::vermilion));
      break;
    case Symbol::Stop:
      draw_sign(svg, {}, left + Vec2{symbol_width / 2, 0}, 26);
      break;
    case Symbol::Way:
      line(way_stroke(info_of(entry.kind), 6));
      break;
    case Symbol::OffsetCurve:
      line(fmt::format(R"(stroke="{}" stroke-width="3")", ink::ochre));
      break;
  }
}

void PlanLegend::draw(Svg& svg, Vec2 at, double width) const {
  const std::vector<Vec2> all = places(width);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    draw_symbol(svg, entries_[i], at + all[i]);
    svg.text(at + all[i] + Vec2{symbol_width + gap, row / 2 + 0.35 * legend_letter},
             entries_[i].words,
             fmt::format(R"(font-family="Inter, Noto Sans, sans-serif" font-size="{}" fill="{}")",
                         legend_letter, ink::quiet));
  }
}

}  // namespace docent::draw

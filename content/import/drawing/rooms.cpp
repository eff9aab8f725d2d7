#include "content/import/drawing/rooms.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "content/import/drawing/choose_lines.h"
#include "content/import/drawing/close_plan.h"
#include "content/import/drawing/drawn_box.h"
#include "content/import/drawing/face_rooms.h"
#include "content/import/drawing/find_doors.h"
#include "content/import/drawing/floor_words.h"
#include "content/import/drawing/inscribed.h"
#include "content/import/drawing/outlined_rooms.h"
#include "content/import/drawing/parts.h"
#include "content/import/drawing/tidy_rooms.h"

namespace docent::import {
namespace {

constexpr std::size_t most_lines = 120'000;
constexpr double widest_plan = 20'000;  ///< Metres across.

/// Finds the rooms of lines that lie together.
class PlanFinder {
 public:
  PlanFinder(const Drawing& drawing, std::vector<WallLine> lines, std::span<const Swing> swings,
             std::span<const Flight> flights, FoundPlans& found)
      : drawing_(drawing), lines_(std::move(lines)), flights_(flights), found_(found) {
    for (const WallLine& line : lines_) {
      box_.add(line.a);
      box_.add(line.b);
    }
    plan_.low = box_.low;
    plan_.high = box_.high;
    for (const Swing& swing : swings)
      if (box_.holds(swing.hinge)) swings_.push_back(swing);
  }

  std::size_t swings() const { return swings_.size(); }

  FoundPlan find() {
    const std::optional<ClosedPlan> closed = close_plan(std::move(lines_), swings_, found_);
    if (!closed) return std::move(plan_);
    RoomFaces faces = find_face_rooms(*closed, plan_, found_);
    find_doors(*closed, faces, plan_, found_);
    tidy_rooms(drawing_, std::move(faces), plan_, found_);
    add_stairs(flights_, box_, plan_);
    return std::move(plan_);
  }

 private:
  const Drawing& drawing_;
  std::vector<WallLine> lines_;
  std::span<const Flight> flights_;
  std::vector<Swing> swings_;
  FoundPlans& found_;
  FoundPlan plan_;
  DrawnBox box_;
};

std::size_t rooms_with_doors(const FoundPlan& plan) {
  return static_cast<std::size_t>(
      std::ranges::count_if(plan.rooms, [](const FoundRoom& room) { return room.doors > 0; }));
}

std::size_t rooms_with_doors(const FoundPlans& found) {
  std::size_t count = 0;
  for (const FoundPlan& plan : found.plans) count += rooms_with_doors(plan);
  return count;
}

/// A plan's title stands above or below it, in no room, nearer to it than to any other.
void read_titles(const Drawing& drawing, std::vector<FoundPlan>& plans) {
  constexpr double farthest_title = 12;  // Metres.
  for (const DrawnText& text : drawing.texts) {
    const auto ordinal = floor_said(text.text);
    if (!ordinal) continue;
    FoundPlan* nearest = nullptr;
    double away = farthest_title;
    for (FoundPlan& plan : plans) {
      const Vec2 beside = glm::clamp(text.at, plan.low, plan.high);
      const bool in_a_room = std::ranges::any_of(
          plan.rooms, [&](const FoundRoom& room) { return inside(room.rings, text.at); });
      if (in_a_room || glm::distance(beside, text.at) >= away) continue;
      away = glm::distance(beside, text.at);
      nearest = &plan;
    }
    if (nearest == nullptr || nearest->ordinal) continue;
    nearest->ordinal = ordinal;
    nearest->title = text.text.substr(0, text.text.find('\n'));
  }
}

/// Could both be floors of one building, drawn side by side? They are about as large, in one row or
/// one column, and each has rooms enough.
bool are_floors(const FoundPlan& a, const FoundPlan& b) {
  constexpr std::size_t fewest_rooms = 4;
  if (a.ordinal && b.ordinal) return *a.ordinal != *b.ordinal;
  if (rooms_with_doors(a) < fewest_rooms || rooms_with_doors(b) < fewest_rooms) return false;
  const Vec2 size_a = a.high - a.low, size_b = b.high - b.low;
  const Vec2 less = glm::min(size_a, size_b), more = glm::max(size_a, size_b);
  if (less.x < 0.5 * more.x || less.y < 0.5 * more.y) return false;
  const Vec2 off = glm::min(glm::abs(a.low - b.low), glm::abs(a.high - b.high));
  return off.x < 0.1 * more.x || off.y < 0.1 * more.y;
}

/// What is no floor of its own is a wing of the nearest plan that is.
void join_wings(FoundPlans& found) {
  std::vector<FoundPlan>& plans = found.plans;
  if (plans.size() < 2) return;
  std::vector<FoundPlan> floors, wings;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    bool is_floor = false;
    for (std::size_t j = 0; j < plans.size(); ++j)
      is_floor = is_floor || (i != j && are_floors(plans[i], plans[j]));
    (is_floor || (i == 0 && floors.empty()) ? floors : wings).push_back(plans[i]);
  }
  const auto away = [](const FoundPlan& a, const FoundPlan& b) {
    return glm::length(glm::max(glm::max(a.low - b.high, b.low - a.high), Vec2(0)));
  };
  for (FoundPlan& wing : wings) {
    FoundPlan& nearest = *std::ranges::min_element(
        floors, {}, [&](const FoundPlan& floor) { return away(floor, wing); });
    std::ranges::move(wing.rooms, std::back_inserter(nearest.rooms));
    std::ranges::move(wing.doors, std::back_inserter(nearest.doors));
    std::ranges::move(wing.columns, std::back_inserter(nearest.columns));
    std::ranges::move(wing.stairs, std::back_inserter(nearest.stairs));
    nearest.low = glm::min(nearest.low, wing.low);
    nearest.high = glm::max(nearest.high, wing.high);
  }
  found.wings = wings.size();
  plans = std::move(floors);
}

/// The rooms of all strokes that could be walls by these kinds of layers.
FoundPlans find_by_lines(const Drawing& drawing, const std::vector<LayerKind>& kinds) {
  FoundPlans found;
  Chosen chosen = choose_lines(drawing, kinds, found);
  if (chosen.lines.size() > most_lines) {
    found.refused = fmt::format("{} strokes could be walls, more than the {} that are looked at",
                                chosen.lines.size(), most_lines);
    return found;
  }
  DrawnBox all;
  for (const WallLine& line : chosen.lines) {
    all.add(line.a);
    all.add(line.b);
  }
  if (const double across = glm::length(all.high - all.low);
      !chosen.lines.empty() && across > widest_plan) {
    found.refused =
        fmt::format("the lines lie {:.0f} km apart, which no building is wide", across / 1000);
    return found;
  }
  const std::vector<Flight> flights = take_flights(chosen, found);
  const std::vector<Swing> swings = swings_of(drawing, chosen, found);

  std::vector<PlanFinder> finders;
  std::size_t most_swings = 0;
  for (const std::vector<std::uint32_t>& part : parts_that_lie_together(chosen.lines)) {
    std::vector<WallLine> lines;
    for (const std::uint32_t i : part) lines.push_back(chosen.lines[i]);
    finders.emplace_back(drawing, std::move(lines), swings, flights, found);
    most_swings = std::max(most_swings, finders.back().swings());
  }
  for (PlanFinder& finder : finders) {
    // A section or a front has no swinging doors; where no plan has, the largest is the plan.
    const bool is_plan = most_swings > 0 ? finder.swings() > 0 : &finder == &finders.front();
    FoundPlan plan = is_plan ? finder.find() : FoundPlan{};
    const bool is_detail = 4 * finder.swings() < most_swings && rooms_with_doors(plan) < 2;
    if (is_plan && !is_detail && !plan.rooms.empty())
      found.plans.push_back(std::move(plan));
    else
      ++found.culled["parts of the drawing without doors: sections, fronts, details"];
  }
  read_titles(drawing, found.plans);
  join_wings(found);
  std::erase_if(found.culled, [](const auto& entry) { return entry.second == 0; });
  return found;
}

}  // namespace

FoundPlans find_rooms(const Drawing& drawing, const std::vector<LayerKind>& kinds) {
  if (const auto layer = layer_of_outlines(drawing, kinds)) {
    FoundPlans found;
    found.outlines_taken = true;
    found.plans.push_back(rooms_of_outlines(drawing, *layer, found));
    return found;
  }
  FoundPlans named = find_by_lines(drawing, kinds);
  if (rooms_with_doors(named) >= 3 || std::ranges::find(kinds, LayerKind::Wall) == kinds.end())
    return named;
  // Layers whose names promise walls and hold none: look at all that are not known to be others.
  std::vector<LayerKind> unnamed = kinds;
  for (LayerKind& kind : unnamed)
    if (kind == LayerKind::Wall) kind = LayerKind::Unknown;
  FoundPlans all = find_by_lines(drawing, unnamed);
  return rooms_with_doors(all) > 2 * rooms_with_doors(named) ? all : named;
}

}  // namespace docent::import

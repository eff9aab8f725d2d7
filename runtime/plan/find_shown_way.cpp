#include "runtime/plan/find_shown_way.h"

#include <algorithm>
#include <cstdint>

#include "runtime/interface/goal.h"
#include "runtime/plan/leg.h"

namespace docent::plan {

std::optional<interface::ShownWay> find_shown_way(const Museum& museum,
                                                  const path::BuildingMap& building,
                                                  const directions::Doorways& doorways,
                                                  const interface::InterfaceState& state) {
  const std::optional<interface::Goal> goal = interface::goal_of(museum, state);
  if (!goal) return {};
  WalkOrder order;
  order.floor = museum.kiosk_floor;
  order.kind = state.kind;
  order.goal = goal->standing;
  order.goal_floor = goal->floor;
  order.permissions = state.ways;
  const path::BuildingWay way = find_building_way(museum, building, order, museum.kiosk.position);
  const directions::Goal wanted{.floor = goal->floor,
                                .position = goal->position,
                                .exhibit = state.exhibit,
                                .place = state.exhibit ? std::nullopt : state.place};
  std::optional<directions::Directions> facts =
      directions::direct(museum, doorways, museum.kiosk, way, wanted);
  if (!facts) return {};
  const std::uint32_t seen = state.guide_floor.value_or(museum.kiosk_floor);
  const auto leg = std::ranges::find_if(way.legs, [&](const path::Leg& each) {
    return each.is_along_floor() && each.floor == seen && each.points.size() > 1;
  });
  if (leg == way.legs.end())
    return interface::ShownWay{std::move(*facts), museum.kiosk_floor, way.legs.front().points};
  return interface::ShownWay{std::move(*facts), seen, leg->points};
}

}  // namespace docent::plan

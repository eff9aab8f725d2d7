#include "runtime/path/building/building_way.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace docent::path {

BuildingStatus building_status(RouteStatus status) noexcept {
  switch (status) {
    case RouteStatus::Ok:
      return BuildingStatus::Ok;
    case RouteStatus::StartBlocked:
      return BuildingStatus::StartBlocked;
    case RouteStatus::GoalBlocked:
      return BuildingStatus::GoalBlocked;
    case RouteStatus::NoRoute:
      break;
  }
  return BuildingStatus::NoRoute;
}

BuildingWay joined(BuildingWay first, BuildingWay second) {
  first.length += second.length;
  first.seconds += second.seconds;
  first.clearance_min = std::min(first.clearance_min, second.clearance_min);
  std::ranges::move(second.legs, std::back_inserter(first.legs));
  return first;
}

}  // namespace docent::path

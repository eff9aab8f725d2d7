#include "runtime/plan/order_own_tour.h"

#include <algorithm>
#include <array>
#include <vector>

#include "runtime/path/building/museum_tour.h"

namespace docent::plan {
namespace {

using interface::InterfaceState;
using interface::OwnTour;
using interface::TourWalk;

/// How many of its stops are seen, or gone to.
std::size_t begun(const InterfaceState& state) noexcept {
  const bool is_on_it = state.tour && state.tour->tour == TourWalk::own;
  return is_on_it ? std::min<std::size_t>(state.tour->stop + 1, state.own_tour.count) : 0;
}

/// The shortest order of what is to come, and the walk from the kiosk through all of it.
path::MuseumTour walk_through(const Museum& museum, const path::BuildingMap& building,
                              const InterfaceState& state, const path::Permissions& permissions) {
  const auto exhibits = state.own_tour.exhibits();
  const std::size_t fixed = begun(state);
  path::TourWish wish = path::tour_from_kiosk(museum);
  wish.permissions = permissions;
  path::TourWish from_here = wish;
  if (fixed > 0) {
    const Exhibit& here = museum.exhibits[exhibits[fixed - 1]];
    from_here.from = {here.floor, here.viewing_point.position};
  }
  path::MuseumTour rest =
      path::shortest_tour(museum, building, exhibits.subspan(fixed), {}, from_here);
  if (rest.why_not || fixed == 0) return rest;
  std::vector<std::uint32_t> all(exhibits.begin(),
                                 exhibits.begin() + static_cast<std::ptrdiff_t>(fixed));
  all.insert(all.end(), rest.exhibits.begin(), rest.exhibits.end());
  return path::tour_in_order(museum, building, all, wish);
}

}  // namespace

void order_own_tour(const Museum& museum, const path::BuildingMap& building,
                    InterfaceState& state) {
  OwnTour& tour = state.own_tour;
  path::Permissions though_closed = state.ways;
  though_closed.closed_too = true;
  tour.is_ordered = true;
  for (const path::Permissions& permissions :
       std::array{state.ways, though_closed, path::Permissions{.closed_too = true}}) {
    const path::MuseumTour walked = walk_through(museum, building, state, permissions);
    if (walked.why_not) continue;
    std::ranges::copy(walked.exhibits, tour.exhibit.begin());
    std::ranges::copy(walked.arrives, tour.arrives.begin());
    tour.seconds = walked.seconds();
    return;
  }
}

}  // namespace docent::plan

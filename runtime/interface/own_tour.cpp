#include "runtime/interface/own_tour.h"

#include <algorithm>

namespace docent::interface {

void order_anew(OwnTour& tour) noexcept {
  tour.arrives = {};
  tour.seconds = 0;
  tour.is_ordered = tour.count == 0;
}

std::size_t place_in(const OwnTour& tour, std::uint32_t exhibit) noexcept {
  const auto all = tour.exhibits();
  return static_cast<std::size_t>(std::ranges::find(all, exhibit) - all.begin());
}

void add_to(OwnTour& tour, std::uint32_t exhibit) noexcept {
  if (tour.is_full() || place_in(tour, exhibit) != tour.count) return;
  tour.exhibit[tour.count++] = exhibit;
  order_anew(tour);
}

void take_from(OwnTour& tour, std::uint32_t exhibit) noexcept {
  const std::size_t place = place_in(tour, exhibit);
  if (place == tour.count) return;
  std::shift_left(tour.exhibit.begin() + static_cast<std::ptrdiff_t>(place),
                  tour.exhibit.begin() + tour.count, 1);
  tour.exhibit[--tour.count] = 0;
  order_anew(tour);
}

}  // namespace docent::interface

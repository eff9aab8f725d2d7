#include "runtime/crowd/reservation_table.h"

#include <algorithm>
#include <utility>

namespace docent::crowd {

void ReservationTable::put(std::uint32_t body, Trajectory trajectory) {
  const auto at = std::ranges::lower_bound(entries_, body, {}, &Entry::body);
  if (at != entries_.end() && at->body == body)
    at->trajectory = std::move(trajectory);
  else
    entries_.insert(at, {body, std::move(trajectory)});
}

void ReservationTable::remove(std::uint32_t body) noexcept {
  std::erase_if(entries_, [body](const Entry& entry) { return entry.body == body; });
}

const Trajectory* ReservationTable::trajectory_of(std::uint32_t body) const noexcept {
  const auto at = std::ranges::lower_bound(entries_, body, {}, &Entry::body);
  return at != entries_.end() && at->body == body ? &at->trajectory : nullptr;
}

std::optional<Conflict> ReservationTable::first_conflict(std::uint32_t body,
                                                         const Trajectory& trajectory, double spare,
                                                         double from) const noexcept {
  std::optional<Conflict> first;
  for (const Entry& entry : entries_) {
    if (entry.body == body) continue;
    const auto at = crowd::first_impact(trajectory, entry.trajectory, 2 * radius_ + spare, from);
    if (at && (!first || *at < first->seconds)) first = Conflict{*at, entry.body};
  }
  return first;
}

}  // namespace docent::crowd

#include "runtime/crowd/timetable.h"

#include <algorithm>
#include <utility>

namespace docent {

void Timetable::put(std::uint32_t body, Course course) {
  const auto at = std::ranges::lower_bound(entries_, body, {}, &Entry::body);
  if (at != entries_.end() && at->body == body)
    at->course = std::move(course);
  else
    entries_.insert(at, {body, std::move(course)});
}

void Timetable::remove(std::uint32_t body) noexcept {
  std::erase_if(entries_, [body](const Entry& entry) { return entry.body == body; });
}

const Course* Timetable::course_of(std::uint32_t body) const noexcept {
  const auto at = std::ranges::lower_bound(entries_, body, {}, &Entry::body);
  return at != entries_.end() && at->body == body ? &at->course : nullptr;
}

std::optional<Conflict> Timetable::first_conflict(std::uint32_t body, const Course& course,
                                                  double spare, double from) const noexcept {
  std::optional<Conflict> first;
  for (const Entry& entry : entries_) {
    if (entry.body == body) continue;
    const auto at = docent::first_meeting(course, entry.course, 2 * radius_ + spare, from);
    if (at && (!first || *at < first->seconds)) first = Conflict{*at, entry.body};
  }
  return first;
}

}  // namespace docent

#include "runtime/company/meetings.h"

#include <algorithm>
#include <cmath>

namespace docent {
namespace {

/// Measured (tests/bench, bench_company): smaller bays are shared by fewer, larger ones are fewer.
/// Metres.
constexpr double bay_size = 2.5;
/// A cover is kept until the body, or where it is going, has moved so far from the line between
/// them, and some more the longer that line is, since turning moves its end. Metres.
constexpr double least_skin = 0.2;
constexpr double skin_per_metre = 0.1;
/// So much further than the horizon a cover reaches, for whoever goes straight on. Seconds, and
/// metres at most.
constexpr double seconds_ahead = 0.5;
constexpr double most_ahead = 0.5;
/// A cover that is longer than it would be made by so much is made anew. Metres.
constexpr double too_long = 1;
/// For rounding, far below what anybody notices. Metres.
constexpr double margin = 1e-6;
/// More bays than this in a row are not looked at one by one.
constexpr double longest_reach = 256;

}  // namespace

Meetings::Meetings(const FloorMap& map, std::size_t most_bodies)
    : regions_(map), bays_(map, bay_size), most_bodies_(most_bodies) {
  body_.resize(most_bodies);
  place_.resize(most_bodies);
  cover_.resize(most_bodies);
  covered_.resize(most_bodies * most_bays);
  // Beyond the first sheet of a bay, all but one of its sheets are full.
  sheet_.resize(bays_.count() + most_bodies * most_bays / guests_on_sheet + 1);
  for (std::size_t i = sheet_.size(); i-- > bays_.count();) {
    sheet_[i].next = spare_sheet_;
    spare_sheet_ = static_cast<std::uint32_t>(i);
  }
  seen_in_.assign(most_bodies, 0);
  neighbours_.reserve(8 * most_bodies);
  candidate_.reserve(8 * most_bodies);
  everywhere_.reserve(most_bodies);
  found_.reserve(4 * most_bodies);
  sorted_.reserve(4 * most_bodies);
  first_found_.resize(most_bodies + 1);
}

void Meetings::update(std::span<const Body> bodies) noexcept {
  const auto count = static_cast<std::uint32_t>(std::min(bodies.size(), most_bodies_));
  for (std::uint32_t i = count; i < count_; ++i) uncover(i);
  count_ = count;
  for (std::uint32_t i = 0; i < count; ++i) {
    Mover& body = body_[i];
    body.now = bodies[i];
    body.takes_part = docent::takes_part(bodies[i]);
    if (!body.takes_part) continue;
    const Vec2 moved = bodies[i].position - place_[i].at;
    const double clearance = place_[i].clearance;
    if (dot(moved, moved) >= clearance * std::abs(clearance)) look_up(i);
  }
}

void Meetings::look_up(std::uint32_t body) noexcept {
  KeptPlace& place = place_[body];
  const Vec2 at = body_[body].now.position;
  const auto found = regions_.follow(at, place.region);
  place = {.at = at,
           .clearance = found.clearance,
           .slack = found.slack,
           .region = found.region,
           .is_new = true};
}

std::uint32_t Meetings::region_of(std::size_t body) const noexcept {
  const KeptPlace& place = place_[body];
  if (body >= count_ || !body_[body].takes_part) return Regions::none;
  return regions_.follow(body_[body].now.position, place.region).region;
}

/// The bay that the body is in now.
std::uint32_t Meetings::bay_of(std::uint32_t body) noexcept {
  const Vec2 at = body_[body].now.position;
  const Vec2 moved = at - place_[body].at;
  const double slack = place_[body].slack;
  if (dot(moved, moved) >= slack * std::abs(slack)) look_up(body);
  if (place_[body].region == Regions::none) return Bays::none;
  return bays_.bay_at(bays_.square_at(at), place_[body].region);
}

/// Is what was covered enough for the body's way to `end`? Every point of that way is as near to
/// the old axis as its ends are.
bool Meetings::is_covered(std::uint32_t body, Vec2 end) noexcept {
  const KeptCover& cover = cover_[body];
  const Body& now = body_[body].now;
  if (cover.bays == 0 || now.radius > cover.radius) return false;
  const auto is_near_axis = [&](Vec2 point) {
    const Vec2 from = point - cover.from;
    const double at = std::clamp(dot(from, cover.along), 0.0, cover.length);
    const Vec2 beside = from - at * cover.along;
    return dot(beside, beside) <= cover.skin * cover.skin;
  };
  if (!is_near_axis(now.position) || !is_near_axis(end)) return false;
  const Vec2 way = end - now.position;
  const double too_short = cover.length - (most_ahead + too_long);
  if (too_short > 0 && dot(way, way) < too_short * too_short) return false;
  if (!place_[body].is_new) return true;  // No wall within that move.
  // It must not have come through a wall: one can walk from its bay to all of them, or to none.
  const std::uint32_t bay = bay_of(body);
  const auto covered = std::span(covered_).subspan(body * most_bays, cover.bays);
  if (std::ranges::find(covered, bay) == covered.end()) return false;
  place_[body].is_new = false;
  return true;
}

void Meetings::uncover(std::uint32_t body) noexcept {
  KeptCover& cover = cover_[body];
  for (const std::uint32_t bay : std::span(covered_).subspan(body * most_bays, cover.bays))
    leave(bay, body);
  cover.bays = 0;
  ++body_[body].edition;
}

/// Enters a bay's first sheet; a full one becomes its second.
void Meetings::enter(std::uint32_t bay, std::uint32_t body) noexcept {
  Sheet& first = sheet_[bay];
  if (first.count == guests_on_sheet) {
    const std::uint32_t spare = spare_sheet_;
    spare_sheet_ = sheet_[spare].next;
    sheet_[spare] = first;
    first.next = spare;
    first.count = 0;
  }
  first.guest[first.count++] = body;
}

/// The last one of the first sheet takes the leaver's place.
void Meetings::leave(std::uint32_t bay, std::uint32_t body) noexcept {
  Sheet& first = sheet_[bay];
  if (first.count == 0) {  // All are on the sheets behind.
    const std::uint32_t second = first.next;
    first = sheet_[second];
    sheet_[second].next = spare_sheet_;
    spare_sheet_ = second;
  }
  for (Sheet* sheet = &first;; sheet = &sheet_[sheet->next]) {
    const auto guests = std::span(sheet->guest).first(sheet->count);
    const auto found = std::ranges::find(guests, body);
    if (found == guests.end()) continue;
    *found = first.guest[--first.count];
    return;
  }
}

void Meetings::cover(std::uint32_t body, Vec2 end) {
  uncover(body);
  KeptCover& cover = cover_[body];
  const Body& now = body_[body].now;
  const double way = glm::distance(now.position, end);
  const double speed = std::sqrt(dot(now.velocity, now.velocity));
  cover.from = now.position;
  cover.along = way > 0 ? (end - now.position) / way : Vec2{0, 0};
  cover.length = way > 0 ? way + std::min(seconds_ahead * speed, most_ahead) : 0;
  cover.skin = least_skin + skin_per_metre * cover.length;
  cover.radius = now.radius;
  if (cover.length + now.radius > longest_reach * bays_.size()) return;
  cover.bays = list_bays(body);
  if (cover.bays == 0) return;
  place_[body].is_new = false;
  enter_bays(body);
}

/// Walks from the body's bay to neighbouring ones, as far as its capsule reaches. How many there
/// are; 0 if too many.
std::uint32_t Meetings::list_bays(std::uint32_t body) noexcept {
  const KeptCover& cover = cover_[body];
  const std::uint32_t own = bay_of(body);
  if (own == Bays::none) return 0;
  const double reach = cover.radius + cover.skin + margin;
  const double half = bays_.size() / 2;
  const Vec2 to_middle = cover.length / 2 * cover.along;
  const Vec2 middle = cover.from + to_middle;
  const Vec2 box = glm::abs(to_middle) + Vec2{reach + half, reach + half};
  const double beside = reach + half * (std::abs(cover.along.x) + std::abs(cover.along.y));
  const auto is_under = [&](std::uint32_t bay) {
    const Vec2 from = bays_.centre_of(bay) - middle;
    return std::abs(from.x) <= box.x && std::abs(from.y) <= box.y &&
           std::abs(cross(cover.along, from)) <= beside;
  };
  std::uint32_t* const covered = &covered_[body * most_bays];
  std::uint32_t count = 0;
  covered[count++] = own;
  for (std::uint32_t done = 0; done < count; ++done)
    for (const std::uint32_t next : bays_.next_to(covered[done])) {
      if (!is_under(next) || std::find(covered, covered + count, next) != covered + count) continue;
      if (count == most_bays) return 0;
      covered[count++] = next;
    }
  return count;
}

/// Enters the bays it covers, and notes whom it may meet of those that are there.
void Meetings::enter_bays(std::uint32_t body) {
  const KeptCover& cover = cover_[body];
  ++looks_;
  for (const std::uint32_t bay : std::span(covered_).subspan(body * most_bays, cover.bays)) {
    for (std::uint32_t i = bay; i != none; i = sheet_[i].next)
      for (const std::uint32_t other : std::span(sheet_[i].guest).first(sheet_[i].count)) {
        if (seen_in_[other] == looks_) continue;
        seen_in_[other] = looks_;
        if (!may_meet(cover, cover_[other])) continue;
        const auto [a, b] = std::minmax(body, other);
        neighbours_.push_back({a, b, body_[a].edition, body_[b].edition});
      }
    enter(bay, body);
  }
}

/// Do the capsules come near each other? Said of some that do not.
bool Meetings::may_meet(const KeptCover& a, const KeptCover& b) const noexcept {
  const double reach = a.radius + a.skin + b.radius + b.skin + margin;
  const Vec2 between = b.from + b.length / 2 * b.along - (a.from + a.length / 2 * a.along);
  const double far = reach + (a.length + b.length) / 2;
  if (dot(between, between) > far * far) return false;
  // Boxes about them, in the directions of either.
  const double slant = std::abs(cross(a.along, b.along));
  const double straight = std::abs(dot(a.along, b.along));
  const double half_a = a.length / 2, half_b = b.length / 2;
  return std::abs(cross(a.along, between)) <= reach + half_b * slant &&
         std::abs(cross(b.along, between)) <= reach + half_a * slant &&
         std::abs(dot(a.along, between)) <= reach + half_a + half_b * straight &&
         std::abs(dot(b.along, between)) <= reach + half_b + half_a * straight;
}

std::span<const Meeting> Meetings::find(double horizon) {
  horizon = clamp_horizon(horizon);
  found_.clear();
  everywhere_.clear();
  for (std::uint32_t i = 0; i < count_; ++i) {
    const Mover& body = body_[i];
    const bool is_on_floor = body.takes_part && place_[i].region != Regions::none;
    if (!is_on_floor && cover_[i].bays > 0) uncover(i);
    if (const Vec2 end = body.now.position + horizon * body.now.velocity;
        is_on_floor && !is_covered(i, end))
      cover(i, end);
    if (body.takes_part && cover_[i].bays == 0) everywhere_.push_back(i);
  }
  compare_neighbours(horizon);
  for (const std::uint32_t body : everywhere_) compare_with_everybody(body, horizon);
  sort_found();
  return sorted_;
}

/// Forgets those of old editions as it goes. In two rounds, the first without a branch: nobody can
/// guess who will meet.
void Meetings::compare_neighbours(double horizon) {
  candidate_.resize(neighbours_.size());
  std::size_t kept = 0, candidates = 0;
  for (const Neighbours& pair : neighbours_) {
    const Mover &a = body_[pair.a], &b = body_[pair.b];
    const bool holds = (a.edition == pair.a_edition) & (b.edition == pair.b_edition);
    candidate_[candidates] = static_cast<std::uint32_t>(kept);
    candidates +=
        static_cast<std::size_t>(holds & !surely_miss(approach_of(a.now, b.now), horizon));
    neighbours_[kept] = pair;
    kept += static_cast<std::size_t>(holds);
  }
  neighbours_.resize(kept);
  for (const std::uint32_t index : std::span(candidate_).first(candidates)) {
    const auto [a, b, a_edition, b_edition] = neighbours_[index];
    if (const auto contact = contact_of_circles(body_[a].now, body_[b].now, horizon))
      add(a, b, *contact);
  }
}

void Meetings::compare_with_everybody(std::uint32_t body, double horizon) {
  for (std::uint32_t other = 0; other < count_; ++other) {
    if (other == body || !body_[other].takes_part) continue;
    if (cover_[other].bays == 0 && other < body) continue;  // It was compared with this one.
    const auto [a, b] = std::minmax(body, other);
    if (const auto contact = contact_of_circles(body_[a].now, body_[b].now, horizon))
      add(a, b, *contact);
  }
}

void Meetings::add(std::uint32_t a, std::uint32_t b, const Collision& contact) {
  if (place_[a].region == Regions::none || place_[b].region == Regions::none)
    found_.push_back({a, b, contact.first});
  else if (const auto time = time_in_sight(bays_, body_[a].now, body_[b].now, contact))
    found_.push_back({a, b, *time});
}

/// By a, then by b: counted into place by a, where few share one.
void Meetings::sort_found() {
  const auto counts = std::span(first_found_).first(count_ + 1);
  std::ranges::fill(counts, 0U);
  for (const Meeting& meeting : found_) ++counts[meeting.a];
  std::uint32_t first = 0;
  for (std::uint32_t& count : counts) {
    const std::uint32_t here = count;
    count = first;
    first += here;
  }
  sorted_.resize(found_.size());
  for (const Meeting& meeting : found_) sorted_[counts[meeting.a]++] = meeting;
  for (std::size_t i = 0; i < sorted_.size();) {
    std::size_t end = i + 1;
    while (end < sorted_.size() && sorted_[end].a == sorted_[i].a) ++end;
    std::ranges::sort(sorted_.begin() + static_cast<std::ptrdiff_t>(i),
                      sorted_.begin() + static_cast<std::ptrdiff_t>(end), {}, &Meeting::b);
    i = end;
  }
}

}  // namespace docent

#include "runtime/company/meetings.h"

#include <algorithm>
#include <cmath>

namespace docent {
namespace {

/// Measured (tests/bench, bench_company): smaller bays are shared by fewer, larger ones are fewer.
/// Metres.
constexpr double bay_size = 2;
/// A body's cover is kept until it, or where it is going, has moved so far. Metres.
constexpr double skin = 0.25;
/// A cover that is longer than needed by so much is made anew. Metres.
constexpr double too_long = 1;
/// For rounding, far below what anybody notices. Metres.
constexpr double margin = 1e-6;
/// More squares than this under a body are not looked at one by one.
constexpr double longest_reach = 256;

}  // namespace

Meetings::Meetings(const FloorMap& map, std::size_t most_bodies)
    : regions_(map), bays_(map, bay_size), most_bodies_(most_bodies) {
  body_.reserve(most_bodies);
  place_.resize(most_bodies);
  cover_.resize(most_bodies);
  cover_bay_.resize(most_bodies * most_bays);
  everywhere_.reserve(most_bodies);
  guests_.assign(bays_.count(), 0);
  first_guest_.assign(bays_.count(), 0);
  used_bay_.reserve(std::min(bays_.count(), most_bodies * most_bays));
  guest_.resize(most_bodies * most_bays);
  company_.resize(most_bodies);
  found_.reserve(4 * most_bodies);
  sorted_.reserve(4 * most_bodies);
  first_found_.resize(most_bodies + 1);
}

void Meetings::update(std::span<const Body> bodies) noexcept {
  bodies = bodies.first(std::min(bodies.size(), most_bodies_));
  body_.assign(bodies.begin(), bodies.end());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    KeptPlace& place = place_[i];
    place.takes_part = docent::takes_part(bodies[i]);
    if (!place.takes_part) continue;
    const Vec2 moved = bodies[i].position - place.at;
    if (dot(moved, moved) < place.slack * std::abs(place.slack)) continue;
    const auto found = regions_.follow(bodies[i].position, place.region);
    place = {bodies[i].position, found.slack, found.clearance, found.region, true};
  }
}

/// Is what was covered enough for the body's way to `end`? Every point of a capsule is within the
/// body's radius of its axis, and the axis is as near to the old one as its ends are.
bool Meetings::is_covered(std::uint32_t body, Vec2 end) noexcept {
  KeptCover& cover = cover_[body];
  const Body& now = body_[body];
  if (cover.bays == 0 || now.radius > cover.radius) return false;
  const auto is_near_axis = [&](Vec2 point) {
    const Vec2 from = point - cover.from;
    const double at = std::clamp(dot(from, cover.along), 0.0, cover.length);
    const Vec2 beside = from - at * cover.along;
    return dot(beside, beside) <= skin * skin;
  };
  if (!is_near_axis(now.position) || !is_near_axis(end)) return false;
  const Vec2 way = end - now.position;
  const double too_short = cover.length - too_long;
  if (too_short > 0 && dot(way, way) < too_short * too_short) return false;
  // It must not have come through a wall: one can walk from its bay to all others, or to none.
  const std::uint32_t square = bays_.square_at(now.position), region = place_[body].region;
  if (square == cover.square && region == cover.region) return true;
  if (std::ranges::find(bays_of(body), bays_.bay_at(square, region)) == bays_of(body).end())
    return false;
  cover.square = square;
  cover.region = region;
  return true;
}

/// Walks from the body's bay to neighbouring ones, as far as its capsule reaches.
void Meetings::cover(std::uint32_t body, Vec2 end) noexcept {
  KeptCover& cover = cover_[body];
  const Body& now = body_[body];
  const Vec2 way = end - now.position;
  const double length = std::sqrt(dot(way, way));
  cover = {.from = now.position,
           .along = length > 0 ? way / length : Vec2{0, 0},
           .length = length,
           .radius = now.radius,
           .square = bays_.square_at(now.position),
           .region = place_[body].region,
           .bays = 0};
  if (length + now.radius > longest_reach * bays_.size()) return;
  const std::uint32_t own = bays_.bay_at(cover.square, cover.region);
  if (own == Bays::none) return;

  const double reach = now.radius + skin + margin;
  const double half = bays_.size() / 2;
  const Vec2 middle = (now.position + end) / 2.0;
  const Vec2 box = glm::abs(way) / 2.0 + Vec2{reach + half, reach + half};
  const double beside = reach + half * (std::abs(cover.along.x) + std::abs(cover.along.y));
  const auto is_under = [&](std::uint32_t bay) {
    const Vec2 from = bays_.centre_of(bay) - middle;
    return std::abs(from.x) <= box.x && std::abs(from.y) <= box.y &&
           std::abs(cross(cover.along, from)) <= beside;
  };
  const auto first = cover_bay_.begin() + static_cast<std::ptrdiff_t>(body * most_bays);
  std::size_t count = 0;
  *first = own;
  ++count;
  for (std::size_t done = 0; done < count; ++done)
    for (const std::uint32_t next : bays_.next_to(first[static_cast<std::ptrdiff_t>(done)])) {
      const auto last = first + static_cast<std::ptrdiff_t>(count);
      if (!is_under(next) || std::find(first, last, next) != last) continue;
      if (count == most_bays) return;
      *last = next;
      ++count;
    }
  cover.bays = static_cast<std::uint32_t>(count);
}

std::span<const Meeting> Meetings::find(double horizon) {
  horizon = clamp_horizon(horizon);
  found_.clear();
  everywhere_.clear();
  for (std::uint32_t i = 0; i < body_.size(); ++i) {
    if (!place_[i].takes_part) {
      cover_[i].bays = 0;
      continue;
    }
    const Vec2 end = body_[i].position + horizon * body_[i].velocity;
    if (place_[i].region == Regions::none)
      cover_[i].bays = 0;
    else if (!is_covered(i, end))
      cover(i, end);
    if (cover_[i].bays == 0) everywhere_.push_back(i);
  }
  sort_into_bays();
  for (const std::uint32_t bay : used_bay_) compare_in_bay(bay, horizon);
  for (const std::uint32_t body : everywhere_) compare_with_everybody(body, horizon);
  for (const std::uint32_t bay : used_bay_) guests_[bay] = 0;
  sort_found();
  return sorted_;
}

void Meetings::sort_into_bays() {
  used_bay_.clear();
  for (std::uint32_t i = 0; i < body_.size(); ++i)
    for (const std::uint32_t bay : bays_of(i))
      if (guests_[bay]++ == 0) used_bay_.push_back(bay);
  std::uint32_t first = 0;
  for (const std::uint32_t bay : used_bay_) {
    first_guest_[bay] = first;
    first += guests_[bay];
  }
  for (std::uint32_t i = 0; i < body_.size(); ++i)
    for (const std::uint32_t bay : bays_of(i)) guest_[first_guest_[bay]++] = i;
}

void Meetings::compare_in_bay(std::uint32_t bay, double horizon) {
  const std::uint32_t count = guests_[bay];
  if (count < 2) return;
  const std::uint32_t first = first_guest_[bay] - count;  // It was counted up when they came in.
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t index = guest_[first + i];
    company_[i] = {body_[index].position, body_[index].velocity, body_[index].radius, index};
  }
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    const Guest& a = company_[i];
    for (std::uint32_t j = i + 1; j < count; ++j) {
      const Guest& b = company_[j];
      const auto contact = contact_of_circles({a.position, a.velocity, a.radius},
                                              {b.position, b.velocity, b.radius}, horizon);
      if (contact && is_first_bay_of_both(bay, a.index, b.index)) add(a.index, b.index, *contact);
    }
  }
}

void Meetings::compare_with_everybody(std::uint32_t body, double horizon) {
  for (std::uint32_t other = 0; other < body_.size(); ++other) {
    if (other == body || !place_[other].takes_part) continue;
    if (cover_[other].bays == 0 && other < body) continue;  // Found when its turn was.
    const auto [a, b] = std::minmax(body, other);
    if (const auto contact = contact_of_circles(body_[a], body_[b], horizon)) add(a, b, *contact);
  }
}

/// Two who share several bays are compared in each, and added in the one of lowest number.
bool Meetings::is_first_bay_of_both(std::uint32_t bay, std::uint32_t a,
                                    std::uint32_t b) const noexcept {
  const auto of_b = bays_of(b);
  return std::ranges::none_of(bays_of(a), [&](std::uint32_t other) {
    return other < bay && std::ranges::find(of_b, other) != of_b.end();
  });
}

void Meetings::add(std::uint32_t a, std::uint32_t b, const Collision& contact) {
  if (place_[a].region == Regions::none || place_[b].region == Regions::none ||
      is_far_from_walls(a, b, contact.first))
    found_.push_back({a, b, contact.first});
  else if (const auto time = time_in_sight(bays_, body_[a], body_[b], contact))
    found_.push_back({a, b, *time});
}

/// Is the way between the centres at this time open because it is within the two discs about the
/// bodies that no wall reaches into?
bool Meetings::is_far_from_walls(std::uint32_t a, std::uint32_t b, double time) const noexcept {
  const auto clearance = [&](std::uint32_t body) {
    return place_[body].clearance - glm::distance(body_[body].position, place_[body].at) - margin;
  };
  const auto has = [&](std::uint32_t body, double room, Vec2 point) {
    const Vec2 from = point - body_[body].position;
    return room > 0 && dot(from, from) <= room * room;
  };
  const Vec2 a_end = body_[a].position + time * body_[a].velocity;
  const Vec2 b_end = body_[b].position + time * body_[b].velocity;
  const double a_room = clearance(a), b_room = clearance(b);
  if (!has(a, a_room, a_end) || !has(b, b_room, b_end)) return false;
  return has(a, a_room, b_end) || has(b, b_room, a_end);
}

/// By a, then by b: counted into place by a, where few share one.
void Meetings::sort_found() {
  const auto counts = std::span(first_found_).first(body_.size() + 1);
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

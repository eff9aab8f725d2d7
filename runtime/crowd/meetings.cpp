#include "runtime/crowd/meetings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "runtime/crowd/branchless.h"
#include "runtime/crowd/contact.h"
#include "runtime/model/none.h"

namespace docent::crowd {
namespace {

/// Measured (tests/bench, bench_crowd): smaller cells are shared by fewer, larger ones are fewer.
/// Metres.
constexpr double cell_size = 2.5;
/// A cover is kept until the body, or where it is going, has moved so far from the line between
/// them, and some more the longer that line is, since turning moves its end. Metres.
constexpr double least_tolerance = 0.2;
constexpr double tolerance_per_metre = 0.1;
/// So much further than the horizon a cover reaches, for whoever goes straight on. Seconds, and
/// metres at most.
constexpr double seconds_ahead = 0.5;
constexpr double most_ahead = 0.5;
/// A cover that is longer than it would be made by so much is made anew. Metres.
constexpr double too_long = 1;
/// A place is clear of walls up to this far, as far as anybody asks. Metres.
constexpr double most_clear = 0.5;
/// More cells than this in a row are not looked at one by one.
constexpr double longest_reach = 256;
/// Room for so many pairs is kept at once.
constexpr std::size_t few_pairs = 4096;
/// After so many steps people have walked a cell or two, and are numbered anew.
constexpr std::uint64_t steps_of_a_numbering = 256;

float rounded_up(double value) noexcept {
  return static_cast<float>(value * (1 + 1e-6));
}
float rounded_down(double value) noexcept {
  return static_cast<float>(value * (1 - 1e-6));
}

}  // namespace

Meetings::Meetings(const path::FloorMap& map, std::size_t most_bodies)
    : regions_(map), cells_(map, cell_size), most_bodies_(most_bodies) {
  index_of_.resize(most_bodies);
  std::iota(index_of_.begin(), index_of_.end(), 0U);
  number_of_ = index_of_;
  numbering_.resize(most_bodies);
  body_.resize(most_bodies);
  place_.resize(most_bodies);
  cover_.resize(most_bodies);
  covered_.resize(most_bodies * most_cells);
  // Beyond the first block of a cell, all but one of its blocks are full.
  blocks_.resize(cells_.count() + most_bodies * most_cells / occupants_a_block + 1);
  for (std::size_t i = blocks_.size(); i-- > cells_.count();) {
    blocks_[i].next = spare_block_;
    spare_block_ = static_cast<std::uint32_t>(i);
  }
  seen_in_.assign(most_bodies, 0);
  // A kiosk's few may all be near each other.
  const std::size_t pairs = most_bodies * (most_bodies + 1) / 2;
  const std::size_t most_pairs = std::min(pairs, std::max(8 * most_bodies, few_pairs));
  neighbours_.reserve(most_pairs);
  new_neighbours_.reserve(most_pairs);
  merged_.reserve(2 * most_pairs);
  candidate_.reserve(2 * most_pairs);
  everywhere_.reserve(most_bodies);
  leaver_.resize(most_bodies);
  found_.reserve(most_pairs);
  sorted_.reserve(most_pairs);
  first_found_.resize(most_bodies + 1);
}

void Meetings::update(std::span<const Body> bodies) noexcept {
  count_ = static_cast<std::uint32_t>(std::min(bodies.size(), most_bodies_));
  numbers_ = std::max(numbers_, count_);
  for (std::uint32_t index = 0; index < numbers_; ++index) {
    Mover& body = body_[number_of_[index]];
    body.takes_part = index < count_ && crowd::takes_part(bodies[index]);
    if (body.takes_part) body.now = bodies[index];
  }
  if (steps_++ % steps_of_a_numbering == 0) sort_bodies();
}

/// Numbers them by the squares they are in. What is kept is kept.
void Meetings::sort_bodies() noexcept {
  const auto numbering = std::span(numbering_).first(numbers_);
  for (std::uint32_t body = 0; body < numbers_; ++body)
    numbering[body] = {body_[body].takes_part ? cells_.square_at(body_[body].now.position) : none,
                       body};
  std::ranges::sort(numbering, {},
                    [](const Numbering& n) { return std::pair(n.square, n.before); });
  // From here on `square` is the number now.
  for (std::uint32_t i = 0; i < numbers_; ++i) numbering[numbering[i].before].square = i;
  const auto renumber = [&](std::uint32_t& body) { body = numbering[body].square; };
  for (Neighbours& pair : neighbours_) renumber(pair.a), renumber(pair.b);
  std::ranges::sort(neighbours_, {}, &Neighbours::a);
  for (std::size_t cell = 0; cell < cells_.count(); ++cell)
    for (auto i = static_cast<std::uint32_t>(cell); i != none; i = blocks_[i].next)
      for (std::uint32_t& occupant : std::span(blocks_[i].occupant).first(blocks_[i].count))
        renumber(occupant);
  for (std::uint32_t body = 0; body < numbers_; ++body)
    while (numbering[body].square != body) {
      const std::uint32_t goal = numbering[body].square;
      swap_bodies(body, goal);
      std::swap(numbering[body].square, numbering[goal].square);
    }
}

void Meetings::swap_bodies(std::uint32_t a, std::uint32_t b) noexcept {
  std::swap(index_of_[a], index_of_[b]);
  std::swap(number_of_[index_of_[a]], number_of_[index_of_[b]]);
  std::swap(body_[a], body_[b]);
  std::swap(place_[a], place_[b]);
  std::swap(cover_[a], cover_[b]);
  std::swap(seen_in_[a], seen_in_[b]);
  const auto cells = std::max(cover_[a].cells, cover_[b].cells);
  std::swap_ranges(&covered_[a * most_cells], &covered_[a * most_cells] + cells,
                   &covered_[b * most_cells]);
}

void Meetings::look_up(std::uint32_t body) noexcept {
  CachedPlace& place = place_[body];
  const Vec2 at = body_[body].now.position;
  const auto found = regions_.follow(at, place.region);
  place = {.at = at, .clearance = found.clearance, .slack = found.slack, .region = found.region};
}

std::uint32_t Meetings::region_of(std::size_t index) const noexcept {
  if (index >= count_) return none;
  const std::uint32_t body = number_of_[index];
  if (!body_[body].takes_part) return none;
  return regions_.follow(body_[body].now.position, place_[body].region).region;
}

/// Also sees whether it has jumped or come through a wall.
bool Meetings::is_on_floor(std::uint32_t body) noexcept {
  const Vec2 moved = body_[body].now.position - place_[body].at;
  const double clearance = place_[body].clearance;
  if (dot(moved, moved) >= clearance * std::abs(clearance)) look_up(body);
  return place_[body].region != none;
}

/// The cell that the body is in now.
std::uint32_t Meetings::cell_of(std::uint32_t body) noexcept {
  const Vec2 at = body_[body].now.position;
  const Vec2 moved = at - place_[body].at;
  const double slack = place_[body].slack;
  if (dot(moved, moved) >= slack * std::abs(slack)) look_up(body);
  if (place_[body].region == none) return none;
  return cells_.cell_at(cells_.square_at(at), place_[body].region);
}

/// Is the cover enough for the body's way to `end`, if it has passed no wall? Every point of that
/// way is as near to the axis as its ends are. Without a branch.
bool Meetings::CachedCover::holds(const Body& now, Vec2 end) const noexcept {
  const Vec2 way = end - now.position;
  const double too_short = std::max(length - (most_ahead + too_long), 0.0);
  return all_hold(cells > 0, now.radius <= radius, is_near(now.position, length, tolerance),
                  is_near(end, length, tolerance), dot(way, way) >= too_short * too_short);
}

/// Those whose covers do not hold, or may not.
std::span<const std::uint32_t> Meetings::list_leavers(double horizon) noexcept {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < numbers_; ++i) {
    const CachedCover& cover = cover_[i];
    const auto& [now, version, takes_part] = body_[i];
    const bool holds = all_hold(cover.holds(now, now.position + horizon * now.velocity),
                                cover.is_clear_at(now.position));
    leaver_[count] = i;
    count += static_cast<std::size_t>(takes_part ? !holds : cover.cells > 0);
  }
  return std::span(leaver_).first(count);
}

void Meetings::CachedCover::clear(Vec2 place, double clearance) noexcept {
  clear_x = static_cast<float>(place.x - from.x);
  clear_y = static_cast<float>(place.y - from.y);
  const double rounding = glm::distance(place, clear_place());
  clear_radius = rounded_down(std::max(clearance - rounding - margin, 0.0));
}

/// Does the cover hold, for a body that may have left what is clear?
bool Meetings::is_covered(std::uint32_t body, Vec2 end) noexcept {
  CachedCover& cover = cover_[body];
  const Vec2 at = body_[body].now.position;
  if (!cover.holds(body_[body].now, end)) return false;
  const double clearance = clearance_at(cells_, at, most_clear);
  if (!cover.leads_to(at, clearance)) {
    // It must not have come through a wall: one can walk from its cell to all of them, or to none.
    if (!is_on_floor(body)) return false;
    const std::uint32_t cell = cell_of(body);
    const auto covered = std::span(covered_).subspan(body * most_cells, cover.cells);
    if (std::ranges::find(covered, cell) == covered.end()) return false;
  }
  cover.clear(at, clearance);
  return true;
}

void Meetings::uncover(std::uint32_t body) noexcept {
  CachedCover& cover = cover_[body];
  for (const std::uint32_t cell : std::span(covered_).subspan(body * most_cells, cover.cells))
    leave(cell, body);
  cover.cells = 0;
  ++body_[body].version;
}

/// Enters a cell's first block; a full one becomes its second.
void Meetings::enter(std::uint32_t cell, std::uint32_t body) noexcept {
  OccupantBlock& first = blocks_[cell];
  if (first.count == occupants_a_block) {
    const std::uint32_t spare = spare_block_;
    spare_block_ = blocks_[spare].next;
    blocks_[spare] = first;
    first.next = spare;
    first.count = 0;
  }
  first.occupant[first.count++] = body;
}

/// The last one of the first block takes the leaver's place.
void Meetings::leave(std::uint32_t cell, std::uint32_t body) noexcept {
  OccupantBlock& first = blocks_[cell];
  if (first.count == 0) {  // All are on the sheets behind.
    const std::uint32_t second = first.next;
    first = blocks_[second];
    blocks_[second].next = spare_block_;
    spare_block_ = second;
  }
  for (OccupantBlock* block = &first;; block = &blocks_[block->next]) {
    const auto occupants = std::span(block->occupant).first(block->count);
    const auto found = std::ranges::find(occupants, body);
    if (found == occupants.end()) continue;
    *found = first.occupant[--first.count];
    return;
  }
}

/// The cell that the body has come to from where its cover is clear, if it has surely met no wall.
std::uint32_t Meetings::followed_cell(std::uint32_t body, double clearance) const noexcept {
  const CachedCover& cover = cover_[body];
  const Vec2 at = body_[body].now.position;
  if (cover.cells == 0 || !cover.leads_to(at, clearance)) return none;
  const std::uint32_t square = cells_.square_at(at);
  std::uint32_t found = cells_.only_cell_of(square);
  if (found != none) return found;
  // It is one of those that it covered, if it is still among them.
  if (!cover.is_near(at, cover.length, cover.tolerance + cover.radius)) return none;
  for (const std::uint32_t cell : std::span(covered_).subspan(body * most_cells, cover.cells)) {
    if (cells_.square_of(cell) != square) continue;
    if (found != none) return none;  // Two of one square.
    found = cell;
  }
  return found;
}

void Meetings::cover(std::uint32_t body, Vec2 end) {
  const Body& now = body_[body].now;
  const double way = glm::distance(now.position, end);
  const double speed = std::sqrt(dot(now.velocity, now.velocity));
  CachedCover made;
  made.from = now.position;
  made.along = way > 0 ? (end - now.position) / way : Vec2{0, 0};
  const double length = way > 0 ? way + std::min(seconds_ahead * speed, most_ahead) : 0;
  if (length + now.radius > longest_reach * cells_.size()) return uncover(body);
  made.length = rounded_up(length);
  made.tolerance = rounded_up(least_tolerance + tolerance_per_metre * made.length);
  made.radius = rounded_up(now.radius);
  const double clearance = clearance_at(cells_, now.position, most_clear);
  std::uint32_t cell = followed_cell(body, clearance);
  if (cell == none && is_on_floor(body)) cell = cell_of(body);
  if (cell == none) return uncover(body);
  CellList list;
  made.cells = list_cells(made, cell, list);
  if (made.cells == 0) return uncover(body);
  made.clear(now.position, clearance);
  enter_cells(body, made, list);
}

/// Walks from the body's cell to neighbouring ones, as far as its capsule reaches. How many there
/// are; 0 if too many.
std::uint32_t Meetings::list_cells(const CachedCover& cover, std::uint32_t own,
                                   CellList& list) const noexcept {
  const double reach = static_cast<double>(cover.radius) + cover.tolerance + margin;
  const double half = cells_.size() / 2;
  const Vec2 to_middle = 0.5 * cover.length * cover.along;
  const Vec2 middle = cover.from + to_middle;
  const Vec2 box = glm::abs(to_middle) + Vec2{reach + half, reach + half};
  const double beside = reach + half * (std::abs(cover.along.x) + std::abs(cover.along.y));
  const auto is_under = [&](Vec2 centre) {
    const Vec2 from = centre - middle;
    return std::abs(from.x) <= box.x && std::abs(from.y) <= box.y &&
           std::abs(cross(cover.along, from)) <= beside;
  };
  std::uint32_t count = 0;
  // Where each square is one cell there is no need to ask where one can walk.
  const Vec2 side = box - half;
  const auto [left, bottom, right, top] = cells_.squares_in(middle - side, middle + side);
  bool is_plain = (right - left + 1) * (top - bottom + 1) <= most_cells;
  for (std::uint32_t y = bottom; y <= top && is_plain; ++y)
    for (std::uint32_t x = left; x <= right && is_plain; ++x) {
      const std::uint32_t square = cells_.square(x, y);
      if (!is_under(cells_.centre_of_square(square))) continue;
      const std::uint32_t cell = cells_.only_cell_of(square);
      is_plain = cell != none;
      list[count++] = cell;
    }
  if (is_plain) return count;

  count = 0;
  list[count++] = own;
  for (std::uint32_t done = 0; done < count; ++done)
    for (const std::uint32_t next : cells_.next_to(list[done])) {
      if (!is_under(cells_.centre_of(next)) ||
          std::find(list.begin(), list.begin() + count, next) != list.begin() + count)
        continue;
      if (count == most_cells) return 0;
      list[count++] = next;
    }
  return count;
}

/// Makes this its cover: enters the cells, and notes whom it may meet of those that are there.
void Meetings::enter_cells(std::uint32_t body, const CachedCover& made, const CellList& list) {
  const auto covered = std::span(covered_).subspan(body * most_cells, most_cells);
  const std::span<const std::uint32_t> before = covered.first(cover_[body].cells);
  const std::span<const std::uint32_t> now = std::span(list).first(made.cells);
  const auto is_in = [](std::span<const std::uint32_t> cells, std::uint32_t cell) {
    return std::ranges::find(cells, cell) != cells.end();
  };
  for (const std::uint32_t cell : before)
    if (!is_in(now, cell)) leave(cell, body);
  ++body_[body].version;
  seen_in_[body] = ++looks_;
  for (const std::uint32_t cell : now) {
    for (std::uint32_t i = cell; i != none; i = blocks_[i].next)
      for (const std::uint32_t other : std::span(blocks_[i].occupant).first(blocks_[i].count)) {
        if (seen_in_[other] == looks_) continue;
        seen_in_[other] = looks_;
        if (may_meet(made, cover_[other]))
          new_neighbours_.push_back(
              {body, other, body_[body].version + body_[other].version, Sight::Unknown});
      }
    if (!is_in(before, cell)) enter(cell, body);
  }
  cover_[body] = made;
  std::ranges::copy(now, covered.begin());
}

/// Do the capsules come near each other? Said of some that do not.
bool Meetings::may_meet(const CachedCover& a, const CachedCover& b) const noexcept {
  const double reach =
      static_cast<double>(a.radius) + a.tolerance + b.radius + b.tolerance + margin;
  const Vec2 between = b.from + 0.5 * b.length * b.along - (a.from + 0.5 * a.length * a.along);
  const double far = reach + 0.5 * (a.length + b.length);
  // Boxes about them, in the directions of either. Without a branch.
  const double slant = std::abs(cross(a.along, b.along));
  const double straight = std::abs(dot(a.along, b.along));
  const double half_a = 0.5 * a.length, half_b = 0.5 * b.length;
  return all_hold(dot(between, between) <= far * far,
                  std::abs(cross(a.along, between)) <= reach + half_b * slant,
                  std::abs(cross(b.along, between)) <= reach + half_a * slant,
                  std::abs(dot(a.along, between)) <= reach + half_a + half_b * straight,
                  std::abs(dot(b.along, between)) <= reach + half_b + half_a * straight);
}

/// The one with the lower index first.
std::pair<std::uint32_t, std::uint32_t> Meetings::in_order(std::uint32_t a,
                                                           std::uint32_t b) const noexcept {
  return index_of_[a] < index_of_[b] ? std::pair(a, b) : std::pair(b, a);
}

std::span<const Meeting> Meetings::find(double horizon) {
  horizon = clamp_horizon(horizon);
  found_.clear();
  everywhere_.clear();
  for (const std::uint32_t i : list_leavers(horizon)) {
    const Body& body = body_[i].now;
    const Vec2 end = body.position + horizon * body.velocity;
    if (!body_[i].takes_part) {
      uncover(i);
    } else if (!is_covered(i, end)) {
      cover(i, end);
      if (cover_[i].cells == 0) everywhere_.push_back(i);
    }
  }
  compare_neighbours(horizon);
  for (const std::uint32_t body : everywhere_) compare_with_everybody(body, horizon);
  sort_found();
  return sorted_;
}

/// Forgets those of old versions as it goes, and puts the new ones among the others: who stand
/// together are compared one after the other. In two rounds, the first without a branch: nobody can
/// guess who will meet.
void Meetings::compare_neighbours(double horizon) {
  const std::size_t most = neighbours_.size() + new_neighbours_.size();
  candidate_.resize(most);
  merged_.resize(most);
  std::size_t kept = 0, candidates = 0;
  const auto compare = [&](const Neighbours& pair) {
    const Mover &a = body_[pair.a], &b = body_[pair.b];
    const bool holds = a.version + b.version == pair.versions;
    candidate_[candidates] = static_cast<std::uint32_t>(kept);
    candidates +=
        static_cast<std::size_t>(holds & !surely_miss(approach_of(a.now, b.now), horizon));
    merged_[kept] = pair;
    kept += static_cast<std::size_t>(holds);
  };
  std::size_t old = 0;
  for (const Neighbours& pair : new_neighbours_) {
    for (; old < neighbours_.size() && neighbours_[old].a <= pair.a; ++old)
      compare(neighbours_[old]);
    compare(pair);
  }
  for (; old < neighbours_.size(); ++old) compare(neighbours_[old]);
  merged_.resize(kept);
  new_neighbours_.clear();
  neighbours_.swap(merged_);
  for (const std::uint32_t index : std::span(candidate_).first(candidates)) {
    Neighbours& pair = neighbours_[index];
    const auto [a, b] = in_order(pair.a, pair.b);
    const auto contact = contact_of_circles(body_[a].now, body_[b].now, horizon);
    if (!contact) continue;
    if (pair.sight == Sight::Unknown)
      pair.sight = sight_between(cells_, swept_line_of(cover_[a]), swept_line_of(cover_[b]));
    std::optional<double> time;
    if (pair.sight == Sight::Open)
      time = contact->first;
    else if (pair.sight == Sight::Closed)
      pair.versions = 0;  // That of nobody.
    else
      time = time_in_sight(cells_, body_[a].now, body_[b].now, *contact);
    if (time) found_.push_back({index_of_[a], index_of_[b], *time});
  }
}

void Meetings::compare_with_everybody(std::uint32_t body, double horizon) {
  for (std::uint32_t other = 0; other < numbers_; ++other) {
    if (other == body || !body_[other].takes_part) continue;
    if (cover_[other].cells == 0 && other < body) continue;  // It was compared with this one.
    const auto [a, b] = in_order(body, other);
    const Body &first = body_[a].now, &second = body_[b].now;
    const auto contact = contact_of_circles(first, second, horizon);
    if (!contact) continue;
    std::optional<double> time = contact->first;
    if (is_on_floor(a) && is_on_floor(b)) time = time_in_sight(cells_, first, second, *contact);
    if (time) found_.push_back({index_of_[a], index_of_[b], *time});
  }
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

}  // namespace docent::crowd

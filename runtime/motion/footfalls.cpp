#include "runtime/motion/footfalls.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace docent::motion {
namespace {

constexpr double same_place = 0.15;        // metres between footfalls of a body that stands
constexpr std::size_t least_frames = 4;    // that are a footfall
constexpr std::size_t frames_between = 4;  // more of them are a swing

bool rests(const Walk& walk, Side side, std::size_t f) noexcept {
  return side == Side::Left ? walk.plants[f].left : walk.plants[f].right;
}

/// The slope at a knot between two chords: none at an extremum, else their harmonic mean.
double slope_between(double before, double after) noexcept {
  return before * after <= 0 ? 0 : 2 * before * after / (before + after);
}

double hermite(double a, double b, double slope_a, double slope_b, double t,
               double width) noexcept {
  const double s = t * t * (3 - 2 * t);
  return std::lerp(a, b, s) + width * t * (1 - t) * ((1 - t) * slope_a - t * slope_b);
}

template <typename Falls>
Falls between_stands(Falls falls) noexcept {
  if (falls.empty()) return falls;
  const double start = falls.front().along + same_place, end = falls.back().along - same_place;
  const auto begins = std::ranges::find_if(falls, [&](const auto& f) { return f.along > start; });
  const auto ends = std::find_if(begins, falls.end(), [&](const auto& f) { return f.along > end; });
  return falls.subspan(static_cast<std::size_t>(begins - falls.begin()),
                       static_cast<std::size_t>(ends - begins));
}

}  // namespace

void find_footfalls(const Walk& walk, Side side, std::span<const Foot> feet, Vec2 from, Vec2 along,
                    std::vector<Footfall>& falls) {
  const std::size_t had = falls.size();
  const std::size_t frames = feet.size();
  for (std::size_t f = 0; f < frames; ++f) {
    if (!rests(walk, side, f)) continue;
    std::size_t end = f;
    while (end < frames && rests(walk, side, end)) ++end;
    if (falls.size() > had && f - falls.back().last <= frames_between)
      falls.back().last = end - 1;
    else if (end - f >= least_frames || f == 0 || end == frames)
      falls.push_back({.side = side, .first = f, .last = end - 1});
    f = end;
  }
  for (std::size_t i = had; i < falls.size(); ++i) {
    Footfall& fall = falls[i];
    const std::size_t typical = fall.first == 0           ? 0
                                : fall.last + 1 == frames ? fall.last
                                                          : (fall.first + fall.last) / 2;
    fall.toe = feet[typical].toe;
    fall.along = dot(to_floor(fall.toe) - from, along);
  }
}

void order_footfalls(std::vector<Footfall>& falls) {
  std::ranges::sort(falls, {}, &Footfall::first);
}

std::span<Footfall> steps(std::span<Footfall> falls) noexcept {
  return between_stands(falls);
}
std::size_t count_of_steps(std::span<const Footfall> falls) noexcept {
  return between_stands(falls).size();
}

std::vector<Footfall*> footfalls_of(std::span<Footfall> falls, Side side) {
  std::vector<Footfall*> own;
  for (Footfall& fall : falls)
    if (fall.side == side) own.push_back(&fall);
  return own;
}

FootfallMap::Place FootfallMap::at(double metres) const noexcept {
  if (metres <= along.front())
    return {place.front().along + metres - along.front(), place.front().height};
  if (metres >= along.back())
    return {place.back().along + metres - along.back(), place.back().height};
  const auto next = static_cast<std::size_t>(std::upper_bound(along.begin(), along.end(), metres) -
                                             along.begin());
  const std::size_t i = next - 1;
  const double width = along[next] - along[i];
  const double t = (metres - along[i]) / width;
  return {
      hermite(place[i].along, place[next].along, slope[i].along, slope[next].along, t, width),
      hermite(place[i].height, place[next].height, slope[i].height, slope[next].height, t, width)};
}

FootfallMap make_footfall_map(std::span<const Footfall> falls) {
  FootfallMap map;
  std::vector<const Footfall*> order;
  for (const Footfall& fall : falls) order.push_back(&fall);
  std::ranges::stable_sort(order, {}, &Footfall::along);
  for (const Footfall* fall : order) {
    if (!map.along.empty() && fall->along - map.along.back() < 0.02) continue;
    map.along.push_back(fall->along);
    map.place.push_back({fall->target, fall->height});
  }
  const std::size_t count = map.along.size();
  map.slope.resize(count, {1, 0});
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const auto chord = [&](std::size_t k, double FootfallMap::Place::* value) {
      return (map.place[k + 1].*value - map.place[k].*value) / (map.along[k + 1] - map.along[k]);
    };
    for (const auto value : {&FootfallMap::Place::along, &FootfallMap::Place::height})
      map.slope[i].*value = slope_between(chord(i - 1, value), chord(i, value));
  }
  return map;
}

}  // namespace docent::motion

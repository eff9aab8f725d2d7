#include "runtime/scene/sunk_walls.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/model/geometry/segment.h"
#include "runtime/model/scenery.h"

namespace docent::scene {
namespace {

constexpr int side = WallLevels::side;
constexpr double cell = WallLevels::cell;
constexpr double half = side * cell / 2;  ///< Of the window, metres.
constexpr double time_constant = 0.16;    ///< Seconds.
constexpr double thinnest_wall = 0.15;    ///< Metres: one seen end on hides from between two rays.
constexpr double wall_behind = 0.5;       ///< Metres that a wall goes on behind its face, or more.
constexpr double whole_radius = 0.75;     ///< Sunk as far as it goes within that, metres...
constexpr double fade = 0.9;              ///< ... and a little this much further.
constexpr double gather_radius = 20, gather_step = 3;

int wrap(int i) noexcept {
  return i & (side - 1);
}

std::size_t cell_of(int column, int row) noexcept {
  return static_cast<std::size_t>(wrap(row)) * side + static_cast<std::size_t>(wrap(column));
}

int column_of(double metres) noexcept {
  return static_cast<int>(std::floor(metres / cell));
}

/// How far along `from` to `to` the segment a to b crosses it, metres; below 0: nowhere.
double crossing(Vec2 from, Vec2 to, Vec2 a, Vec2 b) noexcept {
  const Vec2 line = to - from, wall = b - a;
  const double across = cross(line, wall);
  if (across == 0) return -1;
  const double on_line = cross(a - from, wall) / across;
  const double on_wall = cross(a - from, line) / across;
  if (on_line < 0 || on_line > 1 || on_wall < 0 || on_wall > 1) return -1;
  return on_line * glm::length(line);
}

}  // namespace

static_assert((side & (side - 1)) == 0);

SunkWalls::SunkWalls(std::size_t most_walls)
    : wanted_(std::size_t{side} * side), level_(wanted_.size()) {
  near_.reserve(most_walls);
  beside_.reserve(most_walls);
  levels_.level.resize(wanted_.size());
}

void SunkWalls::show(const FloorPlan& plan) noexcept {
  plan_ = &plan;
  near_.clear();
  gathered_ = {1e9, 1e9};
  std::ranges::fill(level_, 0.0F);
  std::ranges::fill(levels_.level, std::uint8_t{0});
  levels_.any = false;
}

/// What was on the far side of the lattice, before it came along, stands again.
void SunkWalls::go_along(Vec2 centre) noexcept {
  const int column = column_of(centre.x) - side / 2, row = column_of(centre.y) - side / 2;
  const int columns = std::clamp(column - levels_.column, -side, side);
  const int rows = std::clamp(row - levels_.row, -side, side);
  const auto stand = [&](int new_column, int new_row) { level_[cell_of(new_column, new_row)] = 0; };
  for (int i = 0; i < std::abs(columns); ++i)
    for (int j = 0; j < side; ++j) stand(columns > 0 ? column + side - 1 - i : column + i, j);
  for (int i = 0; i < std::abs(rows); ++i)
    for (int j = 0; j < side; ++j) stand(j, rows > 0 ? row + side - 1 - i : row + i);
  levels_.column = column;
  levels_.row = row;
}

void SunkWalls::gather_walls(Vec2 centre) noexcept {
  if (glm::distance(centre, gathered_) < gather_step) return;
  gathered_ = centre;
  near_.clear();
  for (std::uint32_t wall = 0; wall < plan_->vertex.size(); ++wall)
    if (near_.size() < near_.capacity() &&
        distance_to_segment(centre, wall_start(*plan_, wall), wall_end(*plan_, wall)) <
            gather_radius)
      near_.push_back(wall);
}

/// Walls within a radius of the line from a to b sink.
void SunkWalls::sink(Vec2 a, Vec2 b) noexcept {
  constexpr double reach = whole_radius + fade;
  const Vec2 low = glm::min(a, b) - reach, high = glm::max(a, b) + reach;
  const int first_column = std::max(column_of(low.x), levels_.column);
  const int last_column = std::min(column_of(high.x), levels_.column + side - 1);
  const int first_row = std::max(column_of(low.y), levels_.row);
  const int last_row = std::min(column_of(high.y), levels_.row + side - 1);
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column) {
      const Vec2 middle = (Vec2(column, row) + 0.5) * cell;
      const double off = (distance_to_segment(middle, a, b) - whole_radius) / fade;
      const double share = std::clamp(1 - off, 0.0, 1.0);
      float& wanted = wanted_[cell_of(column, row)];
      wanted = std::max(wanted, static_cast<float>(share * share * (3 - 2 * share)));
    }
}

/// Which walls may lines cross that run up to `half_width` beside the one `from` a sight `to`?
void SunkWalls::keep_beside(Vec2 from, Vec2 to, double half_width) noexcept {
  const Vec2 low = glm::min(from, to) - half_width, high = glm::max(from, to) + half_width;
  beside_.clear();
  for (const std::uint32_t wall : near_) {
    const Vec2 a = wall_start(*plan_, wall), b = wall_end(*plan_, wall);
    if (std::max(a.x, b.x) >= low.x && std::min(a.x, b.x) <= high.x &&
        std::max(a.y, b.y) >= low.y && std::min(a.y, b.y) <= high.y)
      beside_.push_back(wall);
  }
}

/// What stands on the line `from` a sight towards the camera sinks, all through each wall.
void SunkWalls::clear(Vec2 from, Vec2 to) noexcept {
  std::array<Crossing, 12> crossings;
  std::size_t count = 0;
  for (const std::uint32_t wall : beside_) {
    const Vec2 a = wall_start(*plan_, wall), b = wall_end(*plan_, wall);
    const double along = crossing(from, to, a, b);
    if (along < 0 || count == crossings.size()) continue;
    crossings[count++] = {along, cross(b - a, to - from) < 0};
  }
  const auto met = std::span(crossings).first(count);
  std::ranges::sort(met, {}, &Crossing::along);
  const double length = glm::distance(from, to);
  const Vec2 on = (to - from) / std::max(length, 1e-9);
  for (std::size_t i = 0; i < count; ++i) {
    const double along = met[i].along;
    if (!met[i].leaves) {
      sink(from + on * std::max(0.0, along - wall_behind), from + on * along);
      continue;
    }
    const double solid = i + 1 < count ? met[i + 1].along : length;
    sink(from + on * along, from + on * std::max(solid, std::min(length, along + wall_behind)));
  }
}

void SunkWalls::advance(Vec2 centre, Vec3 eye, std::span<const Sight> sights,
                        float seconds) noexcept {
  if (plan_ == nullptr) return;
  if (sights.empty() && !levels_.any) return;
  go_along(centre);
  gather_walls(centre);
  std::ranges::fill(wanted_, 0.0F);
  const Vec2 camera = to_floor(eye);
  const double eye_height = std::max(eye.y - plan_->height, 2.0);
  for (const Sight& sight : sights) {
    const double off = glm::distance(camera, sight.place);
    if (off < 1e-6) continue;
    // A wall hides the floor at a sight as far from it as a ray takes to rise to the cut.
    const Vec2 towards = (camera - sight.place) / off;
    const Vec2 to = sight.place + towards * (cut_height / eye_height * off + 0.2);
    keep_beside(sight.place, to, sight.half_width + 0.001);  // and what is rounded
    const int rays = static_cast<int>(std::ceil(sight.half_width / thinnest_wall));
    for (int ray = -rays; ray <= rays; ++ray) {
      const Vec2 beside = left_of(towards) * (sight.half_width * ray / std::max(rays, 1));
      clear(sight.place + beside, to + beside);
    }
  }
  const auto share =
      seconds < 0 ? 1.0F
                  : static_cast<float>(1 - std::exp(-static_cast<double>(seconds) / time_constant));
  levels_.any = false;
  for (std::size_t i = 0; i < level_.size(); ++i) {
    constexpr float near_enough = 0.002F;
    if (wanted_[i] == 0 && level_[i] == 0) {  // nearly everywhere
      levels_.level[i] = 0;
      continue;
    }
    const float off = wanted_[i] - level_[i];
    level_[i] = std::abs(off) < near_enough ? wanted_[i] : level_[i] + off * share;
    levels_.level[i] = static_cast<std::uint8_t>(std::lround(level_[i] * 255));
    levels_.any = levels_.any || level_[i] > 0;
  }
}

/// As a texture that is repeated and interpolated is read.
double SunkWalls::height_at(Vec2 place) const noexcept {
  const Vec2 at = place / cell - 0.5;
  const int column = static_cast<int>(std::floor(at.x)), row = static_cast<int>(std::floor(at.y));
  const double x = at.x - column, y = at.y - row;
  const auto level = [&](int right, int up) {
    return static_cast<double>(levels_.level[cell_of(column + right, row + up)]) / 255;
  };
  const double below = level(0, 0) * (1 - x) + level(1, 0) * x;
  const double above = level(0, 1) * (1 - x) + level(1, 1) * x;
  const double far = std::max(std::abs(place.x - (levels_.column * cell + half)),
                              std::abs(place.y - (levels_.row * cell + half)));
  const bool within = far < half - cell;
  return std::lerp(cut_height, sunk_height, within ? below * (1 - y) + above * y : 0.0);
}

}  // namespace docent::scene

// Who meets whom among many avatars: what does it cost a step, beside comparing everybody with
// everybody and beside a uniform grid, and does it grow with anything but their number?

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "content/floor/medial_axis.h"
#include "content/floor/voronoi.h"
#include "runtime/crowd/meetings.h"
#include "runtime/path/floor_map.h"
#include "tests/bench/bench_floor.h"
#include "tests/bench/generated_floors.h"
#include "tests/bench/measure.h"
#include "tests/support/halls.h"
#include "tests/support/reference_data.h"

namespace docent::bench {
namespace {

constexpr double square_metres_each = 4;
constexpr double radius = 0.25;
constexpr double frame = 1.0 / 60;

// --- Floors with room for a number of avatars.

double area_of(const FloorPlan& plan) {
  double twice = 0;
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall)
    twice += cross(wall_start(plan, wall), wall_end(plan, wall));
  return twice / 2;
}

/// A plan side by side with itself, as often as it takes.
FloorPlan repeated(const FloorPlan& plan, double square_metres) {
  Vec2 low = plan.vertex.front(), high = low;
  for (const Vec2 v : plan.vertex) low = glm::min(low, v), high = glm::max(high, v);
  const int copies = std::max(1, static_cast<int>(std::lround(square_metres / area_of(plan))));
  const int columns = static_cast<int>(std::ceil(std::sqrt(copies)));
  test::HallMaker maker;
  for (int i = 0; i < copies; ++i) {
    const Vec2 shift = (high - low + Vec2{1, 1}) * Vec2{i % columns, i / columns};
    for (const auto& [first, count] : plan.ring) {
      std::vector<Vec2> ring;
      for (const Vec2 v : std::span(plan.vertex).subspan(first, count)) ring.push_back(v + shift);
      maker.ring(ring);
    }
  }
  return std::move(maker.plan);
}

/// One square room.
FloorPlan open_hall(double square_metres) {
  const double side = std::sqrt(square_metres);
  return test::HallMaker().room({0, 0}, {side, side}).plan;
}

/// Halls of 12 m with doors and cases (generated_floors.h); for few avatars a room with a case.
FloorPlan museum(double square_metres) {
  if (square_metres >= 120)
    return generated_museum(static_cast<std::size_t>(square_metres / 135 * 34), Turn::Straight);
  const double side = std::sqrt(square_metres + 1);
  return test::HallMaker()
      .room({0, 0}, {side, side})
      .block({side / 2 - 0.5, side / 2 - 0.5}, {side / 2 + 0.5, side / 2 + 0.5})
      .plan;
}

/// Square booths of 2 m with walls 2 cm thick and doors of 0.8 m: one avatar in each.
FloorPlan booths(double square_metres) {
  constexpr double booth = 2, half_wall = 0.01, half_door = 0.4;
  const int side = std::max(2, static_cast<int>(std::lround(std::sqrt(square_metres) / booth)));
  test::HallMaker maker;
  maker.room({0, 0}, {side * booth, side * booth});
  // About every place where four booths meet a cross, up to the doors.
  constexpr double a = half_wall, b = booth / 2 - half_door;
  for (int y = 1; y < side; ++y)
    for (int x = 1; x < side; ++x) {
      std::vector<Vec2> ring{{a, a},   {b, a},   {b, -a}, {a, -a}, {a, -b}, {-a, -b},
                             {-a, -a}, {-b, -a}, {-b, a}, {-a, a}, {-a, b}, {a, b}};
      for (Vec2& v : ring) v += Vec2{x * booth, y * booth};
      maker.ring(ring);
    }
  return std::move(maker.plan);
}

/// Lanes of 0.8 m with walls 2 cm thick between them, open at both ends, as people queue in.
FloorPlan lanes(double square_metres) {
  constexpr double lane = 0.8, wall = 0.02, cross_way = 1.5;
  const double side = std::sqrt(square_metres);
  test::HallMaker maker;
  maker.room({0, 0}, {side, side});
  for (double x = lane; x < side - lane / 2; x += lane + wall)
    maker.block({x, cross_way}, {x + wall, side - cross_way});
  return std::move(maker.plan);
}

struct Scene {
  Floor floor;
  std::shared_ptr<const path::FloorMap> map;
};

std::unique_ptr<Scene> make_scene(FloorPlan plan) {
  auto scene = std::make_unique<Scene>();
  scene->floor.plan = std::move(plan);
  scene->floor.diagram = floor::voronoi_diagram(scene->floor.plan);
  scene->floor.roadmap = floor::medial_axis(scene->floor.plan, scene->floor.diagram);
  scene->map = path::make_floor_map(scene->floor);
  return scene;
}

// --- Avatars that walk about, clear of the walls.

std::vector<std::vector<crowd::Body>> walk_about(const path::FloorMap& map, std::size_t count,
                                                 std::size_t frames) {
  std::mt19937_64 random(5);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution(a, b)(random);
  };
  Vec2 low = map.plan().vertex.front(), high = low;
  for (const Vec2 v : map.plan().vertex) low = glm::min(low, v), high = glm::max(high, v);
  std::vector<crowd::Body> bodies;
  std::vector<double> speed, heading, turning;
  for (std::size_t tries = 0; bodies.size() < count && tries < 1000 * count; ++tries) {
    const double x = between(low.x, high.x);
    const Vec2 at{x, between(low.y, high.y)};
    if (!map.has_room(at, radius)) continue;
    bodies.push_back({at, {0, 0}, radius});
    speed.push_back(between(0, 1) < 0.2 ? 0 : between(0.6, 1.5));  // A fifth stand and look.
    heading.push_back(between(0, 6.3));
    turning.push_back(0);
  }
  if (bodies.size() < count) throw std::runtime_error("no room for the avatars");

  std::vector<std::vector<crowd::Body>> steps;
  for (std::size_t step = 0; step < frames; ++step) {
    for (std::size_t i = 0; i < count; ++i) {
      turning[i] = std::clamp(turning[i] + between(-0.3, 0.3), -1.0, 1.0);
      heading[i] += turning[i] * frame;
      for (int tries = 0; tries < 20; ++tries) {
        const Vec2 velocity = speed[i] * Vec2{std::cos(heading[i]), std::sin(heading[i])};
        bodies[i].velocity = velocity;
        if (map.has_room(bodies[i].position + frame * velocity, radius)) break;
        heading[i] += between(-2, 2);
        bodies[i].velocity = {0, 0};
      }
      bodies[i].position += frame * bodies[i].velocity;
    }
    steps.push_back(bodies);
  }
  return steps;
}

// --- Those who look for meetings.

/// Whose eyes tell who sees whom: the floor's (`can_see` asks the same), or those that Meetings
/// has, which look at the walls of its cells.
enum class Sight : std::uint8_t { Floors, Ours };

std::optional<double> sighted(const crowd::WalkableCells& floor, const crowd::Body& a,
                              const crowd::Body& b, const crowd::Collision& contact, Sight sight) {
  if (sight == Sight::Ours) return crowd::time_in_sight(floor, a, b, contact);
  const path::WallGrid& walls = floor.map().walls();
  const Vec2 a_then = a.position + contact.first * a.velocity;
  const Vec2 b_then = b.position + contact.first * b.velocity;
  if (!walls.segment_clear(a.position, a_then) || !walls.segment_clear(b.position, b_then))
    return {};
  if (walls.segment_clear(a_then, b_then)) return contact.first;
  return crowd::time_in_sight(floor, a, b, contact);
}

class BruteForce {
 public:
  explicit BruteForce(const crowd::WalkableCells& floor) : floor_(floor) {}
  const std::vector<crowd::Meeting>& find(std::span<const crowd::Body> bodies, double horizon) {
    found_.clear();
    for (std::uint32_t a = 0; a < bodies.size(); ++a)
      for (std::uint32_t b = a + 1; b < bodies.size(); ++b)
        if (const auto contact = crowd::contact_of_circles(bodies[a], bodies[b], horizon))
          if (const auto time = sighted(floor_, bodies[a], bodies[b], *contact, Sight::Floors))
            found_.push_back({a, b, *time});
    return found_;
  }

 private:
  const crowd::WalkableCells& floor_;
  std::vector<crowd::Meeting> found_;
};

/// A uniform grid, made anew every step: everybody is in all cells under the box about the swept
/// circle, and two are compared in the first cell that their boxes share.
class UniformGrid {
 public:
  UniformGrid(const crowd::WalkableCells& floor, double cell, Sight sight)
      : floor_(floor), cells_per_metre_(1 / cell), sight_(sight) {
    const FloorPlan& plan = floor.map().plan();
    Vec2 low = plan.vertex.front(), high = low;
    for (const Vec2 v : plan.vertex) low = glm::min(low, v), high = glm::max(high, v);
    origin_ = low;
    columns_ = 1 + static_cast<int>((high.x - low.x) * cells_per_metre_);
    rows_ = 1 + static_cast<int>((high.y - low.y) * cells_per_metre_);
    first_.resize(static_cast<std::size_t>(columns_ * rows_) + 1);
  }

  const std::vector<crowd::Meeting>& find(std::span<const crowd::Body> bodies, double horizon) {
    found_.clear();
    box_.resize(bodies.size());
    std::ranges::fill(first_, 0U);
    std::uint32_t entries = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const crowd::Body& body = bodies[i];
      const Vec2 end = body.position + horizon * body.velocity;
      const Vec2 reach{body.radius, body.radius};
      const Vec2 low = (glm::min(body.position, end) - reach - origin_) * cells_per_metre_;
      const Vec2 high = (glm::max(body.position, end) + reach - origin_) * cells_per_metre_;
      box_[i] = {index(low.x, columns_), index(low.y, rows_), index(high.x, columns_),
                 index(high.y, rows_)};
      visit_cells(box_[i], [&](std::size_t cell) { ++first_[cell], ++entries; });
    }
    std::exclusive_scan(first_.begin(), first_.end(), first_.begin(), 0U);
    entry_.resize(entries);
    for (std::uint32_t i = 0; i < bodies.size(); ++i)
      visit_cells(box_[i], [&](std::size_t cell) { entry_[first_[cell]++] = i; });

    std::uint32_t begin = 0;
    std::size_t cell = 0;
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x, ++cell) {
        const std::uint32_t end = first_[cell];
        compare(std::span(entry_).subspan(begin, end - begin), x, y, bodies, horizon);
        begin = end;
      }
    return found_;
  }

 private:
  struct Box {
    int left, bottom, right, top;
  };
  static int index(double value, int count) {
    return static_cast<int>(std::clamp(value, 0.0, count - 1.0));
  }
  template <class Visit>
  void visit_cells(const Box& box, Visit visit) const {
    for (int y = box.bottom; y <= box.top; ++y)
      for (int x = box.left; x <= box.right; ++x)
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(x));
  }
  void compare(std::span<const std::uint32_t> entries, int x, int y,
               std::span<const crowd::Body> bodies, double horizon) {
    if (entries.size() < 2) return;
    crowd_.clear();
    for (const std::uint32_t i : entries) crowd_.push_back(bodies[i]);
    for (std::size_t i = 0; i + 1 < entries.size(); ++i)
      for (std::size_t j = i + 1; j < entries.size(); ++j) {
        const auto contact = crowd::contact_of_circles(crowd_[i], crowd_[j], horizon);
        if (!contact) continue;
        const Box &p = box_[entries[i]], &q = box_[entries[j]];
        if (std::max(p.left, q.left) != x || std::max(p.bottom, q.bottom) != y) continue;
        if (const auto time = sighted(floor_, crowd_[i], crowd_[j], *contact, sight_))
          found_.push_back({entries[i], entries[j], *time});
      }
  }

  const crowd::WalkableCells& floor_;
  double cells_per_metre_;
  Sight sight_;
  Vec2 origin_{};
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_, entry_;
  std::vector<Box> box_;
  std::vector<crowd::Body> crowd_;
  std::vector<crowd::Meeting> found_;
};

// --- The contest.

struct Entrant {
  std::function<std::size_t(std::span<const crowd::Body>)> step;
  std::vector<double> seconds;
  std::size_t met = 0;
};

/// Sorted by bodies, to compare.
std::vector<crowd::Meeting> sorted(std::span<const crowd::Meeting> meetings) {
  std::vector<crowd::Meeting> result(meetings.begin(), meetings.end());
  std::ranges::sort(result, {}, [](const crowd::Meeting& m) { return std::pair(m.a, m.b); });
  return result;
}

void check_agreement(const crowd::WalkableCells& floor, std::span<const crowd::Body> bodies,
                     double horizon, std::span<const crowd::Meeting> ours) {
  const auto theirs = sorted(BruteForce(floor).find(bodies, horizon));
  const bool same =
      std::ranges::equal(ours, theirs, [](const crowd::Meeting& x, const crowd::Meeting& y) {
        return x.a == y.a && x.b == y.b && x.time == y.time;
      });
  if (!same) throw std::runtime_error("brute force finds other meetings");
}

/// All take the same steps in turn; a step's time is the mean over the steps of the least of the
/// rounds, which leaves out what the rest of the machine did meanwhile. The first step, to which
/// everybody has jumped from the last, is left out.
double microseconds(const Entrant& entrant, std::size_t steps) {
  std::vector<double> best(steps, 1e9);
  for (std::size_t i = 0; i < entrant.seconds.size(); ++i)
    best[i % steps] = std::min(best[i % steps], entrant.seconds[i]);
  return std::accumulate(best.begin() + 1, best.end(), 0.0) / static_cast<double>(steps - 1) * 1e6;
}

void run(const std::string& name, const FloorPlan& plan, std::size_t count, double horizon,
         std::size_t frames, int rounds, std::span<const double> cells) {
  const auto scene = make_scene(plan);
  const auto steps = walk_about(*scene->map, count, frames);
  crowd::Meetings meetings(*scene->map, count);
  const crowd::WalkableCells& floor = meetings.cells();
  BruteForce brute_force(floor);
  std::vector<UniformGrid> grids;
  for (const Sight sight : {Sight::Floors, Sight::Ours})
    for (const double cell : cells) grids.emplace_back(floor, cell, sight);

  std::vector<Entrant> entrants;
  entrants.push_back({[&](std::span<const crowd::Body> bodies) {
                        meetings.update(bodies);
                        return meetings.find(horizon).size();
                      },
                      {},
                      0});
  for (UniformGrid& grid : grids)
    entrants.push_back(
        {[&](std::span<const crowd::Body> bodies) { return grid.find(bodies, horizon).size(); },
         {},
         0});
  for (int round = 0; round < rounds; ++round)
    for (Entrant& entrant : entrants) {
      entrant.met = 0;
      for (const auto& bodies : steps) {
        const double begin = now();
        entrant.met += entrant.step(bodies);
        entrant.seconds.push_back(now() - begin);
      }
    }
  std::vector<double> grid_us;
  for (std::size_t i = 1; i < entrants.size(); ++i) {
    if (entrants[i].met != entrants[0].met) throw std::runtime_error("a grid finds others");
    grid_us.push_back(microseconds(entrants[i], steps.size()));
  }

  Entrant brute{
      [&](std::span<const crowd::Body> bodies) { return brute_force.find(bodies, horizon).size(); },
      {},
      0};
  const std::size_t few = std::min(steps.size(), std::max<std::size_t>(2, 20'000 / count));
  for (std::size_t i = 0; i < few; ++i) {
    const double begin = now();
    brute.step(steps[i]);
    brute.seconds.push_back(now() - begin);
  }
  for (std::size_t i = 0; i < steps.size(); i += 1 + steps.size() / 4) {
    meetings.update(steps[i]);
    check_agreement(floor, steps[i], horizon, meetings.find(horizon));
  }

  const double ours = microseconds(entrants[0], steps.size());
  const auto best = std::min_element(grid_us.begin(),
                                     grid_us.begin() + static_cast<std::ptrdiff_t>(cells.size()));
  const double best_with_our_sight = std::ranges::min(std::span(grid_us).subspan(cells.size()));
  const auto cell = static_cast<std::size_t>(best - grid_us.begin());
  fmt::print(
      "{:<10.10} {:>8} {:>8} {:>9.1f} {:>12.1f} {:>9.1f} {:>6.1f} {:>9.1f} {:>9.1f} {:>8.2f} "
      "{:>8.2f}\n",
      name, count, plan.vertex.size(),
      static_cast<double>(entrants[0].met) / static_cast<double>(steps.size()),
      microseconds(brute, few), *best, cells[cell], best_with_our_sight, ours, ours / *best,
      ours / best_with_our_sight);
  std::fflush(stdout);
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  using namespace docent;
  using namespace docent::bench;
  std::string folder = (test::reference_data() / "floorplans" / "reference" / "maps").string();
  std::vector<std::size_t> avatars{10, 100, 1'000, 10'000};
  std::vector<std::string> only;
  double horizon = 1;
  std::size_t frames = 120;
  int rounds = 7;
  std::vector<double> cells{1.5, 2, 2.5, 3, 4, 6};
  CLI::App app("Times the detection of meetings");
  app.add_option("--maps", folder, "folder of polymaps");
  app.add_option("--avatars", avatars, "how many")->delimiter(',');
  app.add_option("--only", only, "floors of these names")->delimiter(',');
  app.add_option("--horizon", horizon, "seconds")->check(CLI::NonNegativeNumber);
  app.add_option("--cells", cells, "sizes of the grids' cells, metres")->delimiter(',');
  app.add_option("--frames", frames, "steps")->check(CLI::PositiveNumber);
  app.add_option("--repeat", rounds, "rounds")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    fmt::print("microseconds a step, horizon {} s, one avatar to {} square metres\n", horizon,
               square_metres_each);
    fmt::print("{:<10} {:>8} {:>8} {:>9} {:>12} {:>9} {:>6} {:>9} {:>9} {:>8} {:>8}\n", "floor",
               "avatars", "walls", "meetings", "brute force", "grid", "cell", "grid+eyes", "ours",
               "of grid", "of g+e");
    struct Maker {
      std::string name;
      std::function<FloorPlan(double)> make;
    };
    std::vector<Maker> makers{
        {"museum", museum}, {"open hall", open_hall}, {"booths", booths}, {"lanes", lanes}};
    for (const char* name : {"museum-s1", "museum-l1"}) {
      const auto file = std::filesystem::path(folder) / (std::string(name) + ".json");
      if (!std::filesystem::exists(file)) continue;
      const auto plan = compile(read_polymap(file), std::vector{0.0})->floor.plan;
      makers.push_back({name, [plan](double area) { return repeated(plan, area); }});
    }
    for (const auto& [name, make] : makers) {
      if (!only.empty() && std::ranges::find(only, name) == only.end()) continue;
      for (const std::size_t count : avatars) {
        const FloorPlan plan = make(square_metres_each * static_cast<double>(count));
        // A plan with more room than that is another question.
        if (area_of(plan) > 1.5 * square_metres_each * static_cast<double>(count)) continue;
        run(name, plan, count, horizon, frames, rounds, cells);
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_company: {}\n", error.what());
    return 2;
  }
  return 0;
}

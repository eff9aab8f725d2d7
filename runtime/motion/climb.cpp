#include "runtime/motion/climb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "runtime/motion/footfalls.h"
#include "runtime/motion/leg.h"
#include "runtime/motion/replant.h"
#include "runtime/motion/smoothing.h"
#include "runtime/motion/walk_graph.h"

namespace docent::motion {
namespace {

constexpr double heel = 0.05;            // metres of a foot behind its ankle
constexpr double off_edge = 0.02;        // metres that a foot keeps from the riser
constexpr double least_lift = 0.03;      // metres that a swinging foot rises over a straight line
constexpr double most_lift = 0.3;        // metres
constexpr double clear_of_tread = 0.02;  // metres between a swinging foot and what it passes
constexpr float reach_share = 0.995F;    // of a leg's length that it is stretched to
constexpr double level_step = 0.5;       // metres, before and behind the treads
constexpr double calms = 0.25;           // seconds over which the body sinks
constexpr double on_the_ball = 0.4;  // radians that the heel is up where a foot lands going down
constexpr double heel_down = 0.18;   // seconds in which the heel then comes down
constexpr int aimed_tries = 6;       // for a level walk of as many steps; then...
constexpr int tries = 26;            // ... longer and longer ones

/// Minimum jerk from 0 to 1 (Flash and Hogan 1985).
double ease(double t) noexcept {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * (10 + t * (6 * t - 15));
}

double bump(double t) noexcept {
  const double parabola = 4 * t * (1 - t);
  return parabola * parabola;
}

/// How a foot lies under its ball: metres ahead of it and behind it.
struct Sole {
  double ahead = 0, behind = 0;
};

Sole sole_of(const Leg& leg) noexcept {
  return {glm::length(leg.tip), std::hypot(leg.ankle_to_toe.x, leg.ankle_to_toe.z) + heel};
}

/// Where the ball of a foot is put on a tread: the foot in its middle, as far as there is room.
double ball_on(const Treads& treads, int tread, const Sole& sole) noexcept {
  const double begin = treads.begin_of(tread), end = begin + treads.depth();
  const double middle = (begin + end + sole.behind - sole.ahead) / 2;
  const double free = treads.rise > 0 ? std::min(middle, end - sole.ahead - off_edge)
                                      : std::max(middle, begin + sole.behind + off_edge);
  return std::clamp(free, std::min(begin + off_edge, end), end - std::min(off_edge, end - begin));
}

/// Turns a level walk into one over the flight.
class Climber {
 public:
  Climber(const WalkGraph& graph, const Ascent& ascent, Walk walk)
      : graph_(graph), skeleton_(graph.motion->skeleton), ascent_(ascent), walk_(std::move(walk)) {
    along_ = (ascent.to - ascent.from) / glm::distance(ascent.from, ascent.to);
    for (std::size_t f = 0; f < walk_.root.size(); ++f)
      for (const Side side : both_sides)
        level_[index_of(side)].push_back(foot_of(skeleton_, graph_.legs[side], pose_at(f)));
    for (const Side side : both_sides)
      find_footfalls(walk_, side, level_[index_of(side)], ascent_.from, along_, falls_);
    order_footfalls(falls_);
  }

  /// How many steps there are too many; below 0: too few. `tolerance`: so many more or fewer on the
  /// floor are taken longer or shorter.
  [[nodiscard]] int steps_too_many(int tolerance) const {
    if (falls_.empty()) return -1;
    const int spare = static_cast<int>(count_of_steps(falls_)) - ascent_.treads.count;
    const int least = std::max(0, least_spare() - tolerance);
    const int most = least_spare() + 1 + tolerance;
    return spare < least ? spare - least : std::max(0, spare - most);
  }

  Walk climb() && {
    place_footfalls();
    map_body();
    for (const Side side : both_sides) place_feet(side);
    sink_into_reach();
    set_feet();
    return std::move(walk_);
  }

 private:
  /// Steps on the floor before and after the treads.
  [[nodiscard]] std::pair<int, int> level_steps() const {
    const Treads& treads = ascent_.treads;
    const double before = ball(0) - falls_.front().along;
    const double after = glm::distance(ascent_.from, ascent_.to) + lead() - ball(treads.count - 1);
    const auto count = [](double metres) {
      return std::max(0, static_cast<int>(std::ceil(metres / level_step - 0.2)) - 1);
    };
    return {count(before), count(after)};
  }
  [[nodiscard]] int least_spare() const {
    const auto [before, after] = level_steps();
    return before + after;
  }
  [[nodiscard]] double ball(int tread) const {
    return ball_on(ascent_.treads, tread, sole_of(graph_.legs[Side::Left]));
  }
  /// Where a ball comes next to the first riser, or to the last, and the foot is still on the
  /// floor.
  [[nodiscard]] double last_before(double start) const {
    const double ahead = sole_of(graph_.legs[Side::Left]).ahead + off_edge;
    return std::max(start, ascent_.treads.near - (ascent_.treads.rise > 0 ? ahead : 0));
  }
  [[nodiscard]] double first_after(double end) const {
    const double behind = sole_of(graph_.legs[Side::Left]).behind + off_edge;
    return std::min(end, ascent_.treads.near + ascent_.treads.length +
                             (ascent_.treads.rise < 0 ? behind : off_edge));
  }
  /// Metres from the body's place to the balls of its feet, where it stands.
  [[nodiscard]] double lead() const {
    return falls_.front().along - dot(walk_.body.front().position - ascent_.from, along_);
  }

  PoseView pose_at(std::size_t f) {
    return {walk_.root[f],
            std::span(walk_.rotation).subspan(f * walk_.joint_count, walk_.joint_count)};
  }

  /// Gives each footfall its place: one to each tread, the others evenly on the floor before and
  /// behind.
  void place_footfalls() {
    const double way = glm::distance(ascent_.from, ascent_.to);
    const double level_way = dot(walk_.body.back().position - ascent_.from, along_);
    const std::span<Footfall> own = steps(falls_);
    const int spare = static_cast<int>(own.size()) - ascent_.treads.count;
    const int before = std::max(0, std::min(spare, spare - level_steps().second));
    const double start = falls_.front().along;
    const double end = way + lead();
    for (Footfall& fall : falls_)
      fall.target = fall.along < own.front().along ? fall.along : fall.along + way - level_way;
    for (int i = 0; i < static_cast<int>(own.size()); ++i) {
      Footfall& fall = own[static_cast<std::size_t>(i)];
      const int tread = i - before;
      const int after = static_cast<int>(own.size()) - before - ascent_.treads.count;
      if (tread < 0)
        fall.target =
            std::min(std::lerp(start, ball(0), (i + 1.0) / (before + 1)), last_before(start));
      else if (tread < ascent_.treads.count)
        fall.target = ball(tread);
      else
        fall.target = std::max(std::lerp(ball(ascent_.treads.count - 1), end,
                                         (tread - ascent_.treads.count + 1.0) / (after + 1)),
                               first_after(end));
    }
    for (Footfall& fall : falls_) fall.height = ascent_.treads.height_at(fall.target);
    map_ = make_footfall_map(falls_);
  }

  void map_body() {
    const double ahead = lead();
    walk_.climb.resize(walk_.root.size());
    for (std::size_t f = 0; f < walk_.root.size(); ++f) {
      const double at = dot(walk_.body[f].position - ascent_.from, along_);
      const FootfallMap::Place place = map_.at(at + ahead);
      const Vec2 shift = (place.along - ahead - at) * along_;
      walk_.body[f].position += shift;
      walk_.root[f] += to_world(shift);
      walk_.climb[f].body = static_cast<float>(place.height);
      walk_.along[f] = static_cast<float>(
          std::max(0.0, map_.at(static_cast<double>(walk_.along[f]) + ahead).along - ahead));
    }
  }

  void place_feet(Side side) {
    std::vector<Foot>& feet = level_[index_of(side)];
    const std::vector<Footfall*> own = footfalls_of(falls_, side);
    heel_up_[index_of(side)].assign(feet.size(), 0);
    for (std::size_t i = 0; i < own.size(); ++i)
      plant(side, *own[i], i > 0 && own[i]->height < own[i - 1]->height - 0.01);
    for (std::size_t i = 0; i + 1 < own.size(); ++i) swing(side, *own[i], *own[i + 1]);
    // Before the first and after the last it goes where the floor does.
    for (std::size_t f = own.back()->last + 1; f < feet.size(); ++f)
      shift(side, f, own.back()->target - own.back()->along, own.back()->height);
    for (std::size_t f = 0; f < own.front()->first; ++f)
      shift(side, f, own.front()->target - own.front()->along, own.front()->height);
  }

  void shift(Side side, std::size_t f, double metres, double height) {
    level_[index_of(side)][f].toe += to_world(metres * along_, height);
    walk_.climb[f].foot[index_of(side)] = static_cast<float>(height);
  }

  /// Going down one lands on the ball of the foot, and the heel follows.
  void plant(Side side, const Footfall& fall, bool lands_lower) {
    const Vec3 toe = fall.toe + to_world((fall.target - fall.along) * along_, fall.height);
    for (std::size_t f = fall.first; f <= fall.last; ++f) {
      level_[index_of(side)][f].toe = toe;
      if (lands_lower) {
        const double since = static_cast<double>(f - fall.first) / walk_.frame_rate;
        heel_up_[index_of(side)][f] =
            static_cast<float>(on_the_ball * (1 - ease(since / heel_down)));
      }
      walk_.climb[f].foot[index_of(side)] = static_cast<float>(fall.height);
    }
  }

  [[nodiscard]] bool is_level(const Footfall& a, const Footfall& b) const {
    const Treads& treads = ascent_.treads;
    const double low = std::min(a.target, b.target), high = std::max(a.target, b.target);
    return a.height == b.height && (high < treads.near || low > treads.near + treads.length);
  }

  /// From footfall to footfall. Up a flight a foot rises before it goes ahead, down it goes ahead
  /// before it sinks; and in between it rises as far as it must to pass what is in its way.
  void swing(Side side, const Footfall& from, const Footfall& to) {
    std::vector<Foot>& feet = level_[index_of(side)];
    const std::size_t count = to.first - from.last;
    if (count < 2) return;
    if (is_level(from, to)) {
      for (std::size_t f = from.last + 1; f < to.first; ++f) {
        const double at = dot(to_floor(feet[f].toe) - ascent_.from, along_);
        shift(side, f, map_.at(at).along - at, from.height);
      }
      return;
    }
    const Vec3 lifted = feet[from.last].toe, landing = feet[to.first].toe;
    const Quat lifted_as = feet[from.last].rotation, landing_as = feet[to.first].rotation;
    const double rise = to.height - from.height;
    double lift = least_lift;
    for (std::size_t k = 1; k < count; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(count);
      Foot& foot = feet[from.last + k];
      const double over = rise < 0 ? ease(t / 0.85) : ease((t - 0.14) / 0.86);
      const double risen = rise < 0 ? ease((t - 0.3) / 0.7) : ease(t / 0.8);
      foot.toe = glm::mix(lifted, landing, static_cast<float>(over));
      foot.toe.y = static_cast<float>(std::lerp(lifted.y, landing.y, risen));
      foot.rotation = glm::slerp(lifted_as, landing_as, static_cast<float>(ease(t / 0.65)));
      heel_up_[index_of(side)][from.last + k] =
          heel_up_[index_of(side)][to.first] * static_cast<float>(ease(2 * t - 1));
      lift = std::max(lift, sunk(side, foot, bump(t)) / std::max(bump(t), 0.05));
    }
    lift = std::min(lift, most_lift);
    for (std::size_t k = 1; k < count; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(count);
      Foot& foot = feet[from.last + k];
      foot.toe.y += static_cast<float>(lift * bump(t));
      walk_.climb[from.last + k].foot[index_of(side)] =
          static_cast<float>(ascent_.treads.height_at(distance_of(foot.toe)));
    }
  }

  [[nodiscard]] double distance_of(Vec3 place) const {
    return dot(to_floor(place) - ascent_.from, along_);
  }

  /// How far ball, tip or heel are below where they should pass over the treads. `full` of it where
  /// the foot is well on its way.
  [[nodiscard]] double sunk(Side side, const Foot& foot, double full) const {
    const Leg& leg = graph_.legs[side];
    const double ball_height = foot.toe.y - graph_.toe_height[index_of(side)];
    const Vec3 ankle = ankle_of(leg, foot);  // a heel that is up is higher
    const double heel_height = ankle.y - graph_.ankle_height[index_of(side)];
    const double clear = clear_of_tread * full;
    const auto under = [&](double along, double height) {
      return ascent_.treads.height_at(along) + clear - height;
    };
    const double at = distance_of(foot.toe);
    return std::max({under(at, ball_height), under(at + sole_of(leg).ahead, ball_height),
                     under(distance_of(ankle) - heel, heel_height)});
  }

  /// Lowers the body where a leg would not reach its foot.
  void sink_into_reach() {
    std::vector<double> drop(walk_.root.size());
    for (std::size_t f = 0; f < walk_.root.size(); ++f) {
      PoseView pose = raised_pose(f);
      for (const Side side : both_sides) {
        const Leg& leg = graph_.legs[side];
        const Vec3 ankle = ankle_of(leg, heel_raised(side, f));
        drop[f] =
            std::max(drop[f], static_cast<double>(drop_into_reach(
                                  hip_of(skeleton_, leg, pose), ankle, reach_share * leg.length)));
      }
    }
    const auto radius = static_cast<std::size_t>(calms * walk_.frame_rate);
    const std::vector<double> smooth = smooth_above(drop, radius);
    const auto frames = static_cast<double>(drop.size() - 1);
    for (std::size_t f = 0; f < drop.size(); ++f) {
      const double edge = std::min(static_cast<double>(f), frames - static_cast<double>(f));
      walk_.root[f].y -=
          static_cast<float>(smooth[f] * ease(edge / (2 * static_cast<double>(radius))));
    }
  }

  PoseView raised_pose(std::size_t f) {
    PoseView pose = pose_at(f);
    pose.root.y += walk_.climb[f].body;
    return pose;
  }

  void set_feet() {
    for (std::size_t f = 0; f < walk_.root.size(); ++f) {
      PoseView pose = raised_pose(f);
      for (const Side side : both_sides) set_foot(side, f, pose);
    }
  }

  /// The foot turned about its ball, heel up.
  [[nodiscard]] Foot heel_raised(Side side, std::size_t f) const {
    Foot foot = level_[index_of(side)][f];
    const Vec3 across = to_world({along_.y, -along_.x});  // the body's right
    foot.rotation = glm::angleAxis(-heel_up_[index_of(side)][f], across) * foot.rotation;
    return foot;
  }

  /// The toes stay as flat as they were.
  void set_foot(Side side, std::size_t f, PoseView& pose) const {
    const Leg& leg = graph_.legs[side];
    const Foot foot = heel_raised(side, f);
    place_foot(skeleton_, leg, foot, pose);
    Quat& toes = pose.rotation[leg.joint[leg.toe]];
    toes = glm::normalize(glm::inverse(foot.rotation) * level_[index_of(side)][f].rotation * toes);
  }

  const WalkGraph& graph_;
  const Skeleton& skeleton_;
  const Ascent& ascent_;
  Walk walk_;
  Vec2 along_{};
  std::array<std::vector<Foot>, 2> level_;     ///< Where the feet go, a frame each...
  std::array<std::vector<float>, 2> heel_up_;  ///< ... and radians that the heel is up besides.
  std::vector<Footfall> falls_;
  FootfallMap map_;
};

}  // namespace

Result<Walk> climb(const WalkGraph& graph, const Ascent& ascent, WalkRequest request) {
  const Vec2 along = (ascent.to - ascent.from) / glm::distance(ascent.from, ascent.to);
  const double step = graph.speed * graph.stride_seconds / 2;
  const double likely = step * (ascent.treads.count + 1);
  double way = likely;
  for (int i = 0; i < tries; ++i) {
    const std::array path{ascent.from, ascent.from + way * along};
    request.path = path;
    Result<Walk> walk = make_walk(graph, request);
    if (!walk) return walk;
    Climber climber(graph, ascent, std::move(*walk));
    const int too_many = climber.steps_too_many(i / 5);
    if (too_many == 0) return std::move(climber).climb();
    way = i < aimed_tries ? std::max(way - too_many * step * (i < 3 ? 1.0 : 0.45), 0.3 * step)
                          : likely + step * (0.25 * (i - aimed_tries) - 1.5);
  }
  return std::unexpected(
      Error{Errc::InvalidInput, "no walk has as many steps as the stairs from (" +
                                    std::to_string(ascent.from.x) + ", " +
                                    std::to_string(ascent.from.y) + ") have treads"});
}

}  // namespace docent::motion

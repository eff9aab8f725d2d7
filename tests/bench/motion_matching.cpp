#include "tests/bench/motion_matching.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/model/geometry/polyline.h"
#include "runtime/motion/path_track.h"
#include "runtime/motion/placement.h"
#include "runtime/motion/pose.h"
#include "tests/bench/measure.h"

namespace docent::bench {
namespace {

constexpr std::array<double, 3> horizons{1.0 / 3, 2.0 / 3, 1.0};  // seconds
constexpr double search_every = 0.1;                              // seconds
constexpr double same_passage = 0.2;   // seconds: a jump to a frame so near is none
constexpr double left_in_clip = 0.15;  // seconds that must be left where one jumps to
constexpr double half_life = 0.08;     // seconds, of what differs after a jump
constexpr double speeding_up = 0.3;    // seconds, time constant of the wanted speed
constexpr double standing = 0.12;      // metres a second
constexpr std::size_t feet_begin = 12, velocities_begin = 18;

/// How much each group of features counts.
constexpr double weight_of(std::size_t feature) {
  if (feature < 6) return 1.0;                  // places ahead
  if (feature < feet_begin) return 1.5;         // facings ahead
  if (feature < velocities_begin) return 0.75;  // feet
  return 1.0;                                   // velocities
}

Vec2 facing_of(double heading) {
  return {std::cos(heading), std::sin(heading)};
}

/// A body's parts relative to where it stands: x and y of the floor, z up.
glm::dvec3 relative(const Placement& home, Vec3 world) {
  const Vec2 p = home.position + motion::turned(to_floor(world), home.heading);
  return {p.x, p.y, static_cast<double>(world.y)};
}

struct BodyPlaces {
  std::array<glm::dvec3, 2> toe{};
  glm::dvec3 hips{};
};

BodyPlaces places_in(const motion::WalkGraph& graph, const MotionClip& clip, std::size_t frame,
                     const Placement& home) {
  const Skeleton& skeleton = graph.motion->skeleton;
  std::vector<Quat> rotation(clip.joint_count);
  std::vector<Mat4> world(clip.joint_count);
  motion::PoseView pose{{}, rotation};
  motion::sample(clip, static_cast<double>(frame) / clip.frame_rate, pose);
  motion::to_world_space(skeleton, pose, world);
  const auto place = [&](BodyPart part) {
    return relative(home, Vec3(world[index_of(skeleton[part])][3]));
  };
  return {{place(BodyPart::LeftToe), place(BodyPart::RightToe)}, relative(home, pose.root)};
}

void put(MatchingFeatures& features, std::size_t at, glm::dvec3 v) {
  features[at] = v.x;
  features[at + 1] = v.y;
  features[at + 2] = v.z;
}

void put_ahead(MatchingFeatures& features, std::size_t horizon, const Placement& ahead) {
  const Vec2 facing = facing_of(ahead.heading);
  features[2 * horizon] = ahead.position.x;
  features[2 * horizon + 1] = ahead.position.y;
  features[6 + 2 * horizon] = facing.x;
  features[6 + 2 * horizon + 1] = facing.y;
}

MatchingFeatures features_of(const motion::WalkGraph& graph, ClipFrame at) {
  const MotionClip& clip = graph.motion->clips[at.clip];
  const std::vector<Placement>& body = graph.clip[at.clip].body;
  const std::uint32_t last = frame_count(clip) - 1;
  const Placement home = motion::inverse(body[at.frame]);
  MatchingFeatures features{};
  for (std::size_t h = 0; h < horizons.size(); ++h) {
    const auto ahead = static_cast<std::uint32_t>(std::lround(horizons[h] * clip.frame_rate));
    put_ahead(features, h, motion::compose(home, body[std::min(at.frame + ahead, last)]));
  }
  const std::uint32_t before = at.frame > 0 ? at.frame - 1 : 0;
  const std::uint32_t after = std::min(at.frame + 1, last);
  const double rate = clip.frame_rate / std::max(1U, after - before);
  const BodyPlaces here = places_in(graph, clip, at.frame, home);
  const BodyPlaces past = places_in(graph, clip, before, home);
  const BodyPlaces next = places_in(graph, clip, after, home);
  for (std::size_t side = 0; side < 2; ++side) {
    put(features, feet_begin + 3 * side, here.toe[side]);
    put(features, velocities_begin + 3 * side, rate * (next.toe[side] - past.toe[side]));
  }
  put(features, velocities_begin + 6, rate * (next.hips - past.hips));
  return features;
}

double square_distance(const MatchingFeatures& a, const MatchingFeatures& b, double limit) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size() && sum < limit; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// What differs after a jump and how it changes, on its way to nothing: a critically damped spring.
struct Fading {
  Vec3 value{}, velocity{};

  void step(float seconds) {
    const float damping = 2 * 0.69314718f / static_cast<float>(half_life);
    const Vec3 lead = velocity + damping * value;
    const float left = std::exp(-damping * seconds);
    value = left * (value + seconds * lead);
    velocity = left * (velocity - seconds * damping * lead);
  }
};

Vec3 rotation_vector(Quat q) {
  if (q.w < 0) q = -q;
  const Vec3 axis(q.x, q.y, q.z);
  const float sine = glm::length(axis);
  return sine < 1e-6f ? 2.0f * axis : 2 * std::atan2(sine, q.w) / sine * axis;
}

Quat rotation_by(Vec3 v) {
  const float angle = glm::length(v);
  return angle < 1e-6f ? Quat(1, 0.5f * v.x, 0.5f * v.y, 0.5f * v.z)
                       : glm::angleAxis(angle, v / angle);
}

/// A velocity that a body can have: recordings hold frames in which a joint leaps.
Vec3 at_most(float speed, Vec3 velocity) {
  const float length = glm::length(velocity);
  return length > speed ? speed / length * velocity : velocity;
}
constexpr float quickest_joint = 10;  // radians a second
constexpr float quickest_root = 1;    // metres a second, against the body

/// A pose relative to where the body stands.
struct BodyPose {
  Vec3 root{};
  std::vector<Quat> rotation;
};

}  // namespace

MotionMatcher::MotionMatcher(const motion::WalkGraph& graph) : graph_(graph) {
  for (std::uint32_t c = 0; c < graph.clip.size(); ++c) {
    first_of_clip_.push_back(static_cast<std::uint32_t>(frame_.size()));
    for (std::uint32_t f = 0; f < graph.clip[c].body.size(); ++f) {
      frame_.push_back({c, f});
      features_.push_back(features_of(graph, {c, f}));
    }
  }
  const auto count = static_cast<double>(features_.size());
  for (const MatchingFeatures& f : features_)
    for (std::size_t i = 0; i < f.size(); ++i) mean_[i] += f[i] / count;
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    double variance = 0;
    for (const MatchingFeatures& f : features_) variance += (f[i] - mean_[i]) * (f[i] - mean_[i]);
    scale_[i] = weight_of(i) / std::max(std::sqrt(variance / count), 1e-3);
  }
  for (MatchingFeatures& f : features_)
    for (std::size_t i = 0; i < f.size(); ++i) f[i] = (f[i] - mean_[i]) * scale_[i];
}

/// A path's points at equal distances.
class SampledPath {
 public:
  explicit SampledPath(std::span<const Vec2> path) : length_(polyline_length(path)) {
    double walked = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const double length = glm::distance(path[i - 1], path[i]);
      for (double s = next(); s < walked + length; s = next())
        point_.push_back(glm::mix(path[i - 1], path[i], (s - walked) / length));
      walked += length;
    }
    point_.push_back(path.back());
  }

  static constexpr double spacing = 0.01;  // metres
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] Vec2 at(double along) const {
    const double place = std::max(along, 0.0) / spacing;
    return point_[std::min(static_cast<std::size_t>(place + 0.5), point_.size() - 1)];
  }

 private:
  [[nodiscard]] double next() const { return spacing * static_cast<double>(point_.size()); }

  std::vector<Vec2> point_;
  double length_;
};

/// One walk in the making.
class MatchedWalk {
 public:
  MatchedWalk(const MotionMatcher& matcher, std::span<const Vec2> path, const Placement& start)
      : matcher_(matcher), graph_(matcher.graph_), path_(path), body_(start) {
    at_ = {graph_.starts.front(), graph_.clip[graph_.starts.front()].first};
    walk_.frame_rate = graph_.frame_rate;
    walk_.joint_count = clip().joint_count;
    fading_.resize(walk_.joint_count + 1);
  }

  motion::Walk make() {
    const double longest = 2 * path_.length() / graph_.speed + 4;
    const auto frames = static_cast<std::size_t>(longest * graph_.frame_rate);
    const auto interval = static_cast<std::size_t>(search_every * graph_.frame_rate);
    for (std::size_t f = 0; f < frames; ++f) {
      if (f > 0) advance();
      const bool is_at_clip_end = at_.frame + 1 >= frame_count(clip());
      if (f > 0 && (f % interval == 0 || is_at_clip_end)) search(is_at_clip_end);
      show();
      if (f > interval && path_.length() - along_ < 0.5 && speed_ < standing) break;
    }
    return std::move(walk_);
  }

 private:
  const MotionClip& clip() const { return graph_.motion->clips[at_.clip]; }
  const std::vector<Placement>& clip_body() const { return graph_.clip[at_.clip].body; }

  void advance() {
    if (at_.frame + 1 < frame_count(clip())) {
      const Placement step =
          motion::compose(motion::inverse(clip_body()[at_.frame]), clip_body()[at_.frame + 1]);
      body_ = motion::compose(body_, step);
      speed_ = glm::length(step.position) * graph_.frame_rate;
      ++at_.frame;
    }
    for (Fading& fading : fading_) fading.step(static_cast<float>(1 / graph_.frame_rate));
    find_along();
  }

  /// Nearest point of the path, searched forward.
  void find_along() {
    double best = glm::distance(path_.at(along_), body_.position);
    const double farthest = std::min(along_ + 0.4, path_.length());
    for (double s = along_; s <= farthest; s += SampledPath::spacing) {
      const double distance = glm::distance(path_.at(s), body_.position);
      if (distance <= best) best = distance, along_ = s;
    }
  }

  MatchingFeatures wanted() const {
    const std::uint32_t here = matcher_.first_of_clip_[at_.clip] + at_.frame;
    MatchingFeatures query = matcher_.features_[here];
    MatchingFeatures ahead{};
    for (std::size_t h = 0; h < horizons.size(); ++h) {
      const double t = horizons[h];
      const double way = graph_.speed * t -
                         (graph_.speed - speed_) * speeding_up * (1 - std::exp(-t / speeding_up));
      const double s = std::min(along_ + way, path_.length());
      const Vec2 tangent = path_.at(std::min(s + 0.05, path_.length())) -
                           path_.at(std::min(s, path_.length() - 0.05) - 0.05);
      const Placement place{path_.at(s), std::atan2(tangent.y, tangent.x)};
      put_ahead(ahead, h, motion::compose(motion::inverse(body_), place));
    }
    for (std::size_t i = 0; i < feet_begin; ++i)
      query[i] = (ahead[i] - matcher_.mean_[i]) * matcher_.scale_[i];
    return query;
  }

  void search(bool must_jump) {
    const double began = now();
    const MatchingFeatures query = wanted();
    const std::uint32_t here = matcher_.first_of_clip_[at_.clip] + at_.frame;
    double least = must_jump ? std::numeric_limits<double>::infinity()
                             : square_distance(query, matcher_.features_[here], 1e300);
    std::uint32_t best = here;
    const auto left = static_cast<std::uint32_t>(left_in_clip * graph_.frame_rate);
    for (std::uint32_t i = 0; i < matcher_.frame_.size(); ++i) {
      const ClipFrame there = matcher_.frame_[i];
      if (there.frame + left >= frame_count(graph_.motion->clips[there.clip])) continue;
      const double distance = square_distance(query, matcher_.features_[i], least);
      if (distance < least) least = distance, best = i;
    }
    ++walk_.expanded;
    walk_.search_seconds += now() - began;
    const ClipFrame to = matcher_.frame_[best];
    const double apart = std::abs(static_cast<double>(to.frame) - at_.frame) / graph_.frame_rate;
    if (to.clip != at_.clip || apart > same_passage || must_jump) jump(to);
  }

  BodyPose pose_at(ClipFrame at) const {
    const MotionClip& from = graph_.motion->clips[at.clip];
    const Placement home = motion::inverse(graph_.clip[at.clip].body[at.frame]);
    const auto first =
        from.rotation.begin() + static_cast<std::ptrdiff_t>(at.frame) * from.joint_count;
    BodyPose pose{motion::moved(home, from.root[at.frame]), {first, first + from.joint_count}};
    pose.rotation[0] = motion::world_rotation(home.heading) * pose.rotation[0];
    return pose;
  }

  /// Velocities of a pose: the difference to the frame before, a second.
  BodyPose pose_before(ClipFrame at) const {
    return pose_at({at.clip, at.frame > 0 ? at.frame - 1 : 0});
  }

  void jump(ClipFrame to) {
    const BodyPose old = pose_at(at_), old_before = pose_before(at_);
    const BodyPose next = pose_at(to), next_before = pose_before(to);
    const auto rate = static_cast<float>(graph_.frame_rate);
    fading_.back().value += old.root - next.root;
    fading_.back().velocity += at_most(quickest_root, rate * (old.root - old_before.root)) -
                               at_most(quickest_root, rate * (next.root - next_before.root));
    for (std::size_t j = 0; j < old.rotation.size(); ++j) {
      const auto turn = [](Quat from, Quat target) {
        return rotation_vector(target * glm::inverse(from));
      };
      fading_[j].value = rotation_vector(rotation_by(fading_[j].value) * old.rotation[j] *
                                         glm::inverse(next.rotation[j]));
      fading_[j].velocity +=
          at_most(quickest_joint, rate * turn(old_before.rotation[j], old.rotation[j])) -
          at_most(quickest_joint, rate * turn(next_before.rotation[j], next.rotation[j]));
    }
    at_ = to;
    ++walk_.transitions;
  }

  void show() {
    const BodyPose pose = pose_at(at_);
    walk_.root.push_back(motion::moved(body_, pose.root + fading_.back().value));
    const std::size_t first = walk_.rotation.size();
    for (std::size_t j = 0; j < pose.rotation.size(); ++j)
      walk_.rotation.push_back(glm::normalize(rotation_by(fading_[j].value) * pose.rotation[j]));
    walk_.rotation[first] = motion::world_rotation(body_.heading) * walk_.rotation[first];
    walk_.plants.push_back(clip().plants[at_.frame]);
    walk_.source.push_back(at_);
  }

  const MotionMatcher& matcher_;
  const motion::WalkGraph& graph_;
  SampledPath path_;
  double along_ = 0;  // Metres.
  Placement body_;
  double speed_ = 0;  // Metres a second.
  ClipFrame at_;
  std::vector<Fading> fading_;  // Per joint, as rotation vectors; the last is the root's place.
  motion::Walk walk_;
};

motion::Walk MotionMatcher::walk_along(std::span<const Vec2> path,
                                       std::optional<Placement> start) const {
  const Vec2 way = point_along(path, 0.25) - path.front();
  return MatchedWalk(*this, path, start.value_or(Placement{path.front(), std::atan2(way.y, way.x)}))
      .make();
}

}  // namespace docent::bench

#include "content/motion/cut_takes.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "content/motion/classify.h"
#include "content/motion/joint_positions.h"

namespace docent::motion::offline {
namespace {

constexpr double slowest_walking = 0.5;  // m/s of an adult; who is slower shuffles about

// Seconds. Two strides are the least that can be joined to others.
constexpr double shortest_walking = 2, shortest_standing = 0.6, standing_kept = 0.5, shared = 1.5;

/// Frames from `first` to before `last`.
struct Stretch {
  std::size_t first = 0, last = 0;
};

/// Where the hips go on, over a quarter of a second, faster than those of a body that stands.
std::vector<bool> moving_frames(const Skeleton& skeleton, const MotionClip& take) {
  const double least = standing_speed * size_of(skeleton);
  const std::size_t half = frames_in(0.125, take.frame_rate), last = take.root.size() - 1;
  std::vector<bool> moves;
  for (std::size_t f = 0; f <= last; ++f) {
    const std::size_t before = f - std::min(f, half), after = std::min(f + half, last);
    const double way = glm::distance(to_floor(take.root[before]), to_floor(take.root[after]));
    moves.push_back(way * take.frame_rate > least * static_cast<double>(after - before));
  }
  return moves;
}

/// Metres that the hips go.
double way_in(const MotionClip& take, Stretch stretch) {
  double way = 0;
  for (std::size_t f = stretch.first; f + 1 < stretch.last; ++f)
    way += glm::distance(to_floor(take.root[f]), to_floor(take.root[f + 1]));
  return way;
}

std::vector<Stretch> stretches_of_walking(const Skeleton& skeleton, const MotionClip& take) {
  const std::vector<bool> moves = moving_frames(skeleton, take);
  std::vector<Stretch> stretches;
  for (std::size_t f = 0; f < moves.size();) {
    const std::size_t first = f;
    while (f < moves.size() && moves[f] == moves[first]) ++f;
    if (!moves[first]) continue;
    if (!stretches.empty() &&
        first - stretches.back().last < frames_in(shortest_standing, take.frame_rate))
      stretches.back().last = f;
    else
      stretches.push_back({first, f});
  }
  const std::size_t least = frames_in(shortest_walking, take.frame_rate);
  const double slowest = slowest_walking * size_of(skeleton);
  std::erase_if(stretches, [&](Stretch s) {
    return s.last - s.first < least ||
           way_in(take, s) * take.frame_rate < slowest * static_cast<double>(s.last - s.first);
  });
  return stretches;
}

MotionClip part_of(const MotionClip& take, Stretch part, std::string name) {
  MotionClip clip = take;
  clip.name = std::move(name);
  const auto at = [](std::size_t value) { return static_cast<std::ptrdiff_t>(value); };
  clip.root.assign(take.root.begin() + at(part.first), take.root.begin() + at(part.last));
  clip.rotation.assign(take.rotation.begin() + at(part.first * take.joint_count),
                       take.rotation.begin() + at(part.last * take.joint_count));
  clip.plants.clear();
  return clip;
}

struct Part {
  const char* name;
  Stretch frames;
};

/// The parts of one stretch of walking. `whole` has the standing before and after it, where there
/// is any: without it nothing starts or stops.
std::vector<Part> parts_of(Stretch walking, Stretch whole, double frame_rate) {
  const std::size_t some = frames_in(shared, frame_rate), frames = walking.last - walking.first;
  const bool starts = whole.first<walking.first, stops = whole.last> walking.last;
  if (!starts || !stops) return {{starts ? "start" : stops ? "stop" : "walk", whole}};
  if (frames < 5 * some) {  // too short for a walk between the two
    const std::size_t middle = walking.first + frames / 2, half = std::min(some, frames) / 2;
    return {{"start", {whole.first, middle + half}}, {"stop", {middle - half, whole.last}}};
  }
  return {{"start", {whole.first, walking.first + 2 * some}},
          {"walk", {walking.first + some, walking.last - some}},
          {"stop", {walking.last - 2 * some, whole.last}}};
}

}  // namespace

std::vector<MotionClip> cut_take(const Skeleton& skeleton, const MotionClip& take) {
  const std::vector<Stretch> walking = stretches_of_walking(skeleton, take);
  const std::size_t frames = take.root.size();
  const std::size_t kept = frames_in(standing_kept, take.frame_rate);
  const std::size_t stands = frames_in(0.15, take.frame_rate);
  const bool stands_at_both_ends =
      !walking.empty() && walking.front().first >= stands && walking.back().last + stands <= frames;
  if (!stands_at_both_ends && walking.size() < 2) return {take};

  std::vector<MotionClip> clips;
  for (std::size_t i = 0; i < walking.size(); ++i) {
    const std::size_t before = i > 0 ? walking[i - 1].last : 0;
    const std::size_t after = i + 1 < walking.size() ? walking[i + 1].first : frames;
    const Stretch stretch = walking[i];
    const Stretch whole{stretch.first - std::min(kept, stretch.first - before),
                        stretch.last + std::min(kept, after - stretch.last)};
    const std::string number = walking.size() > 1 ? fmt::format(" {}", i + 1) : "";
    for (const auto& [name, part] : parts_of(stretch, whole, take.frame_rate))
      clips.push_back(part_of(take, part, fmt::format("{}, {}{}", take.name, name, number)));
  }
  return clips;
}

}  // namespace docent::motion::offline

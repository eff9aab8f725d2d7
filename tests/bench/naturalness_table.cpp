#include "tests/bench/naturalness_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "content/motion/path_deviation.h"
#include "tests/bench/measure.h"
#include "tests/bench/naturalness.h"
#include "tests/bench/walk_shapes.h"
#include "tests/bench/zero_moment_point.h"

namespace docent::bench {
namespace {

constexpr double long_step = 0.70;  // seconds

motion::Walk walk_along(const motion::WalkGraph& graph, std::span<const Vec2> path) {
  motion::WalkRequest request;
  request.path = path;
  Result<motion::Walk> walk = motion::make_walk(graph, request);
  if (!walk) throw std::runtime_error(walk.error().what);
  return std::move(*walk);
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

double share_above(const std::vector<double>& values, double limit) {
  const auto above = std::ranges::count_if(values, [&](double v) { return v > limit; });
  return values.empty() ? 0 : static_cast<double>(above) / static_cast<double>(values.size());
}

RoutesLook look_at(const motion::WalkGraph& graph, const RecordedPoses& poses,
                   const MuseumRoutes& routes) {
  RoutesLook look{.kind = routes.name};
  std::vector<double> distances, steps, outside, drifts, means;
  for (const std::vector<Vec2>& path : routes.path) {
    const motion::Walk walk = walk_along(graph, path);
    const TrackedMotion motion = track(graph.motion->skeleton, walk);
    append(distances, poses.distances(motion));
    append(steps, step_seconds(motion));
    append(outside, outside_the_feet(motion));
    append(drifts, plant_drifts(motion));
    look.head_bend = std::max(look.head_bend, head_bend(motion));
    std::vector<Vec2> roots;
    for (const Vec3& root : walk.root) roots.push_back(to_floor(root));
    const auto deviation = motion::offline::measure_deviation(roots, walk.frame_rate, path);
    means.push_back(deviation.mean);
    look.deviation_largest = std::max(look.deviation_largest, deviation.largest);
  }
  look.nearest_pose = quantile(distances, 0.95);
  look.long_steps = share_above(steps, long_step);
  look.step_median = median(steps);
  look.step_95 = quantile(steps, 0.95);
  look.outside_feet = quantile(outside, 0.95);
  look.drift = quantile(drifts, 0.95);
  for (const double mean : means) look.deviation_mean += mean / static_cast<double>(means.size());
  return look;
}

void measure_clips(const std::vector<TrackedMotion>& clips, Naturalness& look) {
  std::vector<double> outside, steps, jolts;
  for (const TrackedMotion& clip : clips) {
    append(outside, outside_the_feet(clip));
    append(steps, step_seconds(clip));
    append(jolts, knee_jolts(clip));
    look.head_bend_of_clips = std::max(look.head_bend_of_clips, head_bend(clip));
  }
  look.outside_feet_of_clips = quantile(outside, 0.95);
  look.long_steps_of_clips = share_above(steps, long_step);
  look.step_95_of_clips = quantile(steps, 0.95);
  look.knee_jolt = quantile(jolts, 0.95);
  look.other_stride_of_clips = median(nearest_other_stride(clips));
  for (const Side side : both_sides) {
    std::vector<double> swings;
    for (const TrackedMotion& clip : clips) append(swings, arm_swings(clip, side));
    look.arm_swing[index_of(side)] = median(swings);
  }
}

double median_seconds(const motion::WalkGraph& graph, std::span<const Vec2> path) {
  std::vector<double> seconds;
  for (int round = 0; round < 15; ++round) {
    const double before = now();
    walk_along(graph, path);
    seconds.push_back(now() - before);
  }
  return median(seconds);
}

void measure_ellipse(const motion::WalkGraph& graph, Naturalness& look) {
  const std::vector<Vec2> ellipse = elliptic_arc();
  const TrackedMotion motion = track(graph.motion->skeleton, walk_along(graph, ellipse));
  look.other_stride = median(nearest_other_stride(std::span(&motion, 1)));
  for (const Side side : both_sides)
    look.arm_variation[index_of(side)] = variation(arm_swings(motion, side));
  look.ready_seconds = median_seconds(graph, ellipse);
  look.stretch_seconds = median_seconds(graph, elliptic_arc(8));
}

}  // namespace

double Naturalness::worst_head_bend() const {
  double worst = hairpin_bend;
  for (const RoutesLook& each : routes) worst = std::max(worst, each.head_bend);
  return worst / head_bend_of_clips;
}

Naturalness measure_naturalness(const motion::WalkGraph& graph,
                                const std::vector<MuseumRoutes>& routes,
                                const std::vector<TrackedMotion>& held_out) {
  Naturalness look;
  const std::vector<TrackedMotion> clips = track_clips(graph);
  const RecordedPoses poses(clips);
  measure_clips(clips, look);
  for (const MuseumRoutes& each : routes) look.routes.push_back(look_at(graph, poses, each));
  look.routes.push_back(look_at(graph, poses, {"stairs of 0.8 m", {stairs_path(0.8)}}));
  const TrackedMotion hairpin = track(graph.motion->skeleton, walk_along(graph, hairpin_path()));
  look.hairpin_bend = head_bend(hairpin);
  look.hairpin_time = head_bend_time(hairpin);
  measure_ellipse(graph, look);
  std::vector<double> distances;
  for (const TrackedMotion& take : held_out) append(distances, poses.distances(take));
  if (!distances.empty()) look.held_out = quantile(distances, 0.95);
  return look;
}

std::string to_table(const std::string& title, const Naturalness& look) {
  std::string out = fmt::format("{}\n{:<44} {:>34} {:>16} {:>16}\n", title, "measure", "today",
                                "of the clips", "goal");
  const auto row = [&](const char* name, const std::string& today, const std::string& clips,
                       const char* goal) {
    out += fmt::format("{:<44} {:>34} {:>16} {:>16}\n", name, today, clips, goal);
  };
  const auto each = [&](auto value, const char* format) {
    std::string text;
    for (const RoutesLook& routes : look.routes)
      text += (text.empty() ? "" : " / ") + fmt::format(fmt::runtime(format), value(routes));
    return text;
  };
  out += fmt::format("(routes: {})\n", each([](const auto& r) { return r.kind; }, "{}"));
  row("nearest recorded pose and velocity, 95 %, cm",
      each([](const auto& r) { return 100 * r.nearest_pose; }, "{:.1f}"),
      look.held_out > 0 ? fmt::format("{:.1f} (takes)", 100 * look.held_out) : "-", "<= takes'");
  row("steps longer than 0.70 s, %",
      each([](const auto& r) { return 100 * r.long_steps; }, "{:.0f}"),
      fmt::format("{:.0f}", 100 * look.long_steps_of_clips), "<= 3");
  row("a step, median, s", each([](const auto& r) { return r.step_median; }, "{:.2f}"), "", "");
  row("a step, 95 %, s", each([](const auto& r) { return r.step_95; }, "{:.2f}"),
      fmt::format("{:.2f}", look.step_95_of_clips), "");
  row("zero moment point outside the feet, 95 %, cm",
      each([](const auto& r) { return 100 * r.outside_feet; }, "{:.1f}"),
      fmt::format("{:.1f}", 100 * look.outside_feet_of_clips), "<= 1.1 of clips");
  row("nearest other stride, median, ellipse, cm", fmt::format("{:.2f}", 100 * look.other_stride),
      fmt::format("{:.2f}", 100 * look.other_stride_of_clips), ">= 2");
  row("head's bend over four frames, worst, mm",
      each([](const auto& r) { return 1000 * r.head_bend; }, "{:.1f}"),
      fmt::format("{:.1f}", 1000 * look.head_bend_of_clips), "");
  row("  on the hairpin, mm (when, s)",
      fmt::format("{:.1f} ({:.2f})", 1000 * look.hairpin_bend, look.hairpin_time), "", "");
  row("  worst over the clips' worst", fmt::format("{:.2f}", look.worst_head_bend()), "1", "<= 1");
  row("knee at heel strike, 20 Hz, 95 %, rad/s2", "", fmt::format("{:.0f}", look.knee_jolt),
      "226 to 284");
  row("arms swing, cm; vary on the ellipse, %",
      fmt::format("{:.0f} / {:.0f}", 100 * look.arm_variation[0], 100 * look.arm_variation[1]),
      fmt::format("{:.0f} / {:.0f}", 100 * look.arm_swing[0], 100 * look.arm_swing[1]), "17 to 25");
  row("planted feet wander, 95 %, mm", each([](const auto& r) { return 1000 * r.drift; }, "{:.1f}"),
      "", "0.8");
  row("deviation, mean, cm", each([](const auto& r) { return 100 * r.deviation_mean; }, "{:.1f}"),
      "", "0.4");
  row("deviation, largest, cm",
      each([](const auto& r) { return 100 * r.deviation_largest; }, "{:.1f}"), "", "1.8");
  row("33 m can be walked after, ms; a first stretch",
      fmt::format("{:.1f}; {:.1f}", 1000 * look.ready_seconds, 1000 * look.stretch_seconds), "",
      "5; 1.5");
  return out;
}

}  // namespace docent::bench

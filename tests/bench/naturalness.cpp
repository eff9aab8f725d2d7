#include "tests/bench/naturalness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "runtime/motion/smoothing.h"

namespace docent::bench {
namespace {

using enum BodyPart;
constexpr std::size_t parts = static_cast<std::size_t>(Count);
constexpr double later = 0.1;  // seconds
constexpr std::size_t pose_numbers = 6 * parts;
constexpr std::size_t stride_moments = 20;
constexpr double shortest_stride = 0.6, longest_stride = 2.0;  // seconds

void add_place(const Placement& body, Vec3 place, std::vector<float>& out) {
  const Vec3 local = seen_from(body, place);
  out.insert(out.end(), {local.x, local.y, local.z});
}

/// Where the parts are, then by how much they move in the next tenth of a second.
void add_pose(const TrackedMotion& motion, std::size_t f, std::vector<float>& out) {
  const std::size_t then = f + motion.frames_in(later);
  for (std::size_t p = 0; p < parts; ++p) add_place(motion.body[f], motion.part[f][p], out);
  for (std::size_t p = 0; p < parts; ++p) {
    const Vec3 moved = seen_from(motion.body[f], motion.part[then][p]) -
                       seen_from(motion.body[f], motion.part[f][p]);
    out.insert(out.end(), {moved.x, moved.y, moved.z});
  }
}

bool walks_all_through(const TrackedMotion& motion, std::size_t from, std::size_t to) {
  return std::all_of(motion.is_walking.begin() + static_cast<std::ptrdiff_t>(from),
                     motion.is_walking.begin() + static_cast<std::ptrdiff_t>(to) + 1,
                     [](bool walks) { return walks; });
}

float squares_between(const float* a, const float* b, std::size_t count, float enough) {
  float sum = 0;
  for (std::size_t i = 0; i < count && sum < enough; i += parts)
    for (std::size_t k = i; k < std::min(i + parts, count); ++k)
      sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

/// First and last frame.
struct Stride {
  std::size_t from, to;
};

std::vector<Stride> strides_of(const TrackedMotion& motion) {
  const std::vector<std::size_t> down = strikes(motion, Side::Left);
  std::vector<Stride> strides;
  for (std::size_t k = 1; k < down.size(); ++k) {
    const double seconds = static_cast<double>(down[k] - down[k - 1]) / motion.rate;
    if (seconds > shortest_stride && seconds < longest_stride &&
        walks_all_through(motion, down[k - 1], down[k]))
      strides.push_back({down[k - 1], down[k]});
  }
  return strides;
}

/// Strides at full swing: not the first after standing still, and not the last before.
std::vector<Stride> strides_between(const TrackedMotion& motion) {
  std::vector<Stride> strides = strides_of(motion);
  const auto is_slow = [&](const Stride& stride) {
    const double metres =
        glm::distance(motion.body[stride.from].position, motion.body[stride.to].position);
    return metres / static_cast<double>(stride.to - stride.from) * motion.rate < 0.7;
  };
  std::erase_if(strides, is_slow);
  return strides;
}

std::size_t worst_bend_frame(const TrackedMotion& motion, double& worst) {
  const std::size_t step = motion.frames_in(4.0 / 120);
  std::size_t frame = 0;
  worst = 0;
  for (std::size_t f = step; f + step < motion.frames(); ++f) {
    const Vec3 bend =
        motion.at(f - step, Head) - 2.0F * motion.at(f, Head) + motion.at(f + step, Head);
    const auto size = static_cast<double>(glm::length(bend));
    if (size > worst) {
      worst = size;
      frame = f;
    }
  }
  return frame;
}

std::vector<double> knee_angles(const TrackedMotion& motion, Side side) {
  const bool left = side == Side::Left;
  const BodyPart hip = left ? LeftHip : RightHip, knee = left ? LeftKnee : RightKnee,
                 ankle = left ? LeftAnkle : RightAnkle;
  std::vector<double> angles;
  for (std::size_t f = 0; f < motion.frames(); ++f) {
    const glm::dvec3 thigh(motion.at(f, knee) - motion.at(f, hip));
    const glm::dvec3 shin(motion.at(f, ankle) - motion.at(f, knee));
    angles.push_back(std::atan2(glm::length(glm::cross(thigh, shin)), glm::dot(thigh, shin)));
  }
  // A Gaussian that halves the power at 20 Hz.
  const double deviation = std::sqrt(std::log(2.0)) / (2 * 3.141592653589793 * 20);
  return motion::smooth_held(angles, motion::gaussian_kernel(deviation * motion.rate));
}

}  // namespace

RecordedPoses::RecordedPoses(std::span<const TrackedMotion> recordings) {
  for (const TrackedMotion& recording : recordings)
    for (std::size_t f = 0; f + recording.frames_in(later) < recording.frames(); f += 2)
      add_pose(recording, f, poses_);
}

std::vector<double> RecordedPoses::distances(const TrackedMotion& motion) const {
  std::vector<double> out;
  std::vector<float> pose;
  const std::size_t stride = motion.frames_in(0.1);
  for (std::size_t f = 0; f + motion.frames_in(later) < motion.frames(); f += stride) {
    if (!motion.is_walking[f]) continue;
    pose.clear();
    add_pose(motion, f, pose);
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < poses_.size(); i += pose_numbers)
      nearest =
          std::min(nearest, squares_between(poses_.data() + i, pose.data(), pose_numbers, nearest));
    out.push_back(std::sqrt(static_cast<double>(nearest) / parts));
  }
  return out;
}

std::vector<double> step_seconds(const TrackedMotion& motion) {
  struct Strike {
    std::size_t frame;
    Side side;
  };
  std::vector<Strike> all;
  for (const Side side : both_sides)
    for (const std::size_t frame : strikes(motion, side)) all.push_back({frame, side});
  std::ranges::sort(all, {}, &Strike::frame);
  std::vector<double> seconds;
  for (std::size_t k = 1; k < all.size(); ++k)
    if (all[k].side != all[k - 1].side && walks_all_through(motion, all[k - 1].frame, all[k].frame))
      seconds.push_back(static_cast<double>(all[k].frame - all[k - 1].frame) / motion.rate);
  return seconds;
}

std::vector<double> nearest_other_stride(std::span<const TrackedMotion> motions) {
  constexpr std::size_t numbers = 3 * parts * stride_moments;
  std::vector<float> strides;
  for (const TrackedMotion& motion : motions)
    for (const Stride& stride : strides_between(motion))
      for (std::size_t m = 0; m < stride_moments; ++m) {
        const std::size_t f = stride.from + (stride.to - stride.from) * m / stride_moments;
        for (std::size_t p = 0; p < parts; ++p)
          add_place(motion.body[f], motion.part[f][p], strides);
      }
  std::vector<double> nearest;
  for (std::size_t i = 0; i < strides.size(); i += numbers) {
    float best = std::numeric_limits<float>::infinity();
    for (std::size_t j = 0; j < strides.size(); j += numbers)
      if (i != j)
        best =
            std::min(best, squares_between(strides.data() + i, strides.data() + j, numbers, best));
    nearest.push_back(std::sqrt(static_cast<double>(best) / (parts * stride_moments)));
  }
  return nearest;
}

double head_bend(const TrackedMotion& motion) {
  double worst = 0;
  worst_bend_frame(motion, worst);
  return worst;
}

double head_bend_time(const TrackedMotion& motion) {
  double worst = 0;
  return static_cast<double>(worst_bend_frame(motion, worst)) / motion.rate;
}

std::vector<double> knee_jolts(const TrackedMotion& motion) {
  std::vector<double> jolts;
  const std::size_t reach = motion.frames_in(0.12);
  for (const Side side : both_sides) {
    const std::vector<double> angle = knee_angles(motion, side);
    for (const std::size_t strike : strikes(motion, side)) {
      if (strike < reach + 1 || strike + reach + 1 >= angle.size()) continue;
      double worst = 0;
      for (std::size_t f = strike - reach; f <= strike + reach; ++f)
        worst = std::max(worst, std::abs(angle[f + 1] - 2 * angle[f] + angle[f - 1]));
      jolts.push_back(worst * motion.rate * motion.rate);
    }
  }
  return jolts;
}

std::vector<double> arm_swings(const TrackedMotion& motion, Side side) {
  const BodyPart wrist = side == Side::Left ? LeftWrist : RightWrist;
  std::vector<double> swings;
  for (const Stride& stride : strides_between(motion)) {
    double back = 1e9, front = -1e9;
    for (std::size_t f = stride.from; f <= stride.to; ++f) {
      const auto ahead = static_cast<double>(seen_from(motion.body[f], motion.at(f, wrist)).x);
      back = std::min(back, ahead);
      front = std::max(front, ahead);
    }
    swings.push_back(front - back);
  }
  return swings;
}

std::vector<double> plant_drifts(const TrackedMotion& motion) {
  constexpr double shortest_plant = 0.08;  // seconds
  std::vector<double> drifts;
  for (const Side side : both_sides) {
    const BodyPart toe = side == Side::Left ? LeftToe : RightToe;
    for (std::size_t f = 0; f < motion.frames();) {
      std::size_t end = f;
      while (end < motion.frames() && motion.planted(end, side)) ++end;
      double drift = 0;
      const Vec2 middle = to_floor(motion.at(std::min((f + end) / 2, motion.frames() - 1), toe));
      for (std::size_t k = f; k < end; ++k)
        drift = std::max(drift, glm::distance(to_floor(motion.at(k, toe)), middle));
      if (static_cast<double>(end - f) >= shortest_plant * motion.rate) drifts.push_back(drift);
      f = std::max(end, f + 1);
    }
  }
  return drifts;
}

double variation(std::span<const double> values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / count) / mean;
}

}  // namespace docent::bench

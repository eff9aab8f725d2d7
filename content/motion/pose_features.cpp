#include "content/motion/pose_features.h"

#include <algorithm>
#include <cmath>

#include "content/parallel.h"

namespace docent::motion::offline {
namespace {

constexpr std::size_t dimensions = PoseFeatures::dimensions;
constexpr std::size_t moments = 5;     // Frames of a window that a point is made of.
constexpr std::size_t studied = 4096;  // Windows from which the principal components are found.

/// A window as numbers: x, y and height of each point in each moment, metres times the square root
/// of the weight, so that the distance of two is the root mean square over the points.
using Window = std::vector<float>;

/// The window round a frame, about its own middle, as it stands on the floor. Where it reaches over
/// an end of the clip, the last frame is held.
void take_window(const PoseCloud& cloud, std::size_t frame, std::size_t half, Window& window) {
  window.resize(moments * cloud.points * 3);
  const auto length = static_cast<std::ptrdiff_t>(cloud.frames);
  float* out = window.data();
  double x = 0, y = 0;
  for (std::size_t m = 0; m < moments; ++m) {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(2 * m * half / (moments - 1)) -
                                  static_cast<std::ptrdiff_t>(half);
    const auto f = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(frame) + offset, 0, length - 1));
    x += (cloud.sum_x[f + 1] - cloud.sum_x[f]) / moments;
    y += (cloud.sum_y[f + 1] - cloud.sum_y[f]) / moments;
    for (std::size_t p = 0; p < cloud.points; ++p, out += 3) {
      out[0] = cloud.x[p * cloud.frames + f];
      out[1] = cloud.y[p * cloud.frames + f];
      out[2] = cloud.h[p * cloud.frames + f];
    }
  }
  out = window.data();
  const auto middle_x = static_cast<float>(x), middle_y = static_cast<float>(y);
  for (std::size_t m = 0; m < moments; ++m)
    for (std::size_t p = 0; p < cloud.points; ++p, out += 3) {
      const float scale = std::sqrt(cloud.weight[p] / static_cast<float>(moments));
      out[0] = scale * (out[0] - middle_x);
      out[1] = scale * (out[1] - middle_y);
      out[2] = scale * out[2];
    }
}

/// Turns a window about its middle until it lies best on another.
void turn_onto(const Window& other, Window& window) {
  double dot = 0, cross = 0;
  for (std::size_t i = 0; i < window.size(); i += 3) {
    const double ax = other[i], ay = other[i + 1], bx = window[i], by = window[i + 1];
    dot += ax * bx + ay * by;
    cross += ay * bx - ax * by;
  }
  const double length = std::hypot(dot, cross);
  if (length == 0) return;
  const auto c = static_cast<float>(dot / length), s = static_cast<float>(cross / length);
  for (std::size_t i = 0; i < window.size(); i += 3) {
    const float x = window[i], y = window[i + 1];
    window[i] = c * x - s * y;
    window[i + 1] = s * x + c * y;
  }
}

/// The mean of windows, each turned onto it. The first window's heading is what all are turned to.
Window mean_window(std::vector<Window>& windows) {
  Window mean = windows.front();
  for (int round = 0; round < 3; ++round) {
    std::vector<double> sum(mean.size());
    for (Window& window : windows) {
      turn_onto(mean, window);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>(window[i]);
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
      mean[i] = static_cast<float>(sum[i] / static_cast<double>(windows.size()));
  }
  return mean;
}

/// Directions of length 1, square to each other, with the most important first.
using Directions = std::vector<std::vector<double>>;

/// Makes the directions square to each other, in their order (Gram and Schmidt). One that is made
/// of those before becomes nothing.
void make_square(Directions& directions) {
  for (std::size_t d = 0; d < directions.size(); ++d) {
    const auto product = [&](const std::vector<double>& a) {
      double sum = 0;
      for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * directions[d][i];
      return sum;
    };
    const double before = std::sqrt(product(directions[d]));
    for (std::size_t e = 0; e < d; ++e) {
      const double along = product(directions[e]);
      for (std::size_t i = 0; i < directions[d].size(); ++i)
        directions[d][i] -= along * directions[e][i];
    }
    const double length = std::sqrt(product(directions[d]));
    for (double& value : directions[d]) value = length > 1e-9 * before ? value / length : 0;
  }
}

/// The principal components of windows about their mean, by orthogonal iteration (Golub and Van
/// Loan 2013, section 8.2.4). It need not converge to the last digit: any directions that hold
/// nearly all differences serve.
Directions principal_components(const std::vector<Window>& windows, const Window& mean,
                                unsigned jobs) {
  const std::size_t size = mean.size();
  std::vector<std::vector<double>> covariance(size, std::vector<double>(size));
  content::for_each_index(size, jobs, [&](std::size_t i) {
    std::vector<double>& row = covariance[i];
    for (const Window& window : windows) {
      const float from_mean = window[i] - mean[i];
      for (std::size_t j = 0; j < size; ++j)
        row[j] += static_cast<double>(from_mean * (window[j] - mean[j]));
    }
  });
  Directions directions(std::min(dimensions, size), std::vector<double>(size));
  for (std::size_t d = 0; d < directions.size(); ++d)  // Begin where windows differ from the mean.
    for (std::size_t i = 0; i < size; ++i)
      directions[d][i] =
          static_cast<double>(windows[d * windows.size() / directions.size()][i] - mean[i]) +
          (i % directions.size() == d ? 1e-3 : 0);
  make_square(directions);
  constexpr int rounds = 30;
  for (int round = 0; round < rounds; ++round) {
    Directions next(directions.size(), std::vector<double>(size));
    content::for_each_index(directions.size(), jobs, [&](std::size_t d) {
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j) next[d][i] += covariance[i][j] * directions[d][j];
    });
    directions = std::move(next);
    make_square(directions);
  }
  return directions;
}

/// Takes windows to their places along the principal components.
class Projection {
 public:
  Projection(const Window& mean, const Directions& directions) : along_(mean.size()) {
    for (std::size_t i = 0; i < mean.size(); ++i) {
      along_[i].fill(0);
      for (std::size_t d = 0; d < directions.size(); ++d) {
        along_[i][d] = static_cast<float>(directions[d][i]);
        of_mean_[d] += along_[i][d] * mean[i];
      }
    }
  }

  PoseFeatures::Point of(const Window& window) const {
    PoseFeatures::Point point{};
    for (std::size_t i = 0; i < window.size(); ++i)
      for (std::size_t d = 0; d < dimensions; ++d) point[d] += window[i] * along_[i][d];
    for (std::size_t d = 0; d < dimensions; ++d) point[d] -= of_mean_[d];
    return point;
  }

 private:
  std::vector<PoseFeatures::Point> along_;  ///< What each number of a window adds.
  PoseFeatures::Point of_mean_{};
};

}  // namespace

PoseFeatures make_pose_features(std::span<const PoseCloud> clouds, std::size_t half,
                                unsigned jobs) {
  PoseFeatures features;
  std::vector<ClipFrame> frames;
  for (std::uint32_t c = 0; c < clouds.size(); ++c) {
    features.first.push_back(frames.size());
    for (std::uint32_t f = 0; f < clouds[c].frames; ++f) frames.push_back({c, f});
  }
  features.first.push_back(frames.size());
  features.point.resize(frames.size());
  if (frames.empty()) return features;

  std::vector<Window> windows(std::min(studied, frames.size()));
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const ClipFrame at = frames[i * frames.size() / windows.size()];
    take_window(clouds[at.clip], at.frame, half, windows[i]);
  }
  const Window mean = mean_window(windows);
  const Projection projection(mean, principal_components(windows, mean, jobs));

  constexpr std::size_t share = 1024;  // Points that a thread makes at a time.
  content::for_each_index((frames.size() + share - 1) / share, jobs, [&](std::size_t part) {
    Window window;
    const std::size_t end = std::min((part + 1) * share, frames.size());
    for (std::size_t i = part * share; i < end; ++i) {
      take_window(clouds[frames[i].clip], frames[i].frame, half, window);
      turn_onto(mean, window);
      features.point[i] = projection.of(window);
    }
  });
  return features;
}

float square_between(const PoseFeatures::Point& a, const PoseFeatures::Point& b) {
  constexpr std::size_t lanes = 4;  // Sums beside each other, in the order in which they are added.
  static_assert(dimensions % lanes == 0);
  std::array<float, lanes> sums{};
  for (std::size_t d = 0; d < dimensions; d += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const float difference = a[d + k] - b[d + k];
      sums[k] += difference * difference;
    }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace docent::motion::offline

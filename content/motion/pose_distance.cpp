#include "content/motion/pose_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace docent {
namespace {

struct WeightedPart {
  BodyPart part;
  float weight;
};

/// The joints that show a walk, and how much each matters: what carries the body most, hands
/// least, because they swing as they like.
constexpr std::array<WeightedPart, 23> compared_parts{{
    {BodyPart::Hips, 1.5f},         {BodyPart::Chest, 1.0f},         {BodyPart::Neck, 0.5f},
    {BodyPart::Head, 0.5f},         {BodyPart::HeadTop, 0.5f},       {BodyPart::LeftHip, 1.0f},
    {BodyPart::LeftKnee, 1.0f},     {BodyPart::LeftAnkle, 1.0f},     {BodyPart::LeftToe, 1.0f},
    {BodyPart::LeftToeTip, 0.5f},   {BodyPart::RightHip, 1.0f},      {BodyPart::RightKnee, 1.0f},
    {BodyPart::RightAnkle, 1.0f},   {BodyPart::RightToe, 1.0f},      {BodyPart::RightToeTip, 0.5f},
    {BodyPart::LeftShoulder, 1.0f}, {BodyPart::LeftElbow, 0.7f},     {BodyPart::LeftWrist, 0.5f},
    {BodyPart::LeftHandTip, 0.2f},  {BodyPart::RightShoulder, 1.0f}, {BodyPart::RightElbow, 0.7f},
    {BodyPart::RightWrist, 0.5f},   {BodyPart::RightHandTip, 0.2f},
}};

/// Sums over the frames of a window of products between the clouds' points.
struct CrossSums {
  double dot = 0;     ///< a . b on the floor
  double cross = 0;   ///< b x a on the floor, counter-clockwise from b to a
  double height = 0;  ///< a b in height
};

/// Sums over the frames of a window of one cloud.
struct OwnSums {
  double x, y, square;
};

OwnSums sums_between(const PoseCloud& cloud, std::size_t first, std::size_t end) {
  return {cloud.sum_x[end] - cloud.sum_x[first], cloud.sum_y[end] - cloud.sum_y[first],
          cloud.sum_square[end] - cloud.sum_square[first]};
}

/// What is left of the squared distance when the best rotation and translation are taken out.
///
/// With weights of sum 1 and centred points, |a - R b|2 = |a|2 + |b|2 - 2 (c cos t + s sin t) with
/// c the dot and s the cross sum; it is least at t = atan2(s, c), where the bracket is hypot(s, c).
double squared_distance(const OwnSums& a, const OwnSums& b, const CrossSums& ab, double frames) {
  const double dot = ab.dot - (a.x * b.x + a.y * b.y) / frames;
  const double cross = ab.cross - (b.x * a.y - b.y * a.x) / frames;
  const double own =
      a.square - (a.x * a.x + a.y * a.y) / frames + b.square - (b.x * b.x + b.y * b.y) / frames;
  const double left = own - 2 * std::sqrt(dot * dot + cross * cross) - 2 * ab.height;
  return std::max(0.0, left / frames);
}

/// The part of a window round `frame_a` and `frame_b` that lies in both clips, as offsets.
struct Overlap {
  std::ptrdiff_t first = 0, end = 0;
};

Overlap overlap_of(std::size_t frame_a, std::size_t frames_a, std::size_t frame_b,
                   std::size_t frames_b, std::size_t half) {
  return {
      -static_cast<std::ptrdiff_t>(std::min({half, frame_a, frame_b})),
      static_cast<std::ptrdiff_t>(std::min({half + 1, frames_a - frame_a, frames_b - frame_b}))};
}

/// Cross products of one frame of `a` with all frames of `b`, or their sums over a window, with
/// blanks before the first and after the last column so that windows may reach over.
template <typename Number>
struct CrossRow {
  explicit CrossRow(std::size_t width) : dot(width), cross(width), height(width) {}
  std::vector<Number> dot, cross, height;
};

void fill_row(const PoseCloud& a, std::size_t frame, const PoseCloud& b, std::size_t margin,
              CrossRow<float>& row) {
  constexpr std::size_t block = 8;  // Sums of one block stay in registers over all points.
  std::size_t f = 0;
  const auto take = [&]<std::size_t width>() {
    std::array<float, width> dot{}, cross{}, height{};
    for (std::size_t p = 0; p < a.points; ++p) {
      const float w = a.weight[p];
      const float ax = w * a.x[p * a.frames + frame], ay = w * a.y[p * a.frames + frame],
                  ah = w * a.h[p * a.frames + frame];
      const float* bx = &b.x[p * b.frames + f];
      const float* by = &b.y[p * b.frames + f];
      const float* bh = &b.h[p * b.frames + f];
      for (std::size_t i = 0; i < width; ++i) {
        dot[i] += ax * bx[i] + ay * by[i];
        cross[i] += ay * bx[i] - ax * by[i];
        height[i] += ah * bh[i];
      }
    }
    const auto at = static_cast<std::ptrdiff_t>(margin + f);
    std::ranges::copy(dot, row.dot.begin() + at);
    std::ranges::copy(cross, row.cross.begin() + at);
    std::ranges::copy(height, row.height.begin() + at);
    f += width;
  };
  while (f + block <= b.frames) take.template operator()<block>();
  while (f < b.frames) take.template operator()<1>();
}

/// Moves all windows of a row one frame on, along their diagonals: `arriving` comes into them and
/// `leaving` goes.
void move_windows(const CrossRow<double>& before, const CrossRow<float>& arriving,
                  const CrossRow<float>& leaving, std::size_t half, CrossRow<double>& sums) {
  const std::size_t margin = half + 1;
  const auto move = [&](const std::vector<double>& from, const std::vector<float>& come,
                        const std::vector<float>& go, std::vector<double>& to) {
    for (std::size_t e = 1; e < margin; ++e)
      to[e] = from[e - 1] + static_cast<double>(come[e + half]);
    for (std::size_t e = margin; e + margin < to.size(); ++e)
      to[e] =
          from[e - 1] + static_cast<double>(come[e + half]) - static_cast<double>(go[e - margin]);
  };
  move(before.dot, arriving.dot, leaving.dot, sums.dot);
  move(before.cross, arriving.cross, leaving.cross, sums.cross);
  move(before.height, arriving.height, leaving.height, sums.height);
}

/// One row of the matrix from the cross sums of its windows.
void fill_distances(const PoseCloud& a, std::size_t frame, const PoseCloud& b,
                    const CrossRow<double>& sums, std::size_t half, DistanceMatrix& matrix) {
  const std::size_t margin = half + 1;
  const auto fill = [&](std::size_t column, const OwnSums& own_a, Overlap overlap) {
    const OwnSums own_b = sums_between(b, column + static_cast<std::size_t>(overlap.first),
                                       column + static_cast<std::size_t>(overlap.end));
    const std::size_t e = column + margin;
    const double square =
        squared_distance(own_a, own_b, {sums.dot[e], sums.cross[e], sums.height[e]},
                         static_cast<double>(overlap.end - overlap.first));
    matrix.distance[frame * matrix.columns + column] = static_cast<float>(std::sqrt(square));
  };
  const auto own_a = [&](Overlap overlap) {
    return sums_between(a, frame + static_cast<std::size_t>(overlap.first),
                        frame + static_cast<std::size_t>(overlap.end));
  };
  const auto fill_edge = [&](std::size_t column) {
    const Overlap overlap = overlap_of(frame, a.frames, column, b.frames, half);
    fill(column, own_a(overlap), overlap);
  };
  // Away from the ends of `b` the window is the same for all columns.
  const std::size_t inner = std::min(half, b.frames);
  const std::size_t inner_end = b.frames > 2 * half ? b.frames - half : inner;
  for (std::size_t column = 0; column < inner; ++column) fill_edge(column);
  if (inner < inner_end) {
    const Overlap overlap = overlap_of(frame, a.frames, inner, b.frames, half);
    const OwnSums own = own_a(overlap);
    for (std::size_t column = inner; column < inner_end; ++column) fill(column, own, overlap);
  }
  for (std::size_t column = inner_end; column < b.frames; ++column) fill_edge(column);
}

}  // namespace

PoseCloud make_pose_cloud(const Skeleton& skeleton, const Track& track) {
  PoseCloud cloud;
  cloud.frames = track.place.size() / track.joints;
  std::vector<std::size_t> joints;
  for (const auto& [part, weight] : compared_parts)
    if (skeleton[part] != JointIndex::None) {
      joints.push_back(index_of(skeleton[part]));
      cloud.weight.push_back(weight);
    }
  cloud.points = joints.size();
  const float total = std::accumulate(cloud.weight.begin(), cloud.weight.end(), 0.0f);
  for (float& weight : cloud.weight) weight /= total;

  for (std::size_t f = 0; f < cloud.frames; ++f) cloud.origin += to_floor(track.at(f, 0));
  cloud.origin /= static_cast<double>(cloud.frames);
  for (const std::size_t joint : joints)
    for (std::size_t f = 0; f < cloud.frames; ++f) {
      const Vec2 place = to_floor(track.at(f, joint)) - cloud.origin;
      cloud.x.push_back(static_cast<float>(place.x));
      cloud.y.push_back(static_cast<float>(place.y));
      cloud.h.push_back(track.at(f, joint).y);
    }

  cloud.sum_x = cloud.sum_y = cloud.sum_square = std::vector<double>(cloud.frames + 1);
  for (std::size_t f = 0; f < cloud.frames; ++f) {
    double x = 0, y = 0, square = 0;
    for (std::size_t p = 0; p < cloud.points; ++p) {
      const double px = cloud.x[p * cloud.frames + f], py = cloud.y[p * cloud.frames + f],
                   ph = cloud.h[p * cloud.frames + f], w = cloud.weight[p];
      x += w * px;
      y += w * py;
      square += w * (px * px + py * py + ph * ph);
    }
    cloud.sum_x[f + 1] = cloud.sum_x[f] + x;
    cloud.sum_y[f + 1] = cloud.sum_y[f] + y;
    cloud.sum_square[f + 1] = cloud.sum_square[f] + square;
  }
  return cloud;
}

PoseMatch compare_poses(const PoseCloud& a, std::size_t frame_a, const PoseCloud& b,
                        std::size_t frame_b, std::size_t half) {
  const Overlap overlap = overlap_of(frame_a, a.frames, frame_b, b.frames, half);
  CrossSums ab;
  for (std::ptrdiff_t k = overlap.first; k < overlap.end; ++k) {
    const std::size_t fa = frame_a + static_cast<std::size_t>(k);
    const std::size_t fb = frame_b + static_cast<std::size_t>(k);
    for (std::size_t p = 0; p < a.points; ++p) {
      const std::size_t ia = p * a.frames + fa, ib = p * b.frames + fb;
      const double w = a.weight[p], ax = a.x[ia], ay = a.y[ia], bx = b.x[ib], by = b.y[ib];
      ab.dot += w * (ax * bx + ay * by);
      ab.cross += w * (ay * bx - ax * by);
      ab.height += w * static_cast<double>(a.h[ia]) * static_cast<double>(b.h[ib]);
    }
  }
  const auto window = [&](const PoseCloud& cloud, std::size_t frame) {
    return sums_between(cloud, frame + static_cast<std::size_t>(overlap.first),
                        frame + static_cast<std::size_t>(overlap.end));
  };
  const OwnSums own_a = window(a, frame_a), own_b = window(b, frame_b);
  const auto frames = static_cast<double>(overlap.end - overlap.first);
  PoseMatch match{.distance = std::sqrt(squared_distance(own_a, own_b, ab, frames)),
                  .alignment = {}};

  const double turn = std::atan2(ab.cross - (own_b.x * own_a.y - own_b.y * own_a.x) / frames,
                                 ab.dot - (own_a.x * own_b.x + own_a.y * own_b.y) / frames);
  const Vec2 middle_a = Vec2{own_a.x, own_a.y} / frames + a.origin;
  const Vec2 middle_b = Vec2{own_b.x, own_b.y} / frames + b.origin;
  const double c = std::cos(turn), s = std::sin(turn);
  match.alignment.heading = turn;
  match.alignment.position =
      middle_a - Vec2{c * middle_b.x - s * middle_b.y, s * middle_b.x + c * middle_b.y};
  return match;
}

DistanceMatrix measure_distances(const PoseCloud& a, const PoseCloud& b, std::size_t half) {
  DistanceMatrix matrix{
      .rows = a.frames, .columns = b.frames, .distance = std::vector<float>(a.frames * b.frames)};
  const std::size_t margin = half + 1, width = b.frames + 2 * margin;
  std::vector<CrossRow<float>> ring(2 * half + 2, CrossRow<float>(width));
  const CrossRow<float> outside(width);
  CrossRow<double> sums(width), before(width);

  // A frame of `a` comes into the window `half` steps before it is the middle, and goes half + 1
  // steps after.
  for (std::size_t step = 0; step < a.frames + half; ++step) {
    CrossRow<float>& newest = ring[step % ring.size()];
    if (step < a.frames) fill_row(a, step, b, margin, newest);
    std::swap(sums, before);
    move_windows(before, step < a.frames ? newest : outside,
                 step > 2 * half ? ring[(step + 1) % ring.size()] : outside, half, sums);
    if (step >= half) fill_distances(a, step - half, b, sums, half, matrix);
  }
  return matrix;
}

}  // namespace docent

#include "content/motion/pose_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace docent::motion::offline {
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

constexpr std::size_t rows = DistanceTile::rows, diagonals = DistanceTile::diagonals;

/// One value for each diagonal of a tile.
using TileRow = std::array<float, diagonals>;

/// The frames of a clip that a tile compares, point by point as in the cloud, moved so that sums of
/// squares stay small, with blanks where the clip has no frame; and the sums of whole windows.
struct LocalCloud {
  std::ptrdiff_t first = 0;  ///< The clip's frame that is frame 0 here.
  std::size_t frames = 0;
  float origin_x = 0, origin_y = 0;  ///< Relative to the cloud's own.
  std::vector<float> x, y, h;
  std::vector<float> sum_x, sum_y;  ///< Of the window round a frame.
  std::vector<float> spread;        ///< Its squares less the square of its middle.
};

/// Takes `frames` frames from `first` on, which may lie outside of the clip. Points are multiplied
/// by their weights if so wanted, because a product needs the weight once.
enum class Weighted : bool { No, Yes };

void take_frames(const PoseCloud& cloud, std::ptrdiff_t first, std::size_t frames, std::size_t half,
                 Weighted weighted, LocalCloud& local) {
  const auto length = static_cast<std::ptrdiff_t>(cloud.frames);
  const std::ptrdiff_t begin = std::clamp<std::ptrdiff_t>(first, 0, length);
  const std::ptrdiff_t end =
      std::clamp<std::ptrdiff_t>(first + static_cast<std::ptrdiff_t>(frames), begin, length);
  local.first = first;
  local.frames = frames;
  for (std::vector<float>* part : {&local.x, &local.y, &local.h})
    part->resize(cloud.points * frames);
  for (std::vector<float>* part : {&local.sum_x, &local.sum_y, &local.spread})
    part->assign(frames, 0);
  if (end - begin < static_cast<std::ptrdiff_t>(frames))
    for (std::vector<float>* part : {&local.x, &local.y, &local.h}) std::ranges::fill(*part, 0.0f);
  if (begin == end) return;

  const auto middle = static_cast<std::size_t>((begin + end) / 2);
  const double x0 = cloud.sum_x[middle + 1] - cloud.sum_x[middle];
  const double y0 = cloud.sum_y[middle + 1] - cloud.sum_y[middle];
  const float fx = local.origin_x = static_cast<float>(x0);
  const float fy = local.origin_y = static_cast<float>(y0);
  for (std::size_t p = 0; p < cloud.points; ++p) {
    const float w = weighted == Weighted::Yes ? cloud.weight[p] : 1.0f;
    const std::size_t from = p * cloud.frames, to = p * frames;
    for (std::ptrdiff_t f = begin; f < end; ++f) {
      const std::size_t source = from + static_cast<std::size_t>(f);
      const std::size_t target = to + static_cast<std::size_t>(f - first);
      local.x[target] = w * (cloud.x[source] - fx);
      local.y[target] = w * (cloud.y[source] - fy);
      local.h[target] = w * cloud.h[source];
    }
  }
  const auto reach = static_cast<std::ptrdiff_t>(half);
  const auto window = static_cast<double>(2 * half + 1);
  for (std::ptrdiff_t f = std::max(begin, reach); f < std::min(end, length - reach); ++f) {
    const auto at = static_cast<std::size_t>(f - first);
    const OwnSums own = sums_between(cloud, static_cast<std::size_t>(f - reach),
                                     static_cast<std::size_t>(f) + half + 1);
    local.sum_x[at] = static_cast<float>(own.x - window * static_cast<double>(fx));
    local.sum_y[at] = static_cast<float>(own.y - window * static_cast<double>(fy));
    local.spread[at] = static_cast<float>(own.square - (own.x * own.x + own.y * own.y) / window);
  }
}

/// Products of one frame of `a` with the frames of `b` on the tile's diagonals, or their sums over
/// a window.
struct CrossRow {
  TileRow dot{}, cross{}, height{};
};

/// Four floats, which every processor that runs docent adds and multiplies at once. Left to itself,
/// the compiler shuffles the three sums among each other for twice the time.
using Lanes [[gnu::vector_size(16)]] = float;
constexpr std::size_t lanes = 4;

Lanes load(const float* from) {
  Lanes value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

void multiply(const LocalCloud& a, const LocalCloud& b, std::size_t points, std::size_t frame,
              CrossRow& row) {
  constexpr std::size_t block = 16;  // Sums of one block stay in registers over all points.
  static_assert(diagonals % block == 0 && block % lanes == 0);
  for (std::size_t e = 0; e < diagonals; e += block) {
    std::array<Lanes, block / lanes> dot{}, cross{}, height{};
    for (std::size_t p = 0; p < points; ++p) {
      const float ax = a.x[p * a.frames + frame], ay = a.y[p * a.frames + frame],
                  ah = a.h[p * a.frames + frame];
      const std::size_t from = p * b.frames + frame + e;
      for (std::size_t i = 0; i < block / lanes; ++i) {
        const Lanes bx = load(&b.x[from + i * lanes]), by = load(&b.y[from + i * lanes]);
        dot[i] += ax * bx + ay * by;
        cross[i] += ay * bx - ax * by;
        height[i] += ah * load(&b.h[from + i * lanes]);
      }
    }
    std::memcpy(&row.dot[e], &dot, sizeof dot);
    std::memcpy(&row.cross[e], &cross, sizeof cross);
    std::memcpy(&row.height[e], &height, sizeof height);
  }
}

/// Moves all windows of a row one frame on.
void move_windows(const CrossRow& arriving, const CrossRow& leaving, CrossRow& sums) {
  for (std::size_t e = 0; e < diagonals; ++e) {
    sums.dot[e] += arriving.dot[e] - leaving.dot[e];
    sums.cross[e] += arriving.cross[e] - leaving.cross[e];
    sums.height[e] += arriving.height[e] - leaving.height[e];
  }
}

/// squared_distance for a row of whole windows.
void fill_row(const LocalCloud& a, std::size_t at, const LocalCloud& b, const CrossRow& sums,
              std::size_t half, float* out) {
  const auto window = static_cast<float>(2 * half + 1);
  const float share = 1 / window, ax = a.sum_x[at] * share, ay = a.sum_y[at] * share;
  const float own = a.spread[at];
  const float *bx = &b.sum_x[at], *by = &b.sum_y[at], *spread = &b.spread[at];
  for (std::size_t e = 0; e < diagonals; ++e) {
    const float dot = sums.dot[e] - (ax * bx[e] + ay * by[e]);
    const float cross = sums.cross[e] - (ay * bx[e] - ax * by[e]);
    const float left =
        own + spread[e] - 2 * std::sqrt(dot * dot + cross * cross) - 2 * sums.height[e];
    out[e] = std::sqrt(std::max(0.0f, left) * share);
  }
}

/// A pair whose windows reach over the end of a clip.
float cut_window(const PoseCloud& a, std::size_t row, const PoseCloud& b, std::size_t column,
                 std::size_t half, const LocalCloud& local_a, const LocalCloud& local_b,
                 const CrossRow& sums, std::size_t diagonal) {
  const Overlap overlap = overlap_of(row, a.frames, column, b.frames, half);
  const auto frames = static_cast<double>(overlap.end - overlap.first);
  const auto own = [&](const PoseCloud& cloud, std::size_t frame, const LocalCloud& local) {
    OwnSums sum = sums_between(cloud, frame + static_cast<std::size_t>(overlap.first),
                               frame + static_cast<std::size_t>(overlap.end));
    const double x = local.origin_x, y = local.origin_y;
    sum.square += frames * (x * x + y * y) - 2 * (x * sum.x + y * sum.y);
    sum.x -= frames * x;
    sum.y -= frames * y;
    return sum;
  };
  const double square =
      squared_distance(own(a, row, local_a), own(b, column, local_b),
                       {sums.dot[diagonal], sums.cross[diagonal], sums.height[diagonal]}, frames);
  return static_cast<float>(std::sqrt(square));
}

}  // namespace

PoseCloud make_pose_cloud(const Skeleton& skeleton, const JointPositions& track) {
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

std::vector<TilePlace> all_tiles(std::size_t frames_a, std::size_t frames_b) {
  std::vector<TilePlace> places;
  for (std::size_t first = 0; first < frames_a; first += rows) {
    const std::size_t last = std::min(first + rows, frames_a) - 1;
    const TilePlace begin = tile_of(frames_a, last, 0);
    const TilePlace end = tile_of(frames_a, first, frames_b - 1);
    for (std::uint32_t d = begin.diagonal; d <= end.diagonal; ++d) places.push_back({begin.row, d});
  }
  return places;
}

void measure_tile(const PoseCloud& a, const PoseCloud& b, std::size_t half, TilePlace place,
                  DistanceTile& tile) {
  thread_local LocalCloud local_a, local_b;
  thread_local std::vector<CrossRow> product;
  const auto reach = static_cast<std::ptrdiff_t>(half);
  const auto frames_a = static_cast<std::ptrdiff_t>(a.frames);
  const auto frames_b = static_cast<std::ptrdiff_t>(b.frames);
  const auto first_row = static_cast<std::ptrdiff_t>(place.row * rows);
  const auto first_diagonal =
      static_cast<std::ptrdiff_t>(place.diagonal * diagonals) - (frames_a - 1);
  const std::size_t steps = rows + 2 * half;
  take_frames(a, first_row - reach, steps, half, Weighted::Yes, local_a);
  take_frames(b, first_row - reach + first_diagonal, steps + diagonals, half, Weighted::No,
              local_b);
  product.resize(steps);

  // A frame of `a` comes into the window `half` steps before it is the middle, and goes half + 1
  // steps after.
  tile.distance.fill(std::numeric_limits<float>::infinity());
  CrossRow sums;
  const CrossRow nothing;
  for (std::size_t step = 0; step < steps; ++step) {
    multiply(local_a, local_b, a.points, step, product[step]);
    move_windows(product[step], step > 2 * half ? product[step - 2 * half - 1] : nothing, sums);
    if (step < 2 * half) continue;
    const std::ptrdiff_t row = first_row + static_cast<std::ptrdiff_t>(step) - 2 * reach;
    if (row >= frames_a) break;
    const std::ptrdiff_t column = row + first_diagonal;  // of the tile's first diagonal
    float* out = &tile.distance[(step - 2 * half) * diagonals];
    fill_row(local_a, step - half, local_b, sums, half, out);
    const bool whole_row = row >= reach && row + reach < frames_a;
    if (whole_row && column >= reach &&
        column + static_cast<std::ptrdiff_t>(diagonals) + reach <= frames_b)
      continue;
    for (std::size_t e = 0; e < diagonals; ++e) {
      const std::ptrdiff_t at = column + static_cast<std::ptrdiff_t>(e);
      if (whole_row && at >= reach && at + reach < frames_b) continue;
      out[e] = at < 0 || at >= frames_b
                   ? std::numeric_limits<float>::infinity()
                   : cut_window(a, static_cast<std::size_t>(row), b, static_cast<std::size_t>(at),
                                half, local_a, local_b, sums, e);
    }
  }
}

DistanceMatrix measure_distances(const PoseCloud& a, const PoseCloud& b, std::size_t half) {
  DistanceMatrix matrix{
      .rows = a.frames, .columns = b.frames, .distance = std::vector<float>(a.frames * b.frames)};
  DistanceTile tile;
  for (const TilePlace place : all_tiles(a.frames, b.frames)) {
    measure_tile(a, b, half, place, tile);
    for (std::size_t r = 0; r < rows && place.row * rows + r < a.frames; ++r) {
      const std::size_t row = place.row * rows + r;
      // Column of the tile's first diagonal, counted so that it is never negative.
      const std::size_t shifted = row + place.diagonal * diagonals;
      const std::size_t zero = a.frames - 1;
      const std::size_t begin = std::max(shifted, zero),
                        end = std::min(shifted + diagonals, zero + b.frames);
      for (std::size_t c = begin; c < end; ++c)
        matrix.distance[row * matrix.columns + c - zero] =
            tile.distance[r * diagonals + c - shifted];
    }
  }
  return matrix;
}

}  // namespace docent::motion::offline

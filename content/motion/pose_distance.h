#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "content/motion/joint_positions.h"

namespace docent::motion::offline {

/// The points by which poses of a clip are compared, and their sums (Kovar, Gleicher, Pighin 2002,
/// section 3.1).
///
/// A pose is seen as a cloud of its joints in a window of frames, so that it compares movements
/// and not stills. Points are in the floor frame with their height, metres, relative to `origin`
/// (the middle of the clip) so that sums of squares stay small. Weights add up to 1 over one frame.
struct PoseCloud {
  std::size_t frames = 0, points = 0;
  Vec2 origin{};
  std::vector<float> x, y, h;        ///< Point p of frame f is [p * frames + f].
  std::vector<float> weight;         ///< One per point.
  std::vector<double> sum_x, sum_y;  ///< Weighted means of the frames before f, summed.
  std::vector<double> sum_square;    ///< The same of x2 + y2 + h2; frames + 1 entries each.
};

PoseCloud make_pose_cloud(const Skeleton& skeleton, const JointPositions& track);

/// How alike two windows are, and the rigid motion on the floor that lays `b` best onto `a`.
struct PoseMatch {
  double distance = 0;  ///< Metres, weighted root mean square over the window after alignment.
  Placement alignment;
};

/// Compares the windows [frame - half, frame + half] of two clips in closed form; where a window
/// reaches over an end of its clip, both are shortened alike.
PoseMatch compare_poses(const PoseCloud& a, std::size_t frame_a, const PoseCloud& b,
                        std::size_t frame_b, std::size_t half);

/// A piece of the matrix of all distances between two clips: `rows` frames of the first that follow
/// each other, each with frames of the second on `diagonals` diagonals side by side. Pieces lie
/// along diagonals because the pairs of two motions that are alike do, too, and because there a
/// window's sums differ from the next one's by the frame that comes and the one that goes.
struct DistanceTile {
  static constexpr std::size_t rows = 64, diagonals = 32;

  /// Metres, [row * diagonals + diagonal]; infinite where a clip has no such frame.
  std::array<float, rows * diagonals> distance;
};

/// Which piece: rows from row * DistanceTile::rows; diagonals (frame of the second less frame of
/// the first) from diagonal * DistanceTile::diagonals, counted from the matrix's lower left corner.
struct TilePlace {
  std::uint32_t row = 0, diagonal = 0;
  auto operator<=>(const TilePlace&) const = default;
};

/// The piece that holds a pair of frames, of a first clip of so many.
constexpr TilePlace tile_of(std::size_t frames_a, std::size_t frame_a, std::size_t frame_b) {
  return {
      static_cast<std::uint32_t>(frame_a / DistanceTile::rows),
      static_cast<std::uint32_t>((frame_b + (frames_a - 1) - frame_a) / DistanceTile::diagonals)};
}

/// All pieces that hold a pair of frames of two clips, in order.
std::vector<TilePlace> all_tiles(std::size_t frames_a, std::size_t frames_b);

/// Measures the same as compare_poses for every pair of a piece (to 0.1 mm and, where less than a
/// centimetre is left, to 2 mm), in a time that does not depend on the window.
void measure_tile(const PoseCloud& a, const PoseCloud& b, std::size_t half, TilePlace place,
                  DistanceTile& tile);

/// Distances of all frames of `a` to all frames of `b`; metres.
struct DistanceMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<float> distance;  ///< distance[row * columns + column]

  float at(std::size_t row, std::size_t column) const { return distance[row * columns + column]; }
};

/// All pieces, put together.
DistanceMatrix measure_distances(const PoseCloud& a, const PoseCloud& b, std::size_t half);

}  // namespace docent::motion::offline

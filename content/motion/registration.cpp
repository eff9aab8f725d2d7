#include "content/motion/registration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace docent::motion::offline {
namespace {

constexpr double look_seconds = 0.025;   // between two rows of the matrix
constexpr double window_seconds = 0.15;  // to each side, as for transitions
constexpr double smooth_seconds = 0.3;
constexpr double still_welcome = 0.15;  // metres: up to here a shared moment is better than none
constexpr double other_foot = 0.1;      // metres that a foot counts which stands in one clip only
constexpr double whole_turn = 0.5;      // metres that it counts when one has turned, the other not
constexpr double least_turn = 0.2;      // radians

/// How much of its turn a clip has made in each frame, from 0 to 1; empty where it does not turn.
std::vector<double> shares_of_turn(std::span<const double> heading) {
  const double turn = heading.back() - heading.front();
  std::vector<double> shares;
  if (std::abs(turn) < least_turn) return shares;
  for (const double h : heading) shares.push_back((h - heading.front()) / turn);
  return shares;
}

/// A way through the matrix of all pairs of moments, by dynamic programming.
class Warp {
 public:
  Warp(const RegisteredClip& a, const RegisteredClip& b)
      : a_(a),
        b_(b),
        step_(frames_in(look_seconds, a.clip.frame_rate)),
        rows_((a.cloud.frames - 1) / step_ + 1),
        columns_((b.cloud.frames - 1) / step_ + 1),
        share_a_(shares_of_turn(a.heading)),
        share_b_(shares_of_turn(b.heading)),
        cell_(rows_ * columns_) {
    for (std::size_t i = 0; i < rows_; ++i)
      for (std::size_t j = 0; j < columns_; ++j) fill(i, j);
  }

  /// The best way, as pairs of frames.
  Registration trace() const {
    std::size_t i = rows_ - 1, j = columns_ - 1;
    for (std::size_t k = 0; k < rows_; ++k)
      if (at(k, columns_ - 1).score > at(i, j).score) i = k, j = columns_ - 1;
    for (std::size_t k = 0; k < columns_; ++k)
      if (at(rows_ - 1, k).score > at(i, j).score) i = rows_ - 1, j = k;
    Registration way;
    double squares = 0;
    for (const Move* move = &at(i, j).move;; move = &at(i, j).move) {
      way.a.push_back(static_cast<double>(i * step_));
      way.b.push_back(static_cast<double>(j * step_));
      squares += at(i, j).unlikeness;
      if (move->rows == 0) break;
      i -= move->rows;
      j -= move->columns;
    }
    way.unlikeness = std::sqrt(squares / static_cast<double>(way.a.size()));
    std::ranges::reverse(way.a);
    std::ranges::reverse(way.b);
    return way;
  }

 private:
  struct Move {
    std::size_t rows = 0, columns = 0;
  };
  struct Cell {
    double score = -std::numeric_limits<double>::infinity();
    double unlikeness = 0;  ///< Square metres.
    Move move{};            ///< From the cell before.
  };
  const Cell& at(std::size_t i, std::size_t j) const { return cell_[i * columns_ + j]; }

  double unlikeness(std::size_t i, std::size_t j) const {
    const std::size_t half = frames_in(window_seconds, a_.clip.frame_rate);
    const std::size_t f = i * step_, g = j * step_;
    const double apart = compare_poses(a_.cloud, f, b_.cloud, g, half).distance;
    const FootPlants feet = a_.clip.plants[f], others = b_.clip.plants[g];
    const int odd = (feet.left != others.left) + (feet.right != others.right);
    const double ahead =
        share_a_.empty() || share_b_.empty() ? 0 : whole_turn * (share_a_[f] - share_b_[g]);
    return apart * apart + odd * other_foot * other_foot + ahead * ahead;
  }

  void fill(std::size_t i, std::size_t j) {
    constexpr std::array<Move, 3> moves{{{1, 1}, {1, 2}, {2, 1}}};
    Cell& cell = cell_[i * columns_ + j];
    cell.unlikeness = unlikeness(i, j);
    const double gain = still_welcome * still_welcome - cell.unlikeness;
    if (i == 0 || j == 0) cell.score = gain;
    for (const Move& move : moves) {
      if (i < move.rows || j < move.columns) continue;
      const double score = at(i - move.rows, j - move.columns).score +
                           gain * static_cast<double>(move.rows + move.columns) / 2;
      if (score <= cell.score) continue;
      cell.score = score;
      cell.move = move;
    }
  }

  const RegisteredClip &a_, &b_;
  std::size_t step_, rows_, columns_;
  std::vector<double> share_a_, share_b_;
  std::vector<Cell> cell_;
};

/// Takes the corners out of a way: evenly spaced along the sum of both times, the difference of the
/// times is averaged over windows that are symmetric, so that time never runs back.
Registration smoothed(const Registration& way, double frame_rate) {
  std::vector<double> lead;
  const double first = way.a.front() + way.b.front();
  std::size_t k = 0;
  for (double sum = first; sum <= way.a.back() + way.b.back(); sum += 2) {
    while (k + 2 < way.a.size() && way.a[k + 1] + way.b[k + 1] <= sum) ++k;
    const double before = way.a[k] + way.b[k], after = way.a[k + 1] + way.b[k + 1];
    const double part = (sum - before) / (after - before);
    lead.push_back(std::lerp(way.b[k] - way.a[k], way.b[k + 1] - way.a[k + 1], part));
  }
  Registration result{.a = {}, .b = {}, .unlikeness = way.unlikeness};
  const std::size_t widest = frames_in(smooth_seconds, frame_rate) / 2;
  for (std::size_t f = 0; f < lead.size(); ++f) {
    const std::size_t half = std::min({f, lead.size() - 1 - f, widest});
    double mean = 0;
    for (std::size_t g = f - half; g <= f + half; ++g) mean += lead[g];
    mean /= static_cast<double>(2 * half + 1);
    const double sum = first + 2 * static_cast<double>(f);
    result.a.push_back((sum - mean) / 2);
    result.b.push_back((sum + mean) / 2);
  }
  return result;
}

}  // namespace

Registration register_clips(const RegisteredClip& a, const RegisteredClip& b) {
  const Registration way = Warp(a, b).trace();
  return way.a.size() < 2 ? way : smoothed(way, a.clip.frame_rate);
}

}  // namespace docent::motion::offline

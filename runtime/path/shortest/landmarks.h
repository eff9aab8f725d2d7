#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/sight_map.h"

namespace docent::path {

/// The distances of every corner to a few corners that lie far from each other, the landmarks. The
/// difference of two corners' distances to a landmark is a lower bound of every way between the two
/// corners. (Goldberg and Harrelson 2005.)
///
/// The distances are those of a point. A disc that goes from where it touches one corner to where
/// it touches another saves no more than twice its radius against a point from corner to corner,
/// and no more than its radius if it ends elsewhere.
class Landmarks {
 public:
  static constexpr std::size_t count = 16;
  /// Numbers that the processor works on at once.
  static constexpr std::size_t lanes = 8;
  using Lanes = std::int16_t __attribute__((vector_size(2 * lanes)));
  /// Distances in steps. At most half of what 16 bits hold, so that a length can be added.
  using Distances = std::array<Lanes, count / lanes>;
  static constexpr std::int16_t most = 16'000;

  Landmarks(const FloorPlan& plan, const SightMap& sight);

  /// Metres that a distance of 1 stands for. Distances are rounded to the nearest step.
  double metres_per_step() const noexcept { return metres_per_step_; }
  /// Those of a corner of the sight map. 0 for a landmark to which no way leads from there.
  const Distances& of(std::uint32_t corner) const noexcept { return distance_[corner]; }

 private:
  double metres_per_step_ = 1;
  std::vector<Distances> distance_;
};

/// A lower bound of the way from a corner to a place that is reached over one of some other
/// corners.
class LandmarkBound {
 public:
  /// `saved`: metres by which a way may be shorter than that of points.
  LandmarkBound(const Landmarks& landmarks, double saved) noexcept
      : landmarks_(landmarks), saved_(saved) {
    low_.fill(Landmarks::Lanes{} + static_cast<std::int16_t>(2 * Landmarks::most));
    high_.fill(Landmarks::Lanes{} - Landmarks::most);
  }

  /// A corner over which the place may be reached, and how long the rest of the way is from there.
  void add(std::uint32_t corner, double rest) noexcept {
    const auto length = static_cast<std::int16_t>(
        std::min<double>(rest / landmarks_.metres_per_step(), Landmarks::most));
    const Landmarks::Distances& distance = landmarks_.of(corner);
    for (std::size_t i = 0; i < distance.size(); ++i) {
      const Landmarks::Lanes farther = distance[i] + length, nearer = distance[i] - length;
      low_[i] = farther < low_[i] ? farther : low_[i];
      high_[i] = nearer > high_[i] ? nearer : high_[i];
    }
  }

  /// Metres; may be a little below 0.
  double from(std::uint32_t corner) const noexcept {
    const Landmarks::Distances& distance = landmarks_.of(corner);
    Landmarks::Lanes most{};
    for (std::size_t i = 0; i < distance.size(); ++i) {
      const Landmarks::Lanes below = low_[i] - distance[i], above = distance[i] - high_[i];
      most = below > most ? below : most;
      most = above > most ? above : most;
    }
    // The largest of all lanes: each beside the one that is 4, 2 and 1 away.
    const auto keep_larger = [&](const Landmarks::Lanes& other) {
      most = other > most ? other : most;
    };
    keep_larger(__builtin_shufflevector(most, most, 4, 5, 6, 7, 0, 1, 2, 3));
    keep_larger(__builtin_shufflevector(most, most, 2, 3, 0, 1, 6, 7, 4, 5));
    keep_larger(__builtin_shufflevector(most, most, 1, 0, 3, 2, 5, 4, 7, 6));
    const std::int16_t steps = most[0];
    // Two distances are rounded to the nearest step, and a length down.
    return (steps - 2) * landmarks_.metres_per_step() - saved_;
  }

 private:
  const Landmarks& landmarks_;
  double saved_;
  /// Per landmark, the least that the place may be away from it, and the most.
  Landmarks::Distances low_, high_;
};

}  // namespace docent::path

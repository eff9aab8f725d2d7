#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/scene/draw_list.h"

namespace docent::scene {

/// Something on the floor that has to be seen.
struct Sight {
  Vec2 place{};           ///< Floor frame.
  double half_width = 0;  ///< Metres to either side, as the camera sees it.
};

/// Where walls have sunk into the floor because they would hide something from the camera.
///
/// A lattice of cells of the floor holds how far the walls there have sunk. It goes along with the
/// attention: a cell that comes into it stands, as everything outside of it does. What is drawn at
/// a place is cut at `height_at`; the renderer does the same with a texture (shaders/sinks.glsl).
class SunkWalls {
 public:
  /// Everything stands on a floor of at most `most_walls` walls. Allocates all that it will need.
  explicit SunkWalls(std::size_t most_walls);

  /// Another floor is shown, on which everything stands.
  void show(const FloorPlan& plan) noexcept;
  /// One step of time: walls sink where they would hide a sight from `eye` (world frame), about
  /// `centre`, and rise elsewhere. With `seconds` below 0 they do so at once.
  void advance(Vec2 centre, Vec3 eye, std::span<const Sight> sights, float seconds) noexcept;

  /// Metres above the floor at which walls are cut at a place now.
  double height_at(Vec2 place) const noexcept;
  const WallLevels& levels() const noexcept { return levels_; }

 private:
  struct Crossing {
    double along = 0;     ///< Of the line, metres.
    bool leaves = false;  ///< Does it go from the open floor into a wall there?
  };

  void go_along(Vec2 centre) noexcept;
  void gather_walls(Vec2 centre) noexcept;
  void keep_beside(Vec2 from, Vec2 to, double half_width) noexcept;
  void clear(Vec2 from, Vec2 to) noexcept;
  void sink(Vec2 a, Vec2 b) noexcept;

  const FloorPlan* plan_ = nullptr;
  std::vector<std::uint32_t> near_;    ///< Walls about `gathered_`.
  std::vector<std::uint32_t> beside_;  ///< Those of them that a sight's rays can cross.
  Vec2 gathered_{1e9, 1e9};
  std::vector<float> wanted_, level_;
  WallLevels levels_;
};

}  // namespace docent::scene

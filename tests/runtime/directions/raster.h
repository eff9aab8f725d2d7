#pragma once

#include <cstdint>
#include <vector>

#include "runtime/directions/directions.h"
#include "runtime/model/museum.h"

namespace docent::test {

/// A room's door as water finds it: the cells of the room from which it runs out.
struct WaterDoor {
  Vec2 middle{};
  double bearing = 0;  ///< Degrees: out of the room.
  double width = 0;
};

/// A floor as cells of 10 cm, each walkable or not, each in a room or in none. Finds by other means
/// what the describer finds by geometry: the checker of its facts.
class Raster {
 public:
  Raster(const Museum& museum, std::uint32_t floor);

  std::uint32_t room_at(Vec2 point) const;
  const std::vector<WaterDoor>& doors_of(std::uint32_t room) const { return doors_[room]; }
  /// The steps of a way along this floor, for somebody who begins it looking to `degrees`; and how
  /// they come into its last room.
  struct Told {
    std::uint32_t first_room = none;
    std::vector<directions::DoorStep> steps;
    Vec2 at{};
    double degrees = 0;
    bool is_borderline = false;  ///< A step aside, or a degree, and it would be told otherwise.
  };
  Told tell(const std::vector<Vec2>& way, double degrees) const;

 private:
  static constexpr double cell = 0.1;

  std::size_t index(long column, long row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }
  Vec2 centre(long column, long row) const {
    return low_ + Vec2{(static_cast<double>(column) + 0.5) * cell,
                       (static_cast<double>(row) + 0.5) * cell};
  }
  bool is_puddle(std::size_t start, std::uint32_t room) const;
  void find_doors(std::uint32_t room);

  Vec2 low_{};
  long columns_ = 0, rows_ = 0;
  std::vector<char> open_;
  std::vector<std::uint32_t> room_;
  std::vector<std::vector<WaterDoor>> doors_;
};

}  // namespace docent::test

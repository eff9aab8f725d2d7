#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "runtime/input/gesture.h"
#include "runtime/model/museum.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// The exhibit's object that a visitor has arrived at, and how far they have turned it. It swings
/// slowly until they touch it; a finger takes it along, and lets it go on turning for a while.
class TurnTable {
 public:
  /// The exhibit whose object is on it; none: no object. Another one stands as staff have placed
  /// it.
  void put(std::optional<std::uint32_t> exhibit) noexcept;
  const std::optional<std::uint32_t>& exhibit() const noexcept { return exhibit_; }
  /// By a key: a twelfth of a turn to the left or the right, softly.
  void turn(bool left) noexcept;
  /// One step of time, with the fingers on the glass: the first that came down in `free` turns it,
  /// all round for a finger that crosses it. `sways_for`: of these seconds it moves by itself for
  /// so many, while nobody touches it.
  void step(std::span<const input::Finger> fingers, const scene::Rect& free, float sways_for,
            float seconds) noexcept;
  /// Radians from how it was placed, counter-clockwise from above.
  float angle() const noexcept { return angle_; }

 private:
  std::optional<std::uint32_t> exhibit_{};
  float angle_ = 0, rate_ = 0;  ///< Radians a second, after a finger has let go.
  float left_to_turn_ = 0;      ///< Radians, by keys.
  float swayed_for_ = 0;        ///< Seconds.
  bool is_touched_ = false;     ///< At any time since then.
  std::optional<std::uint32_t> finger_{};
  float finger_x_ = 0;
};

/// The objects of a floor, the one on the table as it is turned; `near` is the exhibit that is
/// looked at, or about to be. Does not allocate.
void draw_objects(const Museum& museum, std::uint32_t floor, const TurnTable& table,
                  std::optional<std::uint32_t> near, scene::DrawList& list) noexcept;

/// Has the exhibit an object of its own?
bool has_object(const Museum& museum, std::optional<std::uint32_t> exhibit) noexcept;

/// World frame: what an exhibit's object stands on, and how large it stands there.
Vec3 foot_of(const Museum& museum, const Exhibit& exhibit) noexcept;
Vec3 size_of(const Museum& museum, const Exhibit& exhibit) noexcept;

}  // namespace docent::guide

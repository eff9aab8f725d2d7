#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/input/gesture.h"
#include "runtime/scene/camera.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// How the model is seen from above as a whole.
struct WholeModel {
  scene::CameraRig rig;
  /// What there is to see, metres from the rig's target: x to the right of the screen, y up.
  Vec2 least{}, most{};
};

/// That of a floor, as large as fits into `free` (screen frame).
WholeModel whole_model(std::span<const Vec2> outline, double height, double yaw,
                       const scene::Rect& free, float aspect) noexcept;

/// How near a visitor has drawn the model that is seen from above. Two fingers draw it nearer, or
/// put it back; one moves it while it is nearer. What lies on the floor stays under the finger that
/// is on it, as far as the model reaches; it is never seen smaller than whole. Until one of them
/// has come a little way nothing moves, and they press: somebody's sleeve may lie beside a finger.
class CloserLook {
 public:
  static constexpr double nearest = 4;  ///< Times as near.

  /// One step of time, with the fingers that came down on the model, in the order in which they
  /// did; of more than two the first two count.
  void step(std::span<const input::Finger> fingers, const WholeModel& model, float aspect,
            float seconds) noexcept;
  /// Did a finger move the model, and so press nothing?
  bool has_moved(std::uint32_t finger) const noexcept;
  /// The whole model is seen again: softly, or, where `at_once`, without a glide.
  void end(bool at_once) noexcept;

  double nearness() const noexcept { return nearness_; }
  bool is_moving() const noexcept { return held_count_ > 0 || (ends_ && nearness_ > 1); }
  /// The rig of the whole model, moved and drawn nearer.
  scene::CameraRig applied_to(scene::CameraRig rig) const noexcept;

 private:
  struct Held {
    std::uint32_t finger = 0;
    Vec2 ground{};              ///< That is under it: metres from the target, as in WholeModel.
    scene::ScreenPoint from{};  ///< Where it was when the others came or went.
    bool has_moved = false;
  };
  void hold(std::span<const input::Finger> fingers, const WholeModel& model, float aspect) noexcept;
  void begin_to_move(std::span<const input::Finger> fingers, const WholeModel& model,
                     float aspect) noexcept;
  void follow(std::span<const input::Finger> fingers, const WholeModel& model,
              float aspect) noexcept;
  void keep_within(const WholeModel& model) noexcept;

  double nearness_ = 1;
  Vec2 shift_{};  ///< Of the target: metres, as in WholeModel.
  bool ends_ = false;
  std::array<Held, 2> held_{};
  std::size_t held_count_ = 0;
  bool moves_ = false;  ///< One of them has come a little way.
};

}  // namespace docent::guide

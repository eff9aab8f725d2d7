#pragma once

#include <array>
#include <span>
#include <vector>

#include "runtime/guide/avatar.h"
#include "runtime/guide/closer_look.h"
#include "runtime/guide/crowd.h"
#include "runtime/guide/exhibit_shape.h"
#include "runtime/interface/control.h"
#include "runtime/interface/goal.h"
#include "runtime/model/museum.h"
#include "runtime/scene/camera.h"
#include "runtime/scene/draw_list.h"
#include "runtime/scene/sunk_walls.h"
#include "runtime/scene/walking_camera.h"

namespace docent::guide {

/// Does it have a guide's look, and not a stroller's?
bool leaves_a_trail(const Agent& one) noexcept;

/// Appends a guide's way as a trail in the colour of its look, its pattern moved on by `flow`
/// metres; nothing where the list has no capacity left. Does not allocate.
void draw_trail(const Avatar& avatar, float flow, scene::DrawList& list) noexcept;

/// A guide who leads a visitor to an exhibit or a place.
struct LedVisitor {
  std::uint32_t guide = 0;
  std::optional<std::uint32_t> exhibit{};
  std::optional<interface::Goal> goal{};  ///< None until it is known.
  bool arrived = false;
  bool strays = false;  ///< The guide is on another way just now, and comes back to this.
};

/// Where the model is seen: screen frame.
struct Window {
  scene::Rect free{0, 0, 1, 1};           ///< What a view leaves to it.
  std::span<const scene::Rect> boards{};  ///< What lies on that all the same.
};

/// The model as a view shows it: the camera, the ways on the floor, the marks. Everything that is
/// drawn below the interface except the bodies.
class Stage {
 public:
  /// `shapes`: of each exhibit. `reduced_motion`: the camera cuts instead of flying, and follows a
  /// walk in steps.
  Stage(const Museum& museum, std::span<const ExhibitShape> shapes, bool reduced_motion);

  /// A view is entered that shows the model in `window`. The camera flies if need be.
  void enter(const interface::InterfaceState& state, const Window& window, float aspect,
             const Avatar& leader) noexcept;
  void advance(const interface::InterfaceState& state, const Avatar& leader,
               float seconds) noexcept;
  /// The camera is there at once, with the floor that it is to show.
  void cut(const interface::InterfaceState& state, const Avatar& leader) noexcept;
  /// From above, the model is seen turned by so many radians, and from so much further away.
  void sway(double turn, double further) noexcept {
    turn_ = turn;
    further_ = further;
  }
  /// Or as near as a visitor has drawn it.
  void look_closer(const CloserLook& look) noexcept { closer_ = look; }
  /// The whole floor that is shown, in the free part.
  const WholeModel& whole() const noexcept { return whole_; }
  /// Fills in camera, light, ways and marks. The crowd's first agent is the leader. On the glass of
  /// one visitor the way has the colour of its kind, which the panel explains; on a shared glass
  /// each way has the colour of its guide, and the pattern alone tells the kind.
  void draw(const interface::InterfaceState& state, const Crowd& crowd,
            std::span<const LedVisitor> led_visitors, scene::DrawList& list) const noexcept;
  /// The leader follows another way: its points go into the draw list.
  void show_way(const plan::Plan& plan, scene::DrawList& list) noexcept;

  bool is_flying() const noexcept { return flight_ < 1 || changing_ > 0; }
  /// The floor that is shown.
  std::uint32_t floor() const noexcept { return floor_; }
  const scene::CameraRig& rig() const noexcept { return rig_; }
  /// How far walls have sunk, so as to hide nothing.
  const scene::WallLevels& walls() const noexcept { return walls_.levels(); }

 private:
  void draw_own_way(const interface::InterfaceState& state, const Avatar& leader,
                    scene::DrawList& list) const noexcept;
  float walked(const Avatar& leader) const noexcept;
  void measure_walked(const interface::InterfaceState& state, const Avatar& leader) noexcept;
  void draw_doors(scene::DrawList& list) const noexcept;
  void draw_ways(const Crowd& crowd, std::span<const LedVisitor> led_visitors,
                 scene::DrawList& list) const noexcept;
  scene::CameraRig wanted_rig(const interface::InterfaceState& state,
                              const Avatar& leader) const noexcept;
  scene::CameraRig arrival_rig(const interface::InterfaceState& state, const interface::Goal& goal,
                               const Avatar& leader) const noexcept;
  bool take_boards(std::span<const scene::Rect> boards) noexcept;

  std::uint32_t wanted_floor(const interface::InterfaceState& state,
                             const Avatar& leader) const noexcept;
  void show_floor(std::uint32_t floor) noexcept;
  void change_floor(const interface::InterfaceState& state, const Avatar& leader,
                    float seconds) noexcept;
  std::optional<Placement> end_of_way(const interface::InterfaceState& state,
                                      const Avatar& leader) const noexcept;
  void look_at_whole_way(std::span<const Vec2> way) noexcept;
  void cut_to(const interface::InterfaceState& state, const Avatar& leader) noexcept;
  bool shows_walk(const interface::InterfaceState& state, const Avatar& leader) const noexcept;
  void turn_to_way(const interface::InterfaceState& state, const Avatar& leader) noexcept;
  void sink_walls(const interface::InterfaceState& state, const Avatar& leader,
                  float seconds) noexcept;

  const Museum& museum_;
  std::span<const ExhibitShape> shapes_;
  bool reduced_motion_;
  std::vector<std::vector<Vec2>> outlines_;  ///< Per floor: what an overview has to show.
  std::uint32_t floor_ = 0;                  ///< That is shown.
  float changing_ = 0;  ///< How far the model has gone to make way for another floor.
  scene::CameraRig rig_, from_;
  double flight_ = 1;          ///< Share of the flight from `from_` that is done.
  double flight_seconds_ = 1;  ///< How long the flight takes.
  interface::Screen screen_ = interface::Screen::Welcome;
  double turn_ = 0, further_ = 1;
  bool entered_ = false;
  bool above_ = true;  ///< Is the model seen from above?
  scene::Rect free_{0, 0, 1, 1};
  std::array<scene::Rect, 4> boards_{};  ///< That lie on it.
  std::size_t board_count_ = 0;
  float aspect_ = 16.0F / 9;
  scene::WalkingCamera walking_;
  scene::SunkWalls walls_;
  bool is_new_way_ = false;  ///< Shown, and the camera has not turned to it yet.
  WholeModel whole_;
  CloserLook closer_;
  scene::CameraRig whole_way_;  ///< The way that is shown, from above.
  double flow_ = 0;  ///< Metres that patterns of ways have moved; wrapped where it cannot be seen.
  float way_opacity_ = 0;  ///< The ribbon comes and goes softly.
  std::uint32_t revision_ = 0;
  RouteKind way_kind_ = RouteKind::Shortest;
  std::uint32_t way_count_ = 0, way_floor_ = 0;
  float way_length_ = 0;
  Vec2 way_end_{};
  static constexpr std::size_t most_doors = 32;
  struct LitDoor {
    scene::MarkerDraw light{};
    double along = 0;  ///< Metres from the way's beginning.
  };
  std::array<LitDoor, most_doors> doors_{};  ///< That the way leads through, ...
  std::size_t door_count_ = 0;               ///< ... so many of them.
  float walked_ = 0;                         ///< Metres of the way shown.
  bool rests_ = false;                       ///< It has been walked, and all is measured.
};

}  // namespace docent::guide

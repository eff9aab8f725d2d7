#pragma once

#include <cstdint>
#include <optional>

#include "runtime/guide/crowd.h"
#include "runtime/guide/stage.h"
#include "runtime/interface/control.h"
#include "runtime/interface/view.h"
#include "runtime/model/museum.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// What the museum does while nobody has been at its glass for a minute: the interface makes way
/// for the model, light goes slowly over it, the camera sways, and every now and then the guide
/// shows a way to an exhibit, walks it, and goes home. Nothing bright stands still for a minute.
///
/// The first touch ends it. None of its functions throws, allocates or waits.
class Attract {
 public:
  explicit Attract(const Museum& museum) : museum_(museum) {}

  /// Somebody is there. True where that has ended it.
  bool wake() noexcept;
  /// `is_vacant`: nobody is using the glass. Sends the crowd's first agent, who is the guide.
  /// True in the step in which the model is to be seen as another state() than before.
  bool step(float seconds, bool is_vacant, Crowd& crowd) noexcept;

  bool is_on() const noexcept { return phase_ != Phase::Off; }
  /// Has it begun in this step?
  bool has_begun() const noexcept { return is_on() && seconds_ == 0; }
  /// As which the model is shown while it is on.
  const interface::InterfaceState& state() const noexcept { return state_; }
  /// Whom the guide leads: nobody, but it shows the way.
  std::optional<LedVisitor> led() const noexcept;

  /// What it makes of the light in which the model is otherwise.
  scene::Light light(const scene::Light& usual) const noexcept;
  /// By how much the camera turns, radians, and how much further away it is.
  double turn() const noexcept;
  double further() const noexcept;
  /// How much is to be seen of the interface.
  float interface_opacity() const noexcept;
  /// Appends the museum's welcome and its sign, now here and now there.
  void draw_welcome(const interface::View& view, scene::DrawList& list) const noexcept;

 private:
  enum class Phase : std::uint8_t { Off, Rests, Asks, Overlooks, Walks, Looks, Returns };
  void begin(Crowd& crowd) noexcept;
  void enter(Phase phase) noexcept;
  void choose(Crowd& crowd) noexcept;
  void go_on(Crowd& crowd) noexcept;

  const Museum& museum_;
  Phase phase_ = Phase::Off;
  float alone_ = 0;     ///< Seconds since anybody touched anything.
  double seconds_ = 0;  ///< Since it began.
  double phase_seconds_ = 0;
  std::uint32_t chosen_ = 0;  ///< The exhibit that was shown last.
  interface::InterfaceState state_;
};

}  // namespace docent::guide

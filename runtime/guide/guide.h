#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "runtime/company/meetings.h"
#include "runtime/guide/avatar.h"
#include "runtime/guide/company.h"
#include "runtime/guide/overlay.h"
#include "runtime/guide/stage.h"
#include "runtime/guide/strollers.h"
#include "runtime/input/gesture.h"
#include "runtime/model/museum.h"
#include "runtime/plan/planner.h"
#include "runtime/scene/draw_list.h"
#include "runtime/scene/layout.h"

namespace docent {

using Seconds = std::chrono::duration<float>;

/// Someone in front of the glass: what they see and what they asked for.
struct Visitor {
  InterfaceState state;
  float idle_seconds = 0;  ///< Since they last touched anything.
};

/// What the guide was sent to do.
struct Errand {
  enum class Kind : std::uint8_t { None, ToExhibit, Stop, Home };
  Kind kind = Kind::None;
  std::int32_t exhibit = -1;
  RouteKind route = RouteKind::Shortest;
};

/// What an operator set for this device.
struct GuideSettings {
  ScreenShape shape;
  Seconds idle_reset{60};
};

/// What happened so far, for --stats.
struct GuideCounters {
  std::uint64_t touches = 0, routes = 0, collisions = 0;
  std::uint64_t views = 0;  ///< Grows in the frame in which another view is entered.

  GuideCounters& operator+=(const GuideCounters& other) noexcept {
    touches += other.touches;
    routes += other.routes;
    collisions += other.collisions;
    views += other.views;
    return *this;
  }
};

/// The kiosk's whole state, without the edges: touches and time in, a draw list out.
///
/// Called by the frame thread alone. After construction its functions do not throw, allocate or
/// wait: what takes long is asked of the planner, whose answers are taken at the next step. Borrows
/// the museum and the planner.
class Guide {
 public:
  Guide(const Museum& museum, Planner& planner, const GuideSettings& settings);

  void touch(const InputEvent& event) noexcept;
  void step(Seconds dt) noexcept;
  /// What to draw of the state after the last step, in the names of texture memory: so the pieces
  /// that step() let go have to be applied before.
  const DrawList& draw_list() noexcept;

  /// The screen has another size: a view is laid out for it.
  void resize(const ScreenShape& shape) noexcept;
  /// Texture memory that must change before the draw list is drawn; nothing when there is no more.
  std::unique_ptr<PieceChanges> take_pieces() noexcept { return planner_.take_pieces(); }
  /// Views name their texts and pictures; this says which texture memory holds one. The draw list
  /// has the memory's names. TextureId::None: it is gone.
  void bind(TextureId piece, TextureId memory) noexcept;
  TextureId memory_of(TextureId piece) const noexcept;
  /// All texture memory that pieces are bound to.
  std::span<const TextureId> memory() const noexcept { return memory_; }

  const Museum& museum() const noexcept { return museum_; }
  const InterfaceState& state() const noexcept { return visitors_.front().state; }
  const ScreenShape& shape() const noexcept { return settings_.shape; }
  /// The view on the screen; empty before the first one. Its spots follow the camera.
  const View* view() const noexcept { return overlay_.view(); }
  /// Does the screen show the state that the visitor asked for?
  bool shows_its_state() const noexcept;
  /// And does nothing fly or fade any more?
  bool is_settled() const noexcept;
  /// All who walk; the first one is the guide.
  const Company& company() const noexcept { return company_; }
  AvatarState state_of(std::uint32_t who) const noexcept;
  const GuideCounters& counters() const noexcept { return counters_; }

 private:
  void press(const Gesture& gesture) noexcept;
  void press_key(Key key) noexcept;
  void act(Action action) noexcept;
  void show(const InterfaceState& state) noexcept;
  void request_view() noexcept;
  void set_out() noexcept;
  void order(const Errand& errand) noexcept;
  void take_answers() noexcept;
  void take_way() noexcept;
  void notice_arrival() noexcept;
  void notice_absence(float seconds) noexcept;
  void count_collisions() noexcept;

  const Avatar& leader() const noexcept { return company_[0].avatar; }
  bool is_out() const noexcept;

  const Museum& museum_;
  Planner& planner_;
  GuideSettings settings_;
  std::vector<Visitor> visitors_;
  Company company_;
  Strollers strollers_;
  std::vector<Body> bodies_;        ///< Of those who are here, for counting collisions.
  std::vector<Meetings> meetings_;  ///< One, of the kiosk's floor.
  Errand errand_;
  std::uint64_t last_request_ = 0;
  bool awaiting_view_ = false;
  std::optional<Trip> trip_;  ///< Of the errand, once it is planned.
  GestureRecogniser gestures_;
  Overlay overlay_;
  Stage stage_;
  GuideCounters counters_;
  std::vector<TextureId> memory_;  ///< By piece.
  DrawList list_;
};

}  // namespace docent

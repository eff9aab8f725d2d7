#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/guide/crowd.h"
#include "runtime/guide/handshakes.h"
#include "runtime/guide/session.h"
#include "runtime/motion/touch.h"

namespace docent::guide {

/// What guides touch: exhibits that may be touched (ExhibitPlace). Who has led a visitor to one
/// first points at it, then walks up to it, lays a hand on it for some seconds, and goes back to
/// where they stood, so that nothing is hidden. Whoever is told something else meanwhile does that;
/// while a visitor turns an object, no hand lies on it. What a guide does not get to with a hand is
/// pointed at instead, and so is what one would touch who is drawn larger than life.
///
/// Called by the frame thread. Only the constructor allocates.
class Touches {
 public:
  explicit Touches(const Museum& museum);

  /// Before the crowd's step of the same time.
  void step(double seconds, std::span<Session> sessions, const DrawnSize& size,
            Crowd& crowd) noexcept;

 private:
  /// What the guide of a session does about the exhibit that it has led to.
  struct Visit {
    enum class Phase : std::uint8_t { None, Pointing, Coming, Touching, Parting, Done };
    Phase phase = Phase::None;
    double since = 0;  ///< Seconds in this phase.
    std::uint32_t guide = 0, exhibit = 0;
    Touch touch;
  };
  void begin(Session& session, Visit& visit, const DrawnSize& size,
             const Crowd& crowd) const noexcept;
  void go_on(Session& session, Visit& visit, const DrawnSize& size, Crowd& crowd) const noexcept;
  motion::Grip grip_of(const Visit& visit, const Avatar& avatar, const DrawnSize& size,
                       double seconds) const noexcept;
  bool is_in_reach(const Visit& visit, const Avatar& avatar, const DrawnSize& size) const noexcept;

  const Museum& museum_;
  std::vector<Visit> visits_;  ///< By session.
};

}  // namespace docent::guide

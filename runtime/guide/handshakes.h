#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/guide/crowd.h"
#include "runtime/guide/session.h"
#include "runtime/interface/seats.h"
#include "runtime/path/floor_map.h"
#include "runtime/scene/camera.h"

namespace docent::guide {

/// Two guides who meet because their visitors wish it. Places are of the floor that both are on.
struct Handshake {
  enum class Phase : std::uint8_t { Coming, Together, Parting };
  std::array<std::size_t, 2> session{};  ///< Whose guides they are.
  std::array<std::uint32_t, 2> guide{};
  double apart = 0;  ///< Metres between the places where they stand to shake hands.
  Phase phase = Phase::Coming;
  double since = 0;  ///< Seconds in this phase.
};

/// Where two stand who shake hands: face to face and so many metres apart, clear of walls and of
/// who stands there already, as near to both as can be. None where there is no such place. Does not
/// allocate.
std::optional<std::array<Placement, 2>> meeting_place(const path::FloorMap& map, double radius,
                                                      double apart,
                                                      const std::array<Placement, 2>& bodies,
                                                      std::span<const Vec2> others) noexcept;

/// How many times as large as life bodies are drawn on the glass (stature.h).
struct DrawnSize {
  scene::CameraView camera;
  interface::ScreenShape shape;
  bool is_enlarged = true;  ///< Only on a shared glass.
  float of(const Avatar& avatar) const noexcept;
  float of(Vec3 ground) const noexcept;  ///< Of who stands there. World frame.
};

/// Guides of a shared glass who shake hands, as they are drawn there: larger than life, they stand
/// further apart. A visitor touches another visitor's guide, and their own waves to it. If the
/// other is not leading its visitor anywhere, or as soon as that one's visitor has touched the
/// first one's guide too, both walk up to each other, shake hands, and go on with what they were
/// doing; who is just then touching an exhibit does so first. Whoever is told something else
/// meanwhile does that.
///
/// Called by the frame thread. Only the constructor allocates.
class Handshakes {
 public:
  /// Seconds for which a wish is kept for the other visitor's, or until the guides are free.
  static constexpr double wished_for = 30;

  explicit Handshakes(const Museum& museum);

  /// The visitor of a session has touched somebody else's guide.
  void wish(std::size_t session, std::uint32_t guide, std::span<Session> sessions,
            const DrawnSize& size, const plan::Planner& planner, Crowd& crowd) noexcept;
  /// Before the crowd's step of the same time.
  void step(double seconds, std::span<Session> sessions, const DrawnSize& size,
            const plan::Planner& planner, Crowd& crowd) noexcept;

  std::span<const Handshake> all() const noexcept { return shakes_; }

 private:
  struct Wish {
    std::size_t of = 0;                ///< Session whose guide is meant.
    std::uint32_t own = 0, guide = 0;  ///< Whom both had then: a seat outlasts its visitor.
    double left = 0;                   ///< Seconds.
    bool is_due = false;               ///< Nothing is in its way but what one of them has in hand.
    double rests = 0;                  ///< Seconds before it is looked at again.
  };
  void grant_wishes(double seconds, std::span<Session> sessions, const DrawnSize& size,
                    const plan::Planner& planner, Crowd& crowd) noexcept;
  bool begin(std::size_t one, std::size_t other, std::span<Session> sessions, const DrawnSize& size,
             const plan::Planner& planner, Crowd& crowd) noexcept;
  void forget_wishes(double seconds, std::span<const Session> sessions) noexcept;
  void shake(const Handshake& it, const DrawnSize& size, Crowd& crowd) const noexcept;

  const Museum& museum_;
  std::vector<Handshake> shakes_;
  std::vector<Wish> wishes_;  ///< By session.
  std::vector<Vec2> others_;
};

}  // namespace docent::guide

#pragma once

#include <span>

#include "runtime/guide/crowd.h"
#include "runtime/guide/exhibit_shape.h"
#include "runtime/guide/session.h"
#include "runtime/model/museum.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// Whom and what the bodies of a crowd attend to: guides to their visitors, to what they have led
/// them to, and to who passes near; strollers to a guide who waves.
class Attention {
 public:
  /// Borrows both.
  Attention(const Museum& museum, std::span<const ExhibitShape> shapes) noexcept
      : museum_(museum), shapes_(shapes) {}

  /// Tells each body, before it takes its next step. A visitor is where the camera is, or, on a
  /// shared glass, where their card lies. `guides`: how many of the crowd are. `calm`: see Company.
  void direct(std::span<const Session> sessions, const interface::ScreenShape& shape,
              const scene::CameraView& camera, std::size_t guides, bool calm,
              Crowd& crowd) const noexcept;

 private:
  std::optional<Vec3> goal_of(const Session& session) const noexcept;

  const Museum& museum_;
  std::span<const ExhibitShape> shapes_;
};

}  // namespace docent::guide

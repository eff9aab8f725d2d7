#pragma once

#include "runtime/guide/overlay.h"
#include "runtime/guide/session.h"
#include "runtime/plan/planner.h"

namespace docent::guide {

/// Shows what is said to the visitor of a glass of their own as text, for as long as it sounds.
///
/// For the frame thread; after construction nothing allocates or throws.
class Captions {
 public:
  /// The part of the glass that its views are of.
  static constexpr std::uint32_t part = 1;

  explicit Captions(bool reduced_motion) noexcept : overlay_(reduced_motion) {}

  /// Called after the session's step: asks for what has begun to be said.
  void step(const Session& session, const interface::ScreenShape& shape, plan::Planner& planner,
            float seconds) noexcept;
  void take(std::unique_ptr<interface::View> view) noexcept;
  void draw(scene::DrawList& list) const noexcept;

  /// Null while nothing is said.
  const interface::View* view() const noexcept { return is_shown() ? overlay_.view() : nullptr; }
  /// The share that is still to be said.
  float left() const noexcept { return left_; }

 private:
  bool is_shown() const noexcept { return is_said_ && is_answered_; }

  Overlay overlay_;
  std::uint64_t last_request_ = 0;
  bool is_said_ = false, is_answered_ = false;
  float left_ = 0;
};

}  // namespace docent::guide

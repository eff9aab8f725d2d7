#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/guide/session.h"
#include "runtime/interface/layout.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// Which visitor a touch of a shared glass belongs to. Every visitor has a territory, the place
/// about which they touch, and a seat, where their card is.
///
/// Parts are those of the glass: 0 is the model, then the sessions at the seats. Borrows the
/// sessions and the shape. For the frame thread; after construction nothing allocates.
class Seating {
 public:
  Seating(std::span<Session> sessions, const interface::ScreenShape& shape)
      : sessions_(sessions), shape_(shape), territory_(sessions.size()) {}

  std::size_t seats() const noexcept { return sessions_.size() - 1; }
  /// The part of a seat, counted round the glass from 1; none where there is no such seat.
  std::optional<std::size_t> part_of(std::uint32_t seat) const noexcept;
  /// The part whose visitor touches there; 0 where it is somebody new and no seat is free.
  std::size_t visitor_at(scene::ScreenPoint at) const noexcept;
  /// The part of another visitor than that one who has a guide and touches nearest to there; 0
  /// where there is none.
  std::size_t other_visitor_at(scene::ScreenPoint at, std::size_t than) const noexcept;
  bool is_on_model(scene::ScreenPoint at) const noexcept;

  /// The part's visitor has touched there.
  void touch(std::size_t part, scene::ScreenPoint at) noexcept;
  /// The part's visitor has used a key: a new visitor's territory is then their card.
  void press_key(std::size_t part) noexcept;

 private:
  scene::Side side_of(std::size_t part) const noexcept;
  scene::Rect column_of(std::size_t part) const noexcept;
  scene::ScreenPoint middle_of_card(std::size_t part) const noexcept;
  std::size_t seat_at(scene::ScreenPoint at) const noexcept;
  std::size_t vacant_seat_near(scene::ScreenPoint at) const noexcept;
  float millimetres(std::size_t part, scene::ScreenPoint a, scene::ScreenPoint b,
                    float up) const noexcept;
  float column_millimetres(std::size_t part) const noexcept;
  float columns_off(std::size_t part, scene::ScreenPoint at) const noexcept;
  void follow_territory(std::size_t part) noexcept;

  std::span<Session> sessions_;
  const interface::ScreenShape& shape_;
  std::vector<scene::ScreenPoint> territory_;  ///< By part. Screen frame.
};

}  // namespace docent::guide

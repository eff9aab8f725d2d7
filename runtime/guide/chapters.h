#pragma once

#include <cstdint>

#include "runtime/guide/avatar.h"
#include "runtime/interface/control.h"
#include "runtime/model/museum.h"
#include "runtime/model/none.h"

namespace docent::guide {

/// The chapters of a walk: a room ends where the next one begins, a floor where one has come to
/// another, and the last one at the goal. Who goes along with the guide may skip what is left of
/// one. Does not throw or allocate.
class Chapters {
 public:
  explicit Chapters(const Museum& museum) : museum_(museum) {}

  /// How a visitor's state is to go on: what comes next on the way of their guide, and whether they
  /// still skip what is before it.
  interface::InterfaceState step(const interface::InterfaceState& state, const Avatar& leader,
                                 float seconds) noexcept;

 private:
  bool has_ended(const Avatar& leader, std::uint32_t room) const noexcept;

  const Museum& museum_;
  bool skips_ = false;
  std::uint32_t floor_ = 0, room_ = none;  ///< In which they began to skip.
  float since_looked_ = 1e3F;              ///< Seconds.
};

/// What a guide comes to next.
interface::Chapter next_chapter(const Museum& museum, const Avatar& leader) noexcept;

}  // namespace docent::guide

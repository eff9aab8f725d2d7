#pragma once

#include <cstdint>
#include <vector>

#include "runtime/guide/crowd.h"
#include "runtime/model/museum.h"

namespace docent::guide {

/// Visitors on their own: they stroll from exhibit to exhibit by any kind of way, sometimes just
/// somewhere, stand and look, and go on. What they do depends on the museum alone, so runs repeat
/// exactly.
class Strollers {
 public:
  explicit Strollers(const Museum& museum) : museum_(museum) {}

  /// They join a crowd; allocates.
  void enter(Crowd& crowd);
  void step(Crowd& crowd) noexcept;

 private:
  struct Stroller {
    std::uint32_t who = 0;
    std::uint64_t chance = 0;  ///< State of its random numbers.
    double goes_on_at = 0;     ///< Crowd's clock; while it looks.
    bool looks = true;
  };
  double random(Stroller& stroller) const noexcept;
  void choose(Stroller& stroller, Crowd& crowd) const noexcept;
  Placement start_of(std::size_t i) const noexcept;

  const Museum& museum_;
  std::vector<Stroller> strollers_;
};

}  // namespace docent::guide

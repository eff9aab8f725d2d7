#pragma once

#include <cstdint>
#include <vector>

#include "runtime/guide/crowd.h"
#include "runtime/model/museum.h"

namespace docent::guide {

/// The strollers: each walks from exhibit to exhibit by ways of any kind, sometimes to some other
/// place, stands and looks, and goes on. Their random choices depend on the museum alone, so runs
/// repeat exactly.
class Strollers {
 public:
  explicit Strollers(const Museum& museum) : museum_(museum) {}

  /// Adds the strollers to a crowd. Allocates.
  void enter(Crowd& crowd);
  void step(Crowd& crowd) noexcept;

 private:
  struct Stroller {
    std::uint32_t who = 0;
    std::uint64_t chance = 0;  ///< State of its random numbers.
    double goes_on_at = 0;     ///< Crowd's clock: until when it looks.
    bool looks = true;         ///< It stands and looks.
  };
  double random(Stroller& stroller) const noexcept;
  bool may_go_to(std::uint32_t floor, const Agent& one, const Crowd& crowd,
                 Stroller& stroller) const noexcept;
  void choose(Stroller& stroller, Crowd& crowd) const noexcept;
  Placement start_of(std::size_t i) const noexcept;

  const Museum& museum_;
  std::vector<Stroller> strollers_;
};

}  // namespace docent::guide

#pragma once

#include <cstdint>
#include <vector>

#include "runtime/guide/crowd.h"
#include "runtime/model/museum.h"

namespace docent::guide {

/// The strollers: each walks from exhibit to exhibit by ways of any kind, sometimes to some other
/// place, stands and looks, and goes on. Their random choices depend on the museum alone, so runs
/// repeat exactly. A museum that has none has a few all the same while nobody looks for anything:
/// they come when they are told to, and go.
class Strollers {
 public:
  explicit Strollers(const Museum& museum) : museum_(museum) {}

  /// How many a crowd needs room for.
  static std::size_t most(const Museum& museum) noexcept;
  /// Adds the strollers to a crowd, as many as it has room for. Allocates.
  void enter(Crowd& crowd);
  /// Those who are there only at times appear, or are gone.
  void come(Crowd& crowd) const noexcept;
  void leave(Crowd& crowd) const noexcept;
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

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace docent::interface {

/// The tour that a visitor puts together. What is beyond `count` is zero, so that equal tours are
/// equal.
struct OwnTour {
  static constexpr std::size_t most = 60;

  std::array<std::uint32_t, most> exhibit{};  ///< Indices into Museum::exhibits, none twice.
  std::array<double, most> arrives{};         ///< Seconds from the kiosk, looks before included.
  double seconds = 0;      ///< To the end of the last look; 0 while nobody knows.
  std::uint8_t count = 0;  ///< How many there are.
  bool is_ordered = true;  ///< By the shortest walk; else that is being found.

  std::span<const std::uint32_t> exhibits() const noexcept {
    return std::span(exhibit).first(count);
  }
  bool is_full() const noexcept { return count == most; }

  bool operator==(const OwnTour&) const = default;
};

/// Where an exhibit stands in it; `count` where it is not in it.
std::size_t place_in(const OwnTour& tour, std::uint32_t exhibit) noexcept;

/// Puts an exhibit last, or takes it out. A full tour takes up no more.
void add_to(OwnTour& tour, std::uint32_t exhibit) noexcept;
void take_from(OwnTour& tour, std::uint32_t exhibit) noexcept;

/// Its order and times are to be found anew, because other ways can be walked.
void order_anew(OwnTour& tour) noexcept;

}  // namespace docent::interface

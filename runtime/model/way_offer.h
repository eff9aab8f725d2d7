#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "runtime/model/local_text.h"
#include "runtime/model/route_kind.h"

namespace docent {

/// What a visitor may choose of a way: how it lies, or what it is to go without.
enum class WayChoice : std::uint8_t { Shortest, Skeleton, Offset, StepFree, NoEscalators };

struct WayChoiceInfo {
  WayChoice choice{};
  std::string_view name;  ///< In museum.toml: stable.
  std::string_view word;  ///< The key of what the interface calls it.
  std::optional<RouteKind> kind;
};

inline constexpr std::array<WayChoiceInfo, 5> way_choices{{
    {WayChoice::Shortest, "shortest", "route_shortest", RouteKind::Shortest},
    {WayChoice::Skeleton, "skeleton", "route_skeleton", RouteKind::Skeleton},
    {WayChoice::Offset, "offset", "route_offset", RouteKind::Offset},
    {WayChoice::StepFree, "step_free", "step_free", {}},
    {WayChoice::NoEscalators, "no_escalators", "no_escalators", {}},
}};
inline constexpr auto way_choice_names = [] {
  std::array<std::string_view, way_choices.size()> names;
  std::ranges::transform(way_choices, names.begin(), &WayChoiceInfo::name);
  return names;
}();

constexpr const WayChoiceInfo& info_of(WayChoice choice) noexcept {
  return way_choices[static_cast<std::size_t>(choice)];
}

/// Something that the museum lets visitors choose, and what it calls it.
struct WayOffer {
  WayChoice choice{};
  LocalText title;  ///< In a language that it lacks, the interface's own word.
};

/// The kind that guides walk until a visitor chooses another: the first that is offered.
/// `offers`: none, and everything is offered.
constexpr RouteKind usual_kind(std::span<const WayOffer> offers) noexcept {
  for (const WayOffer& offer : offers)
    if (const auto& kind = info_of(offer.choice).kind) return *kind;
  return RouteKind::Shortest;
}

}  // namespace docent

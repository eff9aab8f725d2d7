#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace docent {

struct HubCost {
  std::uint32_t hub = 0;
  std::uint32_t cost = 0;  ///< In HubLabels::unit.
};

/// The labels of all stations: the hubs that a station reaches (or is reached from), with what that
/// costs. The entries of station s are [first[s], first[s + 1]) of the other arrays, ascending
/// hubs.
struct LabelTable {
  static constexpr std::uint32_t no_parent = 0xffffffff;
  std::vector<std::uint32_t> first{0};
  std::vector<HubCost> hub;           ///< Apart from the rest: all that a distance is found from.
  std::vector<std::uint32_t> link;    ///< The link between this entry's hub and its parent's.
  std::vector<std::uint32_t> parent;  ///< The next entry towards the station, or no_parent.

  std::span<const HubCost> of(std::uint32_t station) const noexcept {
    return std::span(hub).subspan(first[station], first[station + 1] - first[station]);
  }
};

/// Distances between all stations of a tangent graph, as two labels for each station. The shortest
/// way from station a to station b costs the least sum of the two costs of a hub, over all hubs
/// that a's leaving label and b's arriving label share. (Cohen, Halperin, Kaplan, Zwick 2002; from
/// a contraction hierarchy as in Abraham, Delling, Goldberg, Werneck 2011.)
///
/// Stations are the sides of the tangent graph. A way from side a to side b begins at the first
/// point of a's arc and ends at the last point of b's arc, in the sense of each side. Hubs are
/// sides where the radius is 0, else tangents, numbered by importance.
///
/// Links, where n is the number of tangents: a link below n is the tangent of that index, followed
/// to where the way may leave again; `roll` stays on the arc as far as the next tangent; link n + i
/// is link_part[2 i] and then link_part[2 i + 1]. A leaving entry's link goes from its parent's hub
/// to its own, an arriving entry's from its own hub to its parent's; an arriving entry without
/// parent ends with its link, a leaving entry without parent has none (`roll`).
struct HubLabels {
  static constexpr std::uint32_t roll = 0xffffffff;
  /// No cost is larger; nor is the diagonal of the floor, in units.
  static constexpr std::uint32_t most_cost = 0xffffffff;
  double unit = 1;  ///< Metres that a cost of 1 stands for.
  LabelTable leaving, arriving;
  std::vector<std::uint32_t> link_part;

  /// False for graphs whose labels would be too long: their ways are searched for instead.
  bool has_labels() const noexcept { return leaving.first.size() > 1; }
};

}  // namespace docent

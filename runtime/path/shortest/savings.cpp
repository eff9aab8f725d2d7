#include "runtime/path/shortest/savings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace docent::path {

/// A point follows the disc's way at its corners: beside a tangent that keeps the sense it walks
/// from corner to corner as far as the disc, and rolls cost it nothing. From a corner to the middle
/// of the next tangent it walks the diagonal, longer than half of the tangent by what is saved;
/// from there on it can walk where the disc's centre does, so that nothing more is saved until the
/// middle of another tangent near the end. And it must do so by the first tangent that changes the
/// sense, whose middle lies between the two corners; a way without any saves nothing.
///
/// So a way saves at most what its first tangent does, and where that keeps the sense, at most what
/// the side beyond does. All sides save at most the radius; from there a few rounds come close.
std::vector<double> savings(const TangentGraph& graph) {
  constexpr int rounds = 4;
  std::vector<double> of_tangent;
  of_tangent.reserve(graph.tangent.size());
  for (const Tangent& tangent : graph.tangent) {
    const double half = tangent.length / 2;
    of_tangent.push_back(std::sqrt(graph.radius * graph.radius + half * half) - half);
  }
  std::vector<double> saved(2 * graph.arc.size(), graph.radius), closer = saved;
  for (int round = 0; round < rounds; ++round) {
    for (std::uint32_t side = 0; side < saved.size(); ++side) {
      closer[side] = 0;
      for (std::uint32_t k = graph.side_first[side]; k < graph.side_first[side + 1]; ++k) {
        const std::uint32_t next = graph.tangent[k].arrive_side;
        const bool keeps_sense = next % 2 == side % 2;
        closer[side] = std::max(closer[side],
                                keeps_sense ? std::min(of_tangent[k], saved[next]) : of_tangent[k]);
      }
    }
    saved.swap(closer);
  }
  return saved;
}

}  // namespace docent::path

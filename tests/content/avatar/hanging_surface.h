#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "tests/content/avatar/posed_body.h"

namespace docent::test {

/// A part of a body's surface as it hangs: triangles by their height.
class HangingSurface {
 public:
  /// Of the triangles whose corners all are of it.
  HangingSurface(const SkinnedMesh& mesh,
                 const std::function<bool(const SkinnedVertex&)>& is_part_of_it);

  std::size_t size() const { return indices_.size(); }
  void hang(const PosedBody& body);
  /// Where a way first goes through it, as a share of the way; more than 1: nowhere.
  float first_on(Vec3 from, Vec3 to) const;

 private:
  const SkinnedMesh& mesh_;
  std::vector<std::array<std::uint32_t, 3>> indices_;
  std::array<std::vector<std::array<Vec3, 3>>, 120> row_;
};

/// What a surface covers: a place on the body, and the axis of the part that it is on.
struct CoveredPlace {
  SkinnedVertex skin, axis;
};

/// How far what is covered is outside of a surface that hangs, at most: metres.
float depth_outside(const std::vector<CoveredPlace>& places, const PosedBody& body,
                    const HangingSurface& surface);

}  // namespace docent::test

#pragma once

#include <vector>

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/motion/cloth.h"

namespace docent::test {

/// The first body of a mesh as a clip moves it, by linear blend skinning.
class PosedBody {
 public:
  PosedBody(const SkinnedMesh& mesh, const Skeleton& skeleton);

  /// In a frame of a clip; clothes hang still.
  void hang(const MotionClip& clip, std::size_t frame);
  /// The same, so many seconds after the last call; clothes swing.
  void swing(const MotionClip& clip, std::size_t frame, double seconds);

  Vec3 place_of(const SkinnedVertex& vertex) const;
  std::vector<Vec3> places() const;
  const std::vector<Mat4>& palette() const { return palette_; }
  const motion::ClothMotion& cloth() const { return cloth_; }

 private:
  motion::ClothView view() const;
  void pose(const MotionClip& clip, std::size_t frame);

  const SkinnedMesh& mesh_;
  const Skeleton& skeleton_;
  std::vector<Mat4> palette_;
  motion::ClothMotion cloth_;
};

}  // namespace docent::test

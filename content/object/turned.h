#pragma once

#include <vector>

#include "content/import/object/read_object.h"
#include "content/object/profile.h"
#include "runtime/model/pixels.h"

namespace docent::object {

/// Something round, as staff describe it.
struct Turned {
  std::vector<Vec2> profile;  ///< Radius and height, metres; without a fault (fault_of).
  Vec3 colour{1};             ///< Linear; of all that no picture covers.
  /// Lies round its outside, from where that rises to its highest rim, as paper would; its middle
  /// is in front. Empty: there is none.
  Pixels wrapped;
};

/// Turns a profile about its axis: a closed surface, every triangle counter-clockwise from
/// outside, in metres with y up. Each point of the profile is on it, and its outline is within
/// 0.7 pixels of 1080 that it fills. At most ObjectDetail::most_triangles.
import::object::ObjectFile turn(const Turned& turned);

}  // namespace docent::object

#pragma once

#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::bench {

/// The track of a walk, in one of the colours of the picture's legend.
struct DrawnTrack {
  std::vector<Vec2> points;  ///< Floor frame, metres.
  std::string colour;        ///< "#RRGGBB".
};

/// A path and the tracks along it.
struct WalkPicture {
  std::string title;
  std::vector<std::string> captions;  ///< A line each, under the picture.
  std::vector<Vec2> path;
  std::vector<DrawnTrack> tracks;  ///< Later ones lie on top.
};

struct LegendEntry {
  std::string name, colour;
};

/// Pictures in rows under a heading, all in one scale, which a bar shows: a whole SVG document. The
/// path is a wide pale band, its beginning a ring and its end a disc.
std::string draw_walks(const std::string& heading, const std::string& note,
                       const std::vector<LegendEntry>& legend,
                       const std::vector<WalkPicture>& pictures, std::size_t columns);

}  // namespace docent::bench

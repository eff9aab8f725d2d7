#include "tests/bench/boost_diagram.h"

#include <boost/polygon/polygon.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <vector>

namespace docent::bench {
namespace {

using Point = boost::polygon::point_data<int>;
using Segment = boost::polygon::segment_data<int>;

constexpr double per_metre = 1e4;

Point on_grid(Vec2 p) {
  return {static_cast<int>(std::lround(p.x * per_metre)),
          static_cast<int>(std::lround(p.y * per_metre))};
}

}  // namespace

std::size_t make_boost_diagram(const FloorPlan& plan) {
  std::vector<Segment> segments;
  for (std::uint32_t wall = 0; wall < plan.next.size(); ++wall)
    segments.emplace_back(on_grid(wall_start(plan, wall)), on_grid(wall_end(plan, wall)));
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(segments.begin(), segments.end(), &diagram);
  return diagram.num_vertices();
}

}  // namespace docent::bench

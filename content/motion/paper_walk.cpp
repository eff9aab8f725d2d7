#include "content/motion/paper_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "content/motion/paper_track.h"
#include "runtime/motion/path_track.h"
#include "runtime/motion/placement.h"

namespace docent::motion::offline {
namespace {

Placement placement_along(std::span<const Vec2> path) {
  const Vec2 way = point_along(path, 0.25) - path.front();
  return {path.front(), std::atan2(way.y, way.x)};
}

}  // namespace

PaperWalk make_paper_walk(const WalkGraph& graph, const PaperWalkRequest& request) {
  const std::uint32_t start_clip = graph.starts.front();
  const ClipFrame start{start_clip, graph.clip[start_clip].first};
  const Placement body = request.start ? *request.start : placement_along(request.path);
  const PaperRequest search{
      .path = request.path,
      .start = start,
      .clip_to_floor = compose(body, inverse(graph.clip[start.clip].body[start.frame])),
      .lookahead = request.lookahead,
      .use_rate = request.use_rate,
      .time_limit = request.time_limit,
      .bound = request.bound};
  const PaperPath found = find_paper_path(*graph.motion, search);
  PaperTrack track = make_paper_track(*graph.motion, found, search.clip_to_floor);

  PaperWalk result{.walk = {}, .reaches_end = found.reaches_end, .length = found.length};
  Walk& walk = result.walk;
  walk.frame_rate = graph.frame_rate;
  walk.joint_count = graph.motion->clips[start.clip].joint_count;
  walk.root = std::move(track.root);
  walk.rotation = std::move(track.rotation);
  for (const ClipFrame source : track.source)
    walk.plants.push_back(graph.motion->clips[source.clip].plants[source.frame]);
  walk.source = std::move(track.source);
  walk.transitions = static_cast<std::uint32_t>(found.passed.size());
  walk.expanded = static_cast<std::uint32_t>(
      std::min<std::uint64_t>(found.expanded, std::numeric_limits<std::uint32_t>::max()));
  walk.search_seconds = found.seconds;
  return result;
}

}  // namespace docent::motion::offline

#include "content/motion/alike_tiles.h"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

#include "content/motion/nearest_poses.h"
#include "content/parallel.h"

namespace docent::motion::offline {
namespace {

/// A frame of each clip, and how far their points are apart.
struct Pair {
  ClipFrame a, b;
  float square = 0;
};

/// Looks for pairs of alike frames.
class PairFinder {
 public:
  PairFinder(std::span<const PoseCloud> clouds, const AlikeSearch& search, unsigned jobs)
      : clouds_(clouds), search_(search), features_(make_pose_features(clouds, search.half, jobs)) {
    std::vector<PoseFeatures::Point> points;
    for (std::uint32_t c = 0; c < clouds.size(); ++c)
      for (std::uint32_t f = search.apart / 2; f < clouds[c].frames; f += search.apart) {
        looked_up_.push_back({c, f});
        points.push_back(features_.at(c, f));
      }
    index_ = NearestPoses(points);
  }

  /// The frames that are to be looked up: one in the middle of each window of `apart` frames.
  std::span<const ClipFrame> looked_up() const { return looked_up_; }

  /// The closest pairs of a frame near `from` and another, closest first.
  void find(ClipFrame from, std::vector<Pair>& pairs) const {
    thread_local std::vector<NearestPoses::Neighbour> alike;
    thread_local std::vector<Pair> all;
    // Points are a little closer than poses, but the frames looked up lie up to half a window
    // aside.
    const auto within = static_cast<float>(1.25 * search_.threshold);
    index_.find(features_.at(from.clip, from.frame), search_.looked_up, within, alike);
    all.clear();
    for (const auto& neighbour : alike)
      if (const auto pair = closest_near(from, looked_up_[neighbour.index])) all.push_back(*pair);
    std::ranges::sort(all, {}, [](const Pair& p) {
      return std::tuple(p.square, p.a.frame, p.b.clip, p.b.frame);
    });
    pairs.clear();
    for (const Pair& pair : all) {
      if (pairs.size() == search_.kept) return;
      if (std::ranges::none_of(pairs, [&](const Pair& p) { return run_beside(p, pair); }))
        pairs.push_back(pair);
    }
  }

 private:
  std::uint32_t last(std::uint32_t clip) const {
    return static_cast<std::uint32_t>(clouds_[clip].frames) - 1;
  }

  bool may_pair(ClipFrame a, ClipFrame b) const {
    const std::uint32_t lag = a.frame > b.frame ? a.frame - b.frame : b.frame - a.frame;
    return a.clip != b.clip || lag >= 2 * search_.half;
  }

  float square(ClipFrame a, ClipFrame b) const {
    return square_between(features_.at(a.clip, a.frame), features_.at(b.clip, b.frame));
  }

  /// The closest pair at most half of `apart` from another pair, in each clip.
  Pair closest_within(const Pair& centre) const {
    Pair best = centre;
    const std::uint32_t reach = search_.apart / 2 + 1;
    const auto from = [&](std::uint32_t f) { return f > reach ? f - reach : 0; };
    const std::uint32_t end_a = std::min(centre.a.frame + reach, last(centre.a.clip));
    const std::uint32_t end_b = std::min(centre.b.frame + reach, last(centre.b.clip));
    for (std::uint32_t i = from(centre.a.frame); i <= end_a; ++i)
      for (std::uint32_t j = from(centre.b.frame); j <= end_b; ++j) {
        const ClipFrame a{centre.a.clip, i}, b{centre.b.clip, j};
        if (!may_pair(a, b)) continue;
        if (const float here = square(a, b); here < best.square) best = {a, b, here};
      }
    return best;
  }

  /// Do two pairs of the same clips lie on nearly the same diagonal?
  bool run_beside(const Pair& p, const Pair& q) const {
    const std::uint32_t one = p.b.frame + q.a.frame, other = q.b.frame + p.a.frame;
    return p.b.clip == q.b.clip && (one > other ? one - other : other - one) < search_.apart;
  }

  /// The closest pair near a pair. Empty where they are not alike.
  std::optional<Pair> closest_near(ClipFrame a, ClipFrame b) const {
    if (!may_pair(a, b)) return {};
    const Pair here = closest_within({a, b, square(a, b)});
    // Points may be a little farther apart than poses, most of all at the ends of clips.
    const auto limit = static_cast<float>(1.44 * search_.threshold * search_.threshold);
    if (here.square > limit || !search_.may_meet(here.a, here.b)) return {};
    return here;
  }

  std::span<const PoseCloud> clouds_;
  AlikeSearch search_;
  PoseFeatures features_;
  std::vector<ClipFrame> looked_up_;
  NearestPoses index_;
};

/// The pieces that hold a pair, which may be off by a few frames.
void add_tiles(std::span<const PoseCloud> clouds, const Pair& pair, std::vector<PairTile>& tiles) {
  ClipFrame a = pair.a, b = pair.b;
  if (std::tuple(b.clip, b.frame) < std::tuple(a.clip, a.frame)) std::swap(a, b);
  const auto around = [&](ClipFrame at) {
    constexpr std::uint32_t off = 2;
    const auto last = static_cast<std::uint32_t>(clouds[at.clip].frames) - 1;
    return std::array{at.frame > off ? at.frame - off : 0, std::min(at.frame + off, last)};
  };
  for (const std::uint32_t i : around(a))
    for (const std::uint32_t j : around(b))
      tiles.push_back({a.clip, b.clip, tile_of(clouds[a.clip].frames, i, j)});
}

void sort_out(std::vector<PairTile>& tiles) {
  std::ranges::sort(tiles);
  const auto repeated = std::ranges::unique(tiles);
  tiles.erase(repeated.begin(), repeated.end());
}

}  // namespace

std::vector<PairTile> every_tile(std::span<const PoseCloud> clouds) {
  std::vector<PairTile> tiles;
  for (std::uint32_t a = 0; a < clouds.size(); ++a)
    for (std::uint32_t b = a; b < clouds.size(); ++b)
      for (const TilePlace place : all_tiles(clouds[a].frames, clouds[b].frames))
        tiles.push_back({a, b, place});
  return tiles;
}

std::vector<PairTile> alike_tiles(std::span<const PoseCloud> clouds, const AlikeSearch& search,
                                  unsigned jobs) {
  const PairFinder finder(clouds, search, jobs);
  constexpr std::size_t share = 256;  // Frames that a thread looks up at a time.
  const std::span<const ClipFrame> frames = finder.looked_up();
  std::vector<std::vector<PairTile>> found((frames.size() + share - 1) / share);
  content::for_each_index(found.size(), jobs, [&](std::size_t part) {
    std::vector<Pair> pairs;
    for (const ClipFrame from :
         frames.subspan(part * share).first(std::min(share, frames.size() - part * share))) {
      finder.find(from, pairs);
      for (const Pair& pair : pairs) add_tiles(clouds, pair, found[part]);
    }
    sort_out(found[part]);
  });
  std::vector<PairTile> tiles;
  for (std::vector<PairTile>& some : found) {
    tiles.insert(tiles.end(), some.begin(), some.end());
    some = {};
  }
  sort_out(tiles);
  return tiles;
}

}  // namespace docent::motion::offline

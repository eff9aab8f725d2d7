#include "content/motion/find_transitions.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>

#include "content/motion/alike_tiles.h"
#include "content/parallel.h"

namespace docent::motion::offline {
namespace {

/// Two clips and what is known of them, in frames.
struct Comparison {
  const MotionClip& a;
  const MotionClip& b;
  const PoseCloud& cloud_a;
  const PoseCloud& cloud_b;
  const std::vector<CaptureFault>& faults_a;
  const std::vector<CaptureFault>& faults_b;
  bool same_clip = false;
  std::uint32_t radius = 0, least_radius = 0, apart = 0;
  float threshold = 0;
};

/// The distances of two clips, measured where they are asked for.
class Distances {
 public:
  explicit Distances(const Comparison& c) : c_(c) {}

  const DistanceTile& tile(TilePlace place) {
    if (last_ == nullptr || place != last_place_) {
      std::unique_ptr<DistanceTile>& tile = tiles_[place];
      if (!tile) {
        tile = std::make_unique<DistanceTile>();
        measure_tile(c_.cloud_a, c_.cloud_b, c_.radius, place, *tile);
      }
      last_place_ = place;
      last_ = tile.get();
    }
    return *last_;
  }

  float at(std::size_t i, std::size_t j) {
    const std::size_t diagonal = j + (c_.cloud_a.frames - 1) - i;
    return tile(tile_of(c_.cloud_a.frames, i, j))
        .distance[i % DistanceTile::rows * DistanceTile::diagonals +
                  diagonal % DistanceTile::diagonals];
  }

  /// Forgets the tiles of earlier rows.
  void forget_before(std::uint32_t row) {
    tiles_.erase(tiles_.begin(), tiles_.lower_bound({row, 0}));
    last_ = nullptr;
  }

 private:
  const Comparison& c_;
  std::map<TilePlace, std::unique_ptr<DistanceTile>> tiles_;
  TilePlace last_place_;
  const DistanceTile* last_ = nullptr;
};

/// The pairs of frames round a pair, in a matrix.
struct Box {
  std::size_t first_row, end_row, first_column, end_column;
};

Box box_round(const Comparison& c, std::size_t i, std::size_t j) {
  const auto from = [&](std::size_t f) { return f > c.apart ? f - c.apart : 0; };
  const auto to = [&](std::size_t f, std::size_t frames) {
    return std::min<std::size_t>(f + c.apart + 1, frames);
  };
  return {from(i), to(i, c.cloud_a.frames), from(j), to(j, c.cloud_b.frames)};
}

/// Is no other pair of frames nearby closer? Of equal ones the first counts.
bool is_local_minimum(const Comparison& c, Distances& distances, std::size_t i, std::size_t j) {
  const float here = distances.at(i, j);
  const Box box = box_round(c, i, j);
  for (std::size_t y = box.first_row; y < box.end_row; ++y)
    for (std::size_t x = box.first_column; x < box.end_column; ++x) {
      const float other = distances.at(y, x);
      const bool earlier = std::tuple(y, x) < std::tuple(i, j);
      if (other < here || (other == here && earlier)) return false;
    }
  return true;
}

/// The same, as far as a tile goes: row and diagonal are those of the tile.
bool is_minimum_of_tile(const Comparison& c, const DistanceTile& tile, std::size_t row,
                        std::size_t diagonal) {
  constexpr auto rows = static_cast<std::ptrdiff_t>(DistanceTile::rows),
                 diagonals = static_cast<std::ptrdiff_t>(DistanceTile::diagonals);
  const auto r = static_cast<std::ptrdiff_t>(row), e = static_cast<std::ptrdiff_t>(diagonal),
             apart = static_cast<std::ptrdiff_t>(c.apart);
  const float here = tile.distance[row * DistanceTile::diagonals + diagonal];
  for (std::ptrdiff_t y = std::max<std::ptrdiff_t>(r - apart, 0); y < std::min(r + apart + 1, rows);
       ++y) {
    // A column is as many diagonals lower as the row is farther down.
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(e - apart - (y - r), 0);
    const std::ptrdiff_t end = std::min(e + apart + 1 - (y - r), diagonals);
    const float* distance = &tile.distance[static_cast<std::size_t>(y * diagonals)];
    for (std::ptrdiff_t x = first; x < end; ++x)
      if (distance[x] < here) return false;
  }
  return true;
}

/// Frames that a blend may reach to both sides of `frame` without leaving its clip.
std::uint32_t room_at(const MotionClip& clip, std::uint32_t frame) {
  return std::min(frame, frame_count(clip) - 1 - frame);
}

/// A frame of each clip that could be one moment.
struct Meeting {
  ClipFrame a, b;
  float distance = 0;
};

std::uint32_t radius_at(std::uint32_t radius, const MotionClip& a, std::uint32_t frame_a,
                        const MotionClip& b, std::uint32_t frame_b) {
  return std::min({radius, room_at(a, frame_a), room_at(b, frame_b)});
}

/// Do the same feet stand in the middle, and for most of the blend?
bool same_feet(const Comparison& c, std::uint32_t i, std::uint32_t j, std::uint32_t radius) {
  const auto alike = [&](std::uint32_t f, std::uint32_t g) {
    return c.a.plants[f].left == c.b.plants[g].left && c.a.plants[f].right == c.b.plants[g].right;
  };
  if (!alike(i, j)) return false;
  std::uint32_t same = 0;
  for (std::uint32_t k = 0; k <= 2 * radius; ++k) same += alike(i - radius + k, j - radius + k);
  return 5 * same >= 4 * (2 * radius + 1);
}

bool touches_fault(const std::vector<CaptureFault>& faults, std::uint32_t frame,
                   std::uint32_t radius) {
  return std::ranges::any_of(faults, [&](const CaptureFault& fault) {
    return frame + radius >= fault.first && frame <= fault.last + radius;
  });
}

/// May a blend lead from one frame to the other, and back, if they are close enough?
bool can_meet(const Comparison& c, std::uint32_t i, std::uint32_t j) {
  const std::uint32_t fits = radius_at(c.radius, c.a, i, c.b, j);
  return same_feet(c, i, j, fits) && !touches_fault(c.faults_a, i, fits) &&
         !touches_fault(c.faults_b, j, fits);
}

/// Finds the local minima of a piece that can be blended.
void find_meetings(const Comparison& c, const PairTile& at, Distances& distances,
                   std::vector<Meeting>& meetings) {
  const std::size_t frames_a = c.cloud_a.frames, frames_b = c.cloud_b.frames;
  const DistanceTile tile = distances.tile(at.place);  // A copy: the checks measure other tiles.
  for (std::size_t r = 0; r < DistanceTile::rows; ++r) {
    const std::size_t i = at.place.row * DistanceTile::rows + r;
    if (i < c.least_radius || i + c.least_radius >= frames_a) continue;
    for (std::size_t e = 0; e < DistanceTile::diagonals; ++e) {
      const float distance = tile.distance[r * DistanceTile::diagonals + e];
      if (!(distance < c.threshold)) continue;
      const std::size_t j = i + at.place.diagonal * DistanceTile::diagonals + e - (frames_a - 1);
      if (j < c.least_radius || j + c.least_radius >= frames_b) continue;
      // Within a clip, pairs mirror each other, and a crossover is not taken for its own neighbour.
      if (c.same_clip && j < i + 2 * c.radius) continue;
      const auto frame_a = static_cast<std::uint32_t>(i), frame_b = static_cast<std::uint32_t>(j);
      if (is_minimum_of_tile(c, tile, r, e) && can_meet(c, frame_a, frame_b) &&
          is_local_minimum(c, distances, i, j))
        meetings.push_back({{at.a, frame_a}, {at.b, frame_b}, distance});
    }
  }
}

/// All that transitions are found from; borrowed.
struct Material {
  const std::vector<MotionClip>& clips;
  const StudiedClips& studied;
  const TransitionOptions& options;
  std::span<const double> threshold;
  unsigned jobs = 1;

  std::uint32_t radius() const { return frames_in(options.radius, clips.front().frame_rate); }
  std::uint32_t apart() const { return frames_in(options.apart, clips.front().frame_rate); }
};

/// Do the same feet stand in two frames, the second of which may be off by two?
bool could_meet(const Material& m, ClipFrame a, ClipFrame b) {
  constexpr std::uint32_t off = 2;
  const FootPlants feet = m.clips[a.clip].plants[a.frame];
  const std::vector<FootPlants>& others = m.clips[b.clip].plants;
  const std::size_t first = b.frame > off ? b.frame - off : 0;
  const std::size_t end = std::min<std::size_t>(b.frame + off + 1, others.size());
  return std::any_of(others.begin() + static_cast<std::ptrdiff_t>(first),
                     others.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](FootPlants f) { return f.left == feet.left && f.right == feet.right; });
}

std::vector<PairTile> tiles_to_measure(const Material& m) {
  const AlikeSearch search{
      .half = m.radius(),
      .apart = m.apart(),
      .threshold = std::ranges::max(m.threshold),
      .looked_up = m.options.looked_up,
      .kept = m.options.looked_closely,
      .may_meet = [&](ClipFrame a, ClipFrame b) { return could_meet(m, a, b); }};
  return alike_tiles(m.studied.cloud, search, m.jobs);
}

/// Pieces that one thread works on: of the same two clips and of rows close to each other.
std::vector<std::span<const PairTile>> parts_of(const std::vector<PairTile>& tiles) {
  constexpr std::uint32_t rows_together = 8;
  const auto part_of = [](const PairTile& t) {
    return std::tuple(t.a, t.b, t.place.row / rows_together);
  };
  std::vector<std::span<const PairTile>> parts;
  for (std::size_t begin = 0; begin < tiles.size();) {
    std::size_t end = begin + 1;
    while (end < tiles.size() && part_of(tiles[end]) == part_of(tiles[begin])) ++end;
    parts.push_back(std::span(tiles).subspan(begin, end - begin));
    begin = end;
  }
  return parts;
}

std::vector<Meeting> meetings_in(const Material& m, std::span<const PairTile> tiles) {
  const std::uint32_t a = tiles.front().a, b = tiles.front().b, radius = m.radius();
  const Comparison comparison{
      .a = m.clips[a],
      .b = m.clips[b],
      .cloud_a = m.studied.cloud[a],
      .cloud_b = m.studied.cloud[b],
      .faults_a = m.studied.faults[a],
      .faults_b = m.studied.faults[b],
      .same_clip = a == b,
      .radius = radius,
      .least_radius = (radius + 1) / 2,
      .apart = m.apart(),
      .threshold = static_cast<float>(std::max(m.threshold[a], m.threshold[b]))};
  Distances distances(comparison);
  std::vector<Meeting> meetings;
  for (const PairTile& at : tiles) {
    if (at.place.row > 0) distances.forget_before(at.place.row - 1);
    find_meetings(comparison, at, distances, meetings);
  }
  return meetings;
}

/// One direction of a meeting.
struct Crossover {
  ClipFrame from, to;
  float distance = 0;
};

/// Of the crossovers that leave in the same window, the closest.
std::vector<Crossover> best_crossovers(const Material& m,
                                       const std::vector<std::vector<Meeting>>& found) {
  std::vector<Crossover> crossovers;
  for (const std::vector<Meeting>& some : found)
    for (const Meeting& meeting : some) {
      crossovers.push_back({meeting.a, meeting.b, meeting.distance});
      crossovers.push_back({meeting.b, meeting.a, meeting.distance});
    }
  const auto window = [length = m.radius()](const Crossover& p) {
    return std::tuple(p.from.clip, p.from.frame / length);
  };
  std::ranges::sort(crossovers, {}, [&](const Crossover& p) {
    return std::tuple(window(p), p.distance, p.from.frame, p.to.clip, p.to.frame);
  });
  std::vector<Crossover> best;
  std::size_t here = 0;  // How many of the same window came before.
  for (std::size_t i = 0; i < crossovers.size(); ++i) {
    here = i > 0 && window(crossovers[i]) == window(crossovers[i - 1]) ? here + 1 : 0;
    if (here < m.options.per_window) best.push_back(crossovers[i]);
  }
  return best;
}

Transition make_transition(const Material& m, const Crossover& crossover) {
  const auto& [from, to, rough] = crossover;
  const PoseMatch match = compare_poses(m.studied.cloud[from.clip], from.frame,
                                        m.studied.cloud[to.clip], to.frame, m.radius());
  return {
      .from = from,
      .to = to,
      .radius = radius_at(m.radius(), m.clips[from.clip], from.frame, m.clips[to.clip], to.frame),
      .distance = static_cast<float>(match.distance),
      .alignment = match.alignment};
}

}  // namespace

std::vector<double> alike_thresholds(const std::vector<MotionClip>& clips,
                                     const StudiedClips& studied,
                                     const TransitionOptions& options) {
  std::map<std::string, std::vector<double>> covered;  // by class
  for (std::size_t c = 0; c < clips.size(); ++c) {
    const std::size_t lag = frames_in(options.alike_within, clips[c].frame_rate);
    const std::size_t half = frames_in(options.radius, clips[c].frame_rate);
    const std::size_t step = frames_in(0.05, clips[c].frame_rate);
    for (std::size_t f = 0; f + lag < studied.cloud[c].frames; f += step)
      covered[clips[c].motion_class].push_back(
          compare_poses(studied.cloud[c], f, studied.cloud[c], f + lag, half).distance);
  }
  std::map<std::string, double> threshold;
  for (auto& [name, distances] : covered) {
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::ranges::nth_element(distances, middle);
    threshold[name] = *middle;
  }
  std::vector<double> of_clip;
  for (const MotionClip& clip : clips) of_clip.push_back(threshold[clip.motion_class]);
  return of_clip;
}

std::vector<Transition> find_transitions(const std::vector<MotionClip>& clips,
                                         const StudiedClips& studied,
                                         std::span<const double> threshold,
                                         const TransitionOptions& options, unsigned jobs) {
  if (clips.empty()) return {};
  const Material material{
      .clips = clips, .studied = studied, .options = options, .threshold = threshold, .jobs = jobs};
  std::size_t frames = 0;
  for (const MotionClip& clip : clips) frames += frame_count(clip);
  const std::vector<PairTile> tiles =
      frames <= options.compare_all_up_to ? every_tile(studied.cloud) : tiles_to_measure(material);
  const std::vector<std::span<const PairTile>> parts = parts_of(tiles);
  std::vector<std::vector<Meeting>> found(parts.size());
  content::for_each_index(parts.size(), jobs, [&](std::size_t part) {
    found[part] = meetings_in(material, parts[part]);
  });

  const std::vector<Crossover> best = best_crossovers(material, found);
  std::vector<Transition> transitions(best.size());
  content::for_each_index(best.size(), jobs, [&](std::size_t i) {
    transitions[i] = make_transition(material, best[i]);
  });
  std::ranges::sort(transitions, {}, [](const Transition& t) {
    return std::tuple(t.from.clip, t.from.frame, t.to.clip, t.to.frame);
  });
  return transitions;
}

}  // namespace docent::motion::offline

#include "content/motion/paper_search.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "content/motion/paper_track.h"
#include "content/motion/transition_section.h"

namespace docent::motion::offline {
namespace {

constexpr double objective_spacing = 0.005;  // metres of arc length
constexpr double rounding = 1e-9;  // metres, of lengths that are added up in different orders
constexpr std::uint64_t pops_between_looks_at_the_clock = 256;
constexpr std::uint32_t no_transition = std::numeric_limits<std::uint32_t>::max();

/// T_obj by arc length.
class Objective {
 public:
  explicit Objective(std::span<const Vec2> path) {
    double walked = 0;  // at the beginning of the segment
    for (std::size_t i = 1; i < path.size(); ++i) {
      const double length = glm::distance(path[i - 1], path[i]);
      for (double s = next_sample(); s < walked + length; s = next_sample())
        point_.push_back(glm::mix(path[i - 1], path[i], (s - walked) / length));
      walked += length;
    }
    point_.push_back(path.back());
    length_ = walked;
  }

  double length() const noexcept { return length_; }

  Vec2 at(double length) const noexcept {
    const double place = std::max(length, 0.0) / objective_spacing;
    const auto below = std::min(static_cast<std::size_t>(place), point_.size() - 1);
    const std::size_t above = std::min(below + 1, point_.size() - 1);
    return glm::mix(point_[below], point_[above],
                    std::min(place - static_cast<double>(below), 1.0));
  }

 private:
  double next_sample() const noexcept {
    return objective_spacing * static_cast<double>(point_.size());
  }

  std::vector<Vec2> point_;
  double length_ = 0;
};

/// A frame at which transitions can be taken with their full section, and those transitions.
struct Exit {
  std::uint32_t frame = 0;
  std::uint32_t transition = 0;
};

/// What the search knows of a clip, and of the graph.
struct SearchClip {
  std::vector<Vec2> root;   ///< Per frame, floor frame.
  std::vector<double> arc;  ///< Per frame: length of the track since the first frame, metres.
  std::vector<Exit> exits;  ///< In the order of frames.
};

struct SearchGraph {
  const MotionGraph& motion;
  TransitionSections sections;
  std::vector<SearchClip> clip;
};

SearchGraph make_search_graph(const MotionGraph& motion) {
  SearchGraph graph{motion, measure_sections(motion), {}};
  for (const MotionClip& clip : motion.clips) {
    SearchClip& out = graph.clip.emplace_back();
    for (const Vec3 root : clip.root) {
      out.root.push_back(to_floor(root));
      const std::size_t f = out.arc.size();
      out.arc.push_back(f == 0 ? 0 : out.arc[f - 1] + glm::distance(out.root[f - 1], out.root[f]));
    }
  }
  for (std::uint32_t t = 0; t < motion.transitions.size(); ++t) {
    const std::uint32_t radius = graph.sections.longest[t];
    const ClipFrame from = motion.transitions[t].from;
    if (radius > 0) graph.clip[from.clip].exits.push_back({from.frame - radius, t});
  }
  for (SearchClip& clip : graph.clip) std::ranges::stable_sort(clip.exits, {}, &Exit::frame);
  return graph;
}

/// A candidate path P_x, by its last vertex; the others are those that it was made from. Until it
/// is taken from the stack, its figures are still those of the path that it goes on from.
struct Candidate {
  ClipFrame at;  ///< The last vertex.
  bool has_arrived =
      true;  ///< By a transition, or it is the start: sections may be shortened here.
  PassedTransition arrived_by{no_transition, 0};  ///< That led to the vertex.
  std::size_t depth = 0;                          ///< Vertices after V_start.
  Placement clip_to_floor;
  Vec2 place{};              ///< Of the hips at the vertex, floor frame.
  double length = 0;         ///< Of the track T_x, metres.
  double squares = 0;        ///< Squared distances times metres up to L_over: D times L_over.
  std::uint32_t frames = 1;  ///< Of the track up to the end of the objective.
};

class PaperSearch {
 public:
  PaperSearch(const SearchGraph& graph, const PaperRequest& request)
      : graph_(graph), request_(request), objective_(request.path) {}

  PaperPath run() {
    Candidate start;
    start.at = request_.start;
    start.clip_to_floor = request_.clip_to_floor;
    start.place = carried(start.clip_to_floor, clip(start.at.clip).root[start.at.frame]);
    path_.start = start.at;
    while (start.length < objective_.length()) {
      over_ = std::min(start.length + request_.lookahead, objective_.length());
      const std::vector<Candidate> best = look_ahead(start);
      if (best.empty()) break;
      const std::size_t kept = points_used(best.size());
      for (std::size_t i = 0; i < kept; ++i) keep(best[i]);
      start = best[kept - 1];
      start.depth = 0;
    }
    return finished(start);
  }

 private:
  const SearchClip& clip(std::uint32_t index) const { return graph_.clip[index]; }

  /// P_opt of one step, V_start left out; empty where no candidate is long enough or time is up.
  std::vector<Candidate> look_ahead(const Candidate& start) {
    stack_.assign(1, start);
    way_.clear();
    std::vector<Candidate> best;
    while (!stack_.empty()) {
      Candidate candidate = stack_.back();
      stack_.pop_back();
      if (path_.expanded++ % pops_between_looks_at_the_clock == 0 && is_time_up()) return {};
      way_.resize(candidate.depth);
      follow(candidate);
      way_.push_back(candidate);
      if (!can_go_on(candidate) && !reaches_end(candidate)) continue;
      if (gives_up(candidate, best)) continue;
      if (candidate.length < over_)
        push_neighbours(candidate);
      else if (best.empty() || candidate.squares < best.back().squares)
        best.assign(way_.begin() + 1, way_.end());
    }
    return best;
  }

  bool gives_up(const Candidate& candidate, const std::vector<Candidate>& best) const {
    return request_.bound == PaperRequest::Bound::OnTheWay && !best.empty() &&
           candidate.squares >= best.back().squares;
  }

  void push_neighbours(const Candidate& from) {
    const std::vector<Exit>& exits = clip(from.at.clip).exits;
    for (const Exit& exit : exits) {
      const bool begins_here = exit.frame == from.at.frame;
      const bool began_before = exit.frame < from.at.frame && from.has_arrived;
      if (!begins_here && !began_before) continue;
      const auto radius =
          section_radius(graph_.motion, graph_.sections, exit.transition, from.at.frame);
      if (!radius) continue;
      const ClipFrame to = graph_.motion.transitions[exit.transition].to;
      push(from, {to.clip, to.frame + *radius}, {exit.transition, *radius});
    }
    const auto next = std::ranges::upper_bound(exits, from.at.frame, {}, &Exit::frame);
    const auto end = static_cast<std::uint32_t>(clip(from.at.clip).root.size() - 1);
    if (next != exits.end())
      push(from, {from.at.clip, next->frame}, {no_transition, 0});
    else if (from.at.frame < end)
      push(from, {from.at.clip, end}, {no_transition, 0});
  }

  void push(const Candidate& from, ClipFrame to, PassedTransition arrived_by) {
    Candidate next = from;
    next.at = to;
    next.has_arrived = arrived_by.transition != no_transition;
    next.arrived_by = arrived_by;
    next.depth = from.depth + 1;
    stack_.push_back(next);
  }

  /// Is there an exit ahead?
  bool can_go_on(const Candidate& candidate) const {
    const std::vector<Exit>& exits = clip(candidate.at.clip).exits;
    const std::optional<std::uint32_t> last = graph_.sections.last_exit[candidate.at.clip];
    if (candidate.has_arrived) return last && candidate.at.frame <= *last;
    return !exits.empty() && candidate.at.frame <= exits.back().frame;
  }

  /// Does what is left of its clip bring a candidate to the end of the path?
  bool reaches_end(const Candidate& candidate) const {
    const std::vector<double>& arc = clip(candidate.at.clip).arc;
    const double rest = arc.back() - arc[candidate.at.frame];
    return candidate.length + rest >= objective_.length() + (rest > 0 ? rounding : 0);
  }

  /// Brings a candidate's figures from the vertex before to its last: T_x = pathToTrack(P_x).
  void follow(Candidate& candidate) const {
    if (candidate.depth == 0) return;
    const ClipFrame from = way_.back().at;
    if (candidate.arrived_by.transition == no_transition)
      follow_clip(candidate, from.frame);
    else
      follow_section(candidate);
  }

  void follow_clip(Candidate& candidate, std::uint32_t from) const {
    const std::vector<Vec2>& root = clip(candidate.at.clip).root;
    const Rotation turn(candidate.clip_to_floor);
    for (std::uint32_t f = from + 1; f <= candidate.at.frame; ++f)
      step_to(candidate, turn(root[f]));
  }

  void follow_section(Candidate& candidate) const {
    const auto [t, radius] = candidate.arrived_by;
    const Transition& way = graph_.motion.transitions[t];
    const Vec2* from = clip(way.from.clip).root.data() + way.from.frame - radius;
    const Vec2* to = clip(way.to.clip).root.data() + way.to.frame - radius;
    const Placement destination = carried(candidate.clip_to_floor, way.alignment);
    const Rotation here(candidate.clip_to_floor), there(destination);
    for (std::uint32_t i = 1; i < 2 * radius; ++i)
      step_to(candidate, glm::mix(here(from[i]), there(to[i]), blend_share(i, radius)));
    step_to(candidate, there(to[2 * radius]));
    candidate.clip_to_floor = destination;
  }

  /// A rigid motion of the floor that is used many times.
  struct Rotation {
    Vec2 position;
    double c, s;
    explicit Rotation(const Placement& p)
        : position(p.position), c(std::cos(p.heading)), s(std::sin(p.heading)) {}
    Vec2 operator()(Vec2 p) const noexcept {
      return position + Vec2{c * p.x - s * p.y, s * p.x + c * p.y};
    }
  };

  void step_to(Candidate& candidate, Vec2 place) const {
    const double step = glm::distance(candidate.place, place);
    if (candidate.length < objective_.length()) ++candidate.frames;
    const double counted = std::min(step, over_ - candidate.length);
    candidate.place = place;
    candidate.length += step;
    if (counted <= 0) return;
    const Vec2 gap = place - objective_.at(candidate.length);
    candidate.squares += counted * dot(gap, gap);
  }

  std::size_t points_used(std::size_t points) const {
    if (over_ >= objective_.length()) return points;
    const auto used =
        static_cast<std::size_t>(request_.use_rate * static_cast<double>(points) + 1e-9);
    return std::clamp<std::size_t>(used, 1, points);
  }

  void keep(const Candidate& candidate) {
    if (candidate.arrived_by.transition != no_transition)
      path_.passed.push_back(candidate.arrived_by);
  }

  bool is_time_up() const { return seconds() >= request_.time_limit; }

  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

  PaperPath finished(const Candidate& last) {
    path_.last_frame = last.at.frame;
    path_.frames = last.frames;
    path_.length = std::min(last.length, objective_.length());
    path_.seconds = seconds();
    path_.reaches_end = last.length >= objective_.length();
    return path_;
  }

  const SearchGraph& graph_;
  const PaperRequest& request_;
  Objective objective_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  double over_ = 0;               ///< L_over.
  std::vector<Candidate> stack_;  ///< S_p.
  std::vector<Candidate> way_;    ///< The vertices of the candidate in hand, V_start first.
  PaperPath path_;                ///< P_result.
};

}  // namespace

PaperPath find_paper_path(const MotionGraph& graph, const PaperRequest& request) {
  const SearchGraph ready = make_search_graph(graph);
  return PaperSearch(ready, request).run();
}

}  // namespace docent::motion::offline

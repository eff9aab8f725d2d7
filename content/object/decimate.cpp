#include "content/object/decimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <span>
#include <utility>

#include <meshoptimizer.h>
#include <glm/geometric.hpp>

#include "content/object/simplify.h"
#include "content/object/surface.h"

namespace docent::object {
namespace {

using Index = std::uint32_t;
constexpr Index nobody = 0xFFFFFFFFU;
constexpr float never = std::numeric_limits<float>::max();

// Of the object's longest side, which is 1 here: on a screen of 1080 lines, 11 pixels ...
constexpr float farthest = 0.01F * 0.01F;
// ... a fifth of one, below which it is all the same how far a face is from the surface ...
constexpr float unseen = 0.0002F * 0.0002F;
// ... three, between samples of what was, and four, between places of what would be: what is
// thinner may be missed.
constexpr float between_samples = 0.003F, between_places = 0.004F;

/// A triangle between places; a border, between a sheet of the surface and nothing, is one of two.
struct Face {
  std::array<Index, 3> place{}, vertex{};
  Index first_sample = nobody;
  bool is_border = false, is_gone = false;

  bool has(Index p) const { return place[0] == p || place[1] == p || place[2] == p; }
};

/// A face as it would lie after a collapse.
struct Moved {
  Corners at{};
  Index face = nobody;
};

struct Collapse {
  float cost = never;  ///< Squared distance.
  Index to = nobody;
};

std::size_t pieces_of(const Corners& triangle, float piece, std::size_t least, std::size_t most) {
  const auto& [a, b, c] = triangle;
  const float longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
  return std::clamp(static_cast<std::size_t>(std::ceil(longest / piece)), least, most);
}

/// The place that is so many pieces from the first corner towards either of the others.
Vec3 within(const Corners& triangle, float second, float third) {
  const auto& [a, b, c] = triangle;
  return a + second * (b - a) + third * (c - a);
}

class Decimation {
 public:
  explicit Decimation(const Shape& shape)
      : faces_(faces_of(shape)), inner_faces_(faces_.size()), surface_(corners_of_all()) {
    left_ = inner_faces_;
    add_borders();
    about_.resize(place_.size());
    for (Index f = 0; f < faces_.size(); ++f)
      for (std::size_t c = 0; c < (faces_[f].is_border ? 2U : 3U); ++c)
        about_[faces_[f].place[c]].push_back(f);
    mark_.resize(place_.size());
    state_.resize(place_.size());
    best_.resize(place_.size());
    is_moved_.resize(place_.size());
    is_settled_.resize(place_.size());
    for (Index p = 0; p < place_.size(); ++p)
      if (about_[p].size() > most_about) state_[p] = State::Kept;
    add_samples();
  }

  float run(std::size_t triangles) {
    for (Index p = 0; p < place_.size(); ++p) evaluate(p);
    float worst = 0;
    while (left_ > triangles && !queue_.empty()) {
      const auto [cost, from] = queue_.top();
      queue_.pop();
      if (state_[from] == State::Gone || best_[from].cost != cost) continue;
      if (state_[from] == State::Stale) {
        evaluate(from);
        continue;
      }
      worst = std::max(worst, cost);
      collapse(from, best_[from].to);
    }
    return std::sqrt(worst);
  }

  /// Corners of round things lie on them, and their faces within: half of that error goes where
  /// corners move out by half of it.
  void settle(float worst) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round)
      for (Index p = 0; p < place_.size(); ++p)
        if (state_[p] != State::Gone && state_[p] != State::Kept && !is_settled_[p])
          settle(p, worst * worst);
  }

  void write_to(Shape& shape) const {
    std::vector<Index> indices;
    for (const Face& face : std::span(faces_).first(inner_faces_)) {
      if (face.is_gone) continue;
      indices.insert(indices.end(), face.vertex.begin(), face.vertex.end());
      for (std::size_t c = 0; c < 3; ++c)
        if (is_moved_[face.place[c]])
          shape.vertices[face.vertex[c]].position = low_ + longest_ * place_[face.place[c]];
    }
    if (!indices.empty()) shape.indices = std::move(indices);
  }

 private:
  /// A place about which there is more stays: to try what it might do takes too long.
  static constexpr std::size_t most_about = 64;
  enum class State : std::uint8_t { Fresh, Stale, Gone, Kept };
  struct Waiting {
    float cost;
    Index place;
    bool operator<(const Waiting& other) const {
      return cost != other.cost ? cost > other.cost : place > other.place;
    }
  };

  std::vector<Face> faces_of(const Shape& shape) {
    std::vector<Vec3> position;
    for (const ShapeVertex& v : shape.vertices) position.push_back(v.position);
    std::vector<Index> number(position.size());
    place_.resize(meshopt_generateVertexRemap(number.data(), shape.indices.data(),
                                              shape.indices.size(), position.data(),
                                              position.size(), sizeof(Vec3)));
    const Box box = box_of(shape);
    const Vec3 size = box.size();
    low_ = box.low;
    longest_ = std::max({size.x, size.y, size.z});
    if (!(longest_ > 0)) longest_ = 1;
    high_ = size / longest_;
    for (std::size_t v = 0; v < position.size(); ++v)
      if (number[v] < place_.size()) place_[number[v]] = (position[v] - low_) / longest_;
    std::vector<Face> faces;
    for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
      Face face;
      for (std::size_t c = 0; c < 3; ++c) {
        face.vertex[c] = shape.indices[k + c];
        face.place[c] = number[face.vertex[c]];
      }
      const auto& [a, b, c] = face.place;
      if (a != b && b != c && c != a) faces.push_back(face);
    }
    return faces;
  }

  Corners corners_of(const Face& face) const {
    return {place_[face.place[0]], place_[face.place[1]], place_[face.place[2]]};
  }

  std::vector<Corners> corners_of_all() const {
    std::vector<Corners> all;
    for (const Face& face : faces_) all.push_back(corners_of(face));
    if (all.empty()) all.emplace_back();
    return all;
  }

  /// A side is a border where all faces that have it lie on one another.
  void add_borders() {
    struct Side {
      Index low, high, third;
      bool is_of(const Side& other) const { return low == other.low && high == other.high; }
    };
    std::vector<Side> sides;
    for (const Face& face : faces_)
      for (std::size_t c = 0; c < 3; ++c) {
        const Index a = face.place[c], b = face.place[(c + 1) % 3];
        sides.push_back({std::min(a, b), std::max(a, b), face.place[(c + 2) % 3]});
      }
    std::ranges::sort(sides, {}, [](const Side& s) { return std::array{s.low, s.high, s.third}; });
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      while (end < sides.size() && sides[end].is_of(sides[i])) ++end;
      if (sides[end - 1].third != sides[i].third) continue;
      Face& border = faces_.emplace_back();
      border.place = {sides[i].low, sides[i].high, sides[i].high};
      border.is_border = true;
    }
  }

  /// Of the surface as it was: each is moved to the face that is nearest to it, as faces go.
  void add_samples() {
    for (Index p = 0; p < place_.size(); ++p) {
      bool has_inner = false, has_border = false;
      for (const Index f : about_[p]) {
        bool& has = faces_[f].is_border ? has_border : has_inner;
        if (!has) add_sample(f, place_[p]);
        has = true;
      }
    }
    float piece = between_samples;
    constexpr std::size_t most_samples = 2'000'000;  // of long splinters there may be many more
    while (samples_in_faces(piece) > most_samples) piece *= 1.5F;
    for (Index f = 0; f < inner_faces_; ++f) {
      const Corners corners = corners_of(faces_[f]);
      const std::size_t pieces = pieces_of(corners, piece, 1, most_pieces);
      const float share = 1 / static_cast<float>(pieces);
      for (std::size_t i = 0; i < pieces; ++i)
        for (std::size_t j = 0; i + j < pieces; ++j)
          add_sample(f, within(corners, share * (static_cast<float>(i) + 1 / 3.0F),
                               share * (static_cast<float>(j) + 1 / 3.0F)));
    }
  }

  static constexpr std::size_t most_pieces = 16;

  std::size_t samples_in_faces(float piece) const {
    std::size_t count = 0;
    for (const Face& face : std::span(faces_).first(inner_faces_)) {
      const std::size_t pieces = pieces_of(corners_of(face), piece, 1, most_pieces);
      count += pieces * (pieces + 1) / 2;
    }
    return count;
  }

  void add_sample(Index face, Vec3 at) {
    next_.push_back(std::exchange(faces_[face].first_sample, static_cast<Index>(sample_.size())));
    sample_.push_back(at);
  }

  void evaluate(Index from) {
    if (state_[from] == State::Kept || state_[from] == State::Gone) return;
    state_[from] = State::Fresh;
    best_[from] = best_collapse(from);
    if (best_[from].to != nobody) queue_.push({best_[from].cost, from});
  }

  Collapse best_collapse(Index from) {
    forget_gone(from);
    if (about_[from].size() > most_about) return {};
    choices_.clear();
    find_neighbours(from);
    for (const Index to : around_) {
      if (state_[to] == State::Kept || !keeps_form(from, to) || !keeps_seams(from, to) ||
          !move(from, to))
        continue;
      const Collapse choice{distance_to_moved(from), to};
      if (choice.cost >= farthest) continue;
      if (choice.cost <= unseen)
        if (const float cost = distance_of_moved(place_[to], choice.cost, 1.0001F * unseen);
            cost <= unseen)
          return {cost, to};
      choices_.push_back(choice);
    }
    std::ranges::sort(choices_, {}, [](const Collapse& c) { return std::pair(c.cost, c.to); });
    Collapse best{.cost = farthest, .to = nobody};
    for (const Collapse& choice : choices_) {
      if (choice.cost >= best.cost) break;
      move(from, choice.to);
      const float cost = distance_of_moved(place_[choice.to], choice.cost, best.cost);
      if (cost < best.cost) best = {cost, choice.to};
    }
    return best;
  }

  void forget_gone(Index p) {
    std::erase_if(about_[p], [&](Index f) { return faces_[f].is_gone; });
  }

  void find_neighbours(Index p) {
    around_.clear();
    mark_[p] = ++stamp_;
    for (const Index f : about_[p])
      for (const Index q : faces_[f].place)
        if (std::exchange(mark_[q], stamp_) != stamp_) around_.push_back(q);
  }

  /// The link condition (Dey et al. 1999): neighbours that both have are those of the faces which
  /// go. Otherwise two sheets would become one.
  bool keeps_form(Index from, Index to) {
    const Index neighbour = ++stamp_, of_both = ++stamp_, of_gone = ++stamp_;
    for (const Index q : around_) mark_[q] = neighbour;
    std::size_t both = 0, gone = 0;
    const auto count = [&](Index p, Index before, Index after, std::size_t& counted) {
      for (const Index f : about_[p])
        if (const Face& face = faces_[f]; !face.is_gone && (after == of_both || face.has(to)))
          for (const Index q : face.place)
            if (q != to && q != from && mark_[q] == before) {
              mark_[q] = after;
              ++counted;
            }
    };
    count(to, neighbour, of_both, both);
    count(from, of_both, of_gone, gone);
    return both == gone;
  }

  /// What a vertex at `from` becomes is what the faces that go have at `to`: each needs one.
  bool keeps_seams(Index from, Index to) {
    becomes_.clear();
    for (const Index f : about_[from]) {
      const Face& face = faces_[f];
      if (!face.is_border && face.has(to))
        becomes_.emplace_back(vertex_at(face, from), vertex_at(face, to));
    }
    return std::ranges::all_of(about_[from], [&](Index f) {
      const Face& face = faces_[f];
      return face.is_border || face.has(to) || becomes(vertex_at(face, from)) != nobody;
    });
  }

  static Index vertex_at(const Face& face, Index p) {
    return face
        .vertex[static_cast<std::size_t>(std::ranges::find(face.place, p) - face.place.begin())];
  }

  Index becomes(Index vertex) const {
    const auto known = std::ranges::find(becomes_, vertex, &std::pair<Index, Index>::first);
    return known == becomes_.end() ? nobody : known->second;
  }

  /// Fills `moved_` and `moved_border_`. False where a face turns over, or none is left.
  bool move(Index from, Index to) {
    moved_.clear();
    moved_border_.clear();
    for (const Index f : about_[from]) {
      const Face& face = faces_[f];
      if (face.has(to)) continue;
      const Corners before = corners_of(face);
      Moved moved{.at = before, .face = f};
      for (std::size_t c = 0; c < 3; ++c)
        if (face.place[c] == from) moved.at[c] = place_[to];
      if (!face.is_border && turns(before, moved.at)) return false;
      (face.is_border ? moved_border_ : moved_).push_back(moved);
    }
    if (moved_.empty()) add_others(from, to, false, moved_);
    if (moved_border_.empty()) add_others(from, to, true, moved_border_);
    return !moved_.empty();
  }

  static bool turns(const Corners& one, const Corners& two) {
    const Vec3 before = glm::cross(one[1] - one[0], one[2] - one[0]),
               after = glm::cross(two[1] - two[0], two[2] - two[0]);
    constexpr float least = 0.2F;
    return glm::dot(before, after) <= least * glm::length(before) * glm::length(after);
  }

  /// What has been about `to` already.
  void add_others(Index from, Index to, bool is_border, std::vector<Moved>& moved) const {
    for (const Index f : about_[to])
      if (const Face& face = faces_[f];
          !face.is_gone && face.is_border == is_border && !face.has(from))
        moved.push_back({.at = corners_of(face), .face = f});
  }

  /// How far is what was from what would be? Squared; `farthest` where it is more.
  float distance_to_moved(Index from) const {
    float worst = 0;
    for (const Index f : about_[from]) {
      const std::vector<Moved>& moved = faces_[f].is_border ? moved_border_ : moved_;
      for (Index s = faces_[f].first_sample; s != nobody; s = next_[s]) {
        float least = farthest;
        for (const Moved& face : moved) {
          least = std::min(least, squared_distance(sample_[s], face.at));
          if (least <= std::max(worst, unseen)) break;
        }
        worst = std::max(worst, least);
        if (worst >= farthest) return worst;
      }
    }
    return worst;
  }

  /// How far is what would be, with `corner` in it, from what was? Squared, no less than `worst`;
  /// `most` where it is more.
  float distance_of_moved(Vec3 corner, float worst, float most) {
    const auto ask = [&](Vec3 place) {
      worst = std::max(worst, surface_.squared_distance_from(place, std::max(worst, unseen), most));
    };
    constexpr std::size_t fewest = 2, most_asked = 10;
    for (Moved moved : moved_) {
      const auto moves = std::ranges::find(moved.at, corner);
      std::ranges::rotate(moved.at, moves);
      const std::size_t pieces = pieces_of(moved.at, between_places, fewest, most_asked);
      const float piece = 1 / static_cast<float>(pieces);
      ask(within(moved.at, 1 / 3.0F, 1 / 3.0F));
      for (std::size_t i = 0; i < pieces && worst < most; ++i)
        for (std::size_t j = i == 0 ? 1 : 0; i + j < pieces; ++j)
          ask(within(moved.at, piece * static_cast<float>(i), piece * static_cast<float>(j)));
      if (worst >= most) return most;
    }
    return worst;
  }

  /// Of a corner that need not lie on what was, which distance_of_moved() does not ask.
  float own_distance(Vec3 corner, float most) {
    return surface_.squared_distance_from(corner, unseen, most);
  }

  /// Moves a place where what is about it comes nearer to what it was: along its normal or an axis,
  /// within the object's box.
  void settle(Index p, float worst) {
    is_settled_[p] = true;
    forget_gone(p);
    Vec3 across{0};
    moved_.clear();
    for (const Index f : about_[p]) {
      if (faces_[f].is_border) return;
      const Corners at = corners_of(faces_[f]);
      across += glm::cross(at[1] - at[0], at[2] - at[0]);
      moved_.push_back({.at = at, .face = f});
    }
    const float length = glm::length(across);
    constexpr float worth = 0.5F;
    if (moved_.empty() || !(length > 0)) return;
    float least =
        std::max({distance_to_moved(p), own_distance(place_[p], farthest), worth * worst});
    least = distance_of_moved(place_[p], least, farthest);
    if (least <= worth * worst || least >= farthest) return;
    const float step = std::sqrt(least);
    for (const Vec3 way : {across / length, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
      for (const float share : {0.5F, -0.5F, 0.25F, -0.25F})
        if (settle_at(p, glm::clamp(place_[p] + share * step * way, Vec3{0.0F}, high_), least,
                      worst))
          return;
  }

  bool settle_at(Index p, Vec3 to, float least, float worst) {
    constexpr float less = 0.95F;
    // A corner is seen wherever it is: it goes no further than what is furthest off, even where
    // its faces would gain.
    const float own = own_distance(to, worst);
    if (own >= worst || !would_lie(p, to)) return false;
    float cost = std::max(own, distance_to_moved(p));
    if (cost < less * least) cost = distance_of_moved(to, cost, less * least);
    if (cost >= less * least) return false;
    place_[p] = to;
    is_moved_[p] = true;
    for (const Index f : about_[p])
      for (const Index q : faces_[f].place) is_settled_[q] = false;
    give_anew(p);
    return true;
  }

  /// Fills `moved_` with the faces about a place, moved. False where one turns over.
  bool would_lie(Index p, Vec3 at) {
    moved_.clear();
    for (const Index f : about_[p]) {
      const Corners before = corners_of(faces_[f]);
      Moved moved{.at = before, .face = f};
      for (std::size_t c = 0; c < 3; ++c)
        if (faces_[f].place[c] == p) moved.at[c] = at;
      if (turns(before, moved.at)) return false;
      moved_.push_back(moved);
    }
    return true;
  }

  void give_anew(Index p) {
    std::vector<Index> samples;
    for (const Index f : about_[p])
      for (Index s = std::exchange(faces_[f].first_sample, nobody); s != nobody; s = next_[s])
        samples.push_back(s);
    give(samples, moved_);
  }

  void collapse(Index from, Index to) {
    forget_gone(from);
    keeps_seams(from, to);
    move(from, to);
    std::vector<Index> samples, border_samples;
    for (const Index f : about_[from]) {
      Face& face = faces_[f];
      for (Index s = std::exchange(face.first_sample, nobody); s != nobody; s = next_[s])
        (face.is_border ? border_samples : samples).push_back(s);
      if (face.has(to)) {
        face.is_gone = true;
        left_ -= face.is_border ? 0 : 1;
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c)
        if (face.place[c] == from) {
          face.place[c] = to;
          if (!face.is_border) face.vertex[c] = becomes(face.vertex[c]);
        }
      about_[to].push_back(f);
    }
    give(samples, moved_);
    give(border_samples, moved_border_);
    about_[from] = {};
    state_[from] = State::Gone;
    renew_about(to);
  }

  void give(const std::vector<Index>& samples, const std::vector<Moved>& faces) {
    for (const Index s : samples) {
      Index nearest = nobody;
      float least = never;
      for (const Moved& moved : faces)
        if (const float own = squared_distance(sample_[s], moved.at); own < least) {
          least = own;
          nearest = moved.face;
        }
      if (nearest != nobody) next_[s] = std::exchange(faces_[nearest].first_sample, s);
    }
  }

  /// Those that wait are tried again when it is their turn; those that could not go, at once.
  void renew_about(Index place) {
    forget_gone(place);
    find_neighbours(place);
    around_.push_back(place);
    const std::vector<Index> touched = around_;
    for (const Index p : touched)
      if (state_[p] == State::Fresh) state_[p] = State::Stale;
    for (const Index p : touched)
      if (best_[p].to == nobody) evaluate(p);
  }

  Vec3 low_{0}, high_{0};  ///< The corners of its box; the second as places are.
  float longest_ = 1;
  std::vector<Vec3> place_;                  ///< From `low_`, of `longest_`.
  std::vector<bool> is_moved_, is_settled_;  ///< Settled: until something about it moves.
  std::vector<Face> faces_;                  ///< First those that are triangles, then the borders.
  std::size_t inner_faces_ = 0, left_ = 0;
  Surface surface_;
  std::vector<std::vector<Index>> about_;  ///< Faces, by place; some that are gone among them.
  std::vector<Vec3> sample_;
  std::vector<Index> next_;  ///< Sample of the same face.
  std::vector<State> state_;
  std::vector<Collapse> best_;
  std::priority_queue<Waiting> queue_;
  // Of the place that is looked at:
  std::vector<Index> mark_, around_;
  Index stamp_ = 0;
  std::vector<std::pair<Index, Index>> becomes_;
  std::vector<Collapse> choices_;
  std::vector<Moved> moved_, moved_border_;
};

}  // namespace

float decimate(Shape& shape, std::size_t triangles) {
  // Some 11 s of a processor. What is larger loses the rest to the quadrics first.
  constexpr std::size_t most_triangles = 200'000;
  if (shape.indices.size() <= 3 * triangles) return 0;
  drop_repeated(shape);
  simplify(shape, std::max(triangles, most_triangles));
  if (shape.indices.size() <= 3 * triangles) return 0;
  Decimation decimation(shape);
  const float off = decimation.run(triangles);
  decimation.settle(off);
  decimation.write_to(shape);
  return off;
}

}  // namespace docent::object

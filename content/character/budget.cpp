#include "content/character/budget.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

namespace docent::character {
namespace {

/// Of a budget, what a textured surface is simplified to when it is above it: the rest is for its
/// colours.
constexpr double share_of_shape = 0.8;

void leave_out_clear(const Colours& colours, Surface& surface) {
  std::vector<bool> is_seen(surface.vertices.size());
  for (std::size_t v = 0; v < is_seen.size(); ++v)
    is_seen[v] = colours.is_seen(surface.vertices[v]);
  std::vector<std::uint32_t> kept;
  for (std::size_t k = 0; k + 2 < surface.indices.size(); k += 3) {
    const std::uint32_t* t = &surface.indices[k];
    if (is_seen[t[0]] || is_seen[t[1]] || is_seen[t[2]]) kept.insert(kept.end(), t, t + 3);
  }
  surface.indices = std::move(kept);
}

/// Keeps the vertices that triangles use, in the order of their first use.
void drop_unused(Surface& surface) {
  std::vector<std::uint32_t> place(surface.vertices.size(), UINT32_MAX);
  std::vector<SurfaceVertex> kept;
  for (std::uint32_t& v : surface.indices) {
    if (place[v] == UINT32_MAX) {
      place[v] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(surface.vertices[v]);
    }
    v = place[v];
  }
  surface.vertices = std::move(kept);
}

/// For each vertex the first one that is the same by a key of floats.
template <std::size_t n, typename Key>
std::vector<std::uint32_t> first_alike(const std::vector<SurfaceVertex>& vertices, Key key) {
  struct Hash {
    std::size_t operator()(const std::array<float, n>& k) const noexcept {
      std::size_t h = 1469598103934665603U;
      for (const float f : k) {
        std::uint32_t bits = 0;
        const float plain = f + 0.0F;  // no negative zero
        std::memcpy(&bits, &plain, sizeof bits);
        h = (h ^ bits) * 1099511628211U;
      }
      return h;
    }
  };
  std::unordered_map<std::array<float, n>, std::uint32_t, Hash> seen;
  std::vector<std::uint32_t> first(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    first[v] = seen.emplace(key(vertices[v]), v).first->second;
  return first;
}

std::vector<std::uint32_t> same_place(const std::vector<SurfaceVertex>& vertices) {
  return first_alike<3>(vertices, [](const SurfaceVertex& v) {
    return std::array{v.position.x, v.position.y, v.position.z};
  });
}

/// Makes vertices one that differ in their normals only, or in nothing but their place where
/// `by_place`; their normals become the mean.
void weld(Surface& surface, bool by_place) {
  const std::vector<std::uint32_t> first =
      by_place ? same_place(surface.vertices)
               : first_alike<8>(surface.vertices, [](const SurfaceVertex& v) {
                   return std::array{v.position.x, v.position.y,
                                     v.position.z, v.uv.x,
                                     v.uv.y,       v.tint.x + 2 * v.tint.y,
                                     v.tint.z,     static_cast<float>(v.material)};
                 });
  std::vector<Vec3> normal(surface.vertices.size(), Vec3{0});
  for (std::size_t v = 0; v < first.size(); ++v) normal[first[v]] += surface.vertices[v].normal;
  for (std::size_t v = 0; v < first.size(); ++v)
    if (first[v] == v && glm::length(normal[v]) > 1e-6F)
      surface.vertices[v].normal = glm::normalize(normal[v]);
  for (std::uint32_t& v : surface.indices) v = first[v];
  drop_unused(surface);
}

/// The head counts for more: what is about the face is kept finer.
std::vector<Vec3> seen_places(const std::vector<SurfaceVertex>& vertices, const Springs& springs) {
  constexpr float magnified = 1.8F;
  Vec3 middle{0};
  float count = 0;
  const auto head_share = [&](const SurfaceVertex& v) {
    float share = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const HumanBone bone = body_bone(springs, v.shares.bone[k]);
      if (bone == HumanBone::Head || bone == HumanBone::Jaw || bone == HumanBone::LeftEye ||
          bone == HumanBone::RightEye)
        share += v.shares.share[k];
    }
    return share;
  };
  for (const SurfaceVertex& v : vertices) {
    middle += head_share(v) * v.position;
    count += head_share(v);
  }
  if (count > 0) middle /= count;
  std::vector<Vec3> places;
  for (const SurfaceVertex& v : vertices)
    places.push_back(v.position + (magnified - 1) * head_share(v) * (v.position - middle));
  return places;
}

bool simplify(Surface& surface, const Springs& springs, std::size_t triangles, bool is_sloppy) {
  const std::vector<Vec3> places = seen_places(surface.vertices, springs);
  std::vector<std::uint32_t> out(surface.indices.size());
  const float* first = &places.front().x;
  float error = 0;
  const std::size_t size =
      is_sloppy
          ? meshopt_simplifySloppy(out.data(), surface.indices.data(), surface.indices.size(),
                                   first, places.size(), sizeof(Vec3), 3 * triangles, 1.0F, &error)
          : meshopt_simplify(out.data(), surface.indices.data(), surface.indices.size(), first,
                             places.size(), sizeof(Vec3), 3 * triangles, 0.1F, 0U, &error);
  if (size == 0) return false;
  out.resize(size);
  surface.indices = std::move(out);
  drop_unused(surface);
  return surface.indices.size() <= 3 * triangles;
}

float difference(Vec4 a, Vec4 b) {
  const auto eye = [](float linear) { return std::sqrt(std::max(linear, 0.0F)); };
  float sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::abs(eye(a[i]) - eye(b[i]));
  return sum;
}

SurfaceVertex between(const SurfaceVertex& a, const SurfaceVertex& b) {
  SurfaceVertex middle = a;
  middle.position = 0.5F * (a.position + b.position);
  const Vec3 normal = a.normal + b.normal;
  middle.normal = glm::length(normal) > 1e-6F ? glm::normalize(normal) : a.normal;
  middle.uv = 0.5F * (a.uv + b.uv);
  middle.tint = 0.5F * (a.tint + b.tint);
  std::vector<std::pair<float, std::uint8_t>> all;
  for (const BoneShares* s : {&a.shares, &b.shares})
    for (std::size_t k = 0; k < 4; ++k) {
      if (!(s->share[k] > 0)) continue;
      const auto same = std::ranges::find(all, s->bone[k], &std::pair<float, std::uint8_t>::second);
      if (same == all.end())
        all.emplace_back(0.5F * s->share[k], s->bone[k]);
      else
        same->first += 0.5F * s->share[k];
    }
  std::ranges::sort(all, std::greater<>());
  all.resize(std::min<std::size_t>(all.size(), 4));
  middle.shares = {};
  float total = 0;
  for (const auto& [share, bone] : all) total += share;
  for (std::size_t k = 0; k < all.size(); ++k) {
    middle.shares.bone[k] = all[k].second;
    middle.shares.share[k] = all[k].first / total;
  }
  return middle;
}

/// Halves edges where the picture between their ends is another colour than the ends make.
class Refinement {
 public:
  Refinement(Surface& surface, const Colours& colours, std::size_t triangles)
      : surface_{surface}, colours_{colours}, most_{triangles} {}

  void run() {
    constexpr int most_rounds = 12;
    for (int round = 0; round < most_rounds; ++round)
      if (!halve_worst()) return;
  }

 private:
  using Edge = std::uint64_t;  ///< Two places, the lesser first: both sides of a seam are halved.

  Edge edge_of(std::uint32_t a, std::uint32_t b) const {
    const std::uint64_t low = std::min(place_[a], place_[b]), high = std::max(place_[a], place_[b]);
    return low << 32U | high;
  }

  /// How wrong the colour is along an edge, by its length: area that shows another colour.
  float fault(std::uint32_t a, std::uint32_t b) const {
    constexpr float least_edge = 0.004F, least_difference = 0.06F;
    const SurfaceVertex &from = surface_.vertices[a], &to = surface_.vertices[b];
    const float length = glm::distance(from.position, to.position);
    if (length < least_edge || !colours_.has_picture(from)) return 0;
    const Vec4 start = colours_.at(from), end = colours_.at(to);
    float worst = 0;
    for (const float at : {0.25F, 0.5F, 0.75F}) {
      SurfaceVertex probe = from;
      probe.uv = from.uv + at * (to.uv - from.uv);
      worst = std::max(worst, difference(colours_.at(probe), start + at * (end - start)));
    }
    return worst < least_difference ? 0 : worst * length;
  }

  bool halve_worst() {
    const std::size_t triangles = surface_.indices.size() / 3;
    if (triangles + 2 > most_) return false;
    place_ = same_place(surface_.vertices);
    std::unordered_map<Edge, float> fault_of;
    std::unordered_map<Edge, std::uint32_t> uses;
    for_each_edge([&](std::uint32_t a, std::uint32_t b) {
      float& worst = fault_of[edge_of(a, b)];
      worst = std::max(worst, fault(a, b));
      ++uses[edge_of(a, b)];
    });
    std::vector<std::pair<float, Edge>> wrong;
    for (const auto& [edge, size] : fault_of)
      if (size > 0) wrong.emplace_back(size, edge);
    if (wrong.empty()) return false;
    std::ranges::sort(wrong, std::greater<>());
    // Not all at once: the colours of the halves decide what is worst next.
    std::size_t room = std::min(most_ - triangles, std::max<std::size_t>(triangles / 3, 64));
    std::unordered_map<Edge, bool> halved;
    for (const auto& [size, edge] : wrong) {
      if (uses[edge] > room) break;
      room -= uses[edge];
      halved[edge] = true;
    }
    if (halved.empty()) return false;
    split(halved);
    return true;
  }

  template <typename Take>
  void for_each_edge(Take take) const {
    for (std::size_t k = 0; k + 2 < surface_.indices.size(); k += 3)
      for (std::size_t c = 0; c < 3; ++c)
        take(surface_.indices[k + c], surface_.indices[k + (c + 1) % 3]);
  }

  void split(const std::unordered_map<Edge, bool>& halved) {
    std::unordered_map<std::uint64_t, std::uint32_t> middle;  // by the two vertices
    const auto middle_of = [&](std::uint32_t a, std::uint32_t b) {
      const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
      const auto [it, is_new] =
          middle.emplace(key, static_cast<std::uint32_t>(surface_.vertices.size()));
      if (is_new)
        surface_.vertices.push_back(
            between(surface_.vertices[std::min(a, b)], surface_.vertices[std::max(a, b)]));
      return it->second;
    };
    std::vector<std::uint32_t> out;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      out.insert(out.end(), {a, b, c});
    };
    for (std::size_t k = 0; k + 2 < surface_.indices.size(); k += 3) {
      std::array<std::uint32_t, 3> v{surface_.indices[k], surface_.indices[k + 1],
                                     surface_.indices[k + 2]};
      const auto is_halved = [&](std::size_t c) {
        return halved.contains(edge_of(v[c], v[(c + 1) % 3]));
      };
      const int count = is_halved(0) + is_halved(1) + is_halved(2);
      // Turned so that the first edge is halved, and the last is not where one is not.
      const auto turn = [&] { std::ranges::rotate(v, v.begin() + 1); };
      while (count == 1 && !is_halved(0)) turn();
      while (count == 2 && is_halved(2)) turn();
      if (count == 0) {
        add(v[0], v[1], v[2]);
        continue;
      }
      const std::uint32_t m = middle_of(v[0], v[1]);
      if (count == 1) {
        add(v[0], m, v[2]);
        add(m, v[1], v[2]);
        continue;
      }
      const std::uint32_t n = middle_of(v[1], v[2]);
      if (count == 2) {
        add(m, v[1], n);
        add(v[0], m, n);
        add(v[0], n, v[2]);
        continue;
      }
      const std::uint32_t o = middle_of(v[2], v[0]);
      add(v[0], m, o);
      add(m, v[1], n);
      add(o, n, v[2]);
      add(m, n, o);
    }
    surface_.indices = std::move(out);
  }

  Surface& surface_;
  const Colours& colours_;
  std::size_t most_;
  std::vector<std::uint32_t> place_;
};

}  // namespace

ColouredSurface to_budget(Surface surface, const Springs& springs, const Colours& colours,
                          std::size_t triangles) {
  leave_out_clear(colours, surface);
  drop_unused(surface);
  const bool has_pictures = std::ranges::any_of(
      surface.vertices, [&](const SurfaceVertex& v) { return colours.has_picture(v); });
  if (surface.indices.size() > 3 * triangles) {
    const auto shape =
        has_pictures ? static_cast<std::size_t>(share_of_shape * static_cast<double>(triangles))
                     : triangles;
    weld(surface, false);
    // Seams of a picture hold their edges; where those alone are too many, they are let go.
    if (!simplify(surface, springs, shape, false) && surface.indices.size() > 3 * triangles) {
      weld(surface, true);
      if (!simplify(surface, springs, shape, false) && surface.indices.size() > 3 * triangles)
        simplify(surface, springs, shape, true);
    }
  }
  if (surface.indices.size() > 3 * triangles) surface.indices.resize(3 * triangles);
  if (has_pictures) Refinement(surface, colours, triangles).run();
  drop_unused(surface);
  ColouredSurface out{.surface = std::move(surface), .colour = {}};
  for (const SurfaceVertex& v : out.surface.vertices) out.colour.push_back(srgb_of(colours.at(v)));
  return out;
}

}  // namespace docent::character

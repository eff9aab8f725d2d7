#include "content/avatar/simplify.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <queue>

namespace docent::avatar {
namespace {

/// The mean squared distance to a set of planes as a function of place: p'Ap + 2b'p + c, and how
/// much area it stands for. Symmetric A as xx, xy, xz, yy, yz, zz.
struct Quadric {
  std::array<double, 6> a{};
  glm::dvec3 b{};
  double c = 0, weight = 0;

  void add_plane(const glm::dvec3& n, double offset, double area) {
    const std::array<double, 6> outer{n.x * n.x, n.x * n.y, n.x * n.z,
                                      n.y * n.y, n.y * n.z, n.z * n.z};
    for (std::size_t k = 0; k < 6; ++k) a[k] += area * outer[k];
    b += area * offset * n;
    c += area * offset * offset;
    weight += area;
  }
  Quadric operator+(const Quadric& other) const {
    Quadric sum = *this;
    for (std::size_t k = 0; k < 6; ++k) sum.a[k] += other.a[k];
    sum.b += other.b;
    sum.c += other.c;
    sum.weight += other.weight;
    return sum;
  }
  double error(const glm::dvec3& p) const {
    const double squared = a[0] * p.x * p.x + a[3] * p.y * p.y + a[5] * p.z * p.z +
                           2 * (a[1] * p.x * p.y + a[2] * p.x * p.z + a[4] * p.y * p.z) +
                           2 * glm::dot(b, p) + c;
    return weight > 0 ? std::max(squared / weight, 0.0) : 0.0;
  }
};

struct Collapse {
  double cost;
  std::uint32_t keep, drop;
  std::uint32_t keep_version, drop_version;

  bool operator>(const Collapse& other) const {
    if (cost != other.cost) return cost > other.cost;
    return keep != other.keep ? keep > other.keep : drop > other.drop;
  }
};

class Simplifier {
 public:
  Simplifier(TriangleSurface& surface, const SimplifyLimits& limits)
      : surface_{surface},
        limits_{limits},
        quadric_(surface.position.size()),
        touching_(surface.position.size()),
        version_(surface.position.size(), 0),
        alive_(surface.indices.size() / 3, true) {
    for (std::uint32_t t = 0; t < alive_.size(); ++t) add_triangle(t);
    for (std::uint32_t v = 0; v < version_.size(); ++v) offer_edges(v, true);
  }

  void run() {
    while (!queue_.empty()) {
      const Collapse next = queue_.top();
      queue_.pop();
      if (next.keep_version != version_[next.keep] || next.drop_version != version_[next.drop])
        continue;
      collapse(next.keep, next.drop);
    }
    compact();
  }

 private:
  std::uint32_t corner(std::uint32_t t, std::size_t k) const { return surface_.indices[3 * t + k]; }
  glm::dvec3 place(std::uint32_t v) const { return glm::dvec3(surface_.position[v]); }

  void add_triangle(std::uint32_t t) {
    const glm::dvec3 a = place(corner(t, 0));
    const glm::dvec3 normal = glm::cross(place(corner(t, 1)) - a, place(corner(t, 2)) - a);
    const double twice_area = glm::length(normal);
    for (std::size_t k = 0; k < 3; ++k) {
      touching_[corner(t, k)].push_back(t);
      if (twice_area > 1e-12)
        quadric_[corner(t, k)].add_plane(normal / twice_area, -glm::dot(normal / twice_area, a),
                                         twice_area);
    }
  }

  /// Vertices that share an edge with v, in ascending order.
  std::vector<std::uint32_t> neighbours(std::uint32_t v) const {
    std::vector<std::uint32_t> ring;
    for (const std::uint32_t t : touching_[v])
      for (std::size_t k = 0; k < 3; ++k)
        if (corner(t, k) != v) ring.push_back(corner(t, k));
    std::ranges::sort(ring);
    ring.erase(std::ranges::unique(ring).begin(), ring.end());
    return ring;
  }

  glm::dvec3 middle(std::uint32_t a, std::uint32_t b) const { return 0.5 * (place(a) + place(b)); }

  /// Of the two ends and the middle, the place with the least error.
  glm::dvec3 best_place(std::uint32_t a, std::uint32_t b, double& error) const {
    const Quadric sum = quadric_[a] + quadric_[b];
    glm::dvec3 best = middle(a, b);
    error = sum.error(best);
    for (const glm::dvec3& end : {place(a), place(b)}) {
      const double at_end = sum.error(end);
      if (at_end >= error) continue;
      error = at_end;
      best = end;
    }
    return best;
  }

  void offer_edges(std::uint32_t v, bool only_upwards) {
    for (const std::uint32_t other : neighbours(v)) {
      if (only_upwards && other < v) continue;
      double error = 0;
      best_place(v, other, error);
      const double length = glm::length(place(v) - place(other));
      if (error > static_cast<double>(limits_.error) * limits_.error) continue;
      // Among flat edges the short ones go first.
      const double cost = error + 1e-4 * length * length;
      queue_.push({cost, v, other, version_[v], version_[other]});
    }
  }

  /// Would the triangles that stay keep their faces up, and their edges short?
  bool keeps_shape(std::uint32_t v, std::uint32_t other, const glm::dvec3& moved) const {
    for (const std::uint32_t t : touching_[v]) {
      std::array<glm::dvec3, 3> before;
      std::array<glm::dvec3, 3> after;
      bool goes = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t c = corner(t, k);
        goes = goes || c == other;
        before[k] = place(c);
        after[k] = c == v ? moved : before[k];
        if (c != v && glm::length(before[k] - moved) > static_cast<double>(limits_.edge))
          return false;
      }
      if (goes) continue;
      const glm::dvec3 n0 = glm::cross(before[1] - before[0], before[2] - before[0]);
      const glm::dvec3 n1 = glm::cross(after[1] - after[0], after[2] - after[0]);
      if (glm::dot(n0, n1) < 0.5 * glm::length(n0) * glm::length(n1)) return false;
      // No needles: they shade badly.
      const double longest =
          std::max({glm::length(after[1] - after[0]), glm::length(after[2] - after[1]),
                    glm::length(after[0] - after[2])});
      if (glm::length(n1) < 0.25 * longest * longest) return false;
    }
    return true;
  }

  /// An edge of a closed surface may go where exactly two vertices see both its ends.
  bool keeps_topology(std::uint32_t a, std::uint32_t b) const {
    const auto around_a = neighbours(a);
    const auto around_b = neighbours(b);
    std::vector<std::uint32_t> shared;
    std::ranges::set_intersection(around_a, around_b, std::back_inserter(shared));
    return shared.size() == 2;
  }

  void collapse(std::uint32_t keep, std::uint32_t drop) {
    double error = 0;
    const glm::dvec3 moved = best_place(keep, drop, error);
    if (!keeps_topology(keep, drop) || !keeps_shape(keep, drop, moved) ||
        !keeps_shape(drop, keep, moved))
      return;
    surface_.position[keep] = Vec3(moved);
    quadric_[keep] = quadric_[keep] + quadric_[drop];
    for (const std::uint32_t t : touching_[drop]) {
      const auto end = surface_.indices.begin() + 3 * t + 3;
      if (std::find(end - 3, end, keep) != end) {
        alive_[t] = false;
        for (std::size_t k = 0; k < 3; ++k)
          if (corner(t, k) != drop) std::erase(touching_[corner(t, k)], t);
      } else {
        std::replace(end - 3, end, drop, keep);
        touching_[keep].push_back(t);
      }
    }
    touching_[drop].clear();
    ++version_[keep];
    ++version_[drop];
    offer_edges(keep, false);
  }

  void compact() {
    std::vector<std::uint32_t> moved_to(surface_.position.size(), 0);
    std::vector<Vec3> position;
    for (std::uint32_t v = 0; v < touching_.size(); ++v) {
      if (touching_[v].empty()) continue;
      moved_to[v] = static_cast<std::uint32_t>(position.size());
      position.push_back(surface_.position[v]);
    }
    std::vector<std::uint32_t> indices;
    for (std::uint32_t t = 0; t < alive_.size(); ++t)
      if (alive_[t])
        for (std::size_t k = 0; k < 3; ++k) indices.push_back(moved_to[corner(t, k)]);
    surface_.position = std::move(position);
    surface_.indices = std::move(indices);
  }

  TriangleSurface& surface_;
  SimplifyLimits limits_;
  std::vector<Quadric> quadric_;
  std::vector<std::vector<std::uint32_t>> touching_;
  std::vector<std::uint32_t> version_;
  std::vector<bool> alive_;
  std::priority_queue<Collapse, std::vector<Collapse>, std::greater<>> queue_;
};

}  // namespace

void simplify(TriangleSurface& surface, const SimplifyLimits& limits) {
  Simplifier(surface, limits).run();
}

}  // namespace docent::avatar

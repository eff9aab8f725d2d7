#include "content/object/turned.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "content/import/object/one_primitive.h"
#include "runtime/model/exhibit/object.h"

namespace docent::object {
namespace {

using import::gltf::Primitive;

/// Pixels of 1080 that the object fills.
constexpr double off_along = 0.25, off_around = 0.45, lines = 1080;
constexpr double on_axis = 1e-9;

std::size_t columns_for(double widest, double longest) {
  const double off = off_around / lines * longest;
  const double angle = std::acos(1 - std::min(1.0, off / widest));
  constexpr std::size_t least = 24, step = 4;
  const auto needed = static_cast<std::size_t>(std::ceil(std::numbers::pi / angle));
  return std::max(least, (needed + step - 1) / step * step);
}

/// As fine as there are triangles for.
Profile fitting_profile(const Turned& turned, double longest, std::size_t columns) {
  double tolerance = off_along / lines * longest;
  Profile profile = profile_of(turned.profile, tolerance);
  while (2 * columns * (profile.points.size() + 1) > ObjectDetail::most_triangles &&
         tolerance < longest) {
    tolerance *= 1.5;
    profile = profile_of(turned.profile, tolerance);
  }
  return profile;
}

/// Where the outside begins to rise, and where its rim is.
std::pair<std::size_t, std::size_t> outside_of(const std::vector<Vec2>& profile) {
  const auto rim =
      static_cast<std::size_t>(std::ranges::max_element(profile, {}, &Vec2::y) - profile.begin());
  const double rise = 1e-3 * longest_side(profile);
  std::size_t foot = 0;
  while (foot + 1 < rim && profile[foot + 1].y < profile[0].y + rise) ++foot;
  return {foot, rim};
}

/// Rings of vertices, each with its seam at the back.
class Lathe {
 public:
  explicit Lathe(std::size_t columns) : columns_(columns) {}

  /// A strip of the surface, from the first to the last of these points. `v` by point.
  Primitive strip(std::span<const Vec2> points, std::span<const float> v) const {
    Primitive strip;
    for (std::size_t i = 0; i < points.size(); ++i) add_ring(points[i], v[i], strip);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const bool from_axis = points[i].x < on_axis, to_axis = points[i + 1].x < on_axis;
      for (std::size_t k = 0; k < columns_; ++k) {
        const std::uint32_t a = corner(i, k), b = corner(i, k + 1), c = corner(i + 1, k + 1),
                            d = corner(i + 1, k);
        if (!from_axis) strip.indices.insert(strip.indices.end(), {a, b, to_axis ? d : c});
        if (!to_axis) strip.indices.insert(strip.indices.end(), {a, c, d});
      }
    }
    return strip;
  }

 private:
  std::uint32_t corner(std::size_t ring, std::size_t column) const {
    return static_cast<std::uint32_t>(ring * (columns_ + 1) + column);
  }

  void add_ring(Vec2 at, float v, Primitive& strip) const {
    for (std::size_t k = 0; k <= columns_; ++k) {
      // The last is where the first is, to the bit.
      const double turn = 2 * std::numbers::pi *
                          (static_cast<double>(k % columns_) / static_cast<double>(columns_) - 0.5);
      strip.position.emplace_back(static_cast<float>(at.x * std::sin(turn)),
                                  static_cast<float>(at.y),
                                  static_cast<float>(at.x * std::cos(turn)));
      strip.uv.emplace_back(static_cast<float>(k) / static_cast<float>(columns_), v);
    }
  }

  std::size_t columns_;
};

/// How far up the outside each point is, of 1 at its foot to 0 at its rim, as pictures lie.
std::vector<float> rows_of(std::span<const Vec2> outside) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < outside.size(); ++i)
    along.push_back(along.back() + glm::distance(outside[i - 1], outside[i]));
  std::vector<float> rows;
  for (const double at : along) rows.push_back(static_cast<float>(1 - at / along.back()));
  return rows;
}

}  // namespace

import::object::ObjectFile turn(const Turned& turned) {
  const double longest = longest_side(turned.profile);
  const double widest = std::ranges::max(turned.profile, {}, &Vec2::x).x;
  const std::size_t columns = columns_for(widest, longest);
  std::vector<Vec2> points = fitting_profile(turned, longest, columns).points;
  if (points.front().x >= on_axis) points.insert(points.begin(), {0, points.front().y});
  if (points.back().x >= on_axis) points.emplace_back(0, points.back().y);

  const Lathe lathe(columns);
  const auto [foot, rim] = outside_of(points);
  const std::span<const Vec2> all(points);
  const std::vector<float> plain(points.size(), 0.0F);
  const auto plain_strip = [&](std::size_t first, std::size_t last) {
    return lathe.strip(all.subspan(first, last - first + 1), plain);
  };
  std::vector<Primitive> strips;
  if (turned.wrapped.rgba.empty()) {
    strips.push_back(plain_strip(0, points.size() - 1));
  } else {
    const auto outside = all.subspan(foot, rim - foot + 1);
    strips = {plain_strip(0, foot), lathe.strip(outside, rows_of(outside)),
              plain_strip(rim, points.size() - 1)};
  }
  for (Primitive& strip : strips) strip.material = 0;
  import::object::ObjectFile file;
  file.is_in_metres = file.says_up = true;
  if (!turned.wrapped.rgba.empty()) strips[1].material = 1;
  file.model = import::object::scene_of(std::move(strips));
  file.model.materials.push_back({.name = "", .base = Vec4(turned.colour, 1)});
  if (!turned.wrapped.rgba.empty()) {
    file.model.images.push_back(turned.wrapped);
    file.model.materials.push_back(
        {.name = "", .image = 0, .wrap = {import::gltf::Wrap::Repeat, import::gltf::Wrap::Clamp}});
  }
  return file;
}

}  // namespace docent::object

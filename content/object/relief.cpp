#include "content/object/relief.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "content/import/gltf/colour.h"
#include "content/import/object/one_primitive.h"
#include "content/object/cut_out.h"
#include "content/object/inflate.h"
#include "content/object/trace.h"
#include "platform/image/image.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"

namespace docent::object {
namespace {

using Ring = std::vector<Vec2>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<
                CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>,
                CGAL::Constrained_triangulation_face_base_2<Kernel>>>;

/// Of 1080 pixels that the thing fills: its corners are so near the traced outline.
constexpr double off = 0.5, lines = 1080;
/// So many points of its swelling lie along its longest side.
constexpr double points_along = 56;
/// Of the cushion's height: how far its faces swell, and how thick the rim between them is.
constexpr double swelling = 0.55, rim = 0.16;

/// Corners and triangles in the plane, counter-clockwise.
struct Flat {
  std::vector<Vec2> points;  ///< First those of the rings, one after another.
  std::size_t on_outline = 0;
  std::vector<std::uint32_t> triangles;
};

double distance_to(const std::vector<Ring>& rings, Vec2 p) {
  double least = 1e18;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      least = std::min(
          least, nearest_on_segment(p, ring[i], ring[(i + 1) % ring.size()]).distance_squared);
  return std::sqrt(least);
}

bool is_within(const std::vector<Ring>& rings, Vec2 p) {
  return std::ranges::count_if(rings, [&](const Ring& ring) { return contains(ring, p); }) % 2 == 1;
}

/// Lines of points along the outline, within it: so that it rises evenly from there.
void add_rows_along(const std::vector<Ring>& rings, double step, std::vector<Vec2>& points) {
  for (const double in : {0.3 * step, 0.9 * step})
    for (const Ring& ring : rings) {
      double next = 0;  // along the side
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], along = ring[(i + 1) % ring.size()] - a;
        const double length = std::hypot(along.x, along.y);
        for (; next < length; next += 0.6 * step) {
          const Vec2 p = a + (next * along + in * left_of(along)) / length;
          if (is_within(rings, p) && distance_to(rings, p) > 0.95 * in) points.push_back(p);
        }
        next -= length;
      }
    }
}

/// Rows of points, each row half a step beside the one below, where there is room to the outline.
void add_rows_across(const std::vector<Ring>& rings, double step, std::vector<Vec2>& points) {
  Vec2 low = rings.front().front(), high = low;
  for (const Vec2 p : rings.front()) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool is_odd = false;
  for (double y = low.y + step / 2; y < high.y; y += step * std::sqrt(0.75), is_odd = !is_odd)
    for (double x = low.x + (is_odd ? step : step / 2); x < high.x; x += step)
      if (is_within(rings, {x, y}) && distance_to(rings, {x, y}) > 1.4 * step)
        points.emplace_back(x, y);
}

Flat flat_of(const std::vector<Ring>& rings, double step) {
  Flat flat;
  for (const Ring& ring : rings) flat.points.insert(flat.points.end(), ring.begin(), ring.end());
  flat.on_outline = flat.points.size();
  add_rows_along(rings, step, flat.points);
  add_rows_across(rings, step, flat.points);
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> handles;
  for (std::size_t i = 0; i < flat.points.size(); ++i) {
    const auto before = cdt.number_of_vertices();
    handles.push_back(cdt.insert({flat.points[i].x, flat.points[i].y}));
    // Of two in one place the first is meant.
    if (cdt.number_of_vertices() > before) handles.back()->info() = static_cast<std::uint32_t>(i);
  }
  std::size_t first = 0;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      cdt.insert_constraint(handles[first + i], handles[first + (i + 1) % ring.size()]);
    first += ring.size();
  }
  for (const auto face : cdt.finite_face_handles()) {
    Vec2 middle{};
    for (int k = 0; k < 3; ++k) middle += flat.points[face->vertex(k)->info()] / 3.0;
    if (!is_within(rings, middle)) continue;
    for (int k = 0; k < 3; ++k) flat.triangles.push_back(face->vertex(k)->info());
  }
  return flat;
}

/// Its front and its back with their picture, in pixels.
import::gltf::Primitive faces_of(const Flat& flat, const Cushion& cushion, double half_rim,
                                 const Mask& mask) {
  import::gltf::Primitive faces;
  const auto count = static_cast<std::uint32_t>(flat.points.size());
  for (const double side : {1.0, -1.0})
    for (std::size_t i = 0; i < flat.points.size(); ++i) {
      const Vec2 p = flat.points[i];
      const double swells = i < flat.on_outline ? 0 : swelling * cushion.height_at(p);
      faces.position.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y),
                                  static_cast<float>(side * (half_rim + swells)));
      faces.uv.emplace_back(static_cast<float>(p.x / mask.width),
                            static_cast<float>(1 - p.y / mask.height));
    }
  for (std::size_t k = 0; k + 2 < flat.triangles.size(); k += 3) {
    const std::uint32_t a = flat.triangles[k], b = flat.triangles[k + 1], c = flat.triangles[k + 2];
    faces.indices.insert(faces.indices.end(), {a, b, c, count + a, count + c, count + b});
  }
  return faces;
}

/// What joins them: of the colours beside it, a little darker, as where a thing turns away.
import::gltf::Primitive rim_of(const std::vector<Ring>& rings, double half_rim, const Mask& mask,
                               const Pixels& picture) {
  constexpr std::uint32_t blurred = 40;
  constexpr float darker = 0.75F;
  import::gltf::Model colours;
  colours.images.push_back(image::shrink(picture, blurred));
  colours.materials.push_back({.name = "", .image = 0});
  import::gltf::Primitive made;
  for (const Ring& ring : rings) {
    const auto first = static_cast<std::uint32_t>(made.position.size());
    const auto size = static_cast<std::uint32_t>(ring.size());
    for (const Vec2 p : ring) {
      const glm::vec2 uv{p.x / mask.width, 1 - p.y / mask.height};
      const Vec4 colour = import::gltf::colour_at(colours, 0, uv, Vec4{darker, darker, darker, 1});
      for (const double side : {1.0, -1.0}) {
        made.position.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y),
                                   static_cast<float>(side * half_rim));
        made.colour.push_back(colour);
      }
    }
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % size);
      made.indices.insert(made.indices.end(), {a + 1, b + 1, b, a + 1, b, a});
    }
  }
  return made;
}

}  // namespace

import::object::ObjectFile relief_of(const Pixels& picture, const std::string& file) {
  CutOut cut = cut_out(picture, file);
  const double longest = std::max(cut.mask.width, cut.mask.height);
  const std::vector<Ring> rings = trace(cut.mask, off / lines * longest);
  const Cushion cushion(rings);
  const double half_rim = rim * cushion.highest() / 2;
  std::vector<import::gltf::Primitive> parts{
      faces_of(flat_of(rings, longest / points_along), cushion, half_rim, cut.mask),
      rim_of(rings, half_rim, cut.mask, cut.picture)};
  for (import::gltf::Primitive& part : parts)
    for (Vec3& p : part.position) p /= static_cast<float>(cut.mask.height);
  parts[0].material = 0;
  import::object::ObjectFile made;
  made.is_in_metres = made.says_up = true;
  made.model = import::object::scene_of(std::move(parts));
  constexpr std::uint32_t largest_picture = 768;
  made.model.images.push_back(image::shrink(std::move(cut.picture), largest_picture));
  made.model.materials.push_back(
      {.name = "", .image = 0, .wrap = {import::gltf::Wrap::Clamp, import::gltf::Wrap::Clamp}});
  if (cut.other_pieces > 0)
    made.model.warnings.push_back(fmt::format(
        "it shows {} pieces, and the largest alone stands there", cut.other_pieces + 1));
  return made;
}

}  // namespace docent::object

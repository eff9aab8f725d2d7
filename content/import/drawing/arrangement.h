#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::import {

/// A straight line of a wall, or of what closes one.
struct WallLine {
  Vec2 a{}, b{};
  std::uint32_t kind = 0;  ///< The caller's; travels with the pieces.
};

/// Kinds from this one on shut an opening: there the wall does not go on.
constexpr std::uint32_t first_closing_kind = 2;

struct ArrangementEdge {
  std::uint32_t from = 0, to = 0;  ///< Vertices.
  std::uint32_t kind = 0;
};

/// What wall lines make of the plane: pieces that meet only at their ends.
///
/// Half-edge 2e runs along edge e, 2e + 1 against it; the face of a half-edge lies to its left.
struct Arrangement {
  std::vector<Vec2> vertex;
  std::vector<ArrangementEdge> edge;
  std::size_t snapped = 0;  ///< Ends that were put on a neighbour's end or line.

  std::uint32_t origin(std::uint32_t half) const {
    return half % 2 == 0 ? edge[half / 2].from : edge[half / 2].to;
  }
  std::uint32_t head(std::uint32_t half) const { return origin(half ^ 1U); }
};

/// Ends that are nearer than this are one; an end nearer than this to a line lies on it. Metres.
constexpr double snap_distance = 0.01;

/// Cuts the lines where they cross or touch. Nothing where there would be more than 400,000 pieces.
std::optional<Arrangement> arrange(std::span<const WallLine> lines);

/// Its pieces as lines again.
std::vector<WallLine> lines_of(const Arrangement& arrangement);

/// Takes away the ends of lines that run past a corner by less than `reach` metres; returns how
/// many.
std::size_t trim_overruns(Arrangement& arrangement, double reach);

/// Takes away what ends in nothing, again and again; returns how many pieces that were.
std::size_t remove_loose_pieces(Arrangement& arrangement);

/// The half-edges that leave each vertex, counter-clockwise by their direction from west.
std::vector<std::vector<std::uint32_t>> leaving_half_edges(const Arrangement& arrangement);

/// A region of the plane, as the half-edges around it.
struct Face {
  std::vector<std::uint32_t> outer;               ///< Counter-clockwise.
  std::vector<std::vector<std::uint32_t>> holes;  ///< Clockwise.
  double area = 0;                                ///< Without its holes.
};

/// All bounded regions; `face_of` says for each half-edge in which face it is, `no_face` outside.
struct Faces {
  std::vector<Face> face;
  std::vector<std::uint32_t> face_of;
};
constexpr std::uint32_t no_face = 0xffffffff;
Faces trace_faces(const Arrangement& arrangement);

/// The corners of a cycle, those on straight lines left out.
std::vector<Vec2> corners_of(const Arrangement& arrangement, std::span<const std::uint32_t> cycle);

}  // namespace docent::import

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace docent::import {

/// What the strokes of a layer draw, as far as its name tells.
enum class LayerKind : std::uint8_t {
  Unknown,
  Wall,    ///< Walls, partitions, columns, outlines to walk in.
  Window,  ///< Windows, glazing, openings: they close a room as walls do.
  Door,
  Room,    ///< Outlines of rooms.
  Stairs,  ///< Stairs, lifts, ramps.
  Other,   ///< Dimensions, texts, furniture, foundations: no room's edge.
};

/// By words of eleven languages in the last part of the name (`xref$0$A-WALL` is A-WALL).
LayerKind kind_of_layer(std::string_view name);

/// What `--layers` says of a layer: `by_kind` has names, or parts with `*`, for `wall`, `door`,
/// `window`, `room`, `stairs`, `other`, several parted by commas. Where walls are named, what is
/// not named is Other.
LayerKind kind_of_layer(std::string_view name, const std::map<std::string, std::string>& by_kind);

}  // namespace docent::import

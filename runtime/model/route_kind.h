#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace docent {

/// The kinds of route: by which kind of way a guide leads.
enum class RouteKind : std::uint8_t { Shortest, Skeleton, Offset };

/// The pattern of a kind's line, which tells kinds apart without colours too. Pieces have round
/// ends; a piece without length is a dot. Without a period the line is one piece.
struct LinePattern {
  float period = 0, piece = 0;  ///< On the floor, metres: from piece to piece, and its length.
  double drawn_piece = 0, drawn_gap = 0;  ///< On a drawn plan, in widths of the line.
  int sample_pieces = 1;                  ///< How many are shown beside the kind's name.

  bool is_solid() const noexcept { return period == 0; }
};

/// All that is told of a kind. A further kind is a row in the table below, its search in
/// `runtime/path/route.cpp`, and its words `route_NAME` in every language of the museum.
struct RouteKindInfo {
  RouteKind kind{};
  std::string_view name;     ///< In commands, scripted visits and keys of words: stable.
  std::string_view legend;   ///< On a drawn plan.
  std::uint32_t colour = 0;  ///< 0xRRGGBB.
  LinePattern pattern;
};

inline constexpr std::array<RouteKindInfo, 3> route_kinds{{
    {RouteKind::Shortest, "shortest", "shortest path", 0xD2452D, {}},  // vermilion
    {RouteKind::Skeleton,                                              // teal, long dashes
     "skeleton",
     "path on the medial axis",
     0x1D7874,
     {.period = 1.2F, .piece = 0.88F, .drawn_piece = 3, .drawn_gap = 1.8, .sample_pieces = 2}},
    {RouteKind::Offset,  // ochre, round dots
     "offset",
     "path along the walls",
     0xC0841A,
     {.period = 0.36F, .piece = 0, .drawn_piece = 0, .drawn_gap = 1.7, .sample_pieces = 4}},
}};

constexpr const RouteKindInfo& info_of(RouteKind kind) noexcept {
  return route_kinds[static_cast<std::size_t>(kind)];
}

}  // namespace docent

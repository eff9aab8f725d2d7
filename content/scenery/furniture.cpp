#include "content/scenery/furniture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/model/geometry/polygon.h"

namespace docent::scenery {
namespace {

double perimeter(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 d = outline[(i + 1) % outline.size()] - outline[i];
    sum += std::hypot(d.x, d.y);
  }
  return sum;
}

/// 1 for a circle, 0.785 for a square.
double roundness(const Outline& outline) {
  const double around = perimeter(outline);
  return 4 * std::numbers::pi * signed_area(outline) / (around * around);
}

/// How wide the outline is across `direction`.
double extent(const Outline& outline, Vec2 direction) {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (const Vec2 p : outline) {
    low = std::min(low, dot(p, direction));
    high = std::max(high, dot(p, direction));
  }
  return high - low;
}

struct Extents {
  double least = std::numeric_limits<double>::max(), most = 0;
};

Extents extents(const Outline& outline) {
  Extents e;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 side = outline[(i + 1) % outline.size()] - outline[i];
    const double length = std::hypot(side.x, side.y);
    if (length == 0) continue;
    const double across = extent(outline, left_of(side) / length);
    const double along = extent(outline, side / length);
    e.least = std::min(e.least, std::min(across, along));
    e.most = std::max(e.most, std::max(across, along));
  }
  return e;
}

/// A convex outline's area fills its hull; an L does not. We compare with the widest box.
bool is_compact(const Outline& outline, const Extents& e) {
  return signed_area(outline) > 0.55 * e.least * e.most;
}

/// An octagon is meant as one; from ten sides on, a circle is.
bool is_round(const Outline& outline) {
  return outline.size() >= 10 && roundness(outline) > 0.92;
}

HoleKind kind_of(const Outline& outline, bool holds_exhibit) {
  constexpr double largest_case = 4.5;
  constexpr double largest_empty_case = 2.6;
  constexpr double largest_column = 1.3;
  constexpr double thinnest_case = 0.4;
  const Extents e = extents(outline);
  if (e.least < thinnest_case && e.most > 3 * e.least) return HoleKind::Wall;
  if (!is_compact(outline, e)) return HoleKind::Wall;
  if (holds_exhibit) {
    if (e.most > largest_case) return HoleKind::Wall;
    return roundness(outline) > 0.9 || e.most < 1.05 ? HoleKind::Pedestal : HoleKind::Case;
  }
  if (is_round(outline) && e.most < largest_column) return HoleKind::Column;
  if (e.most < 0.75) return HoleKind::Column;
  return e.most < largest_empty_case ? HoleKind::Case : HoleKind::Wall;
}

/// A round outline with more corners, so that it looks round from nearby too; any other as it is.
/// Plans draw circles with a dozen corners: the true circle goes a centimetre beyond their sides.
Outline rounded(const Outline& outline) {
  if (!is_round(outline)) return outline;
  Vec2 centre{};
  for (const Vec2 p : outline) centre += p / static_cast<double>(outline.size());
  double radius = 0;
  for (const Vec2 p : outline)
    radius += std::hypot(p.x - centre.x, p.y - centre.y) / static_cast<double>(outline.size());
  constexpr int corners = 40;
  Outline circle;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    circle.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return circle;
}

// Heights of furniture, metres.
constexpr double toe_height = 0.07;
constexpr double case_height = 0.74;
constexpr double pedestal_height = 0.72;
constexpr double low_pedestal_height = 0.36;
constexpr double bevel = 0.025;

bool is_low_pedestal(const Outline& outline) {
  return extents(outline).most > 2.0;
}

/// A body that stands on a shadow gap and has its upper edge taken off.
void build_body(const Outline& outline, double height, MeshBuilder& mesh) {
  const bool round = is_round(outline);
  const Outline toe = inset(outline, 0.05);
  const std::array low{0.0, toe_height};
  mesh.use(Surface::CutFace);
  mesh.sides(toe, low, round);
  mesh.use(Surface::CaseBody);
  const std::array body{toe_height, 0.3, 0.6 * height, height - bevel};
  mesh.sides(outline, std::span(body).subspan(height < 0.5 ? 2 : 0), round);
  if (height < 0.5) {
    const std::array lower{toe_height, 0.6 * height};
    mesh.sides(outline, lower, round);
  }
  const Outline rim = inset(outline, bevel);
  mesh.slope(outline, height - bevel, rim, height);
  mesh.lid(rim, height);
}

/// A pane with a brighter rim, as the cut edge of glass is.
void build_pane(const std::array<Vec3, 4>& corner, MeshBuilder& mesh) {
  constexpr std::uint8_t clear = 14;
  constexpr std::uint8_t edge = 110;
  constexpr float rim = 0.013F;
  const Vec3 right = corner[1] - corner[0];
  const Vec3 up = corner[3] - corner[0];
  const float width = std::sqrt(glm::dot(right, right));
  const float height = std::sqrt(glm::dot(up, up));
  if (width <= 3 * rim || height <= 3 * rim) return;
  const Vec3 dx = right * (rim / width);
  const Vec3 dy = up * (rim / height);
  const std::array<Vec3, 4> inner{corner[0] + dx + dy, corner[1] - dx + dy, corner[2] - dx - dy,
                                  corner[3] + dx - dy};
  mesh.glass_opacity(clear);
  mesh.quad(inner);
  mesh.glass_opacity(edge);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    mesh.quad({corner[i], corner[j], inner[j], inner[i]});
  }
}

void build_glass(const Outline& outline, MeshBuilder& mesh) {
  const Outline pane = inset(outline, 0.05);
  mesh.use(Surface::Glass);
  for (std::size_t i = 0; i < pane.size(); ++i) {
    const Vec2 a = pane[i];
    const Vec2 b = pane[(i + 1) % pane.size()];
    build_pane({to_world(a, case_height), to_world(b, case_height), to_world(b, glass_top),
                to_world(a, glass_top)},
               mesh);
  }
  if (pane.size() == 4) {
    build_pane({to_world(pane[0], glass_top), to_world(pane[1], glass_top),
                to_world(pane[2], glass_top), to_world(pane[3], glass_top)},
               mesh);
  } else {
    mesh.glass_opacity(20);
    mesh.lid(pane, glass_top);
  }
}

constexpr double board_thickness = 0.035;

/// A board with a picture on its front, and on its back where it stands free. The board leans back
/// by `lean` radians about its lower edge.
struct Board {
  Vec2 foot{};  ///< Floor frame, middle of the lower front edge.
  double heading = 0, bottom = 0, width = 1, height = 1, lean = 0, thickness = board_thickness;
  double border = 0.03;  ///< Of frame round the picture.
  bool two_sided = false;
};

void build_board(const Board& board, std::int32_t exhibit, MeshBuilder& mesh) {
  const Vec2 forward{std::cos(board.heading), std::sin(board.heading)};
  const Vec2 right = left_of(forward);  // of the picture, as one looks at it
  const auto at = [&](double x, double y, double depth) {
    const double back = y * std::sin(board.lean) + depth * std::cos(board.lean);
    const double height = board.bottom + y * std::cos(board.lean) - depth * std::sin(board.lean);
    return to_world(board.foot + right * x - forward * back, height);
  };
  const double x = board.width / 2;
  const double y = board.height;
  const double back = board.thickness;
  const double b = board.border;
  const std::array<Vec3, 4> front{at(-x, 0, 0), at(x, 0, 0), at(x, y, 0), at(-x, y, 0)};
  const std::array<Vec3, 4> rear{at(x, 0, back), at(-x, 0, back), at(-x, y, back), at(x, y, back)};
  mesh.use(board.two_sided ? Surface::Object : Surface::Frame, exhibit);
  mesh.quad(front);
  mesh.quad(rear);
  mesh.quad({front[1], rear[0], rear[3], front[2]});
  mesh.quad({rear[1], front[0], front[3], rear[2]});
  mesh.quad({front[3], front[2], rear[3], rear[2]});
  mesh.quad({rear[1], rear[0], front[1], front[0]});

  constexpr double proud = 0.004;  // metres the picture lies before its frame
  const std::array<std::array<float, 2>, 4> uv{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  mesh.use(Surface::Picture, exhibit);
  mesh.quad({at(b - x, b, -proud), at(x - b, b, -proud), at(x - b, y - b, -proud),
             at(b - x, y - b, -proud)},
            uv);
  if (board.two_sided)
    mesh.quad({at(x - b, b, back + proud), at(b - x, b, back + proud),
               at(b - x, y - b, back + proud), at(x - b, y - b, back + proud)},
              uv);
}

/// Width and height of a picture of this aspect inside a box.
Vec2 fitted(double aspect, Vec2 box) {
  const double a = std::clamp(aspect, 0.25, 4.0);
  return box.x / a <= box.y ? Vec2{box.x, box.x / a} : Vec2{box.y * a, box.y};
}

/// Metres: a frame ends below the cut of its wall.
constexpr double lowest_on_wall = 0.42, highest_on_wall = cut_height - 0.06;

Board board_on_wall(const ExhibitStand& stand) {
  const Vec2 size = fitted(stand.aspect, {1.8, highest_on_wall - lowest_on_wall});
  const Vec2 forward{std::cos(stand.placement.heading), std::sin(stand.placement.heading)};
  constexpr double depth = 0.06;
  return {.foot = stand.placement.position + forward * depth,
          .heading = stand.placement.heading,
          .bottom = highest_on_wall - size.y,
          .width = size.x,
          .height = size.y,
          .thickness = depth - 0.01,
          .border = 0.045};
}

/// What shows of a base beside what stands on it, metres.
constexpr double base_rim = 0.03;

bool has_base(const ExhibitStand& stand) {
  return stand.taken.x > 4 * base_rim && stand.taken.y > 4 * base_rim;
}

/// How far it is from a point within an outline to its edge, along a direction; 0 outside.
double reach(const Outline& outline, Vec2 from, Vec2 direction) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], side = outline[(i + 1) % outline.size()] - a;
    const double across = cross(direction, side);
    if (across == 0) continue;
    const double along = cross(a - from, side) / across;
    const double share = cross(a - from, direction) / across;
    if (along >= 0 && share >= 0 && share <= 1) least = std::min(least, along);
  }
  return least < std::numeric_limits<double>::max() ? least : 0;
}

double depth_of(const Board& board) {
  return board.height * std::sin(board.lean) + board.thickness;
}

/// Makes a board that stands about `foot` so small, and moves it as little, that nothing of it is
/// nearer than `margin` to the edge of what it stands on: the pane of a case, or a pedestal's edge.
void keep_within(const Outline& outline, double margin, Board& board) {
  const Outline inner = inset(outline, margin);
  const Vec2 forward{std::cos(board.heading), std::sin(board.heading)};
  const Vec2 right = left_of(forward);
  const Vec2 foot = board.foot;
  const double before = reach(inner, foot, forward), behind = reach(inner, foot, -forward);
  const double one = reach(inner, foot, right), other = reach(inner, foot, -right);
  constexpr double smallest = 0.12, smaller = 0.95;
  for (;; board.width *= smaller, board.height *= smaller) {
    const Vec2 half = Vec2{board.width, depth_of(board)} / 2.0;
    const double along = std::min(std::max(0.0, half.y - behind), before - half.y);
    const double aside = std::min(std::max(0.0, half.x - other), one - half.x);
    board.foot = foot + forward * along + right * aside;
    const Outline stands = rectangle(board.foot, board.heading, half);
    if (std::ranges::all_of(stands, [&](Vec2 p) { return contains(inner, p); })) return;
    if (board.width < smallest || board.height < smallest) return;
  }
}

Board standing_board(const ExhibitStand& stand) {
  const bool in_glass = stand.on == HoleKind::Case;
  Vec2 room{1.0, 1.05};
  double bottom = 0.0;
  if (stand.hole) {
    bottom = top_of(stand.on, *stand.hole);
    room = is_low_pedestal(*stand.hole) ? Vec2{1.7, 1.8} : Vec2{1.4, 1.05};
    if (in_glass) room = {1.4, 0.72};
  } else if (has_base(stand)) {
    room.x = std::min(stand.taken.x, 2.5) - 2 * base_rim;
    room.y = std::clamp(1.75 * room.x, 1.05, 1.8);
  }
  const Vec2 size = fitted(stand.aspect, room);
  Board board{.foot = stand.placement.position,
              .heading = stand.placement.heading,
              .bottom = bottom + 0.03,
              .width = size.x,
              .height = size.y,
              .lean = in_glass ? 0.42 : 0.24,
              .border = 0.02,
              .two_sided = true};
  if (stand.hole) keep_within(*stand.hole, in_glass ? 0.1 : 0.05, board);
  board.foot += depth_of(board) / 2 * Vec2{std::cos(board.heading), std::sin(board.heading)};
  return board;
}

}  // namespace

double top_of(HoleKind kind, const Outline& outline) {
  if (kind == HoleKind::Case) return case_height;
  return is_low_pedestal(outline) ? low_pedestal_height : pedestal_height;
}

void build_plinth(const Outline& outline, double height, MeshBuilder& mesh) {
  constexpr double least_body = 0.2;
  if (height >= least_body) return build_body(outline, height, mesh);
  mesh.use(Surface::CaseBody);
  const std::array rows{0.0, height};
  mesh.sides(outline, rows);
  mesh.lid(outline, height);
}

Outline outline_of(const FloorPlan& plan, const Ring& ring) {
  const auto first = plan.vertex.begin() + ring.first;
  Outline outline(first, first + ring.count);
  if (signed_area(outline) < 0) std::reverse(outline.begin(), outline.end());
  return outline;
}

std::vector<HoleKind> hole_kinds(const FloorPlan& plan, std::span<const Exhibit> exhibits) {
  std::vector<HoleKind> kinds;
  for (const Ring& ring : plan.ring) {
    const auto first = plan.vertex.begin() + ring.first;
    if (signed_area(Outline(first, first + ring.count)) >= 0) {
      kinds.push_back(HoleKind::Wall);
      continue;
    }
    const Outline outline = outline_of(plan, ring);
    const bool holds = std::any_of(exhibits.begin(), exhibits.end(), [&](const Exhibit& e) {
      return e.place == ExhibitPlace::InCase && contains(outline, e.placement.position);
    });
    kinds.push_back(kind_of(outline, holds));
  }
  return kinds;
}

void build_hole(HoleKind kind, const Outline& hole, MeshBuilder& mesh,
                std::vector<Blocker>& blockers) {
  if (kind == HoleKind::Wall || kind == HoleKind::Flight) return;
  const Outline outline = rounded(hole);
  if (kind == HoleKind::Column) {
    constexpr std::array rows{0.0, 0.12, 0.4, 0.9, cut_height};
    mesh.use(Surface::Plaster);
    mesh.sides(outline, rows, is_round(outline));
    mesh.use(Surface::CutFace);
    mesh.lid(outline, cut_height);
    blockers.push_back({outline, cut_height});
    return;
  }
  const double top = top_of(kind, outline);
  build_body(outline, top, mesh);
  blockers.push_back({outline, top});
  if (kind == HoleKind::Case) build_glass(outline, mesh);
}

void build_stand(const ExhibitStand& stand, MeshBuilder& mesh, std::vector<Blocker>& blockers) {
  const Board board = stand.on_wall ? board_on_wall(stand) : standing_board(stand);
  build_board(board, stand.exhibit, mesh);
  const Vec2 forward{std::cos(board.heading), std::sin(board.heading)};
  const double depth = depth_of(board);
  if (!stand.hole && !stand.on_wall) {
    const Vec2 half =
        has_base(stand) ? 0.5 * stand.taken : Vec2{board.width / 2 + 0.04, depth / 2 + 0.06};
    build_plinth(rectangle(stand.placement.position, board.heading, half), 0.03, mesh);
  }
  blockers.push_back(
      {rectangle(board.foot - forward * (depth / 2), board.heading, {board.width / 2, depth / 2}),
       board.bottom + board.height * std::cos(board.lean)});
}

}  // namespace docent::scenery

#include "runtime/guide/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

#include "runtime/scene/side.h"

namespace docent::guide {
namespace {

/// Which parts of the screen are covered, on a grid whose cells are rounded outwards: what is free
/// here covers nothing.
class Covered {
 public:
  explicit Covered(const scene::Rect& free) noexcept : free_(free) {}

  void add(const scene::Rect& rect) noexcept {
    const Cells cells = cells_of(rect);
    for (int y = std::max(cells.top, 0); y <= std::min(cells.bottom, side - 1); ++y)
      for (int x = std::max(cells.left, 0); x <= std::min(cells.right, side - 1); ++x)
        cell_[index(x, y)] = 1;
  }
  /// A line from `begin` on, which is a share of it.
  void add(const Leader& line, float begin) noexcept {
    follow(line, begin, [this](const scene::Rect& point, float /*share*/) {
      add(point);
      return true;
    });
  }
  /// From where on a line is free, as a share of it: its beginning may lie below what has taken its
  /// place. Empty where less than half of it would be seen.
  std::optional<float> has_room(const Leader& line) const noexcept {
    constexpr float most_hidden = 0.5F;
    float hidden = 0;
    const bool is_seen = follow(line, 0, [&](const scene::Rect& point, float share) {
      if (!has_room(point)) hidden = share;
      return hidden < most_hidden;
    });
    return is_seen ? std::optional(hidden) : std::nullopt;
  }
  /// Is it within the free part, and covers nothing?
  bool has_room(const scene::Rect& rect) const noexcept {
    const Cells cells = cells_of(rect);
    if (cells.left < 0 || cells.top < 0 || cells.right >= side || cells.bottom >= side)
      return false;
    for (int y = cells.top; y <= cells.bottom; ++y)
      for (int x = cells.left; x <= cells.right; ++x)
        if (cell_[index(x, y)] != 0) return false;
    return true;
  }

 private:
  static constexpr int side = 256;
  struct Cells {
    int left, top, right, bottom;
  };
  /// Calls for squares of a cell along a line that lie less than that apart, as long as that says
  /// so: two lines that cross share one.
  template <typename Visit>
  bool follow(const Leader& line, float begin, Visit&& visit) const noexcept {
    const float across = line.to.x - line.from.x, down = line.to.y - line.from.y;
    const float cells =
        side * std::max(std::abs(across) / free_.width, std::abs(down) / free_.height);
    const int count = std::max(1, static_cast<int>(std::ceil(2 * cells)));
    for (int i = 0; i < count; ++i) {  // its end lies at the label
      const float share = static_cast<float>(i) / static_cast<float>(count);
      if (share <= begin && begin > 0) continue;
      const scene::Rect point = around(line.from.x + share * across, line.from.y + share * down,
                                       free_.width / side, free_.height / side);
      if (!visit(point, share)) return false;
    }
    return true;
  }
  static std::size_t index(int x, int y) noexcept {
    return static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x);
  }
  static int cell_at(float share) noexcept {
    return static_cast<int>(std::floor(std::clamp(share, -1.0F, 2.0F) * side));
  }
  Cells cells_of(const scene::Rect& r) const noexcept {
    return {cell_at((r.x - free_.x) / free_.width), cell_at((r.y - free_.y) / free_.height),
            cell_at((r.x + r.width - free_.x) / free_.width),
            cell_at((r.y + r.height - free_.y) / free_.height)};
  }

  scene::Rect free_;
  std::array<std::uint8_t, static_cast<std::size_t>(side) * side> cell_{};
};

/// Steps from a place, nearest first: rings of ever more steps.
constexpr std::size_t rings = 6;
const auto steps = [] {
  constexpr std::size_t on_a_ring = 12;
  std::array<std::array<float, 2>, 1 + rings * on_a_ring> all{};
  std::size_t count = 1;
  for (std::size_t ring = 1; ring <= rings; ++ring)
    for (std::size_t i = 0; i < on_a_ring; ++i) {
      const double angle = (static_cast<double>(i) + (ring % 2 == 0 ? 0.5 : 0.0)) * 2 *
                           std::numbers::pi / static_cast<double>(on_a_ring);
      const double reach = 0.4 * static_cast<double>(ring);
      all[count++] = {static_cast<float>(reach * std::sin(angle)),
                      static_cast<float>(-reach * std::cos(angle))};
    }
  return all;
}();

/// Steps about a gallery's name, nearest first, in heights of it.
constexpr auto name_steps = [] {
  constexpr int across = 6, up = 6;  // either way
  std::array<std::array<float, 2>, (2 * across + 1) * (2 * up + 1)> all{};
  std::size_t count = 0;
  for (int x = -across; x <= across; ++x)
    for (int y = -up; y <= up; ++y)
      all[count++] = {0.8F * static_cast<float>(x), 0.5F * static_cast<float>(y)};
  std::ranges::sort(all, {}, [](const auto& s) { return s[0] * s[0] + s[1] * s[1]; });
  return all;
}();

/// Where the middle of a gallery's name may be: about where the gallery is seen.
scene::Rect seen_gallery(const scene::CameraView& camera, const interface::FloorLabel& name,
                         float height) noexcept {
  float left = 1, right = 0, top = 1, bottom = 0;
  for (const Vec2 corner :
       {name.least, name.most, Vec2{name.least.x, name.most.y}, Vec2{name.most.x, name.least.y}}) {
    const auto at = scene::project(camera, to_world(corner, height));
    if (!at) continue;
    left = std::min(left, at->x);
    right = std::max(right, at->x);
    top = std::min(top, at->y);
    bottom = std::max(bottom, at->y);
  }
  return {left, top, right - left, bottom - top};
}

bool touches(const scene::Rect& a, const scene::Rect& b) noexcept {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// What a spot needs: its disc or tile, and a fingertip.
scene::Rect room_of(const interface::View& view, const interface::FloorLabel& label) noexcept {
  const scene::Rect ground = ground_of(view, label);
  if (label.control < 0) return ground;
  return around(ground.x + ground.width / 2, ground.y + ground.height / 2,
                std::max(ground.width, view.spot_px / view.pixel_width),
                std::max(ground.height, view.spot_px / view.pixel_height));
}

bool is_selected(const interface::View& view, const interface::FloorLabel& label) noexcept {
  return label.control >= 0 && view.controls[static_cast<std::size_t>(label.control)].selected;
}

void cover_panel(const interface::View& view, Covered& covered) noexcept {
  covered.add(view.panel);
  for (const interface::Control& control : view.controls)
    if (control.role != interface::Role::Spot && control.rect.width > 0) covered.add(control.rect);
  for (const interface::Element& element : view.elements)
    if (element.control < 0 && !element.is_panel && element.quad.fill != scene::QuadFill::Shadow)
      covered.add(element.quad.rect);
}

/// Tries the places about a name: free of all, or, where there is none, free of what is `hard`.
void place_name(const interface::View& view, const scene::Rect& gallery,
                interface::FloorLabel& name, const Covered& soft, const Covered& hard) noexcept {
  if (scene::is_at_end(name.side))  // it has room in its gallery, and stays there
    name.rect.y = std::clamp(name.rect.y, gallery.y,
                             std::max(gallery.y, gallery.y + gallery.height - name.rect.height));
  const scene::Rect at = name.rect, ground = ground_of(view, name);
  const float line = std::min(ground.width * view.pixel_width, ground.height * view.pixel_height);
  const float across = line / view.pixel_width, down = line / view.pixel_height;
  for (const Covered* covered : {&soft, &hard})
    for (const auto& [x, y] : name_steps) {
      const scene::Rect here{ground.x + x * across, ground.y + y * down, ground.width,
                             ground.height};
      const bool is_moved = x != 0 || y != 0;
      if (is_moved && !scene::contains(gallery, here.x + here.width / 2, here.y + here.height / 2))
        continue;
      if (!covered->has_room(here)) continue;
      name.rect = {at.x + x * across, at.y + y * down, at.width, at.height};
      return;
    }
  name.rect = {};
}

void place_spot(const interface::View& view, interface::FloorLabel& label,
                const Covered& covered) noexcept {
  const scene::Rect at = label.rect, room = room_of(view, label);
  for (const auto& [x, y] : steps) {
    const scene::Rect here{room.x + x * room.width, room.y + y * room.height, room.width,
                           room.height};
    if (!covered.has_room(here)) continue;
    label.rect = {at.x + x * room.width, at.y + y * room.height, at.width, at.height};
    return;
  }
  label.rect = {};
}

/// A label that has found no room at its place goes to the nearest from which a line leads to what
/// it marks without crossing anything. Another fingertip's breadth away at each try, all round.
/// `tries` are those that are left for all labels, so that no frame takes long.
void place_afar(const interface::View& view, interface::FloorLabel& label, Covered& covered,
                int& tries) noexcept {
  constexpr int most_rings = 24, directions = 24;
  label.rect = around(label.anchor_x, label.anchor_y, label.lying_width() / view.pixel_width,
                      label.lying_height() / view.pixel_height);
  const scene::Rect at = label.rect, room = room_of(view, label);
  const float least = std::min(room.width * view.pixel_width, room.height * view.pixel_height);
  const float ring_px = std::max(0.4F * view.spot_px, 0.8F * least);
  for (int ring = 1; ring <= most_rings; ++ring)
    for (int i = 0; i < directions && tries > 0; ++i) {
      const auto turn =
          static_cast<float>((i + 0.5 * (ring % 2)) * 2 * std::numbers::pi / directions);
      const float x = static_cast<float>(ring) * ring_px * std::sin(turn) / view.pixel_width,
                  y = -static_cast<float>(ring) * ring_px * std::cos(turn) / view.pixel_height;
      const scene::Rect here{room.x + x, room.y + y, room.width, room.height};
      if (!covered.has_room(here)) continue;
      --tries;
      label.rect = {at.x + x, at.y + y, at.width, at.height};
      const Leader line = leader_of(view, label);
      const std::optional<float> begin = covered.has_room(line);
      if (!begin) continue;
      covered.add(line, *begin);
      covered.add(room_of(view, label));
      label.is_led = true;
      return;
    }
  label.rect = {};
}

/// What is in the picture and has found no room joins the exhibit that is nearest to it.
void gather(interface::View& view) noexcept {
  const auto is_head = [](const interface::FloorLabel& label) {
    return label.on_disc && label.rect.width > 0;
  };
  for (interface::FloorLabel& label : view.labels) {
    if (!label.on_disc || label.control < 0 || label.rect.width > 0 || label.anchor_x < 0) continue;
    float nearest = 1e9F;
    for (std::size_t i = 0; i < view.labels.size(); ++i) {
      const interface::FloorLabel& other = view.labels[i];
      if (!is_head(other) || other.control < 0) continue;
      const float far = std::hypot((other.anchor_x - label.anchor_x) * view.pixel_width,
                                   (other.anchor_y - label.anchor_y) * view.pixel_height);
      if (far >= nearest) continue;
      nearest = far;
      label.head = static_cast<std::int32_t>(i);
    }
    if (label.head >= 0) ++view.labels[static_cast<std::size_t>(label.head)].held;
  }
}

/// A board of so many cells, in pixels.
struct Board {
  std::size_t columns = 1, rows = 1;
  float cell = 0, pad = 0;
  float width() const noexcept { return static_cast<float>(columns) * cell + 2 * pad; }
  float height() const noexcept { return static_cast<float>(rows) * cell + 2 * pad; }
};

/// The board's place nearest to a point that covers nothing of the panel; empty: there is none.
scene::Rect place_of(const interface::View& view, const Board& board, const scene::Rect& head,
                     const Covered& panel) noexcept {
  constexpr int tries = 16;  // across, and down
  const float width = board.width() / view.pixel_width, height = board.height() / view.pixel_height;
  if (width > view.free.width || height > view.free.height) return {};
  scene::Rect best{};
  float nearest = 1e9F;
  for (int x = 0; x <= tries; ++x)
    for (int y = 0; y <= tries; ++y) {
      const scene::Rect here{
          view.free.x + (view.free.width - width) * static_cast<float>(x) / tries,
          view.free.y + (view.free.height - height) * static_cast<float>(y) / tries, width, height};
      const float across = here.x + (width - head.width) / 2 - head.x,
                  down = here.y + (height - head.height) / 2 - head.y;
      const float far = std::hypot(across * view.pixel_width, down * view.pixel_height);
      // A hair within the free part's edges, where rounding would count it out.
      const scene::Rect inner =
          around(here.x + width / 2, here.y + height / 2, 0.98F * width, 0.98F * height);
      if (far >= nearest || !panel.has_room(inner)) continue;
      nearest = far;
      best = here;
    }
  return best;
}

/// Does the board of the open cluster lie over the line that leads to a label?
bool crosses(const interface::View& view, const interface::FloorLabel& label) noexcept {
  constexpr int points = 64;
  const auto [from, to] = leader_of(view, label);
  for (int i = 0; i <= points; ++i) {
    const float share = static_cast<float>(i) / points;
    if (scene::contains(view.cluster, std::lerp(from.x, to.x, share),
                        std::lerp(from.y, to.y, share)))
      return true;
  }
  return false;
}

/// All of the open cluster side by side, as many as there is room for; what they would cover is not
/// to be seen meanwhile.
void open_cluster(interface::View& view) noexcept {
  const auto open = static_cast<std::size_t>(view.open);
  if (open >= view.labels.size() || view.labels[open].held == 0) {
    view.open = -1;
    return;
  }
  const scene::Rect head = view.labels[open].rect;
  const auto is_in = [&](std::size_t i) { return i == open || view.labels[i].head == view.open; };
  const std::size_t count = 1 + view.labels[open].held;
  constexpr float apart = 1.25F;  // of a target
  const float wide = room_of(view, view.labels[open]).width * view.pixel_width;
  Board board{.cell = apart * std::max(view.spot_px, wide), .pad = 1.5F * view.unit_px};
  const auto most = static_cast<std::size_t>(std::max(
      1.0F, std::floor((view.free.width * view.pixel_width - 2 * board.pad) / board.cell)));
  board.columns = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::ceil(std::sqrt(1.4 * static_cast<double>(count)))), 1, most);
  Covered panel(view.free);
  cover_panel(view, panel);
  for (board.rows = (count + board.columns - 1) / board.columns; board.rows > 0; --board.rows) {
    view.cluster = place_of(view, board, head, panel);
    if (view.cluster.width > 0) break;
  }
  if (board.rows == 0) {
    view.open = -1;
    return;
  }
  std::size_t n = 0;
  for (std::size_t i = 0; i < view.labels.size(); ++i) {
    interface::FloorLabel& label = view.labels[i];
    if (!is_in(i)) {
      const bool is_under = label.rect.width > 0 && (touches(room_of(view, label), view.cluster) ||
                                                     (label.is_led && crosses(view, label)));
      if (is_under) label.rect = {};
      continue;
    }
    label.rect = {};
    if (n == board.columns * board.rows) continue;
    const std::size_t row_of = n / board.columns, column_of = n % board.columns;
    const auto column = static_cast<float>(column_of), row = static_cast<float>(row_of);
    ++n;
    label.anchor_x = view.cluster.x + (board.pad + (column + 0.5F) * board.cell) / view.pixel_width;
    label.anchor_y = view.cluster.y + (board.pad + (row + 0.5F) * board.cell) / view.pixel_height;
    label.rect = around(label.anchor_x, label.anchor_y, label.lying_width() / view.pixel_width,
                        label.lying_height() / view.pixel_height);
  }
}

/// Of those from which it is read, as shares of the model's part of the glass: each has its
/// quarter, however long the glass is. Where nobody is said to read it, the lower one.
scene::Side nearest_side(const interface::View& view, interface::Sides readers, float x,
                         float y) noexcept {
  scene::Side nearest = scene::Side::Bottom;
  float least = 1e9F;
  const scene::ScreenPoint at{(x - view.free.x) / view.free.width,
                              (y - view.free.y) / view.free.height};
  for (const scene::Side side : scene::all_sides) {
    const float far = 1 - scene::as_seen_from(side, at).y;
    if (!readers.has(side) || far >= least) continue;
    least = far;
    nearest = side;
  }
  return nearest;
}

/// From where a label is read. A name that is longer than its gallery is deep would lie in the next
/// one: it is read from the longer sides, where anybody is there.
scene::Side side_of(const interface::View& view, interface::FloorLabel label,
                    const scene::CameraView& camera, float height) noexcept {
  label.side = nearest_side(view, view.readers, label.anchor_x, label.anchor_y);
  if (!is_name(label) || !scene::is_at_end(label.side)) return label.side;
  interface::Sides along;
  for (const scene::Side side : scene::all_sides)
    if (view.readers.has(side) && !scene::is_at_end(side)) along.add(side);
  const float room = seen_gallery(camera, label, height).height * view.pixel_height;
  return along.count() == 0 || label.lying_height() <= room
             ? label.side
             : nearest_side(view, along, label.anchor_x, label.anchor_y);
}

/// A spot is touched where its label is.
void move_spots(interface::View& view) noexcept {
  for (const interface::FloorLabel& label : view.labels)
    if (label.control >= 0)
      view.controls[static_cast<std::size_t>(label.control)].rect =
          label.rect.width > 0
              ? around(label.rect.x + label.rect.width / 2, label.rect.y + label.rect.height / 2,
                       view.spot_px / view.pixel_width, view.spot_px / view.pixel_height)
              : scene::Rect{};
}

}  // namespace

scene::Rect ground_of(const interface::View& view, const interface::FloorLabel& label) noexcept {
  const float unit = view.unit_px;
  float width = label.width_px + 1.6F * unit, height = label.height_px * 0.82F;
  if (scene::is_at_end(label.side)) std::swap(width, height);
  if (label.on_disc)
    width = height = std::max({4.2F * unit, label.width_px + 1.4F * unit, label.height_px});
  if (label.is_sign) width = height = label.width_px + 1.2F * unit;
  return around(label.rect.x + label.rect.width / 2, label.rect.y + label.rect.height / 2,
                width / view.pixel_width, height / view.pixel_height);
}

Leader leader_of(const interface::View& view, const interface::FloorLabel& label) noexcept {
  const scene::Rect ground = ground_of(view, label);
  const float x = ground.x + ground.width / 2, y = ground.y + ground.height / 2;
  const float across = std::abs(label.anchor_x - x), down = std::abs(label.anchor_y - y);
  // From the middle, what share of the line is within.
  const float inside = std::min({1.0F, across > 0 ? ground.width / 2 / across : 1.0F,
                                 down > 0 ? ground.height / 2 / down : 1.0F});
  return {{label.anchor_x, label.anchor_y},
          {std::lerp(x, label.anchor_x, inside), std::lerp(y, label.anchor_y, inside)}};
}

void project_labels(interface::View& view, const scene::CameraView& camera,
                    float floor_height) noexcept {
  for (interface::FloorLabel& label : view.labels) {
    const auto at = scene::project(camera, to_world(label.position, floor_height + label.height));
    label.rect = {};
    label.head = -1;
    label.held = 0;
    label.is_led = false;
    label.anchor_x = -1;  // out of the picture
    if (!at || !scene::contains(view.free, at->x, at->y)) continue;
    label.anchor_x = at->x;
    label.anchor_y = at->y;
    label.side = side_of(view, label, camera, floor_height + label.height);
    label.rect = around(at->x, at->y, label.lying_width() / view.pixel_width,
                        label.lying_height() / view.pixel_height);
  }
  move_spots(view);
}

void place_labels(interface::View& view, const scene::CameraView& camera,
                  float floor_height) noexcept {
  project_labels(view, camera, floor_height);
  Covered hard(view.free);
  cover_panel(view, hard);
  Covered soft = hard;
  for (const interface::FloorLabel& label : view.labels)
    if (label.on_disc && label.rect.width > 0) soft.add(room_of(view, label));
  for (interface::FloorLabel& label : view.labels) {
    if (!is_name(label) || label.rect.width <= 0) continue;
    place_name(view, seen_gallery(camera, label, floor_height + label.height), label, soft, hard);
    if (label.rect.width <= 0) continue;
    hard.add(ground_of(view, label));
    soft.add(ground_of(view, label));
  }
  const auto place = [&](auto&& is_meant) {
    for (interface::FloorLabel& label : view.labels) {
      if (label.rect.width <= 0 || is_name(label) || !is_meant(label)) continue;
      place_spot(view, label, hard);
      if (label.rect.width > 0) hard.add(room_of(view, label));
    }
  };
  place([&](const interface::FloorLabel& one) { return is_selected(view, one); });
  place([&](const interface::FloorLabel& one) { return one.on_disc && !is_selected(view, one); });
  place([&](const interface::FloorLabel& one) { return one.is_sign && !is_selected(view, one); });
  std::size_t afar = 0;
  constexpr std::size_t most_afar = 64;  // more lines than that nobody follows
  int tries = 2000;                      // lines that are followed
  const auto place_others = [&](auto&& is_meant) {
    for (interface::FloorLabel& label : view.labels) {
      if (label.rect.width > 0 || label.anchor_x < 0 || !is_meant(label)) continue;
      if (++afar <= most_afar) place_afar(view, label, hard, tries);
    }
  };
  place_others([&](const interface::FloorLabel& one) { return is_selected(view, one); });
  place_others(is_name);
  place_others([](const interface::FloorLabel& one) { return one.is_sign; });
  gather(view);
  view.cluster = {};
  if (view.open >= 0) open_cluster(view);
  move_spots(view);
}

bool stands_for_several(const interface::View& view, std::int32_t control) noexcept {
  if (control < 0 || view.open >= 0) return false;
  return std::ranges::any_of(view.labels, [&](const interface::FloorLabel& label) {
    return label.control == control && label.held > 0;
  });
}

std::int32_t head_of(const interface::View& view, std::int32_t control) noexcept {
  const auto label = std::ranges::find(view.labels, control, &interface::FloorLabel::control);
  if (control < 0 || label == view.labels.end() || label->head < 0 || view.open >= 0) return -1;
  return view.labels[static_cast<std::size_t>(label->head)].control;
}

}  // namespace docent::guide

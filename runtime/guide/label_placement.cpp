#include "runtime/guide/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

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
  const scene::Rect at = name.rect, ground = ground_of(view, name);
  const float across = ground.height * view.pixel_height / view.pixel_width;
  for (const Covered* covered : {&soft, &hard})
    for (const auto& [x, y] : name_steps) {
      const scene::Rect here{ground.x + x * across, ground.y + y * ground.height, ground.width,
                             ground.height};
      const bool is_moved = x != 0 || y != 0;
      if (is_moved && !scene::contains(gallery, here.x + here.width / 2, here.y + here.height / 2))
        continue;
      if (!covered->has_room(here)) continue;
      name.rect = {at.x + x * across, at.y + y * ground.height, at.width, at.height};
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
  if (label.on_disc)
    width = height = std::max({4.2F * unit, label.width_px + 1.4F * unit, label.height_px});
  if (label.is_sign) width = height = label.width_px + 1.2F * unit;
  return around(label.rect.x + label.rect.width / 2, label.rect.y + label.rect.height / 2,
                width / view.pixel_width, height / view.pixel_height);
}

void project_labels(interface::View& view, const scene::CameraView& camera,
                    float floor_height) noexcept {
  for (interface::FloorLabel& label : view.labels) {
    const auto at = scene::project(camera, to_world(label.position, floor_height + label.height));
    label.rect = {};
    if (!at || !scene::contains(view.free, at->x, at->y)) continue;
    label.anchor_x = at->x;
    label.anchor_y = at->y;
    label.rect = around(at->x, at->y, label.width_px / view.pixel_width,
                        label.height_px / view.pixel_height);
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
  move_spots(view);
}

}  // namespace docent::guide

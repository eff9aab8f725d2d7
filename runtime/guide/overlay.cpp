#include "runtime/guide/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "runtime/scene/theme.h"

namespace docent::guide {
namespace {

constexpr float press_depth_share = 0.02F;  ///< A pressed control is this much smaller.
constexpr float release_seconds = 0.15F;

const scene::Theme theme;

bool same(const scene::Rect& a, const scene::Rect& b) noexcept {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

bool same(const scene::Colour& a, const scene::Colour& b) noexcept {
  return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

bool same(const scene::Quad& a, const scene::Quad& b) noexcept {
  return a.fill == b.fill && a.texture == b.texture && same(a.rect, b.rect) &&
         same(a.colour, b.colour);
}

scene::Rect scaled(const scene::Rect& rect, const scene::Rect& about, float scale) noexcept {
  const float x = about.x + about.width / 2, y = about.y + about.height / 2;
  return {x + (rect.x - x) * scale, y + (rect.y - y) * scale, rect.width * scale,
          rect.height * scale};
}

scene::Rect between(const scene::Rect& a, const scene::Rect& b, float t) noexcept {
  return {std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t), std::lerp(a.width, b.width, t),
          std::lerp(a.height, b.height, t)};
}

scene::Rect around(float x, float y, float width, float height) noexcept {
  return {x - width / 2, y - height / 2, width, height};
}

float shorter_px(const interface::View& view) noexcept {
  return std::min(view.pixel_width, view.pixel_height);
}

/// Marks what two views have in common: it is drawn once and does not fade.
void note_what_stays(interface::View& leaving, interface::View& entering) noexcept {
  for (interface::Element& old : leaving.elements) old.stays = false;
  for (interface::Element& element : entering.elements) {
    const auto twin = std::ranges::find_if(leaving.elements, [&](const interface::Element& old) {
      return same(old.quad, element.quad);
    });
    element.stays = twin != leaving.elements.end();
    if (element.stays) twin->stays = true;
  }
}

/// The control of `to` that is what that one of `from` was, for the finger that holds it.
std::int32_t twin_of(std::int32_t control, const interface::View& from,
                     const interface::View& to) noexcept {
  if (control < 0) return -1;
  const interface::Control& old = from.controls[static_cast<std::size_t>(control)];
  const auto twin = std::ranges::find_if(to.controls, [&](const interface::Control& c) {
    return c.enabled && c.role == old.role && c.name == old.name;
  });
  return twin == to.controls.end() ? -1 : static_cast<std::int32_t>(twin - to.controls.begin());
}

/// What a label covers where it is shown, with what it is drawn on.
scene::Rect ground_of(const interface::View& view, const interface::FloorLabel& label) noexcept {
  const float unit = view.unit_px;
  float width = label.width_px + 1.6F * unit, height = label.height_px * 0.82F;
  if (label.on_disc)
    width = height = std::max({4.2F * unit, label.width_px + 1.4F * unit, label.height_px});
  if (label.is_sign) width = height = label.width_px + 1.2F * unit;
  return around(label.rect.x + label.rect.width / 2, label.rect.y + label.rect.height / 2,
                width / view.pixel_width, height / view.pixel_height);
}

/// Of a gallery.
bool is_name(const interface::FloorLabel& label) noexcept {
  return !label.on_disc && !label.is_sign;
}

bool overlap(const scene::Rect& a, const scene::Rect& b) noexcept {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// Steps about a place, nearest first, in shares of a sign's size.
constexpr std::array<std::array<float, 2>, 17> about{{{0, 0},
                                                      {0, -0.6F},
                                                      {0, 0.6F},
                                                      {-0.6F, 0},
                                                      {0.6F, 0},
                                                      {0, -1.1F},
                                                      {0, 1.1F},
                                                      {-1.1F, 0},
                                                      {1.1F, 0},
                                                      {-1.1F, -1.1F},
                                                      {1.1F, -1.1F},
                                                      {-1.1F, 1.1F},
                                                      {1.1F, 1.1F},
                                                      {0, -2.2F},
                                                      {0, 2.2F},
                                                      {-2.2F, 0},
                                                      {2.2F, 0}}};

/// Moves a sign to where it covers none of the labels before it and none that is no sign; leaves it
/// where it is if there is no such place about it.
void make_way(const interface::View& view, std::size_t sign,
              std::span<interface::FloorLabel> labels) noexcept {
  interface::FloorLabel& label = labels[sign];
  const scene::Rect place = label.rect;
  const scene::Rect ground = ground_of(view, label);
  for (const auto& [x, y] : about) {
    label.rect = place;
    label.rect.x += x * ground.width;
    label.rect.y += y * ground.height;
    const scene::Rect here = ground_of(view, label);
    bool is_free = scene::contains(view.free, here.x, here.y) &&
                   scene::contains(view.free, here.x + here.width, here.y + here.height);
    for (std::size_t i = 0; is_free && i < labels.size(); ++i)
      if (i != sign && labels[i].rect.width > 0 && (!labels[i].is_sign || i < sign))
        is_free = !overlap(here, ground_of(view, labels[i]));
    if (is_free) return;
  }
  label.rect = place;
}

/// Steps about a gallery's name, nearest first, in heights of it.
constexpr auto about_name = [] {
  constexpr int across = 4, up = 5;  // either way
  std::array<std::array<float, 2>, (2 * across + 1) * (2 * up + 1)> steps{};
  std::size_t count = 0;
  for (int x = -across; x <= across; ++x)
    for (int y = -up; y <= up; ++y)
      steps[count++] = {0.8F * static_cast<float>(x), 0.5F * static_cast<float>(y)};
  std::ranges::sort(steps, {}, [](const auto& s) { return s[0] * s[0] + s[1] * s[1]; });
  return steps;
}();

float shared_area(const scene::Rect& a, const scene::Rect& b) noexcept {
  const float width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
  const float height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
  return std::max(width, 0.0F) * std::max(height, 0.0F);
}

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

/// Moves a gallery's name, within the gallery, to where it covers no number and no name before it,
/// and is in the picture; or where least of it does not.
void find_room(const interface::View& view, std::size_t name, const scene::Rect& gallery,
               std::span<interface::FloorLabel> labels) noexcept {
  interface::FloorLabel& label = labels[name];
  const scene::Rect place = label.rect;
  const scene::Rect ground = ground_of(view, label);
  const float line_x = ground.height * view.pixel_height / view.pixel_width;
  constexpr float free = 1e-6F;  // of the screen
  float least = 1e9F;
  for (const auto& [x, y] : about_name) {
    const scene::Rect here{ground.x + x * line_x, ground.y + y * ground.height, ground.width,
                           ground.height};
    const bool is_moved = x != 0 || y != 0;
    if (is_moved && !scene::contains(gallery, here.x + here.width / 2, here.y + here.height / 2))
      continue;
    float covered = here.width * here.height - shared_area(here, view.free);
    for (std::size_t i = 0; i < labels.size() && covered < least; ++i)
      if (i != name && labels[i].rect.width > 0 &&
          (labels[i].on_disc || (is_name(labels[i]) && i < name)))
        covered += shared_area(here, ground_of(view, labels[i]));
    if (covered >= least) continue;
    least = covered;
    label.rect = {place.x + x * line_x, place.y + y * ground.height, place.width, place.height};
    if (least <= free) return;
  }
}

/// Within this the figure on the inset plan has run the whole way.
constexpr float run_seconds = 3.6F;

bool is_same_way(const interface::InsetPlan& a, const interface::InsetPlan& b) noexcept {
  return a.floor == b.floor && a.way == b.way;
}

/// The point so many metres along the way of an inset plan, which has one.
Vec2 point_on(const interface::InsetPlan& inset, double metres) noexcept {
  const auto next = std::ranges::lower_bound(inset.reach, metres);
  if (next == inset.reach.end()) return inset.way.back();
  const auto i = static_cast<std::size_t>(next - inset.reach.begin());
  if (i == 0) return inset.way.front();
  const double step = inset.reach[i] - inset.reach[i - 1];
  return step <= 0 ? inset.way[i]
                   : glm::mix(inset.way[i - 1], inset.way[i], (metres - inset.reach[i - 1]) / step);
}

}  // namespace

void Overlay::enter(std::unique_ptr<interface::View> view) noexcept {
  if (view_) note_what_stays(*view_, *view);
  if (!view_ || !is_same_way(view_->inset, view->inset)) run_ = 0;
  leaving_ = std::exchange(view_, std::move(view));
  age_ = leaving_ ? 0 : fade_seconds;
  for (Press& press : presses_)
    press.control = leaving_ ? twin_of(press.control, *leaving_, *view_) : -1;
  if (focus_ >= static_cast<std::int32_t>(view_->controls.size())) focus_ = -1;
  if (leaving_ && leaving_->state.screen != view_->state.screen && focus_ >= 0) {
    focus_ = -1;
    move_focus(1);
  }
  if (reduced_motion_) leaving_.reset();
}

void Overlay::advance(float seconds) noexcept {
  age_ += seconds;
  run_ += seconds;
  if (!is_fading()) leaving_.reset();
  for (Ring& ring : rings_) ring.age += seconds;
  for (Press& press : presses_)
    if (!press.held) press.age += seconds;
}

void Overlay::follow(const scene::CameraView& camera, float floor_height) noexcept {
  for (interface::View* view : {view_.get(), leaving_.get()}) {
    if (view == nullptr) continue;
    for (interface::FloorLabel& label : view->labels) {
      const auto at = scene::project(camera, to_world(label.position, floor_height + label.height));
      label.rect = {};
      const bool in_picture = at && scene::contains(view->free, at->x, at->y);
      if (in_picture)
        label.rect = around(at->x, at->y, label.width_px / view->pixel_width,
                            label.height_px / view->pixel_height);
    }
    for (std::size_t i = 0; i < view->labels.size(); ++i)
      if (is_name(view->labels[i]) && view->labels[i].rect.width > 0)
        find_room(*view, i,
                  seen_gallery(camera, view->labels[i], floor_height + view->labels[i].height),
                  view->labels);
    for (std::size_t i = 0; i < view->labels.size(); ++i)
      if (view->labels[i].is_sign && view->labels[i].rect.width > 0)
        make_way(*view, i, view->labels);
    for (const interface::FloorLabel& label : view->labels) {
      if (label.control < 0) continue;
      const scene::Rect& at = label.rect;
      view->controls[static_cast<std::size_t>(label.control)].rect =
          at.width > 0
              ? around(at.x + at.width / 2, at.y + at.height / 2, view->spot_px / view->pixel_width,
                       view->spot_px / view->pixel_height)
              : scene::Rect{};
    }
  }
}

std::int32_t Overlay::control_at(float x, float y) const noexcept {
  if (!view_) return -1;
  std::int32_t nearest = -1;
  float nearest_square = 1e9F;
  for (std::size_t i = 0; i < view_->controls.size(); ++i) {
    const interface::Control& control = view_->controls[i];
    if (!control.enabled || !scene::contains(control.rect, x, y)) continue;
    if (control.role != interface::Role::Spot) return static_cast<std::int32_t>(i);
    const float across = (control.rect.x + control.rect.width / 2 - x) * view_->pixel_width;
    const float down = (control.rect.y + control.rect.height / 2 - y) * view_->pixel_height;
    const float square = across * across + down * down;
    if (square < nearest_square && !scene::contains(view_->panel, x, y)) {
      nearest_square = square;
      nearest = static_cast<std::int32_t>(i);
    }
  }
  return nearest;
}

void Overlay::touch_down(const input::Finger& finger) noexcept {
  rings_[next_ring_++ % rings_.size()] = {finger.at.x, finger.at.y, 0};
  Press& press = *std::ranges::min_element(presses_, {},
                                           [](const Press& p) { return p.held ? 1e9F : -p.age; });
  press = {finger.at.id, control_at(finger.at.x, finger.at.y), true, 0};
}

std::int32_t Overlay::touch_up(const input::Finger& finger) noexcept {
  const auto press = std::ranges::find_if(
      presses_, [&](const Press& p) { return p.held && p.finger == finger.at.id; });
  if (press == presses_.end()) return -1;
  press->held = false;
  press->age = 0;
  const std::int32_t left = control_at(finger.at.x, finger.at.y);
  return left == press->control ? left : -1;
}

void Overlay::move_focus(int step) noexcept {
  if (!view_ || view_->controls.empty()) return;
  const auto count = static_cast<std::int32_t>(view_->controls.size());
  std::int32_t at = focus_ < 0 && step < 0 ? 0 : focus_;
  for (std::int32_t tried = 0; tried < count; ++tried) {
    at = (at + step + count) % count;
    const interface::Control& control = view_->controls[static_cast<std::size_t>(at)];
    if (control.role == interface::Role::Spot || !control.enabled || control.rect.width <= 0)
      continue;
    focus_ = at;
    return;
  }
}

float Overlay::press_depth(std::int32_t control) const noexcept {
  float depth = 0;
  for (const Press& press : presses_)
    if (press.control == control && control >= 0)
      depth = std::max(depth, press.held        ? 1
                              : reduced_motion_ ? 0
                                                : 1 - press.age / release_seconds);
  return depth;
}

void Overlay::draw_elements(const interface::View& view, float opacity, float unchanged_opacity,
                            bool leaving, scene::DrawList& list) const noexcept {
  for (const interface::Element& element : view.elements) {
    if (element.is_panel && leaving) continue;
    scene::Quad quad = element.quad;
    float shown = element.stays ? unchanged_opacity : opacity;
    if (element.is_panel) {
      shown = 1;
      if (leaving_ && !same(leaving_->panel, view.panel)) {
        const scene::Rect at = between(leaving_->panel, view.panel,
                                       static_cast<float>(scene::ease_out(age_ / fade_seconds)));
        quad.rect.x += at.x - view.panel.x;
        quad.rect.y += at.y - view.panel.y;
      }
    }
    if (element.control >= 0 && !leaving)
      if (const float depth = press_depth(element.control); depth > 0)
        quad.rect = scaled(quad.rect, view.controls[static_cast<std::size_t>(element.control)].rect,
                           1 - press_depth_share * depth);
    quad.colour = scene::with_opacity(quad.colour, shown);
    if (quad.colour.a > 0.002F) list.quads.push_back(quad);
  }
}

void Overlay::draw_focus(scene::DrawList& list) const noexcept {
  if (focus_ < 0 || !view_) return;
  const scene::Rect& rect = view_->controls[static_cast<std::size_t>(focus_)].rect;
  if (rect.width <= 0) return;
  // Two nested frames, dark round light, are seen on every ground.
  const float thick = view_->unit_px * 0.5F;
  for (const auto& [reach, colour] : {std::pair{1.6F, theme.focus}, std::pair{0.9F, theme.paper}}) {
    const float x = reach * thick / view_->pixel_width, y = reach * thick / view_->pixel_height;
    scene::Quad frame;
    frame.rect = {rect.x - x, rect.y - y, rect.width + 2 * x, rect.height + 2 * y};
    frame.colour = colour;
    frame.corner = (1.5F * view_->unit_px + reach * thick) / shorter_px(*view_);
    list.quads.push_back(frame);
  }
}

void Overlay::draw_labels(const interface::View& view, float opacity,
                          scene::DrawList& list) const noexcept {
  if (opacity <= 0.002F) return;
  const float shorter = shorter_px(view);
  for (const interface::FloorLabel& label : view.labels) {
    if (label.rect.width <= 0 || label.texture == scene::TextureId::None) continue;
    const interface::Control* spot =
        label.control < 0 ? nullptr : &view.controls[static_cast<std::size_t>(label.control)];
    const bool selected = spot != nullptr && spot->selected;
    scene::Quad ground;
    const float size = (1 - 0.1F * press_depth(label.control)) * (selected ? 1.2F : 1);
    ground.rect = scaled(ground_of(view, label), label.rect, size);
    ground.corner = label.on_disc ? ground.rect.width * view.pixel_width / 2 / shorter
                                  : 0.8F * view.unit_px / shorter;
    ground.colour = scene::with_opacity(selected        ? theme.invitation
                                        : label.is_sign ? theme.quiet_ink
                                                        : theme.paper,
                                        is_name(label) ? 0.74F * opacity : opacity);
    list.quads.push_back(ground);
    scene::Quad text;
    text.fill = scene::QuadFill::Text;
    text.texture = label.texture;
    text.rect = label.rect;
    text.rect.x = std::round(text.rect.x * view.pixel_width) / view.pixel_width;
    text.rect.y = std::round(text.rect.y * view.pixel_height) / view.pixel_height;
    text.colour = scene::with_opacity(selected || label.is_sign ? theme.paper : theme.ink, opacity);
    list.quads.push_back(text);
  }
}

void Overlay::draw_inset(const interface::View& view, float opacity, const GuideSpot& guide,
                         scene::DrawList& list) const noexcept {
  const interface::InsetPlan& inset = view.inset;
  if (inset.board.width <= 0 || inset.way.empty()) return;
  const auto disc = [&](Vec2 at, float side, float lift, scene::Colour colour) {
    const auto u = static_cast<float>(dot(at - inset.origin, inset.right));
    const auto v = static_cast<float>(dot(at - inset.origin, inset.down));
    if (u < 0 || v < 0 || u > 1 || v > 1) return;
    const float px = side * view.unit_px;
    scene::Quad quad;
    quad.rect =
        around(inset.board.x + u * inset.board.width,
               inset.board.y + v * inset.board.height - lift * view.unit_px / view.pixel_height,
               px / view.pixel_width, px / view.pixel_height);
    quad.corner = px / 2 / shorter_px(view);
    quad.colour = scene::with_opacity(colour, opacity);
    list.quads.push_back(quad);
  };
  if (guide.floor == inset.floor) {
    disc(guide.at, 2.4F, 0, theme.paper);
    disc(guide.at, 1.8F, 0, theme.focus);
  }
  // A small figure: a body, and a head above it.
  const float share = reduced_motion_ ? 1 : std::min(1.0F, run_ / run_seconds);
  const Vec2 at = point_on(inset, share * inset.reach.back());
  disc(at, 2.2F, 0.9F, theme.paper);
  disc(at, 1.7F, 2.4F, theme.paper);
  disc(at, 1.6F, 0.9F, theme.ink);
  disc(at, 1.1F, 2.4F, theme.ink);
}

void Overlay::draw_remaining(const interface::View& view, float metres, float opacity,
                             scene::DrawList& list) const noexcept {
  for (const interface::CountedText& text : view.remaining) {
    if (metres > text.metres) continue;
    scene::Quad quad = text.quad;
    quad.colour = scene::with_opacity(quad.colour, opacity);
    list.quads.push_back(quad);
    return;
  }
}

void Overlay::draw(float remaining, float labels_opacity, const GuideSpot& guide,
                   scene::DrawList& list) const noexcept {
  if (!view_) return;
  const float t = is_fading() ? static_cast<float>(scene::ease_out(age_ / fade_seconds)) : 1;
  if (leaving_) draw_labels(*leaving_, labels_opacity * (1 - t), list);
  draw_labels(*view_, labels_opacity * t, list);

  draw_elements(*view_, t, 1, false, list);
  if (leaving_) {
    draw_elements(*leaving_, 1 - t, 0, true, list);
    if (view_->remaining.empty()) draw_remaining(*leaving_, remaining, 1 - t, list);
  }
  draw_remaining(*view_, remaining, leaving_ && leaving_->remaining.empty() ? t : 1, list);
  draw_inset(*view_, leaving_ && leaving_->inset.board.width <= 0 ? t : 1, guide, list);
  draw_focus(list);

  for (const Ring& ring : rings_) {
    if (ring.age >= ring_seconds) continue;
    const float share = reduced_motion_ ? 0.3F : ring.age / ring_seconds;
    const float size = (3 + 5 * static_cast<float>(scene::ease_out(share))) * view_->unit_px * 2;
    scene::Quad quad;
    quad.fill = scene::QuadFill::Ring;
    quad.rect = around(ring.x, ring.y, size / view_->pixel_width, size / view_->pixel_height);
    quad.softness = 0.6F * view_->unit_px / shorter_px(*view_);
    quad.colour = scene::with_opacity(view_->accent, (1 - share) * 0.9F);
    list.quads.push_back(quad);
  }
}

}  // namespace docent::guide

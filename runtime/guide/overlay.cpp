#include "runtime/guide/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "runtime/guide/label_placement.h"
#include "runtime/interface/scroll.h"
#include "runtime/scene/side.h"
#include "runtime/scene/theme.h"

namespace docent::guide {
namespace {

constexpr float press_depth_share = 0.02F;  ///< A pressed control is this much smaller.
constexpr float release_seconds = 0.15F;
constexpr float cluster_seconds = 20;  ///< After which nobody looks at it any more.

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

float shorter_px(const interface::View& view) noexcept {
  return std::min(view.pixel_width, view.pixel_height);
}

/// Marks what two views have in common: it is drawn once and does not fade.
void note_what_stays(interface::View& leaving, interface::View& entering) noexcept {
  for (interface::Element& old : leaving.elements) old.stays = false;
  for (interface::Element& element : entering.elements) {
    const auto twin = std::ranges::find_if(leaving.elements, [&](const interface::Element& old) {
      return old.scrolls == element.scrolls && same(old.quad, element.quad);
    });
    element.stays = twin != leaving.elements.end();
    if (element.stays) twin->stays = true;
  }
}

/// Does it lie in the part that scrolls?
bool lies_in_scroll(const interface::View& view, std::int32_t control) noexcept {
  return std::ranges::find(view.scroll.controls, control,
                           &interface::ScrollArea::Scrolled::control) != view.scroll.controls.end();
}

/// Is it the same text or list as before, so that one reads on where one was?
bool is_same_page(const interface::InterfaceState& a, const interface::InterfaceState& b) noexcept {
  return a.screen == b.screen && a.exhibit == b.exhibit && a.place == b.place &&
         a.seeks == b.seeks && a.lists == b.lists && a.page == b.page && a.language == b.language &&
         a.large_letters == b.large_letters && a.low_reach == b.low_reach;
}

/// Does it turn what scrolls to where there is nothing more?
bool is_end_of_scroll(const interface::View& view, std::int32_t control) noexcept {
  if (control < 0 || (control != view.scroll.up && control != view.scroll.down)) return false;
  return !view.controls[static_cast<std::size_t>(control)].enabled;
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

/// Discs behind the one on top: it stands for several.
void draw_stack(const scene::Quad& edge, const scene::Quad& ground, float opacity,
                const interface::View& view, scene::DrawList& list) noexcept {
  const float step = 0.55F * view.unit_px;
  for (const float behind : {2.0F, 1.0F}) {
    for (scene::Quad quad : {edge, ground}) {
      quad.rect.x += behind * step / view.pixel_width;
      quad.rect.y -= behind * step / view.pixel_height;
      quad.colour.a = opacity;
      list.quads.push_back(quad);
    }
  }
}

/// A bar across a disc.
scene::Quad strike_through(const interface::View& view, const scene::Rect& disc,
                           scene::Colour colour) noexcept {
  const float thick = 0.3F * view.unit_px / view.pixel_height;
  scene::Quad bar;
  bar.rect = around(disc.x + disc.width / 2, disc.y + disc.height / 2, 0.7F * disc.width, thick);
  bar.colour = colour;
  return bar;
}

}  // namespace

void Overlay::enter(std::unique_ptr<interface::View> view) noexcept {
  if (view_ && view_->side != view->side) view_.reset();
  if (view_) note_what_stays(*view_, *view);
  if (!view_ || !is_same_way(view_->inset, view->inset)) run_ = 0;
  const bool is_same = view_ && is_same_page(view_->state, view->state);
  leaving_scroller_ = scroller_;
  scroller_.enter(view->scroll, is_same);
  leaving_ = std::exchange(view_, std::move(view));
  interface::place_scrolled(*view_, scrolled());
  age_ = leaving_ ? 0 : fade_seconds;
  is_placed_ = false;
  for (Press& press : presses_)
    press.control = leaving_ ? twin_of(press.control, *leaving_, *view_) : -1;
  if (const std::int32_t same = leaving_ ? twin_of(focus_, *leaving_, *view_) : -1; same >= 0)
    focus_ = same;
  if (focus_ >= static_cast<std::int32_t>(view_->controls.size())) focus_ = -1;
  if (leaving_ && leaving_->state.screen != view_->state.screen && focus_ >= 0) {
    focus_ = -1;
    move_focus(1);
  }
  if (reduced_motion_) leaving_.reset();
  reveal_focus();
}

void Overlay::advance(float seconds) noexcept {
  age_ += seconds;
  run_ += seconds;
  open_seconds_ += seconds;
  if (open_seconds_ > cluster_seconds) close_cluster();
  if (!is_fading()) leaving_.reset();
  for (Ring& ring : rings_) ring.age += seconds;
  for (Press& press : presses_)
    if (!press.held) press.age += seconds;
  if (!view_ || !view_->scroll.exists()) return;
  scroller_.advance(view_->scroll, seconds);
  interface::place_scrolled(*view_, scrolled());
}

float Overlay::pixels_of(const interface::View& view, const Scroller& scroller) const noexcept {
  return std::round(scroller.offset() * view.pixel_height) / view.pixel_height;
}

float Overlay::scrolled() const noexcept {
  return view_ ? pixels_of(*view_, scroller_) : 0;
}

void Overlay::turn(int pages) noexcept {
  if (view_ && view_->scroll.exists()) scroller_.turn(view_->scroll, pages);
  if (view_) interface::place_scrolled(*view_, scrolled());
}

bool Overlay::touch_move(const input::Finger& finger) noexcept {
  if (!view_ || !view_->scroll.exists()) return false;
  constexpr float slack = 1.5F;  // units
  const float least = slack * view_->unit_px / view_->pixel_height;
  if (!scroller_.drag(view_->scroll, finger.at, least)) return false;
  interface::place_scrolled(*view_, scrolled());
  for (Press& press : presses_)
    if (press.held && press.finger == finger.at.id) {
      press.drags = true;
      press.control = -1;
    }
  return true;
}

bool Overlay::is_dragged_by(std::uint32_t finger) const noexcept {
  return std::ranges::any_of(
      presses_, [&](const Press& p) { return p.held && p.drags && p.finger == finger; });
}

/// Who comes to a control by keys sees all of it.
void Overlay::reveal_focus() noexcept {
  if (!view_ || focus_ < 0) return;
  const float offset = interface::offset_showing(view_->scroll, focus_, scroller_.offset());
  if (offset != scroller_.offset()) scroller_.go_to(offset);
  interface::place_scrolled(*view_, scrolled());
}

void Overlay::follow(const scene::CameraView& camera, float floor_height, bool is_held) noexcept {
  const bool moves = camera_ && camera != *camera_;  // the first picture has its labels
  if (!moves && is_placed_) return;
  camera_ = camera;
  is_placed_ = !moves || is_held;
  for (interface::View* view : {view_.get(), leaving_.get()}) {
    if (view == nullptr) continue;
    view->readers = readers_;
    if (moves) {
      view->open = -1;
      view->cluster = {};
    }
    if (moves && !is_held)
      project_labels(*view, camera, floor_height);
    else
      place_labels(*view, camera, floor_height);
  }
}

/// The board on which an open cluster lies.
void Overlay::draw_cluster(const interface::View& view, float opacity,
                           scene::DrawList& list) const noexcept {
  if (view.cluster.width <= 0) return;
  const scene::Theme& theme = view.theme;
  scene::Quad board;
  board.rect = view.cluster;
  board.corner = 1.5F * view.unit_px / shorter_px(view);
  scene::Quad shade = board;
  shade.fill = scene::QuadFill::Shadow;
  shade.softness = 2 * view.unit_px / shorter_px(view);
  shade.colour = scene::with_opacity(theme.shade, 0.25F * opacity);
  list.quads.push_back(shade);
  board.colour = scene::with_opacity(theme.plaster, opacity);
  list.quads.push_back(board);
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

bool Overlay::is_on_model(float x, float y) const noexcept {
  if (!view_ || !scene::contains(view_->free, x, y) || scene::contains(view_->cluster, x, y))
    return false;
  const std::int32_t control = control_at(x, y);
  return control < 0 ||
         view_->controls[static_cast<std::size_t>(control)].role == interface::Role::Spot;
}

void Overlay::ring(float x, float y) noexcept {
  rings_[next_ring_++ % rings_.size()] = {x, y, 0};
}

void Overlay::touch_down(const input::Finger& finger) noexcept {
  ring(finger.at.x, finger.at.y);
  Press& press = *std::ranges::min_element(presses_, {},
                                           [](const Press& p) { return p.held ? 1e9F : -p.age; });
  press = {finger.at.id, control_at(finger.at.x, finger.at.y), true, false, 0};
  if (view_ && scene::contains(view_->scroll.rect, finger.at.x, finger.at.y))
    scroller_.hold(finger.at);
}

std::int32_t Overlay::touch_up(const input::Finger& finger) noexcept {
  scroller_.let_go(finger.at.id);
  const auto press = std::ranges::find_if(
      presses_, [&](const Press& p) { return p.held && p.finger == finger.at.id; });
  if (press == presses_.end()) return -1;
  press->held = false;
  press->age = 0;
  const std::int32_t left = control_at(finger.at.x, finger.at.y);
  return left == press->control && !press->drags ? left : -1;
}

void Overlay::close_cluster() noexcept {
  if (!view_ || view_->open < 0) return;
  view_->open = -1;
  is_placed_ = false;
}

bool Overlay::open_or_close(std::int32_t control) noexcept {
  if (!view_) return false;
  if (view_->open >= 0) {
    close_cluster();
    return control < 0;
  }
  if (!stands_for_several(*view_, control)) return false;
  const auto head = std::ranges::find(view_->labels, control, &interface::FloorLabel::control);
  view_->open = static_cast<std::int32_t>(head - view_->labels.begin());
  open_seconds_ = 0;
  is_placed_ = false;
  return true;
}

void Overlay::move_focus(int step) noexcept {
  if (!view_ || view_->controls.empty()) return;
  const auto count = static_cast<std::int32_t>(view_->controls.size());
  std::int32_t at = focus_ < 0 && step < 0 ? 0 : focus_;
  for (std::int32_t tried = 0; tried < count; ++tried) {
    at = (at + step + count) % count;
    const interface::Control& control = view_->controls[static_cast<std::size_t>(at)];
    const bool is_there = control.rect.width > 0 || lies_in_scroll(*view_, at);
    if (control.role == interface::Role::Spot || !control.enabled || !is_there) continue;
    focus_ = at;
    return reveal_focus();
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
  const float offset = pixels_of(view, leaving ? leaving_scroller_ : scroller_);
  for (const interface::Element& element : view.elements) {
    if (element.is_panel && leaving) continue;
    scene::Quad quad = element.quad;
    float shown = element.stays ? unchanged_opacity : opacity;
    if (element.scrolls) {
      quad = interface::moved(view.scroll, quad, offset);
      if (!interface::is_seen(view.scroll, quad)) continue;
    }
    if (is_end_of_scroll(view, element.control)) shown *= 0.35F;
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

/// Which part of what scrolls is seen.
void Overlay::draw_thumb(float opacity, scene::DrawList& list) const noexcept {
  const interface::ScrollArea& area = view_->scroll;
  if (!area.exists() || area.rail.height <= 0) return;
  constexpr float wide = 0.8F, least = 3;  // units
  const float x = area.rail.x + area.rail.width / 2;
  const float width = wide * view_->unit_px / view_->pixel_width;
  const float shortest = std::min(area.rail.height, least * view_->unit_px / view_->pixel_height);
  const float height = std::max(shortest, area.rail.height * area.rect.height / area.length);
  const float share = area.most() > 0 ? scrolled() / area.most() : 0;
  const float y = area.rail.y + share * (area.rail.height - height);
  const auto bar = [&](float top, float tall, scene::Colour colour) {
    scene::Quad quad;
    quad.rect = {x - width / 2, top, width, tall};
    quad.corner = width * view_->pixel_width / 2 / shorter_px(*view_);
    quad.colour = scene::with_opacity(colour, opacity);
    list.quads.push_back(quad);
  };
  bar(area.rail.y, area.rail.height, view_->theme.plaster);
  bar(y, height, view_->theme.quiet_ink);
}

/// A dot for each second, of which those that are over are pale.
void Overlay::draw_countdown(float opacity, scene::DrawList& list) const noexcept {
  const scene::Theme& theme = view_->theme;
  const scene::Rect& at = view_->countdown;
  if (at.width <= 0) return;
  constexpr int dots = static_cast<int>(countdown_seconds);
  constexpr float size = 0.11F;  // of the ring
  for (int i = 0; i < dots; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / dots;
    const float reach = (1 - size) / 2;
    scene::Quad dot;
    dot.rect = around(at.x + at.width * (0.5F + reach * std::sin(angle)),
                      at.y + at.height * (0.5F - reach * std::cos(angle)), size * at.width,
                      size * at.height);
    dot.corner = size * at.width * view_->pixel_width / 2 / shorter_px(*view_);
    const bool is_left = static_cast<float>(dots - i) <= seconds_left_;
    dot.colour = scene::with_opacity(is_left ? theme.focus : theme.plaster, opacity);
    list.quads.push_back(dot);
  }
}

void Overlay::draw_focus(scene::DrawList& list) const noexcept {
  if (focus_ < 0 || !view_) return;
  const scene::Theme& theme = view_->theme;
  const scene::Rect& rect = view_->controls[static_cast<std::size_t>(focus_)].rect;
  if (rect.width <= 0) return;
  // An outline, which leaves what it is about as it is: dark beside light is seen on every ground.
  const float unit = view_->unit_px;
  constexpr float pale_reach = 0.9F, dark_reach = 0.7F, pale = 0.9F, dark = 0.5F;  // units
  for (const auto& [reach, thick, colour] :
       {std::tuple{pale_reach, pale, theme.paper}, std::tuple{dark_reach, dark, theme.focus}}) {
    const float x = reach * unit / view_->pixel_width, y = reach * unit / view_->pixel_height;
    list.quads.push_back({.rect = {rect.x - x, rect.y - y, rect.width + 2 * x, rect.height + 2 * y},
                          .fill = scene::QuadFill::Frame,
                          .colour = colour,
                          .corner = (1.5F + reach) * unit / shorter_px(*view_),
                          .softness = thick * unit / shorter_px(*view_)});
  }
}

/// Dots from what a label marks to where it has made way to.
void Overlay::draw_leader(const interface::View& view, const interface::FloorLabel& label,
                          float opacity, scene::DrawList& list) const noexcept {
  const scene::Theme& theme = view.theme;
  constexpr float step = 1.2F, dot = 0.45F;  // units
  const auto [from, to] = leader_of(view, label);
  const float across = (to.x - from.x) * view.pixel_width,
              down = (to.y - from.y) * view.pixel_height;
  const auto dots = static_cast<int>(std::hypot(across, down) / (step * view.unit_px));
  if (dots < 1 || list.quads.size() + static_cast<std::size_t>(dots) > list.quads.capacity() / 2)
    return;
  const float size = dot * view.unit_px;
  for (int i = 0; i < dots; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(dots);
    scene::Quad quad;
    quad.rect = around(std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share),
                       size / view.pixel_width, size / view.pixel_height);
    quad.corner = size / 2 / shorter_px(view);
    quad.colour = scene::with_opacity(theme.quiet_ink, opacity);
    list.quads.push_back(quad);
  }
}

void Overlay::draw_labels(const interface::View& view, float opacity,
                          scene::DrawList& list) const noexcept {
  const scene::Theme& theme = view.theme;
  if (opacity <= 0.002F) return;
  const float shorter = shorter_px(view);
  // Lines lie below all labels. A name that has not left its gallery needs none.
  for (const interface::FloorLabel& label : view.labels)
    if (label.rect.width > 0 && (label.is_led || !is_name(label)))
      draw_leader(view, label, opacity, list);
  draw_cluster(view, opacity, list);
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
    ground.colour = scene::with_opacity(selected          ? theme.invitation
                                        : label.is_sign   ? theme.quiet_ink
                                        : label.is_closed ? theme.plaster
                                                          : theme.paper,
                                        is_name(label) ? 0.74F * opacity : opacity);
    if (!is_name(label) && !label.is_sign) {  // paper is seen on paper by its edge
      scene::Quad edge = ground;
      const float x = 0.25F * view.unit_px / view.pixel_width,
                  y = 0.25F * view.unit_px / view.pixel_height;
      edge.rect = {edge.rect.x - x, edge.rect.y - y, edge.rect.width + 2 * x,
                   edge.rect.height + 2 * y};
      edge.corner += 0.25F * view.unit_px / shorter;
      edge.colour = scene::with_opacity(theme.quiet_ink, opacity);
      if (label.held > 0 && view.open < 0) draw_stack(edge, ground, opacity, view, list);
      list.quads.push_back(edge);
    }
    list.quads.push_back(ground);
    scene::Quad text;
    text.fill = scene::QuadFill::Text;
    text.texture = label.texture;
    text.side = label.side;
    text.rect = label.rect;
    text.rect.x = std::round(text.rect.x * view.pixel_width) / view.pixel_width;
    text.rect.y = std::round(text.rect.y * view.pixel_height) / view.pixel_height;
    const scene::Colour ink = selected || label.is_sign ? theme.paper
                              : label.is_closed         ? theme.quiet_ink
                                                        : theme.ink;
    text.colour = scene::with_opacity(ink, opacity);
    list.quads.push_back(text);
    if (label.is_closed)
      list.quads.push_back(strike_through(view, ground.rect, scene::with_opacity(ink, opacity)));
  }
}

void Overlay::draw_inset(const interface::View& view, float opacity, const GuideSpot& guide,
                         scene::DrawList& list) const noexcept {
  const scene::Theme& theme = view.theme;
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
    disc(guide.at, 1.8F, 0, inset.guide);
  }
  // A small figure: a body, and a head above it.
  const float share = reduced_motion_ ? 1 : std::min(1.0F, run_ / run_seconds);
  const Vec2 at = point_on(inset, share * inset.reach.back());
  disc(at, 2.2F, 0.9F, theme.paper);
  disc(at, 1.7F, 2.4F, theme.paper);
  disc(at, 1.6F, 0.9F, theme.ink);
  disc(at, 1.1F, 2.4F, theme.ink);
}

void Overlay::draw(float remaining, float labels_opacity, const GuideSpot& guide,
                   scene::DrawList& list) const noexcept {
  if (!view_) return;
  const std::size_t first = list.quads.size();
  if (!is_placed_) labels_opacity = 0;
  const float t = is_fading() ? static_cast<float>(scene::ease_out(age_ / fade_seconds)) : 1;
  if (leaving_) draw_labels(*leaving_, labels_opacity * (1 - t), list);
  draw_labels(*view_, labels_opacity * t, list);

  draw_elements(*view_, t, 1, false, list);
  if (leaving_) {
    draw_elements(*leaving_, 1 - t, 0, true, list);
    if (view_->remaining.empty()) draw_remaining(*leaving_, remaining, 1 - t, list);
  }
  draw_remaining(*view_, remaining, leaving_ && leaving_->remaining.empty() ? t : 1, list);
  draw_listened(t, list);
  draw_cue(t, list);
  draw_thumb(t, list);
  draw_countdown(t, list);
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
  if (view_->side == scene::Side::Bottom) return;
  for (scene::Quad& quad : std::span(list.quads).subspan(first)) {
    const scene::ScreenPoint corner{quad.rect.x, quad.rect.y};
    const scene::ScreenPoint at = scene::to_screen(view_->side, corner);
    // What is hidden is turned, too: it differs where it will be seen.
    quad.rect = quad.rect.width > 0 ? scene::to_screen(view_->side, quad.rect)
                                    : scene::Rect{at.x, at.y, 0, 0};
    quad.side = view_->side;
  }
}

}  // namespace docent::guide

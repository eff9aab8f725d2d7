/// What an overlay reads off as time passes.
#include <algorithm>
#include <cmath>

#include "runtime/guide/overlay.h"
#include "runtime/interface/scroll.h"
#include "runtime/scene/theme.h"

namespace docent::guide {
namespace {

/// It stays in the list and is not to be seen: letters are as large as their texture's part.
void hide(scene::Quad& quad) noexcept {
  quad.rect.width = quad.rect.height = 0;
  quad.uv = {};
}

}  // namespace

void Overlay::draw_remaining(const interface::View& view, float metres, float opacity,
                             scene::DrawList& list) const noexcept {
  for (const interface::CountedText& text : view.remaining) {
    if (metres > text.metres) continue;
    scene::Quad quad = text.quad;
    if (view.remaining_scrolls) {
      const bool is_leaving = &view == leaving_.get();
      quad = interface::moved(view.scroll, quad,
                              pixels_of(view, is_leaving ? leaving_scroller_ : scroller_));
      if (!interface::is_seen(view.scroll, quad)) return;
    }
    quad.colour = scene::with_opacity(quad.colour, opacity);
    list.quads.push_back(quad);
    return;
  }
}

/// As many quads whether one is read or not, so that nothing else is taken for changed.
void Overlay::draw_cue(float opacity, scene::DrawList& list) const noexcept {
  if (view_->cues.empty()) return;
  const float at = video_seconds_.value_or(-1);
  const auto read = std::ranges::find_if(view_->cues, [&](const interface::TimedText& cue) {
    return cue.begin <= at && at < cue.end;
  });
  const bool is_read = read != view_->cues.end();
  const interface::TimedText& cue = is_read ? *read : view_->cues.front();
  for (scene::Quad quad : {cue.ground, cue.quad}) {
    if (view_->cues_scroll) {
      quad = interface::moved(view_->scroll, quad, pixels_of(*view_, scroller_));
      if (!interface::is_seen(view_->scroll, quad)) hide(quad);
    }
    if (!is_read) hide(quad);
    quad.colour = scene::with_opacity(quad.colour, opacity);
    list.quads.push_back(quad);
  }
}

/// A line along the lower edge of the button that stops the sound, which fills from where lines
/// begin, pixel by pixel.
void Overlay::draw_listened(float opacity, scene::DrawList& list) const noexcept {
  if (!listened_) return;
  const auto playing = std::ranges::find_if(view_->controls, [](const interface::Control& one) {
    return one.action.kind == interface::Action::Kind::StopSound;
  });
  if (playing == view_->controls.end() || playing->rect.height <= 0) return;
  const scene::Theme& theme = view_->theme;
  const float unit_x = view_->unit_px / view_->pixel_width,
              unit_y = view_->unit_px / view_->pixel_height;
  constexpr float inset = 2, thick = 0.5F;
  scene::Quad rail;
  rail.rect = {playing->rect.x + inset * unit_x,
               playing->rect.y + playing->rect.height - 2 * thick * unit_y,
               playing->rect.width - 2 * inset * unit_x, thick * unit_y};
  rail.colour = scene::with_opacity(theme.paper, opacity);
  list.quads.push_back(rail);
  scene::Quad heard = rail;
  const float pixels =
      std::floor(std::clamp(*listened_, 0.0F, 1.0F) * rail.rect.width * view_->pixel_width);
  heard.rect.width = pixels / view_->pixel_width;
  if (view_->is_right_to_left) heard.rect.x += rail.rect.width - heard.rect.width;
  heard.colour = scene::with_opacity(theme.quiet_ink, opacity);
  list.quads.push_back(heard);
}

}  // namespace docent::guide

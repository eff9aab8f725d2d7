/// What an overlay reads off as time passes.
#include <algorithm>

#include "runtime/guide/overlay.h"
#include "runtime/interface/scroll.h"
#include "runtime/scene/theme.h"

namespace docent::guide {

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
      if (!interface::is_seen(view_->scroll, quad)) quad.rect.width = 0;
    }
    if (!is_read) quad.rect.width = 0;
    quad.colour = scene::with_opacity(quad.colour, opacity);
    list.quads.push_back(quad);
  }
}

}  // namespace docent::guide

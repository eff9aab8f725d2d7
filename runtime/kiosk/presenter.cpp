#include "runtime/kiosk/presenter.h"

#include <utility>

#include "runtime/kiosk/start_code.h"

namespace docent::kiosk {

Presenter::Presenter(const config::KioskConfig& config, Edges& edges, gles::Renderer renderer,
                     PosterFile poster, bool has_poster)
    : edges_(edges),
      renderer_(std::move(renderer)),
      poster_(std::move(poster), has_poster),
      hours_(config.screen_on, config.idle_reset),
      wanders_(config.pixel_shift),
      has_poster_(has_poster) {
  if (edges_.headless == nullptr) heat_.emplace();
}

/// A screen shows every frame that differs from the one before, but keeps its poster until there is
/// as much to see, for a moment. In memory only those are drawn that somebody will look at, and two
/// a second for the statistics: a visit of minutes then takes seconds.
bool Presenter::is_seen(const FrameFacts& frame) const noexcept {
  constexpr std::uint64_t sampled_every = 30;
  constexpr double longest_poster = 2;
  if (edges_.headless != nullptr)
    return frame.is_asked_for || frame.is_touched || frame.number % sampled_every == 0;
  if (has_poster_ && !frame.is_first_picture && !frame.is_touched &&
      poster_seconds_ < longest_poster)
    return false;
  return edges_.display->can_show() && heat_->lets_show(frame.number);
}

/// What would look different on a screen that was drawn to before?
scene::Change Presenter::change(const scene::DrawList& list,
                                const RenderTarget& target) const noexcept {
  if (edges_.headless != nullptr || edges_.display->wants_frame() || target != shown_on_) return {};
  return shown_.change(list, static_cast<float>(target.size.height));
}

/// The first picture is there sooner with a quarter of the model's pixels; the next has all of
/// them. In memory nobody waits for others.
float Presenter::fineness_of(const FrameFacts& frame, const RenderTarget& target) noexcept {
  constexpr float of_first = 0.5F;
  if (frame.number == 0 && !frame.is_asked_for) return of_first;
  if (edges_.headless != nullptr) return 1;
  if (has_drawn_model_) fineness_.took(frame.passed, target.size);
  return fineness_.share();
}

bool Presenter::show(const scene::DrawList& list, const gles::Holdings& holdings,
                     const FrameFacts& frame, Statistics& statistics) noexcept {
  const RenderTarget target = target_of(edges_);
  const scene::Change different = change(list, target);
  const float fineness = fineness_of(frame, target);
  if (has_drawn_bodies_ && edges_.headless == nullptr) time_for_video_.took(frame.passed);
  has_drawn_ = is_seen(frame) && !(different.nothing() && !renderer_.is_coarse());
  has_drawn_model_ = has_drawn_ && (different.everything || different.model);
  has_drawn_bodies_ =
      has_drawn_ && !has_drawn_model_ && different.bodies.any() && !renderer_.is_coarse();
  if (!has_drawn_) return false;
  has_poster_ = false;
  gpu_timer_.begin();
  renderer_.draw(list, holdings, target, different, fineness, edges_.display->age());
  gpu_timer_.end();
  poster_.drawn(frame.is_first_picture && !renderer_.is_coarse(), target);
  edges_.display->present();
  if (edges_.headless == nullptr) shown_.keep(list, different);
  shown_on_ = target;
  while (const auto gpu = gpu_timer_.take()) statistics.gpu.add(*gpu);
  return true;
}

/// In a new view a software driver may compile once more, which brings its compiler's code back.
void Presenter::give_back_code(const FrameFacts& frame) noexcept {
  constexpr std::uint64_t frames_to_settle = 30;  // half a second
  if (frame.is_new_view) settled_at_ = frame.number + frames_to_settle;
  const bool was_vacant = std::exchange(was_vacant_, frame.is_vacant);
  if (frame.number == 0 || frame.number == settled_at_ || (frame.is_vacant && !was_vacant))
    give_back_code_of_start();
}

void Presenter::keep(const FrameFacts& frame) noexcept {
  give_back_code(frame);
  if (edges_.headless != nullptr) return;
  poster_.step();
  if (has_poster_) poster_seconds_ += frame.passed;
  if (hours_.are_set())
    edges_.display->light(hours_.is_lit(local_minute(), frame.passed, frame.is_touched));
  if (!wanders_) return;
  shift_.advance(frame.passed, frame.is_new_view);
  edges_.shift = shift_.at();
}

}  // namespace docent::kiosk

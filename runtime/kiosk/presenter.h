#pragma once

#include <cstdint>
#include <optional>

#include "config/kiosk_config.h"
#include "platform/gles/gpu_timer.h"
#include "platform/gles/holdings.h"
#include "platform/gles/renderer.h"
#include "runtime/kiosk/edges.h"
#include "runtime/kiosk/fineness.h"
#include "runtime/kiosk/heat_watch.h"
#include "runtime/kiosk/pixel_shift.h"
#include "runtime/kiosk/poster.h"
#include "runtime/kiosk/screen_hours.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/kiosk/time_for_video.h"
#include "runtime/scene/shown_list.h"

namespace docent::kiosk {

/// What is about a frame that decides whether and how it is drawn.
struct FrameFacts {
  std::uint64_t number = 0;       ///< Since the start.
  double passed = 0;              ///< Seconds since the one before.
  bool is_asked_for = false;      ///< In memory only those are drawn that somebody looks at.
  bool is_touched = false;        ///< Somebody touched since the one before.
  bool is_vacant = true;          ///< Nobody is being guided.
  bool is_new_view = false;       ///< It is the first one of a view.
  bool is_first_picture = false;  ///< It is what the next visitor sees: all there, nobody served.
};

/// The kiosk's picture on its screen: draws a frame where it would look different from what is
/// there, lets it wander, and keeps the screen's hours. Borrows the edges. For the frame thread;
/// nothing here allocates after the first frame, or waits, but for the driver's own affairs.
class Presenter {
 public:
  /// `poster`: where the first picture is kept; `has_poster`: it is on the screen now.
  Presenter(const config::KioskConfig& config, Edges& edges, gles::Renderer renderer,
            PosterFile poster, bool has_poster);

  gles::Renderer& renderer() noexcept { return renderer_; }
  RenderTarget target() const noexcept { return target_of(edges_); }

  /// Draws the list and presents it, where it is to be seen; returns whether it did.
  bool show(const scene::DrawList& list, const gles::Holdings& holdings, const FrameFacts& frame,
            Statistics& statistics) noexcept;
  /// After each frame: hours, wandering, and what the driver still owes.
  void keep(const FrameFacts& frame) noexcept;
  /// What was drawn looks different now: textures have changed.
  void forget() noexcept { shown_.forget(); }
  /// This one alone has.
  void forget(scene::TextureId texture) noexcept { shown_.forget(texture); }
  /// Is there no time to draw bodies that move while a video plays? Never in memory.
  bool lacks_time_for_video() const noexcept { return time_for_video_.is_short(); }
  /// Was the frame before drawn?
  bool has_drawn() const noexcept { return has_drawn_; }

 private:
  bool is_seen(const FrameFacts& frame) const noexcept;
  void give_back_code(const FrameFacts& frame) noexcept;
  scene::Change change(const scene::DrawList& list, const RenderTarget& target) const noexcept;
  float fineness_of(const FrameFacts& frame, const RenderTarget& target) noexcept;

  Edges& edges_;
  gles::Renderer renderer_;
  gles::GpuTimer gpu_timer_;
  PosterKeeper poster_;
  ScreenHours hours_;
  PixelShift shift_;
  bool wanders_;
  bool has_poster_;
  double poster_seconds_ = 0;      ///< How long frames were held back for it.
  std::optional<HeatWatch> heat_;  ///< Of a display that shows something.
  scene::ShownList shown_;         ///< On the display.
  RenderTarget shown_on_;
  Fineness fineness_;
  TimeForVideo time_for_video_;
  /// In the frame before; all of the model; nothing of it but bodies.
  bool has_drawn_ = false, has_drawn_model_ = false, has_drawn_bodies_ = false;
  bool was_vacant_ = true;
  std::uint64_t settled_at_ = 0;  ///< The frame at which a new view has been drawn whole.
};

}  // namespace docent::kiosk

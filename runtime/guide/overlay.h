#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "runtime/guide/scroller.h"
#include "runtime/input/gesture.h"
#include "runtime/interface/view.h"
#include "runtime/scene/camera.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// The interface on the glass: the view that is shown, the one that is leaving, what is pressed,
/// what has the keypad's focus, and the rings that answer touches. Frame: the glass as it is seen
/// from the view's side; fingers come in it, and only what is drawn is in the screen frame.
class Overlay {
 public:
  /// `reduced_motion`: nothing fades, glides or grows; it is there, or it is not.
  explicit Overlay(bool reduced_motion = false) noexcept
      : reduced_motion_(reduced_motion),
        scroller_(reduced_motion),
        leaving_scroller_(reduced_motion) {}

  /// Another view: the panel stays, what both have in common stays, the rest fades.
  void enter(std::unique_ptr<interface::View> view) noexcept;
  void advance(float seconds) noexcept;
  /// Spots and names follow the camera; when it stands still, or `is_held` by a visitor, they make
  /// way for each other.
  void follow(const scene::CameraView& camera, float floor_height, bool is_held = false) noexcept;

  /// From which edges of a table what is written on the model is read; none: from below.
  void turn_labels(interface::Sides readers) noexcept {
    if (readers != readers_) is_placed_ = false;
    readers_ = readers;
  }

  /// The control at a point of the screen: one of the panel's, or else the nearest spot of the
  /// model within reach; -1 where there is none.
  std::int32_t control_at(float x, float y) const noexcept;
  /// Is that a point of the model, beside everything that lies on it?
  bool is_on_model(float x, float y) const noexcept;
  /// A ring, and nothing else.
  void ring(float x, float y) noexcept;
  /// A finger came down: answers with a ring and holds the control under it.
  void touch_down(const input::Finger& finger) noexcept;
  /// A finger moved: it may drag what scrolls, and then presses nothing. True where it does.
  bool touch_move(const input::Finger& finger) noexcept;
  bool is_dragged_by(std::uint32_t finger) const noexcept;
  /// Turns what scrolls by so many pages: up below 0.
  void turn(int pages) noexcept;
  /// How far that has been moved. Share of the screen's height, on whole pixels.
  float scrolled() const noexcept;
  /// A finger left: returns the control that it pressed, -1 unless it left the one it came down on.
  std::int32_t touch_up(const input::Finger& finger) noexcept;

  /// A touch of a disc that stands for several shows them all; one beside them, or of one of them,
  /// puts them away again. True where that was all it did.
  bool open_or_close(std::int32_t control) noexcept;

  /// Moves the keypad's focus by `step` in focus order; nothing has it before the first key.
  void move_focus(int step) noexcept;
  void clear_focus() noexcept { focus_ = -1; }
  std::int32_t focus() const noexcept { return focus_; }

  const interface::View* view() const noexcept { return view_.get(); }
  /// From where it is read.
  scene::Side side() const noexcept { return view_ ? view_->side : scene::Side::Bottom; }
  bool is_scrolling() const noexcept { return scroller_.is_moving(); }
  bool is_fading() const noexcept { return !reduced_motion_ && age_ < fade_seconds; }

  /// Seconds until the visitor counts as gone, of `countdown_seconds`; a ring shows them where the
  /// view has room for one.
  void count_down(float seconds_left) noexcept { seconds_left_ = seconds_left; }
  static constexpr float countdown_seconds = 20;

  /// Which share of a sound has been heard, on its button; nothing: none plays.
  void listen(std::optional<float> share) noexcept { listened_ = share; }
  /// How far the video or the sound of the view has come, whose captions are shown; nothing: none
  /// plays.
  void watch(std::optional<float> seconds) noexcept { video_seconds_ = seconds; }

  /// Where the guide is, for the inset plan.
  struct GuideSpot {
    std::uint32_t floor = 0;
    Vec2 at{};
  };
  /// Appends the quads of the interface. `remaining`: metres that the guide still has to walk;
  /// `labels_opacity`: of what is written on the model.
  void draw(float remaining, float labels_opacity, const GuideSpot& guide,
            scene::DrawList& list) const noexcept;

 private:
  static constexpr float fade_seconds = 0.26F;
  static constexpr float ring_seconds = 0.45F;
  static constexpr std::size_t most_presses = 40;  ///< Of all fingers at a shared glass.

  struct Ring {
    float x = 0, y = 0, age = ring_seconds;
  };
  struct Press {
    std::uint32_t finger = 0;
    std::int32_t control = -1;
    bool held = false;
    bool drags = false;  ///< What scrolls.
    float age = 1;       ///< Seconds since it was let go.
  };

  float press_depth(std::int32_t control) const noexcept;
  float pixels_of(const interface::View& view, const Scroller& scroller) const noexcept;
  void reveal_focus() noexcept;
  void draw_thumb(float opacity, scene::DrawList& list) const noexcept;
  void draw_elements(const interface::View& view, float opacity, float unchanged_opacity,
                     bool leaving, scene::DrawList& list) const noexcept;
  void draw_focus(scene::DrawList& list) const noexcept;
  void draw_countdown(float opacity, scene::DrawList& list) const noexcept;
  void draw_leader(const interface::View& view, const interface::FloorLabel& label, float opacity,
                   scene::DrawList& list) const noexcept;
  void draw_labels(const interface::View& view, float opacity,
                   scene::DrawList& list) const noexcept;
  void draw_cluster(const interface::View& view, float opacity,
                    scene::DrawList& list) const noexcept;
  void close_cluster() noexcept;
  void draw_inset(const interface::View& view, float opacity, const GuideSpot& guide,
                  scene::DrawList& list) const noexcept;
  void draw_remaining(const interface::View& view, float metres, float opacity,
                      scene::DrawList& list) const noexcept;
  void draw_cue(float opacity, scene::DrawList& list) const noexcept;
  void draw_listened(float opacity, scene::DrawList& list) const noexcept;

  bool reduced_motion_;
  Scroller scroller_, leaving_scroller_;
  std::unique_ptr<interface::View> view_, leaving_;
  std::optional<scene::CameraView> camera_;  ///< That the labels follow, ...
  bool is_placed_ = false;  ///< ... and for which they have made way for each other.
  interface::Sides readers_{};
  float age_ = 1;  ///< Seconds since view_ was entered.
  float seconds_left_ = 0;
  std::optional<float> video_seconds_{}, listened_{};
  float open_seconds_ = 0;  ///< Since a cluster was opened.
  float run_ = 0;           ///< Seconds since the figure on the inset plan set out.
  std::int32_t focus_ = -1;
  std::array<Ring, most_presses> rings_{};
  std::array<Press, most_presses> presses_{};
  std::size_t next_ring_ = 0;
};

}  // namespace docent::guide

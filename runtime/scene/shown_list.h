#pragma once

#include <bitset>

#include "runtime/scene/draw_list.h"

namespace docent::scene {

/// What of a picture has to be drawn anew.
struct Change {
  static constexpr std::size_t most_bodies = 64;

  bool everything = true;  ///< Otherwise only what follows.
  bool model = false;      ///< All of the model, wherever it is seen: the camera has moved.
  Rect interface{};  ///< About the rectangles of the interface that differ; without width: none.
  std::bitset<most_bodies> bodies{};  ///< Which of the avatars have moved.
  bool ways = false;                  ///< Ways look different where they are.

  bool nothing() const noexcept {
    return !everything && !model && interface.width <= 0 && bodies.none() && !ways;
  }
};

/// Remembers what a screen shows, and says whether another draw list would look different there: a
/// frame that would not need not be drawn.
///
/// A body that breathes moves by less than a pixel between most frames. It counts as moved once a
/// part of it is an eighth of a pixel from where it was drawn, half of what four samples a pixel
/// can show. All else is compared exactly.
class ShownList {
 public:
  /// What would look different of `list` on a screen that is `pixels_high`: everything until
  /// something was kept. Does not allocate.
  Change change(const DrawList& list, float pixels_high) const noexcept;
  bool differs(const DrawList& list, float pixels_high) const noexcept {
    return !change(list, pixels_high).nothing();
  }
  /// `list` is drawn, as far as `change` says: bodies that have not been seen to move stay
  /// remembered where they were drawn. Takes as much memory as the list has reserved, the first
  /// time.
  void keep(const DrawList& list, const Change& change = {});
  /// What was drawn is lost.
  void forget() noexcept { is_kept_ = false; }
  /// This texture has other contents now: what shows it looks different. None: nothing does.
  void forget(TextureId texture) noexcept;

 private:
  bool model_differs(const DrawList& list) const noexcept;
  bool has_moved(const DrawList& list, std::size_t avatar, float pixels_high) const noexcept;
  void keep_bodies(const DrawList& list, const Change& change);

  bool is_kept_ = false;
  DrawList kept_;
};

}  // namespace docent::scene

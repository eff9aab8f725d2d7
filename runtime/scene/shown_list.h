#pragma once

#include "runtime/scene/draw_list.h"

namespace docent::scene {

/// Remembers what a screen shows, and says whether another draw list would look different there: a
/// frame that would not need not be drawn.
///
/// A body that breathes moves by less than a pixel between most frames. It counts as moved once a
/// part of it is an eighth of a pixel from where it was drawn, half of what four samples a pixel
/// can show. All else is compared exactly.
class ShownList {
 public:
  /// Would `list` look different on a screen that is `pixels_high`? True until something was kept.
  /// Does not allocate.
  bool differs(const DrawList& list, float pixels_high) const noexcept;
  /// `list` is drawn. Takes as much memory as the list has reserved, the first time.
  void keep(const DrawList& list);
  /// What was drawn is lost.
  void forget() noexcept { is_kept_ = false; }

 private:
  bool bodies_differ(const DrawList& list, float pixels_high) const noexcept;

  bool is_kept_ = false;
  DrawList kept_;
};

}  // namespace docent::scene

#pragma once

#include <cstdint>
#include <optional>

#include "runtime/input/contact.h"
#include "runtime/interface/view.h"

namespace docent::guide {

/// How far the part of a view that scrolls has been moved: by one finger, which drags it and lets
/// it run on calmly; or a page at a time.
///
/// For the frame thread; nothing allocates or throws. Lengths are shares of the screen's height.
class Scroller {
 public:
  /// `reduced_motion`: nothing runs on or glides.
  explicit Scroller(bool reduced_motion) noexcept : reduced_motion_(reduced_motion) {}

  float offset() const noexcept { return offset_; }
  bool is_moving() const noexcept { return glides_ || speed_ != 0; }

  /// Another view is shown: from its beginning, or where the last one was.
  void enter(const interface::ScrollArea& area, bool is_same) noexcept;
  /// A finger came down on the part.
  void hold(const input::Contact& at) noexcept;
  /// It moved. True where it drags the part by now, and so presses nothing. `slack`: how far up or
  /// down it has to go for that.
  bool drag(const interface::ScrollArea& area, const input::Contact& at, float slack) noexcept;
  void let_go(std::uint32_t finger) noexcept;
  /// A page up or down; to that offset.
  void turn(const interface::ScrollArea& area, int pages) noexcept;
  void go_to(float offset) noexcept;
  void advance(const interface::ScrollArea& area, float seconds) noexcept;

 private:
  bool reduced_motion_;
  float offset_ = 0;
  float speed_ = 0;  ///< A second; of what runs on.
  float from_ = 0, to_ = 0,
        glide_ = 0;  ///< Of a page that is turned; the share of it that is done.
  bool glides_ = false;
  std::optional<std::uint32_t> finger_;
  bool drags_ = false;
  float start_ = 0, last_ = 0;  ///< Where the finger came down, and was.
  float moved_ = 0;             ///< Since the last frame.
};

}  // namespace docent::guide

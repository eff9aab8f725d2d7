#pragma once

#include "runtime/interface/view.h"
#include "runtime/scene/camera.h"

namespace docent::guide {

inline scene::Rect around(float x, float y, float width, float height) noexcept {
  return {x - width / 2, y - height / 2, width, height};
}

/// What a label covers where it is shown, with what it is drawn on. Screen frame.
scene::Rect ground_of(const interface::View& view, const interface::FloorLabel& label) noexcept;

/// From what a label marks to the edge of what it covers. Screen frame.
struct Leader {
  scene::ScreenPoint from, to;
};
Leader leader_of(const interface::View& view, const interface::FloorLabel& label) noexcept;

/// Is it the name of a gallery?
inline bool is_name(const interface::FloorLabel& label) noexcept {
  return !label.on_disc && !label.is_sign;
}

/// Puts every label where the camera sees what it marks, whatever it covers there; what is out of
/// the picture gets an empty rectangle. `floor_height`: metres.
void project_labels(interface::View& view, const scene::CameraView& camera,
                    float floor_height) noexcept;

/// Places the labels so that none covers another, a control, or a text of the panel, and none
/// leaves the free part. Names of galleries come first and stay about their gallery; then exhibits,
/// what is selected before the rest; then places. A spot that is moved stays within a few
/// fingertips of what it marks, and keeps its `anchor`. A name or a place that finds no room there
/// goes further away, with a line that crosses no label and no other such line (`leader_of`), after
/// all that have room. What has none even then gets an empty rectangle: an exhibit is in the
/// cluster of the one nearest to it, and the list leads to places. The cluster that is open lies on
/// a board of its own, each of it to be touched. Does not allocate.
void place_labels(interface::View& view, const scene::CameraView& camera,
                  float floor_height) noexcept;

/// Does this control stand for others too, which are not to be seen yet?
bool stands_for_several(const interface::View& view, std::int32_t control) noexcept;
/// The control that stands for this one, which is in its cluster; -1: none does.
std::int32_t head_of(const interface::View& view, std::int32_t control) noexcept;

}  // namespace docent::guide

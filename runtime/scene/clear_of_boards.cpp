#include "runtime/scene/clear_of_boards.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace docent::scene {
namespace {

constexpr std::size_t most_things = 4;
constexpr double further = 1.06, most_times_further = 3;

/// How far a picture may be moved along one axis: what is tried.
struct Moves {
  std::array<float, 1 + most_things * 12> by{};
  std::size_t count = 1;  ///< The first is not to move.

  void add(float move) noexcept {
    if (count < by.size()) by[count++] = move;
  }
  std::span<const float> all() const noexcept { return {by.data(), count}; }
};

struct Boxes {
  std::array<Rect, most_things> box{};
  std::size_t count = 0;

  std::span<const Rect> all() const noexcept { return {box.data(), count}; }
};

Rect grown(const Rect& r, float x, float y) noexcept {
  return {r.x - x, r.y - y, r.width + 2 * x, r.height + 2 * y};
}

bool meet(const Rect& a, const Rect& b) noexcept {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool holds(const Rect& outer, const Rect& inner) noexcept {
  constexpr float hair = 1e-5F;
  return inner.x >= outer.x - hair && inner.y >= outer.y - hair &&
         inner.x + inner.width <= outer.x + outer.width + hair &&
         inner.y + inner.height <= outer.y + outer.height + hair;
}

/// Things as they are seen, with the margin about them; none where one is behind the eye.
std::optional<Boxes> boxes_of(const CameraView& view, std::span<const Thing> things,
                              float aspect) noexcept {
  Boxes boxes;
  for (const Thing& thing : things.first(std::min(things.size(), most_things))) {
    const Rect seen = seen_box(view, thing);
    if (seen.width <= 0) return {};
    boxes.box[boxes.count++] = grown(seen, clear_margin / aspect, clear_margin);
  }
  return boxes;
}

/// Just past each edge.
void add_moves(const Rect& thing, std::span<const Rect> boards, const Rect& free, Moves& across,
               Moves& down) noexcept {
  constexpr float past = 1e-4F;
  across.add(free.x - thing.x);
  across.add(free.x + free.width - thing.x - thing.width);
  down.add(free.y - thing.y);
  down.add(free.y + free.height - thing.y - thing.height);
  for (const Rect& board : boards) {
    across.add(board.x - thing.x - thing.width - past);
    across.add(board.x + board.width - thing.x + past);
    down.add(board.y - thing.y - thing.height - past);
    down.add(board.y + board.height - thing.y + past);
  }
}

struct Move {
  float x = 0, y = 0;
};

/// The least one after which all is seen.
std::optional<Move> least_move(const Boxes& boxes, std::span<const Rect> boards, const Rect& free,
                               float aspect) noexcept {
  Moves across, down;
  for (const Rect& box : boxes.all()) add_moves(box, boards, free, across, down);
  const auto is_seen = [&](Move move) {
    return std::ranges::all_of(boxes.all(), [&](Rect box) {
      box.x += move.x;
      box.y += move.y;
      return holds(free, box) &&
             std::ranges::none_of(boards, [&](const Rect& board) { return meet(box, board); });
    });
  };
  std::optional<Move> best;
  float least = 1e9F;
  for (const float x : across.all())
    for (const float y : down.all()) {
      const float length = std::hypot(x * aspect, y);
      if (length >= least || !is_seen({x, y})) continue;
      least = length;
      best = Move{x, y};
    }
  return best;
}

}  // namespace

Rect seen_box(const CameraView& view, const Thing& thing) noexcept {
  float left = 1e9F, top = 1e9F, right = -1e9F, bottom = -1e9F;
  for (const float x : {thing.low.x, thing.high.x})
    for (const float y : {thing.low.y, thing.high.y})
      for (const float z : {thing.low.z, thing.high.z}) {
        const auto at = project(view, {x, y, z});
        if (!at) return {0, 0, 0, 0};
        left = std::min(left, at->x);
        right = std::max(right, at->x);
        top = std::min(top, at->y);
        bottom = std::max(bottom, at->y);
      }
  return {left, top, right - left, bottom - top};
}

CameraRig clear_of_boards(const CameraRig& rig, std::span<const Thing> things,
                          std::span<const Rect> boards, const Rect& free, float aspect) noexcept {
  CameraRig moved = rig;
  for (; moved.distance < most_times_further * rig.distance; moved.distance *= further) {
    const auto boxes = boxes_of(view_of(moved, aspect), things, aspect);
    if (!boxes) continue;
    if (const auto move = least_move(*boxes, boards, free, aspect)) {
      moved.centre_x += move->x;
      moved.centre_y += move->y;
      return moved;
    }
  }
  return rig;
}

}  // namespace docent::scene

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/guide/crowd.h"
#include "runtime/guide/leaf.h"
#include "runtime/model/museum.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// The leaves of all doors that staff have marked. Whoever goes through one that is closed turns it
/// with a hand on its bar and walks on; it is always turned far enough for who walks there, and
/// farther only as the hand comes along. Before one that slides, or has to be pulled, they stop,
/// draw it with a hand on its bar as far as that reaches, let it go on from there, and walk
/// through; two that slide go together. Where there is no place to stand out of its way, or others
/// come, it opens by itself. A leaf that is pulled, or opens so, waits some seconds for who is in
/// its way. Whoever comes next finds it open; when nobody has been near it for a while it closes by
/// itself.
///
/// Called by the frame thread. Only the constructor allocates.
class Doors {
 public:
  explicit Doors(const Museum& museum);

  /// Before the crowd's step of the same time: turns the leaves to where they are at its end, and
  /// sends hands there.
  void step(double seconds, Crowd& crowd) noexcept;

  const std::vector<Leaf>& leaves() const noexcept { return leaves_; }
  /// Appends the leaves of a floor.
  void draw(std::uint32_t floor, scene::DrawList& list) const noexcept;

 private:
  void begin_push(double seconds, Leaf& leaf, const Crowd& crowd) noexcept;
  void turn(double seconds, Leaf& leaf, Crowd& crowd) noexcept;
  double turned_by_hand(double seconds, double wanted, const Foresight& ahead, Leaf& leaf,
                        const Avatar& avatar) const noexcept;
  void begin_search(Leaf& leaf, const Crowd& crowd) noexcept;
  std::optional<Vec2> last_bend(const Leaf& leaf, const Agent& one, const LeafPassing& passing,
                                const Crowd& crowd) const noexcept;
  void search(Leaf& leaf, Crowd& crowd) const noexcept;
  void begin_drawing(Leaf& leaf, Crowd& crowd) const noexcept;
  void come_to_draw(double seconds, Leaf& leaf, Crowd& crowd) noexcept;
  void draw_open(double seconds, Leaf& leaf, Crowd& crowd) noexcept;
  void let_go(Leaf& leaf, Crowd& crowd) const noexcept;
  ClosedLeaf closed(const Leaf& leaf, double sign, double passed_at) const noexcept;
  Holder holder_of(const Avatar& avatar) const noexcept;
  static Avatar standing(const Museum& museum);
  bool is_free_for(std::uint32_t who, Vec2 place, const Leaf& leaf,
                   const Crowd& crowd) const noexcept;
  bool is_sweep_free(const Leaf& leaf, double ahead, const Crowd& crowd) const noexcept;
  bool may_open_on(const Leaf& leaf, const Crowd& crowd) const noexcept;
  Leaf* other_leaf(const Leaf& leaf) noexcept;
  bool is_awaited(const Leaf& leaf, const Crowd& crowd) const noexcept;
  void close(double seconds, Leaf& leaf, const Crowd& crowd) noexcept;

  const Museum& museum_;
  std::vector<Leaf> leaves_;
  Avatar standing_;  ///< As one stands: to know how far hands will reach.
};

/// Where on its bar a leaf is held, and what a hand there does: the palm lies on the bar.
motion::Grip grip_of(const Leaf& leaf, const Leaf::Push& push, double floor_height) noexcept;

}  // namespace docent::guide

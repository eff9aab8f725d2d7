#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <semaphore>
#include <thread>
#include <vector>

#include "runtime/plan/mailbox.h"
#include "runtime/plan/plan.h"
#include "runtime/plan/traffic.h"
#include "runtime/interface/layout.h"
#include "runtime/interface/piece_cache.h"

namespace docent {

/// The worker that answers routes, walks and views while frames go on. One thread of its own; every
/// public function but the constructor is for the frame thread, does not wait (but for wait()) and
/// does not allocate.
///
/// There is a letterbox for each avatar's orders and one for each part of the glass's view
/// requests, of which only the latest letter counts: what the visitor no longer wants is not worked
/// out. Boxes are emptied in the order in which they were filled, and answers come in that order.
class Planner {
 public:
  /// Borrows the museum. The makers are called on the worker only. `avatars`: how many there will
  /// be at most; `parts`: of the glass.
  Planner(const Museum& museum, PieceMakers makers, std::size_t avatars = 1, std::size_t parts = 1);
  ~Planner();
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;

  void ask(const WalkOrder& order) noexcept;
  void ask(const ViewRequest& request) noexcept;

  std::unique_ptr<Plan> take_plan() noexcept { return plans_.take(); }
  std::unique_ptr<View> take_view() noexcept { return views_.take(); }
  /// Changes of texture memory, to be applied in this order before the views that need them.
  std::unique_ptr<PieceChanges> take_pieces() noexcept { return pieces_.take(); }

  /// Waits until everything asked so far is answered: for runs that must repeat exactly.
  void wait() const noexcept;

  const std::vector<std::shared_ptr<const FloorMap>>& maps() const noexcept { return maps_; }

 private:
  /// Longer than there are avatars: who waits for the worker does not empty the belts meanwhile.
  static constexpr std::size_t belt_length = 512;

  void work();
  void answer_next();
  void answer(const WalkOrder& order);
  void answer(const ViewRequest& request);
  void announce(std::size_t box) noexcept;
  Traffic& traffic_on(std::uint32_t floor);

  const Museum& museum_;
  std::optional<WalkGraph> walking_;  ///< None where the museum's motion cannot walk.
  std::vector<std::shared_ptr<const FloorMap>> maps_;  ///< One per floor.
  PieceCache cache_;                                   ///< The worker's.
  std::vector<std::unique_ptr<Traffic>> traffic_;      ///< Per floor, made when it is needed.
  std::vector<LatestMail<WalkOrder>> orders_;          ///< Per avatar.
  std::vector<LatestMail<ViewRequest>> requests_;      ///< Per part of the glass.
  Round round_;  ///< The boxes of the avatars, then those of the parts.
  Belt<Plan, belt_length> plans_;
  Belt<View, belt_length> views_;
  Belt<PieceChanges, belt_length> pieces_;
  std::counting_semaphore<> letters_{0};
  std::atomic<std::uint64_t> asked_{0}, answered_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;  ///< Last: it uses all of the above.
};

}  // namespace docent

#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <semaphore>
#include <thread>
#include <vector>

#include "runtime/directions/doorways.h"
#include "runtime/interface/finder.h"
#include "runtime/interface/layout.h"
#include "runtime/interface/piece_cache.h"
#include "runtime/plan/fill_order.h"
#include "runtime/plan/plan.h"
#include "runtime/plan/rides.h"
#include "runtime/plan/single_producer_queue.h"
#include "runtime/plan/traffic.h"
#include "runtime/plan/triple_buffer.h"

namespace docent::plan {

/// The worker that answers routes, walks and views while frames go on. One thread of its own; every
/// public function but the constructor is for the frame thread, does not wait (but for wait()) and
/// does not allocate.
///
/// There is a triple buffer for each avatar's orders and one for each part of the glass's view
/// requests, of which only the latest counts: what the visitor no longer wants is not worked out.
/// They are answered in the order in which they were filled.
class Planner {
 public:
  /// Borrows the museum. The makers are called on the worker only. `avatars`: how many there will
  /// be at most; `parts`: of the glass.
  Planner(const Museum& museum, interface::PieceMakers makers, std::size_t avatars = 1,
          std::size_t parts = 1);
  ~Planner();
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;

  void ask(const WalkOrder& order) noexcept;
  void ask(const interface::ViewRequest& request) noexcept;

  std::unique_ptr<Plan> take_plan() noexcept { return plans_.take(); }
  /// Its state is the one asked about, with the visitor's own tour in order and what they search
  /// for found.
  std::unique_ptr<interface::View> take_view() noexcept { return views_.take(); }
  /// Changes of texture memory, to be applied in this order before the views that need them.
  std::unique_ptr<interface::PieceChanges> take_pieces() noexcept { return pieces_.take(); }

  /// Waits until everything asked so far is answered: for runs that must repeat exactly.
  void wait() const noexcept;

  /// How many avatars there may be.
  std::size_t avatars() const noexcept { return orders_.size(); }
  /// How many parts of the glass.
  std::size_t parts() const noexcept { return requests_.size(); }
  const std::vector<std::shared_ptr<const path::FloorMap>>& maps() const noexcept { return maps_; }
  /// From now on that is closed for all who walk, and views made from now on say so. Any thread but
  /// the frame's: it takes a while.
  void close(const Closures& closures);

 private:
  /// More than there are avatars and parts: nobody empties the queues during wait().
  static constexpr std::size_t queue_length = 512;

  void work();
  void answer_next();
  void answer(const WalkOrder& order);
  void answer(const interface::ViewRequest& request);
  void announce(std::size_t buffer) noexcept;
  void send_way(std::unique_ptr<Plan> plan);
  const directions::Doorways& doorways();
  std::optional<interface::ShownWay> shown_way(const interface::InterfaceState& state);
  Traffic& traffic_on(std::uint32_t floor);
  const motion::WalkGraph* walking() const noexcept { return walking_ ? &*walking_ : nullptr; }

  const Museum& museum_;
  std::optional<motion::WalkGraph> walking_;  ///< None where the museum's motion cannot walk.
  std::vector<std::shared_ptr<const path::FloorMap>> maps_;  ///< One per floor.
  interface::PieceCache cache_;                              ///< Used by the worker only.
  std::uint32_t language_ = 0;                               ///< Of its last view. Likewise.
  interface::Finder finder_;                                 ///< Of what visitors type.
  path::BuildingMap building_;                               ///< Of all floors.
  std::optional<directions::Doorways> doorways_;             ///< Found when they are first needed.
  std::atomic<std::shared_ptr<const Closures>> closed_;      ///< Just now; never null.
  std::vector<std::unique_ptr<Traffic>> traffic_;            ///< Per floor, made when it is needed.
  Rides rides_;
  std::vector<TripleBuffer<WalkOrder>> orders_;                 ///< Per avatar.
  std::vector<TripleBuffer<interface::ViewRequest>> requests_;  ///< Per part of the glass.
  FillOrder fill_order_;  ///< The buffers of the avatars, then those of the parts.
  SingleProducerQueue<Plan, queue_length> plans_;
  SingleProducerQueue<interface::View, queue_length> views_;
  SingleProducerQueue<interface::PieceChanges, queue_length> pieces_;
  std::counting_semaphore<> waiting_{0};
  std::atomic<std::uint64_t> asked_{0}, answered_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;  ///< Last: it uses all of the above.
};

}  // namespace docent::plan

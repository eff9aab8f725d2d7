#include "runtime/plan/planner.h"

#include <utility>

#include "runtime/interface/caption.h"
#include "runtime/model/last_catch.h"
#include "runtime/model/scenery_images.h"
#include "runtime/plan/find_shown_way.h"
#include "runtime/plan/order_own_tour.h"

namespace docent::plan {
namespace {

/// At 1080 lines: all texts of a visit in one language, and the pictures of the views last seen.
constexpr std::size_t piece_budget = 2 << 20;

/// Puts an answer into the queue; while the queue is full, the frame thread is behind and gets
/// time.
template <typename T, std::size_t n>
void send(SingleProducerQueue<T, n>& queue, std::unique_ptr<T> answer,
          const std::atomic<bool>& stop) {
  while (!queue.put(answer) && !stop.load(std::memory_order_relaxed)) std::this_thread::yield();
}

/// Ids of textures: 0 is none, then come the pictures of the building.
std::uint32_t first_piece_of(const Museum& museum) noexcept {
  return static_cast<std::uint32_t>(1 + scenery_images(museum));
}

std::optional<motion::WalkGraph> walk_graph_of(const Museum& museum) {
  Result<motion::WalkGraph> walking = motion::make_walk_graph(museum.motion);
  if (!walking) return {};
  return std::move(*walking);
}

std::vector<std::shared_ptr<const path::FloorMap>> maps_of(const Museum& museum) {
  std::vector<std::shared_ptr<const path::FloorMap>> maps;
  for (const Floor& floor : museum.floors) maps.push_back(path::make_floor_map(floor));
  return maps;
}

/// Does it ask for a way to what is closed? Who is on a way already is told by being asked anew.
bool is_refused(const WalkOrder& order, const Closures& closed) noexcept {
  return order.exhibit && !order.continues && closed_exhibit(closed, *order.exhibit) != nullptr;
}

std::unique_ptr<Plan> refusal_of(const WalkOrder& order) {
  auto plan = std::make_unique<Plan>();
  plan->order = order;
  plan->status = path::RouteStatus::GoalBlocked;
  plan->hindrance = interface::Hindrance::Exhibit;
  return plan;
}

}  // namespace

Planner::Planner(const Museum& museum, interface::PieceMakers makers, std::size_t avatars,
                 std::size_t parts)
    : museum_(museum),
      walking_(walk_graph_of(museum)),
      maps_(maps_of(museum)),
      cache_(std::move(makers), first_piece_of(museum), piece_budget),
      finder_(museum),
      building_(museum, maps_),
      closed_(std::make_shared<const Closures>()),
      traffic_(museum.floors.size()),
      rides_(museum, walking()),
      orders_(avatars),
      requests_(parts),
      fill_order_(avatars + parts) {
  thread_ = std::thread([this] { work(); });
}

Planner::~Planner() {
  stop_ = true;
  waiting_.release();
  thread_.join();
}

void Planner::announce(std::size_t buffer) noexcept {
  if (!fill_order_.add(buffer)) return;
  asked_.fetch_add(1, std::memory_order_release);
  waiting_.release();
}

void Planner::ask(const WalkOrder& order) noexcept {
  if (order.avatar >= orders_.size()) return;
  orders_[order.avatar].put(order);
  announce(order.avatar);
}

void Planner::ask(const interface::ViewRequest& request) noexcept {
  if (request.part >= requests_.size()) return;
  requests_[request.part].put(request);
  announce(orders_.size() + request.part);
}

void Planner::close(const Closures& closures) {
  closed_.store(std::make_shared<const Closures>(closures));
  building_.close(building_.closure(closures));
}

void Planner::wait() const noexcept {
  const std::uint64_t asked = asked_.load(std::memory_order_acquire);
  for (std::uint64_t done = answered_.load(std::memory_order_acquire); done < asked;
       done = answered_.load(std::memory_order_acquire))
    answered_.wait(done, std::memory_order_acquire);
}

void Planner::work() {
  while (true) {
    waiting_.acquire();
    if (stop_) return;
    guarded("planning", [this] { answer_next(); });  // an answer is lost, and not the worker
    answered_.fetch_add(1, std::memory_order_release);
    answered_.notify_all();
  }
}

void Planner::answer_next() {
  const auto buffer = fill_order_.take();
  if (!buffer) return;
  if (*buffer < orders_.size()) {
    if (const auto order = orders_[*buffer].take()) answer(*order);
  } else if (const auto request = requests_[*buffer - orders_.size()].take()) {
    answer(*request);
  }
}

Traffic& Planner::traffic_on(std::uint32_t floor) {
  if (!traffic_[floor])
    traffic_[floor] = std::make_unique<Traffic>(museum_, walking(), building_, floor);
  return *traffic_[floor];
}

void Planner::answer(const WalkOrder& order) {
  if (order.floor >= maps_.size()) return;
  if (order.leaves) {
    for (const std::unique_ptr<Traffic>& floor : traffic_)
      if (floor) floor->leave(order.avatar, 0);
    return;
  }
  if (is_refused(order, *closed_.load())) return send(plans_, refusal_of(order), stop_);
  Traffic& here = traffic_on(order.floor);
  if (order.enters)  // it is on no other floor from now on
    for (const std::unique_ptr<Traffic>& other : traffic_)
      if (other && other.get() != &here) other->leave(order.avatar, 0);
  if (!order.ride) return send_way(here.plan(order));
  const Connection& connection = museum_.connections[order.ride->connection];
  Traffic& there = traffic_on(connection.stops[order.ride->to].floor);
  send_way(rides_.plan(order, here, there));
}

void Planner::send_way(std::unique_ptr<Plan> plan) {
  if (plan && plan->is_new_way)
    plan->doors = directions::doors_along(museum_, doorways(), plan->order.floor, plan->points);
  send(plans_, std::move(plan), stop_);
}

const directions::Doorways& Planner::doorways() {
  if (!doorways_) doorways_ = directions::find_doorways(museum_, maps_);
  return *doorways_;
}

std::optional<interface::ShownWay> Planner::shown_way(const interface::InterfaceState& state) {
  if (!interface::shows_way(state)) return {};
  return find_shown_way(museum_, building_, doorways(), state);
}

void Planner::answer(const interface::ViewRequest& asked) {
  interface::ViewRequest request = asked;
  if (!request.state.own_tour.is_ordered) order_own_tour(museum_, building_, request.state);
  if (!request.state.found.is_current) finder_.look_up(request.state);
  const std::optional<interface::ShownWay> way = shown_way(request.state);
  const auto make = request.said ? interface::make_caption : interface::make_view;
  std::unique_ptr<interface::View> view =
      make(museum_, request, cache_, *closed_.load(), way ? &*way : nullptr);
  if (auto changes = cache_.end_view(request.part)) send(pieces_, std::move(changes), stop_);
  send(views_, std::move(view), stop_);
  // Letters of a language that nobody reads any more; on a shared glass somebody may.
  const bool reads_another = !request.state.seat && request.state.language != language_;
  language_ = request.state.language;
  if (request.state.screen == interface::Screen::Welcome || reads_another) cache_.rest();
}

}  // namespace docent::plan

#include "runtime/guide/stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "runtime/guide/step_aside.h"
#include "runtime/guide/turn_table.h"
#include "runtime/scene/clear_of_boards.h"
#include "runtime/scene/look.h"

namespace docent::guide {
namespace {

constexpr double long_flight_seconds = 1.1;  ///< From over the whole floor down to the guide.
constexpr double short_flight_seconds = 0.7;
constexpr double turned_enough = 0.5;  ///< Radians: for less the camera does not fly to a new way.
/// Metres to go at which the goal is taken into the picture, and those at which it is all there.
constexpr double goal_comes = 16, goal_is_there = 12.8;
constexpr float way_fade_seconds = 0.3F;
constexpr double veil_seconds = 1.6;  ///< In which the model goes, and comes.
constexpr double veil_shut = 0.1;
constexpr float change_seconds = 0.25F;  ///< Twice: until one floor is gone, and the other there.
constexpr float overview_radius = 80;    ///< Metres: an overview's model goes from that far.
constexpr float veiled_radius = -4;
constexpr double flow_speed = 0.35;  ///< Metres a second that the ribbon's pattern moves.
/// Metres: a whole number of each pattern's periods, and of the 2.4 of the solid way's sheen. A
/// kiosk runs for months, and metres without end would be too coarse for a float after three days.
constexpr double flow_wraps = 7.2;

bool seen_from_above(interface::Screen screen) noexcept {
  return screen == interface::Screen::Welcome || screen == interface::Screen::Choosing ||
         screen == interface::Screen::Searching;
}

bool from_above(const interface::InterfaceState& state) noexcept {
  return seen_from_above(state.screen) || interface::shows_whole_way(state);
}

double height_of(const Museum& museum, std::uint32_t floor) noexcept {
  return floor < museum.floors.size() ? museum.floors[floor].plan.height : 0;
}

/// How far the model is taken away while the guide changes floors: all of it for a moment half way,
/// when the one floor makes way for the other.
float veil_over(const Museum& museum, const Avatar& leader) noexcept {
  if (ride_of(leader) == nullptr) return 0;
  const double off = std::abs(ride_share(museum, leader) - 0.5) * leader.plan->seconds();
  return static_cast<float>(1 - scene::smooth_step((off - veil_shut) / veil_seconds));
}

std::size_t most_walls(const Museum& museum) noexcept {
  std::size_t most = 0;
  for (const Floor& floor : museum.floors) most = std::max(most, floor.plan.vertex.size());
  return most;
}

/// What a walking picture has to show, besides the guide.
struct InView {
  std::array<Vec2, 8> point{};  ///< What the guide is about to walk, at every metre.
  std::size_t count = 0;
  std::array<Vec3, 2> goal{};  ///< World frame: where the way ends, and what stands there.
  std::size_t goals = 0;

  std::span<const Vec2> ahead() const noexcept { return {point.data(), count}; }
  scene::Walker walker(const Avatar& avatar) const noexcept {
    return {avatar.body, avatar.height, ahead(), std::span(goal).first(goals)};
  }
};

void add_way_ahead(const Avatar& avatar, InView& view) noexcept {
  const plan::Plan& plan = *avatar.plan;
  for (double metres = 1; metres <= scene::view_ahead; metres += 1) {
    if (avatar.along + metres > plan.reach.back() + 1) break;
    view.point[view.count++] = plan::point_along(plan, avatar.along + metres);
  }
}

/// The goal comes into the picture from the end of the way that is ahead, and not in a leap.
void add_goal(const Avatar& avatar, Vec2 end, Vec2 object, InView& view) noexcept {
  constexpr double breast_height = 1.2;
  const double left = avatar.plan->reach.back() - avatar.along;
  const double share = scene::smooth_step((goal_comes - left) / (goal_comes - goal_is_there));
  if (share <= 0) return;
  const Vec2 from = view.count > 0 ? view.point[view.count - 1] : avatar.body.position;
  view.goal[0] = to_world(glm::mix(from, end, share), avatar.height);
  view.goal[1] = to_world(glm::mix(from, object, share), avatar.height + share * breast_height);
  view.goals = 2;
}

InView in_view(const Museum& museum, const interface::InterfaceState& state,
               const Avatar& avatar) noexcept {
  InView view;
  const plan::Plan& plan = *avatar.plan;
  if (plan.points.size() < 2) return view;
  add_way_ahead(avatar, view);
  if (plan.then)
    add_goal(avatar, plan.end.position, plan.end.position, view);
  else if (const auto goal = interface::goal_of(museum, state); goal && goal->floor == avatar.floor)
    add_goal(avatar, goal->standing.position, goal->position, view);
  return view;
}

/// What a visitor has come to see.
scene::Thing thing_of(std::span<const ExhibitShape> shapes, const interface::InterfaceState& state,
                      const interface::Goal& goal, double height) noexcept {
  if (!state.exhibit || *state.exhibit >= shapes.size()) {
    constexpr float breast_height = 1.2F;
    const Vec3 foot = to_world(goal.position, height);
    return {foot, foot + Vec3{0, breast_height, 0}};
  }
  const ExhibitShape& shape = shapes[*state.exhibit];
  const Vec3 a = to_world(shape.low, shape.middle.y), b = to_world(shape.high, shape.middle.y);
  const Vec3 up{0, shape.half_height, 0};
  return {glm::min(a, b) - up, glm::max(a, b) + up};
}

/// Where one stands to look at it.
scene::Thing spot_of(Vec2 place, double height) noexcept {
  constexpr float radius = 0.35F;
  const Vec3 middle = to_world(place, height), half{radius, 0, radius};
  return {middle - half, middle + half};
}

/// A door that a way leads through.
scene::MarkerDraw light_in(const auto& door, double height) noexcept {
  return {.kind = scene::MarkerDraw::Kind::Doorway,
          .position = to_world(door.middle, height),
          .radius = static_cast<float>(door.width / 2),
          .heading = static_cast<float>(std::atan2(door.through.y, door.through.x))};
}

}  // namespace

bool leaves_a_trail(const Agent& one) noexcept {
  return one.avatar.look < scene::guide_look_count;
}

void draw_trail(const Avatar& avatar, float flow, scene::DrawList& list) noexcept {
  const plan::Plan& plan = *avatar.plan;
  const std::size_t room = list.ribbon_point.capacity() - list.ribbon_point.size();
  if (plan.points.size() < 2 || plan.points.size() > room ||
      list.ribbons.size() == list.ribbons.capacity())
    return;
  list.ribbons.push_back({.kind = plan.order.kind,
                          .look = avatar.look,
                          .first = static_cast<std::uint32_t>(list.ribbon_point.size()),
                          .count = static_cast<std::uint32_t>(plan.points.size()),
                          .revision = static_cast<std::uint32_t>(plan.order.id),
                          .length = static_cast<float>(plan.reach.back()),
                          .walked = static_cast<float>(avatar.along),
                          .flow = flow});
  list.ribbon_point.insert(list.ribbon_point.end(), plan.points.begin(), plan.points.end());
}

Stage::Stage(const Museum& museum, std::span<const ExhibitShape> shapes, bool reduced_motion)
    : museum_(museum),
      shapes_(shapes),
      reduced_motion_(reduced_motion),
      walls_(most_walls(museum)) {
  for (const Floor& floor : museum.floors) {
    std::vector<Vec2>& outline = outlines_.emplace_back();
    for (const Vec2 p : floor.plan.vertex) outline.push_back(p);
  }
}

/// Are there other ones than before?
bool Stage::take_boards(std::span<const scene::Rect> boards) noexcept {
  boards = boards.first(std::min(boards.size(), boards_.size()));
  const bool are_new = !std::ranges::equal(boards, std::span(boards_).first(board_count_));
  std::ranges::copy(boards, boards_.begin());
  board_count_ = boards.size();
  return are_new;
}

void Stage::enter(const interface::InterfaceState& state, const Window& window, float aspect,
                  const Avatar& leader) noexcept {
  const scene::Rect& free = window.free;
  const bool covers_goal = take_boards(window.boards) && state.screen == interface::Screen::Arrived;
  const bool same_free = free_.x == free.x && free_.y == free.y && free_.width == free.width;
  const bool above = from_above(state);
  const bool both_above = seen_from_above(screen_) && seen_from_above(state.screen);
  const bool flies = (screen_ != state.screen && !both_above) || above != above_ || !same_free ||
                     aspect_ != aspect || covers_goal;
  const bool long_way = above != above_;
  const bool sets_out = state.screen == interface::Screen::Walking && !above &&
                        (above_ || screen_ != interface::Screen::Walking);
  free_ = free;
  aspect_ = aspect;
  screen_ = state.screen;
  above_ = above;
  if (!entered_) floor_ = wanted_floor(state, leader);
  show_floor(floor_);
  if (sets_out) walking_.cut(in_view(museum_, state, leader).walker(leader), free_, aspect_);
  if (!entered_ || (flies && reduced_motion_)) {
    cut_to(state, leader);
  } else if (flies) {
    from_ = rig_;
    flight_ = 0;
    flight_seconds_ = long_way ? long_flight_seconds : short_flight_seconds;
  }
  entered_ = true;
}

/// From above, what the visitor looks at; else where the guide is seen.
std::uint32_t Stage::wanted_floor(const interface::InterfaceState& state,
                                  const Avatar& leader) const noexcept {
  if (!seen_from_above(screen_)) return leader.shown_floor;
  return std::min(state.floor.value_or(museum_.kiosk_floor),
                  static_cast<std::uint32_t>(outlines_.size()) - 1);
}

void Stage::show_floor(std::uint32_t floor) noexcept {
  floor_ = floor;
  if (floor_ < museum_.floors.size()) walls_.show(museum_.floors[floor_].plan);
  whole_ = whole_model(outlines_[floor_], height_of(museum_, floor_), museum_.kiosk.heading, free_,
                       aspect_);
}

/// The floor that is shown makes way for the one that is wanted. With a guide on a ride it does so
/// half way; else within half a second, the model going behind paper in between.
void Stage::change_floor(const interface::InterfaceState& state, const Avatar& leader,
                         float seconds) noexcept {
  const std::uint32_t wanted = wanted_floor(state, leader);
  const bool rides = ride_of(leader) != nullptr && !seen_from_above(screen_);
  if (wanted == floor_) {
    changing_ = std::max(0.0F, changing_ - seconds / change_seconds);
    return;
  }
  changing_ = std::min(1.0F, changing_ + seconds / change_seconds);
  if (rides) changing_ = 0;
  if (changing_ == 1 || rides || reduced_motion_) show_floor(wanted);
}

/// Neither what is looked at lies under a board nor who shows it.
scene::CameraRig Stage::arrival_rig(const interface::InterfaceState& state,
                                    const interface::Goal& goal,
                                    const Avatar& leader) const noexcept {
  constexpr float body_height = 1.8F;
  const double yaw = arrival_yaw(goal, leader.body.position);
  const auto clear = [&](const scene::CameraRig& rig, std::span<const scene::Thing> things) {
    const auto boards = std::span(boards_).first(board_count_);
    return scene::clear_of_boards(rig, things, boards, free_, aspect_);
  };
  std::array<scene::Thing, 3> things;
  things[0] = thing_of(shapes_, state, goal, leader.height);
  if (state.glass == interface::Glass::Whole && has_object(museum_, state.exhibit)) {
    const Exhibit& exhibit = museum_.exhibits[*state.exhibit];
    return clear(
        scene::close_up(foot_of(museum_, exhibit), size_of(museum_, exhibit), yaw, free_, aspect_),
        std::span(things).first(1));
  }
  things[1] = spot_of(goal.standing.position, leader.height);
  things[2] = spot_of(about_aside(goal, leader.body.position), leader.height);
  things[2].high.y += body_height;
  return clear(
      scene::beside(goal.standing.position, goal.position, yaw, leader.height, free_, aspect_),
      things);
}

scene::CameraRig Stage::wanted_rig(const interface::InterfaceState& state,
                                   const Avatar& leader) const noexcept {
  const double height = leader.height;
  if (state.screen == interface::Screen::Arrived)
    if (const auto goal = interface::goal_of(museum_, state))
      return arrival_rig(state, *goal, leader);
  if (state.screen == interface::Screen::Walking && above_)
    return way_count_ >= 2 && way_floor_ == floor_ ? whole_way_ : whole_.rig;
  if (state.screen == interface::Screen::Walking)
    return walking_.rig({leader.body, height, {}}, free_);
  scene::CameraRig above = closer_.applied_to(whole_.rig);
  above.yaw += turn_;
  above.distance *= further_;
  return above;
}

void Stage::cut(const interface::InterfaceState& state, const Avatar& leader) noexcept {
  changing_ = 0;
  show_floor(wanted_floor(state, leader));
  cut_to(state, leader);
}

void Stage::cut_to(const interface::InterfaceState& state, const Avatar& leader) noexcept {
  if (reduced_motion_ && screen_ == interface::Screen::Walking)
    walking_.cut(in_view(museum_, state, leader).walker(leader), free_, aspect_);
  rig_ = wanted_rig(state, leader);
  flight_ = 1;
}

/// Are the guide and its next metres well within the picture?
bool Stage::shows_walk(const interface::InterfaceState& state,
                       const Avatar& leader) const noexcept {
  constexpr float edge = 0.07F;
  constexpr std::size_t metres_ahead = 2;
  const scene::CameraView view = scene::view_of(rig_, aspect_);
  const double height = leader.height;
  const scene::Rect inner{free_.x + edge * free_.width, free_.y + edge * free_.height,
                          (1 - 2 * edge) * free_.width, (1 - 2 * edge) * free_.height};
  const auto is_inside = [&](Vec2 place) {
    const auto at = scene::project(view, to_world(place, height));
    return at && scene::contains(inner, at->x, at->y);
  };
  const InView due = in_view(museum_, state, leader);
  const auto next = due.ahead().first(std::min(metres_ahead, due.count));
  return is_inside(leader.body.position) && std::ranges::all_of(next, is_inside);
}

/// The guide goes another way than the picture shows: the camera flies round to it at once.
void Stage::turn_to_way(const interface::InterfaceState& state, const Avatar& leader) noexcept {
  if (!is_new_way_ || leader.next) return;
  is_new_way_ = false;
  if (screen_ != interface::Screen::Walking || state.screen != screen_ || above_) return;
  const InView due = in_view(museum_, state, leader);
  const scene::Walker walker = due.walker(leader);
  const double yaw = scene::yaw_towards(walker, leader.body.heading);
  const double turn = std::abs(scene::wrapped(yaw - walking_.yaw()));
  if (turn < turned_enough) return;
  walking_.cut(walker, free_, aspect_);
  from_ = rig_;
  flight_seconds_ = std::max((1 - flight_) * flight_seconds_, 0.5 + 0.25 * turn);
  flight_ = 0;
}

void Stage::advance(const interface::InterfaceState& state, const Avatar& leader,
                    float seconds) noexcept {
  change_floor(state, leader, seconds);
  measure_walked(state, leader);
  if (reduced_motion_) {
    way_opacity_ = 1;
    if (screen_ != interface::Screen::Walking || above_ || !shows_walk(state, leader))
      cut_to(state, leader);
    sink_walls(state, leader, -1);
    return;
  }
  // A way that has been walked rests, and with it all of the picture but the guide.
  if (!state.arrived) flow_ = std::fmod(flow_ + seconds * flow_speed, flow_wraps);
  way_opacity_ = std::min(1.0F, way_opacity_ + seconds / way_fade_seconds);
  turn_to_way(state, leader);
  walking_.advance(in_view(museum_, state, leader).walker(leader), free_, aspect_, seconds);

  flight_ = std::min(1.0, flight_ + seconds / flight_seconds_);
  const scene::CameraRig wanted = wanted_rig(state, leader);
  rig_ = flight_ < 1 ? scene::blend(from_, wanted, scene::smooth_step(flight_)) : wanted;
  sink_walls(state, leader, seconds);
}

/// On a walk, and where it has led: nothing hides the guide, its next metres or the goal.
void Stage::sink_walls(const interface::InterfaceState& state, const Avatar& leader,
                       float seconds) noexcept {
  constexpr double half_body = 0.3, half_object = 0.4;
  constexpr double seen_ahead = 12;  ///< Metres: as far as the way is in most pictures.
  std::array<scene::Sight, 16> sights;
  std::size_t count = 0;
  if (!seen_from_above(screen_) && leader.floor == floor_ && ride_of(leader) == nullptr) {
    const InView due = in_view(museum_, state, leader);
    sights[count++] = {leader.body.position, half_body};
    const plan::Plan& way = *leader.plan;
    const double left = way.points.size() < 2 ? 0 : way.reach.back() - leader.along;
    for (double metres = 1; metres <= std::min(left, seen_ahead); ++metres)
      sights[count++] = {plan::point_along(way, leader.along + metres)};
    if (due.goals > 0) {
      // From before what stands there: it may hang on a wall, which is to stand.
      constexpr double before = 0.4;
      const Vec2 end = to_floor(due.goal[0]), object = to_floor(due.goal[1]);
      const double off = std::max(glm::distance(end, object), before);
      sights[count++] = {end, half_object};
      sights[count++] = {glm::mix(object, end, before / off), half_object};
    }
  }
  walls_.advance(leader.body.position, scene::view_of(rig_, aspect_).eye,
                 std::span(sights).first(count), seconds);
}

void Stage::show_way(const plan::Plan& plan, scene::DrawList& list) noexcept {
  ++revision_;
  is_new_way_ = true;
  way_opacity_ = 0;
  way_kind_ = plan.order.kind;
  way_floor_ = plan.order.floor;
  way_count_ =
      static_cast<std::uint32_t>(std::min(plan.points.size(), list.ribbon_point.capacity()));
  way_length_ = plan.reach.empty() ? 0 : static_cast<float>(plan.reach.back());
  if (way_count_ > 0) way_end_ = plan.points[way_count_ - 1];
  rests_ = false;
  door_count_ = std::min(plan.doors.size(), most_doors);
  std::ranges::transform(
      std::span(plan.doors).first(door_count_), doors_.begin(), [&](const auto& door) {
        return LitDoor{light_in(door, height_of(museum_, way_floor_)), door.along};
      });
  list.ribbon_point.assign(plan.points.begin(),
                           plan.points.begin() + static_cast<std::ptrdiff_t>(way_count_));
  look_at_whole_way(list.ribbon_point);
}

/// From above, turned as the visitor stands, clear of the helps and the inset plan, which is on
/// the other side where a language runs from right to left.
void Stage::look_at_whole_way(std::span<const Vec2> way) noexcept {
  constexpr double nearest = 18;
  const scene::Rect inner{free_.x + 0.27F * free_.width, free_.y + 0.16F * free_.height,
                          0.46F * free_.width, 0.66F * free_.height};
  whole_way_ = scene::overview_of(way, height_of(museum_, way_floor_), museum_.kiosk.heading, inner,
                                  aspect_);
  whole_way_.distance = std::max(whole_way_.distance, nearest);
}

void Stage::draw(const interface::InterfaceState& state, const Crowd& crowd,
                 std::span<const LedVisitor> led_visitors, scene::DrawList& list) const noexcept {
  const Avatar& leader = crowd[0].avatar;
  const double height = height_of(museum_, floor_);
  list.floor = floor_;
  list.camera = scene::view_of(rig_, aspect_);
  const bool above = seen_from_above(screen_);
  list.focus = leader.body.position;
  const float ride_veil = above || reduced_motion_ ? 0 : veil_over(museum_, leader);
  const float veil = std::max(ride_veil, reduced_motion_ ? 0 : changing_);
  list.focus_radius =
      std::lerp(above_ ? veil > 0 ? overview_radius : 1e3F : 16.0F, veiled_radius, veil);
  list.fade = std::lerp(scene::DrawList{}.fade, 1.0F, veil);
  list.walls = walls_.levels();
  list.goal_radius = 0;
  list.highlighted_exhibit = state.exhibit;

  list.ribbons.clear();
  list.markers.clear();
  const auto mark = [&](scene::MarkerDraw::Kind kind, Vec2 at, float radius, double heading) {
    list.markers.push_back({.kind = kind,
                            .position = to_world(at, height),
                            .radius = radius,
                            .heading = static_cast<float>(heading)});
  };
  if (museum_.kiosk_floor == floor_)
    mark(scene::MarkerDraw::Kind::YouAreHere, museum_.kiosk.position, 0.45F, museum_.kiosk.heading);
  const auto is_chosen = [&](std::uint32_t exhibit) {
    return exhibit == state.exhibit ||
           std::ranges::any_of(led_visitors,
                               [&](const LedVisitor& one) { return one.exhibit == exhibit; });
  };
  if (above)
    for (std::size_t i = 0; i < museum_.exhibits.size(); ++i)
      if (museum_.exhibits[i].floor == floor_)
        mark(is_chosen(static_cast<std::int32_t>(i)) ? scene::MarkerDraw::Kind::SelectedExhibit
                                                     : scene::MarkerDraw::Kind::Exhibit,
             museum_.exhibits[i].placement.position, 0.3F, 0);
  list.ribbon_point.resize(way_count_);
  if (state.glass != interface::Glass::Whole)
    draw_ways(crowd, led_visitors, list);
  else if (!led_visitors.empty())
    draw_own_way(state, leader, list);
}

/// On this floor: at the goal, or where the guide leaves it for another.
std::optional<Placement> Stage::end_of_way(const interface::InterfaceState& state,
                                           const Avatar& leader) const noexcept {
  const auto goal = interface::goal_of(museum_, state);
  if (!goal) return {};
  if (goal->floor == floor_) return goal->standing;
  if (leader.plan->then && leader.floor == floor_) return leader.plan->end;
  return {};
}

/// Metres of the way shown that are behind the guide, who may have left it near its end.
float Stage::walked(const Avatar& leader) const noexcept {
  constexpr double same = 0.3;
  const plan::Plan& plan = *leader.plan;
  double left = glm::distance(leader.body.position, way_end_);
  if (glm::distance(plan.end.position, way_end_) < same || plan.then || plan.beyond > 0)
    left = (plan.reach.empty() ? 0 : plan.reach.back() - leader.along) + plan.beyond;
  return std::clamp(way_length_ - static_cast<float>(left), 0.0F, way_length_);
}

/// Who has arrived steps about there, to touch what it shows; its way is walked all the same.
void Stage::measure_walked(const interface::InterfaceState& state, const Avatar& leader) noexcept {
  if (!state.arrived || !rests_) walked_ = walked(leader);
  rests_ = state.arrived;
}

void Stage::draw_own_way(const interface::InterfaceState& state, const Avatar& leader,
                         scene::DrawList& list) const noexcept {
  if (const auto end = end_of_way(state, leader)) {
    list.goal = end->position;
    list.goal_radius = 6;
    if (!state.arrived)
      list.markers.push_back({.kind = scene::MarkerDraw::Kind::Goal,
                              .position = to_world(end->position, height_of(museum_, floor_)),
                              .radius = 0.35F,
                              .heading = static_cast<float>(end->heading)});
  }
  if (way_count_ < 2 || way_floor_ != floor_) return;
  draw_doors(list);
  list.ribbons.push_back({.kind = way_kind_,
                          .first = 0,
                          .count = way_count_,
                          .revision = revision_,
                          .length = way_length_,
                          .walked = walked_,
                          .flow = static_cast<float>(flow_),
                          .opacity = way_opacity_});
}

/// Those that the guide has not gone through yet glow.
void Stage::draw_doors(scene::DrawList& list) const noexcept {
  for (const LitDoor& door : std::span(doors_).first(door_count_)) {
    if (door.along < walked_ || list.markers.size() == list.markers.capacity()) continue;
    list.markers.push_back(door.light);
    list.markers.back().opacity = way_opacity_;
  }
}

void Stage::draw_ways(const Crowd& crowd, std::span<const LedVisitor> led_visitors,
                      scene::DrawList& list) const noexcept {
  for (const LedVisitor& one : led_visitors) {
    const Agent& guide = crowd[one.guide];
    if (!one.goal) continue;
    if (!one.strays && guide.is_on_its_way && guide.avatar.floor == list.floor)
      draw_trail(guide.avatar, static_cast<float>(flow_), list);
    const Placement& view = one.goal->standing;
    if (!one.arrived && one.goal->floor == list.floor)
      list.markers.push_back({.kind = scene::MarkerDraw::Kind::Goal,
                              .look = guide.avatar.look,
                              .position = to_world(view.position, height_of(museum_, list.floor)),
                              .radius = 0.35F,
                              .heading = static_cast<float>(view.heading)});
  }
}

}  // namespace docent::guide

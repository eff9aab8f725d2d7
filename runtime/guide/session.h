#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "runtime/guide/closer_look.h"
#include "runtime/guide/crowd.h"
#include "runtime/guide/exhibit_shape.h"
#include "runtime/guide/overlay.h"
#include "runtime/guide/turn_table.h"
#include "runtime/guide/voice.h"
#include "runtime/input/gesture.h"
#include "runtime/interface/layout.h"
#include "runtime/model/museum.h"
#include "runtime/plan/planner.h"

namespace docent::guide {

/// What a guide was sent to do.
struct Errand {
  enum class Kind : std::uint8_t { None, ToGoal, Stop, Home, Meet };
  Kind kind = Kind::None;
  std::optional<std::uint32_t> exhibit{};
  std::optional<PlaceKind> seeks{};  ///< The nearest place of that kind; or just this place.
  std::optional<std::uint32_t> place{};
  RouteKind route = RouteKind::Shortest;
  path::Permissions permissions{};

  bool operator==(const Errand&) const = default;
};

/// A video that a visitor sees, how far it has come, and whether it goes on.
struct ShownVideo {
  std::uint32_t image = 0;                            ///< Index into Museum::images.
  scene::TextureId texture = scene::TextureId::None;  ///< In which it is played.
  float seconds = 0;                                  ///< Of it.
  bool plays = false;
  bool is_asked_for = false;  ///< Its visitor has touched it to be played; else they leafed to it.
};

/// A sound that a visitor listens to, and how far it has come. Borrows from the museum.
struct PlayedSound {
  const SpeechSound* recording = nullptr;  ///< Never null.
  std::uint32_t sound = 0;                 ///< Index into Museum::sounds.
  std::uint32_t number = 0;                ///< Grows each time that one begins.
  float seconds = 0;                       ///< Of it.
};

/// What the sessions of a kiosk have in common. Borrowed.
struct SessionContext {
  const Museum& museum;
  plan::Planner& planner;
  Crowd& crowd;  ///< Its first agents are the guides; guide i waits at homes[i].
  const interface::ScreenShape& shape;
  std::span<const Placement> homes;
  std::span<const ExhibitShape> exhibit_shapes;  ///< One per exhibit.
  bool reduced_motion = false;                   ///< As in GuideSettings.
};

/// One visitor in front of the glass: what they see of it, what they asked for, and how their guide
/// gets on with that. On a shared glass there is one for each seat, which stays when its visitor
/// leaves.
///
/// After construction its functions do not throw, allocate or wait.
class Session {
 public:
  /// `part`: of the glass (ViewRequest::part). `guide`: who leads the visitor; none until one is
  /// picked.
  Session(const SessionContext& context, std::uint32_t part, const interface::InterfaceState& state,
          std::optional<std::uint32_t> guide);

  /// A touch by this session's visitor; `surface` is the overlay that was touched: the session's
  /// own or that of the model. False where a finger left the glass and there was nothing to press.
  bool touch(const input::InputEvent& event, Overlay& surface) noexcept;
  void press_key(input::Key key) noexcept;
  void type(char letter) noexcept;
  void act(interface::Action action) noexcept;
  /// Goes to another state without a touch or a key.
  void show(const interface::InterfaceState& state) noexcept;
  void request_view() noexcept;
  /// Something has been closed or opened: the view says so, and whoever was told that there is no
  /// way is led if there is one now.
  void heed_closures() noexcept;
  /// Takes the planner's answer. True where the view is now on the glass.
  bool take_view(std::unique_ptr<interface::View> view) noexcept;
  /// Called after the crowd's step. `absent_after`: seconds without a touch or a key after which
  /// the visitor counts as gone. `liveliness`: so much of that time passes on the model.
  void step(float seconds, float absent_after, float liveliness) noexcept;

  /// Their fingers on the model draw it nearer, while all of it is seen from above.
  void look_closer(const WholeModel& model, float aspect, float seconds) noexcept;
  const CloserLook& closer_look() const noexcept { return closer_; }

  /// Headphones were plugged in, or pulled out: whoever has them is read to.
  void headphones(bool are_in) noexcept;

  const interface::InterfaceState& state() const noexcept { return state_; }
  const Voice& voice() const noexcept { return voice_; }
  const std::optional<interface::RouteSummary>& route_summary() const noexcept {
    return route_summary_;
  }
  void heard(bool is_speaking) noexcept { voice_.heard(is_speaking); }
  /// Nothing while no video is on the glass.
  std::optional<ShownVideo> video() const noexcept;
  /// The video is over: its first frame is seen again.
  void video_ended() noexcept;
  /// It stands still where it is.
  void stop_video() noexcept;
  /// Nothing while the visitor listens to none.
  std::optional<PlayedSound> sound() const noexcept;
  /// Is there something to hear a sound with? What plays goes on meanwhile, unheard.
  void can_sound(bool is_there) noexcept;
  Overlay& overlay() noexcept { return overlay_; }
  const Overlay& overlay() const noexcept { return overlay_; }
  const interface::View* view() const noexcept { return overlay_.view(); }
  /// The object that the visitor stands before.
  const TurnTable& table() const noexcept { return table_; }
  const std::optional<std::uint32_t>& guide() const noexcept { return guide_; }
  bool leads_to_goal() const noexcept { return errand_.kind == Errand::Kind::ToGoal; }
  bool is_under_way() const noexcept { return leads_to_goal() && !state_.arrived; }
  /// Does it lead to its goal, or will it when it has met another, or touched what it shows?
  bool shows_goal() const noexcept {
    return leads_to_goal() || (is_meeting() && waiting_errand_.kind == Errand::Kind::ToGoal);
  }
  /// Is the guide not on its way to its goal meanwhile, nor where it stood there?
  bool strays() const noexcept {
    return is_meeting() || (state_.arrived && guide_ && !agent().has_arrived);
  }
  /// Can the guide go and meet another where it is?
  bool can_meet() const noexcept;
  bool is_meeting() const noexcept { return errand_.kind == Errand::Kind::Meet; }
  /// The guide goes to a place of its floor to meet another; what it was doing waits...
  void meet(const Placement& place) noexcept;
  /// ... until here, unless it has been told something else.
  void part() noexcept;
  /// Has the guide left its way for its place beside what it leads to?
  bool ends_aside() const noexcept { return ends_aside_; }
  /// Does the glass show the state that the visitor asked for?
  bool shows_its_state() const noexcept;
  bool is_vacant() const noexcept { return state_.screen == interface::Screen::Welcome; }
  /// Metres that the guide still has to walk to where it leads its visitor.
  double remaining() const noexcept;
  /// How many ways were begun so far.
  std::uint64_t routes() const noexcept { return routes_; }

 private:
  bool press(const input::Gesture& gesture, Overlay& surface) noexcept;
  void swipe(bool left) noexcept;
  void set_out() noexcept;
  void order(const Errand& errand) noexcept;
  void lead(const Errand& errand) noexcept;
  void go_home() noexcept;
  void begin_visit() noexcept;
  void take_way() noexcept;
  void go_on_after_meeting() noexcept;
  void step_aside() noexcept;
  std::optional<Side> side_to_touch_from() const noexcept;
  void turn_object(float seconds, float liveliness) noexcept;
  bool has_turned(const input::Finger& finger) const noexcept;
  void notice_floor() noexcept;
  void notice_arrival() noexcept;
  void notice_absence(float seconds, float absent_after) noexcept;
  void ask_to_stay(float absent_after) noexcept;
  void resume() noexcept;
  bool press_key_of_voice(input::Key key) noexcept;
  void move_focus(int step) noexcept;
  void speak(float seconds) noexcept;
  void play_video(float seconds) noexcept;
  void play_sound(float seconds) noexcept;
  void stop_sound() noexcept;
  void keep_to_resume(float seconds) noexcept;

  const Agent& agent() const noexcept { return context_.crowd[*guide_]; }
  bool is_out() const noexcept;

  SessionContext context_;
  std::uint32_t part_;
  interface::InterfaceState state_, vacant_;
  std::optional<std::uint32_t> guide_;
  Errand errand_;
  Errand waiting_errand_{};  ///< What is gone on with after a meeting, ...
  Placement stood_{};        ///< ... and where it stood before.
  /// What was left to walk when it went to meet another, until it goes on.
  std::optional<double> left_to_walk_{};
  bool ends_aside_ = false;
  std::optional<interface::RouteSummary> route_summary_;  ///< Of the errand, once it is planned.
  input::GestureRecogniser gestures_;
  Overlay overlay_;
  Voice voice_;
  TurnTable table_;
  CloserLook closer_;
  /// The screen where they drew it nearer, and the height of the floor.
  std::optional<std::pair<interface::Screen, float>> looked_at_{};
  float let_be_seconds_ = 0;              ///< Since a finger was on the model.
  std::optional<std::uint32_t> video_{};  ///< The image, while it is before the visitor.
  float video_seconds_ = 0;
  bool has_asked_for_video_ = false;
  std::optional<std::uint32_t> sound_{};  ///< That plays.
  const SpeechSound* recording_ = nullptr;
  std::uint32_t sounds_begun_ = 0;
  float sound_seconds_ = 0;
  bool has_headphones_ = false;
  std::optional<interface::InterfaceState> left_{};  ///< What starting over can be taken back to.
  float left_seconds_ = 0;                           ///< Since then.
  float idle_seconds_ = 0;                           ///< Since they last touched anything.
  float vacant_seconds_ = 1e9F;                      ///< Since the last visitor left the seat.
  std::uint64_t last_request_ = 0, routes_ = 0;
  bool awaiting_view_ = false;
};

}  // namespace docent::guide

#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "runtime/guide/attention.h"
#include "runtime/guide/attract.h"
#include "runtime/guide/captions.h"
#include "runtime/guide/chapters.h"
#include "runtime/guide/crowd.h"
#include "runtime/guide/doors.h"
#include "runtime/guide/handshakes.h"
#include "runtime/guide/repose.h"
#include "runtime/guide/seating.h"
#include "runtime/guide/session.h"
#include "runtime/guide/stage.h"
#include "runtime/guide/strollers.h"
#include "runtime/guide/touches.h"
#include "runtime/guide/video_turns.h"
#include "runtime/input/contact.h"
#include "runtime/interface/layout.h"
#include "runtime/interface/on_glass.h"
#include "runtime/model/museum.h"
#include "runtime/plan/planner.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

using Seconds = std::chrono::duration<float>;

/// What an operator set for this device.
struct GuideSettings {
  interface::ScreenShape shape;
  Seconds idle_reset{60};
  std::uint32_t visitors = 1;  ///< Who may use the glass at the same time; 1 to most_seats.
  /// Nothing moves but a guide on its way: nobody breathes or strolls, the camera cuts, cards are
  /// there at once; and nothing happens while nobody is there.
  bool reduced_motion = false;
  bool can_sound = false;  ///< There is something to hear a sound with, to begin with.
};

/// How many avatars and parts of the glass a planner has to serve.
struct PlannerSize {
  std::size_t avatars = 1, parts = 1;
};
PlannerSize planner_size(const Museum& museum, const GuideSettings& settings) noexcept;

/// What happened so far, for --stats.
struct GuideCounters {
  std::uint64_t touches = 0, routes = 0, collisions = 0;
  std::uint64_t views = 0;  ///< Grows in the frame in which another view is entered.

  GuideCounters& operator+=(const GuideCounters& other) noexcept {
    touches += other.touches;
    routes += other.routes;
    collisions += other.collisions;
    views += other.views;
    return *this;
  }
};

/// The kiosk's whole state, without the edges: touches and time in, a draw list out.
///
/// A single visitor has the whole glass and a camera that follows the guide. On a shared glass each
/// visitor has a seat at one of its edges, and the model between the seats belongs to all: a touch
/// of the model is taken for that of the visitor whose territory (the place about which they touch)
/// is nearest, or for somebody new beyond an arm's reach. A card follows its visitor's territory.
/// Each visitor has one of the guides, who wait about the kiosk and are told apart by their looks.
///
/// Called by the frame thread alone. After construction its functions do not throw, allocate or
/// wait: what takes long is asked of the planner, whose answers are taken at the next step. Borrows
/// the museum and the planner.
class Guide {
 public:
  Guide(const Museum& museum, plan::Planner& planner, const GuideSettings& settings);
  /// Waits until everything asked is answered: till then the worker reads the plans in progress.
  ~Guide() { planner_.wait(); }
  Guide(const Guide&) = delete;
  Guide& operator=(const Guide&) = delete;

  void touch(const input::InputEvent& event) noexcept;
  /// Headphones were plugged in, or pulled out.
  void headphones(bool are_in) noexcept;
  /// Is the sound edge still playing what was last said? Where nobody plays, nobody calls it.
  void heard(bool is_speaking) noexcept { sessions_[0].heard(is_speaking); }
  void step(Seconds dt) noexcept;
  /// What to draw of the state after the last step. It names textures, so the changes that
  /// take_pieces() gives after that step have to be applied before it is drawn.
  const scene::DrawList& draw_list() noexcept;

  /// Something has been closed or opened: whoever is under way looks for a new way, and what is on
  /// the glass says so.
  void heed_closures() noexcept;
  /// The screen has another size: a view is laid out for it.
  void resize(const interface::ScreenShape& shape) noexcept;
  /// Texture memory that must change before the draw list is drawn; nothing when there is no more.
  std::unique_ptr<interface::PieceChanges> take_pieces() noexcept { return planner_.take_pieces(); }

  /// What is said, as text on the glass; null while nothing is.
  const interface::View* caption() const noexcept { return captions_.view(); }
  /// What is said to the visitor of a glass of their own.
  const Voice& voice() const noexcept { return sessions_[0].voice(); }

  /// How many videos may be shown at once, each by a player of its own.
  std::size_t players() const noexcept { return std::min(seats(), VideoTurns::most); }
  /// What one of them shows; nothing while it is free.
  std::optional<ShownVideo> video(std::size_t player = 0) const noexcept {
    const std::optional<std::size_t> watcher = video_turns_.watcher(player);
    return watcher ? sessions_[*watcher].video() : std::nullopt;
  }
  /// What the visitor of a glass of their own listens to; nothing while it is no sound.
  std::optional<PlayedSound> sound() const noexcept {
    return is_shared() ? std::nullopt : sessions_[0].sound();
  }
  /// Is there something to hear a sound with? Else it is read.
  void can_sound(bool is_there) noexcept {
    if (!is_shared()) sessions_[0].can_sound(is_there);
  }
  /// It has come to its end, or cannot be played.
  void video_ended(std::size_t player = 0) noexcept {
    if (const auto watcher = video_turns_.watcher(player)) sessions_[*watcher].video_ended();
  }
  /// There is no time to draw a model that moves beside a video: while one plays, it keeps still;
  /// but not the model that visitors share.
  void spare_videos(bool are_spared) noexcept { spares_videos_ = are_spared; }

  const Museum& museum() const noexcept { return museum_; }
  const interface::ScreenShape& shape() const noexcept { return settings_.shape; }
  /// How many visitors can use the glass at the same time.
  std::size_t seats() const noexcept { return seating_ ? seating_->seats() : 1; }
  /// The part of the glass that belongs to a seat (counted from the left, from 1); without a seat,
  /// the part that was touched last.
  std::size_t part_of(std::optional<std::uint32_t> seat) const noexcept;
  /// Part 0 is the whole glass, or the model of a shared one; the sessions at the seats follow.
  const interface::InterfaceState& state(std::size_t part = 0) const noexcept {
    return sessions_[part].state();
  }
  /// The language of whoever touched last.
  std::uint32_t language() const noexcept { return state(speaker_).language; }
  /// The view on the screen; empty before the first one. Its spots follow the camera.
  const interface::View* view(std::size_t part = 0) const noexcept {
    return sessions_[part].view();
  }
  /// Every control and label on the glass, part by part. Allocates: for scripted visits and tests.
  std::vector<interface::OnGlass> on_glass() const;
  /// Does the screen show the state that the visitor asked for?
  bool shows_its_state(std::size_t part = 0) const noexcept;
  /// Does it, and has every flight and fade ended?
  bool is_settled(std::size_t part = 0) const noexcept;
  bool is_scrolling(std::size_t part = 0) const noexcept {
    return sessions_[part].overlay().is_scrolling();
  }
  /// Is nobody using the glass?
  bool is_vacant() const noexcept;
  /// Has nobody been there for so long that the museum lives by itself? The next touch is answered
  /// by the first screen, and does nothing else.
  bool is_attracting() const noexcept { return attract_.is_on(); }
  /// All who walk; the guides come first.
  const Crowd& crowd() const noexcept { return crowd_; }
  const Doors& doors() const noexcept { return doors_; }
  AvatarState state_of(std::uint32_t who) const noexcept;
  const GuideCounters& counters() const noexcept { return counters_; }

 private:
  /// A finger on the glass: whose it is, and what it touched.
  struct Held {
    std::uint32_t contact = 0;
    std::size_t visitor = 0, surface = 0;    ///< Parts.
    scene::Side side = scene::Side::Bottom;  ///< From where that surface is read.
    scene::ScreenPoint at{};                 ///< Where it is, as far as is known.
  };
  void enter_guides();
  void take_seats();
  bool wake() noexcept;
  void let_go() noexcept;
  void attract(float seconds) noexcept;
  const interface::InterfaceState& seen() const noexcept {
    return attract_.is_on() ? attract_.state() : state();
  }
  /// From where people look at the model who are at a table, or might come to it.
  interface::Sides readers() const noexcept;
  void draw_interface() noexcept;
  float height_of_floor() const noexcept;
  DrawnSize drawn_size() const noexcept;
  void wish(std::size_t part, std::uint32_t guide, scene::ScreenPoint at) noexcept;
  std::optional<std::uint32_t> guide_at(scene::ScreenPoint at) const noexcept;
  void put_down(const input::InputEvent& event) noexcept;
  void tell_each_other() noexcept;
  void take_answers() noexcept;
  float keep_still(float seconds) noexcept;
  void walk(float seconds) noexcept;
  int pace() const noexcept;
  void follow_chapters(float seconds) noexcept;
  void go_along_in_time(float seconds) noexcept;
  std::span<const LedVisitor> led_visitors() noexcept;

  void draw_bodies() noexcept;

  bool is_shared() const noexcept { return seating_.has_value(); }
  const Avatar& leader() const noexcept { return crowd_[0].avatar; }

  const Museum& museum_;
  plan::Planner& planner_;
  GuideSettings settings_;
  scene::Light light_;  ///< In which the model is while somebody is there.
  Crowd crowd_;
  Strollers strollers_;
  Doors doors_;
  Handshakes handshakes_;
  std::optional<Touches> touches_;  ///< None with reduced motion.
  std::vector<ExhibitShape> exhibit_shapes_;
  Attention attention_;
  Attract attract_;
  Chapters chapters_;
  Repose repose_;
  VideoTurns video_turns_;
  bool spares_videos_ = false;
  std::vector<Placement> homes_;    ///< Of the guides.
  std::vector<Session> sessions_;   ///< By part.
  std::optional<Seating> seating_;  ///< Of a shared glass.
  Captions captions_;               ///< Of the glass of one visitor.
  std::vector<Held> held_;
  std::vector<LedVisitor> led_visitors_;
  std::size_t speaker_ = 0;      ///< The part whose visitor touched last.
  float whole_way_seconds_ = 0;  ///< How long the visitor has seen the whole way.
  float refusal_seconds_ = 0;    ///< How much longer the glass says that no seat is free.
  Stage stage_;
  GuideCounters counters_;
  scene::DrawList list_;
};

}  // namespace docent::guide

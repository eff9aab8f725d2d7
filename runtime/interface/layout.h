#pragma once

#include <memory>
#include <optional>

#include "runtime/interface/measures.h"
#include "runtime/interface/piece_cache.h"
#include "runtime/interface/shown_way.h"
#include "runtime/interface/speech.h"
#include "runtime/interface/view.h"
#include "runtime/model/closures.h"
#include "runtime/model/museum.h"
#include "runtime/path/way.h"

namespace docent::interface {

/// Why there is no way, though there would be one if something were not closed, or if steps or
/// escalators were allowed.
enum class Hindrance : std::uint8_t {
  Door,
  Stairs,
  Escalator,
  Lift,
  Ramp,
  Steps,
  Escalators,
  Exhibit,  ///< It is closed itself, or with its room.
};

/// The key of the interface's word that says so; {floor} in it is the floor that cannot be reached.
std::string_view hindrance_word(Hindrance hindrance) noexcept;

/// What is known of the way that the guide is about to take.
struct RouteSummary {
  path::RouteStatus status = path::RouteStatus::Ok;
  double metres = 0;
  double seconds = 0;
  std::optional<Hindrance> hindrance{};  ///< Only where there is no way.

  bool operator==(const RouteSummary&) const = default;
};

/// Everything that decides what a view looks like.
struct ViewRequest {
  std::uint64_t id = 0;
  InterfaceState state;
  ScreenShape shape;
  std::optional<RouteSummary> route_summary;  ///< Absent while the way is still being planned.
  std::uint32_t part = 0;  ///< Of the glass: 0 is the whole of it, or the model; then the seats.
  std::optional<SpeechPart> said{};  ///< Of a caption: what it shows (caption.h).
};

/// Lays out one view: what it says, and where everything lies on the glass. On the glass of one
/// visitor there is one panel: in landscape at the side where lines of text begin (so Arabic is the
/// mirror image), in portrait along the lower edge. Pure but for the pieces it adds to the cache;
/// runs on the worker. `closed`: what is so just
/// now; its exhibits say so, and until when. `way`: to what the visitor has chosen; null where
/// there is none, or none is asked for (shows_way).
std::unique_ptr<View> make_view(const Museum& museum, const ViewRequest& request,
                                PieceCache& pieces, const Closures& closed = {},
                                const ShownWay* way = nullptr);

/// From where the view of that state is read.
scene::Side side_of(const ScreenShape& shape, const InterfaceState& state) noexcept;

/// Does the view of that state show the way from the kiosk?
bool shows_way(const InterfaceState& state) noexcept;

/// The glass as this visitor wants it: with larger letters, or lower.
ScreenShape shape_for(ScreenShape shape, const InterfaceState& state) noexcept;

/// How many exhibits a page of the list shows on such a screen.
std::uint32_t exhibits_per_page(const ScreenShape& shape) noexcept;
/// The same for a state, which may be that of a card.
std::uint32_t exhibits_per_page(const ScreenShape& shape, const InterfaceState& state) noexcept;

/// The panel as it lies for a language that runs from left to right, and the part of the screen
/// that the panel leaves free. Screen frame.
scene::Rect panel_of(const ScreenShape& shape) noexcept;
scene::Rect free_part_of(const ScreenShape& shape, bool right_to_left) noexcept;

/// Does the language at this index run from right to left?
bool runs_right_to_left(const Museum& museum, std::uint32_t language) noexcept;

}  // namespace docent::interface

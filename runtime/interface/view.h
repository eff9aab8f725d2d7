#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/interface/control.h"
#include "runtime/interface/measures.h"
#include "runtime/interface/speech.h"
#include "runtime/interface/text.h"
#include "runtime/model/pixels.h"
#include "runtime/scene/draw_list.h"
#include "runtime/scene/side.h"
#include "runtime/scene/theme.h"

namespace docent::interface {

/// A piece that goes into texture memory under `texture` before the next frame is drawn.
struct PieceUpload {
  scene::TextureId texture = scene::TextureId::None;
  TextBitmap text;  ///< Of `text` and `picture` one is empty.
  Pixels picture;
};

/// What the worker's cache of pieces changed; to be applied in order, retired ones first.
struct PieceChanges {
  std::vector<scene::TextureId> retired;
  std::vector<PieceUpload> uploads;
};

/// What a text on the glass says, for whoever does not read pixels.
struct Words {
  std::string text;
  float capitals_px = 0;  ///< How high its capitals are.
};

/// A rectangle of a view, in the order to be drawn.
struct Element {
  scene::Quad quad;
  std::int32_t control = -1;  ///< The control that it belongs to and is pressed with; -1: none.
  std::int32_t words = -1;    ///< Index into View::words; -1: it is no text.
  bool is_panel = false;      ///< Part of the panel itself, which moves instead of fading.
  bool greets = false;        ///< The museum's sign, its name and its welcome.
  bool scrolls = false;       ///< It lies in the view's part that scrolls.
  bool stays = false;         ///< Set by the frame thread: also in the view before or after.
};

/// A part of the panel whose content is longer than there is room for. Screen frame. Elements and
/// controls lie as they do at its beginning; the frame thread moves them.
struct ScrollArea {
  scene::Rect rect;  ///< Empty: nothing scrolls.
  scene::Rect rail;  ///< Where a thumb shows what part of it is seen.
  float length = 0;  ///< How long the content is.
  float page = 0;    ///< How far one turns at a time.
  float least = 0;   ///< How much of a control must be seen to be touched.
  float fade = 0;    ///< Within this from its edges what goes on beyond them fades.
  struct Scrolled {
    std::int32_t control = -1;
    scene::Rect rect;  ///< At its beginning.
  };
  std::vector<Scrolled> controls;   ///< That lie in it.
  std::int32_t up = -1, down = -1;  ///< The controls that turn it.

  bool exists() const noexcept { return rect.height > 0; }
  float most() const noexcept { return std::max(0.0F, length - rect.height); }
};

/// A text at a place of the model: a gallery's name, an exhibit's number.
struct FloorLabel {
  Vec2 position{};   ///< Floor frame.
  float height = 0;  ///< Metres above the floor.
  scene::TextureId texture = scene::TextureId::None;
  float width_px = 0, height_px = 0;
  std::int32_t control = -1;  ///< The spot that it marks; -1: none.
  std::int32_t words = -1;    ///< Index into View::words; -1: it is a pictogram.
  bool on_disc = false;       ///< Drawn on a small disc.
  bool is_closed = false;     ///< Struck through and pale: it cannot be seen just now.
  bool is_sign = false;       ///< A place's pictogram, on a dark tile; makes way for other labels.
  /// Floor frame: the corners between which a gallery's name stays when it makes way.
  Vec2 least{}, most{};
  /// From where it is read: on a table from the nearest edge at which people stand. Set by the
  /// frame thread.
  scene::Side side = scene::Side::Bottom;
  scene::Rect rect;                  ///< Screen frame: where it is seen now; follows the camera.
  float anchor_x = 0, anchor_y = 0;  ///< Screen frame: what it marks; it may have made way.
  bool is_led = false;  ///< Set by the frame thread: it lies elsewhere, and a line leads there.
  /// Likewise: a label that finds no room is in the cluster of another, which then stands for so
  /// many more.
  std::int32_t head = -1;
  std::uint32_t held = 0;

  /// As it lies on the glass, in pixels.
  float lying_width() const noexcept { return scene::is_at_end(side) ? height_px : width_px; }
  float lying_height() const noexcept { return scene::is_at_end(side) ? width_px : height_px; }
};

/// One of several prepared texts: shown while at most `metres` of the way remain.
struct CountedText {
  float metres = 0;
  scene::Quad quad;
  std::int32_t words = -1;  ///< Index into View::words.
};

/// A caption of a video or a sound: shown on its ground from `begin` on, before `end`; seconds of
/// that.
struct TimedText {
  float begin = 0, end = 0;
  scene::Quad ground, quad;
  std::int32_t words = -1;  ///< Index into View::words.
};

/// The small plan of the kiosk's floor, with the way from where the visitor stands. The frame
/// thread draws a figure that runs along the way, and where the guide is.
struct InsetPlan {
  scene::Rect board;          ///< Screen frame; empty: there is none.
  std::uint32_t floor = 0;    ///< Index into Museum::floors.
  Vec2 origin{};              ///< Floor frame: the board's upper left corner.
  Vec2 right{}, down{};       ///< Floor frame: what one metre is, in shares of the board.
  std::vector<Vec2> way;      ///< Floor frame.
  std::vector<double> reach;  ///< Metres along the way of each point.
  scene::Colour guide;        ///< Of the spot that is where it is.
};

/// What the interface shows in one state: made on the worker, shown by the frame thread, which only
/// reads it and follows its spots with the camera.
struct View {
  std::uint64_t request = 0;  ///< Which request it answers.
  std::uint32_t part = 0;     ///< Of the glass.
  /// From where it is read: its screen frame is that of the glass as it is seen from there.
  scene::Side side = scene::Side::Bottom;
  Sides readers{};  ///< From where labels are read; none: from below. Set by the frame thread.
  InterfaceState state;
  std::vector<Control> controls;
  std::vector<Element> elements;
  std::vector<FloorLabel> labels;
  std::vector<Words> words;
  std::vector<CountedText> remaining;  ///< Ascending metres; empty where no distance is shown.
  bool remaining_scrolls = false;      ///< They lie in the part that scrolls.
  /// Of the sound that plays, else of the video: by time, one at a time.
  std::vector<TimedText> cues;
  bool cues_scroll = false;  ///< They lie in the part that scrolls.
  ScrollArea scroll;
  Speech speech;  ///< For who does not see it.
  InsetPlan inset;
  /// In which the video that the visitor sees is played; None: there is none.
  scene::TextureId video = scene::TextureId::None;
  scene::Rect panel;             ///< Screen frame.
  std::int32_t open = -1;        ///< Set by the frame thread: the label whose cluster is open, ...
  scene::Rect cluster;           ///< ... and the board on which it is. Screen frame.
  scene::Rect countdown;         ///< Screen frame: of a ring of seconds; empty: none.
  scene::Rect free{0, 0, 1, 1};  ///< What is left to the model; at least 55 % of the screen.
  std::vector<scene::Rect> boards;          ///< Screen frame: what lies on that all the same.
  float pixel_width = 1, pixel_height = 1;  ///< Of the screen: labels are drawn texel for pixel.
  float spot_px = 54;                       ///< How wide and high a spot is.
  float unit_px = 8;                        ///< 1/135 of the shorter side.
  scene::Colour accent;                     ///< Of the rings that answer touches.
  bool is_right_to_left = false;            ///< Lines begin on the right.
  scene::Theme theme;                       ///< In whose colours it is.
};

}  // namespace docent::interface

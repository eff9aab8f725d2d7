#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/interface/measures.h"
#include "runtime/interface/text.h"
#include "runtime/interface/view.h"
#include "runtime/kiosk/staff_words.h"
#include "runtime/scene/draw_list.h"
#include "runtime/scene/theme.h"

namespace docent::kiosk {

/// What staff can press. Figures come first, so that their number is their value.
enum class StaffAction : std::uint8_t {
  Figure0,
  Figure9 = 9,
  Delete,
  Enter,
  Close,
  Calibrate,
  Diagnose,
  Exit,
  Keep,
  Menu,
};

enum class StaffScreen : std::uint8_t {
  Pad,        ///< Asks for the PIN.
  Menu,       ///< What staff can do.
  Calibrate,  ///< One of four marks to touch.
  Confirm,    ///< Was the calibration right? Touching the button proves it.
  Diagnose,   ///< What is running here, and where it is touched.
};

/// What a page of the staff's says.
struct StaffFact {
  std::string label, value;
  /// The value is a name of the machine's, or what the journal says too: it is the same in every
  /// language, and runs from left to right.
  bool is_of_machine = false;
};

struct StaffPageRequest {
  StaffScreen screen = StaffScreen::Pad;
  interface::ScreenShape shape;
  StaffWords words;
  Livery livery{};                  ///< What the museum wears.
  std::string message;              ///< Below the heading; may be empty.
  std::vector<StaffFact> facts;     ///< Diagnose.
  std::size_t mark = 0;             ///< Calibrate: of input::calibration_marks.
  std::uint32_t first_texture = 0;  ///< Its texts take the numbers from there.
};

/// One of the staff's pages, laid out: over the whole glass, in the museum's colours, of the day or
/// the night. Screen frame.
struct StaffPage {
  struct Button {
    StaffAction action = StaffAction::Close;
    scene::Rect rect;
  };
  StaffScreen screen = StaffScreen::Pad;
  std::vector<Button> buttons;  ///< In focus order.
  std::vector<scene::Quad> quads;
  scene::Rect entry;            ///< Pad: where the figures that were typed are shown, as dots.
  scene::Theme theme;           ///< As staff_theme.
  float unit_px = 8;            ///< 1/135 of the shorter side.
  float width = 1, height = 1;  ///< Pixels of the screen.
  std::vector<interface::PieceUpload> uploads;
};

/// The museum's colours, or docent's own where what is written in them could not be read: a page
/// by which a kiosk is mended has to be readable, whatever is in its database.
scene::Theme staff_theme(const Livery& livery, bool is_night) noexcept;

/// Lays a page out. Takes milliseconds: not for the frame thread.
StaffPage make_staff_page(const StaffPageRequest& request, const interface::SetText& set_text);

/// A page has no more texts than that.
inline constexpr std::uint32_t most_staff_texts = 64;

}  // namespace docent::kiosk

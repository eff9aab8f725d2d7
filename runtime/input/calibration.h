#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/input/contact.h"
#include "runtime/model/result.h"

namespace docent::input {

/// Where a touch really was: an affine map of the screen frame, for a glass that was glued on
/// askew. x' = a x + b y + c, y' = d x + e y + f.
struct Calibration {
  double a = 1, b = 0, c = 0;
  double d = 0, e = 1, f = 0;

  bool operator==(const Calibration&) const = default;
};

/// A mark that somebody was asked to touch, and where the glass says that they did.
struct TouchedMark {
  float mark_x = 0, mark_y = 0;
  float touched_x = 0, touched_y = 0;
};

/// The four marks, in the order in which they are shown; screen frame.
inline constexpr std::array<std::array<float, 2>, 4> calibration_marks{
    {{0.1F, 0.1F}, {0.9F, 0.1F}, {0.9F, 0.9F}, {0.1F, 0.9F}}};

/// The map that brings the touches nearest to their marks, by least squares. None where the touches
/// do not agree within 3 % of the glass (one of them was somewhere else), or the map is none that a
/// glass could need (is_plausible()).
std::optional<Calibration> fit(std::span<const TouchedMark> touched) noexcept;

/// Moves no corner of the glass by more than a quarter of it, and keeps its sides: a finger can
/// still reach everything.
bool is_plausible(const Calibration& calibration) noexcept;

/// The contact as it was meant; at most at the edge of the screen.
Contact calibrated(const Calibration& calibration, Contact contact) noexcept;

/// Six numbers in a line, after a line that says what they are.
std::string to_text(const Calibration& calibration);
/// Reads to_text(). Fails with a sentence on other text, and on a calibration that is not
/// plausible; `file` names it.
Result<Calibration> parse_calibration(std::string_view text, std::string_view file);

}  // namespace docent::input

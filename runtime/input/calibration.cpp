#include "runtime/input/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace docent::input {
namespace {

constexpr std::string_view heading = "docent calibration 1\n";
constexpr double most_moved = 0.25;  // shares of the glass
constexpr double most_residual = 0.03;

/// One row of the map: the least-squares solution of p x + q y + r = wanted, by Cramer's rule on
/// the normal equations.
std::optional<std::array<double, 3>> fit_row(std::span<const TouchedMark> touched,
                                             float TouchedMark::* wanted) noexcept {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0, sw = 0, sxw = 0, syw = 0;
  for (const TouchedMark& t : touched) {
    const double x = t.touched_x, y = t.touched_y, w = t.*wanted;
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y, syy += y * y;
    sw += w, sxw += x * w, syw += y * w;
  }
  const double det =
      sxx * (syy * n - sy * sy) - sxy * (sxy * n - sy * sx) + sx * (sxy * sy - syy * sx);
  constexpr double touches_in_a_line = 1e-6;
  if (!(std::abs(det) > touches_in_a_line)) return std::nullopt;
  const double p =
      sxw * (syy * n - sy * sy) - sxy * (syw * n - sy * sw) + sx * (syw * sy - syy * sw);
  const double q =
      sxx * (syw * n - sw * sy) - sxw * (sxy * n - sy * sx) + sx * (sxy * sw - syw * sx);
  const double r =
      sxx * (syy * sw - sy * syw) - sxy * (sxy * sw - sx * syw) + sxw * (sxy * sy - syy * sx);
  return std::array{p / det, q / det, r / det};
}

std::array<double, 2> mapped(const Calibration& k, double x, double y) noexcept {
  return {k.a * x + k.b * y + k.c, k.d * x + k.e * y + k.f};
}

}  // namespace

bool is_plausible(const Calibration& calibration) noexcept {
  return std::ranges::all_of(std::array<std::array<double, 2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
                             [&](const std::array<double, 2>& corner) {
                               const auto at = mapped(calibration, corner[0], corner[1]);
                               return std::abs(at[0] - corner[0]) <= most_moved &&
                                      std::abs(at[1] - corner[1]) <= most_moved;
                             });
}

std::optional<Calibration> fit(std::span<const TouchedMark> touched) noexcept {
  const auto x = fit_row(touched, &TouchedMark::mark_x);
  const auto y = fit_row(touched, &TouchedMark::mark_y);
  if (!x || !y) return std::nullopt;
  const Calibration found{(*x)[0], (*x)[1], (*x)[2], (*y)[0], (*y)[1], (*y)[2]};
  const bool agree = std::ranges::all_of(touched, [&](const TouchedMark& t) {
    const auto at = mapped(found, t.touched_x, t.touched_y);
    return std::hypot(at[0] - t.mark_x, at[1] - t.mark_y) <= most_residual;
  });
  if (!agree || !is_plausible(found)) return std::nullopt;
  return found;
}

Contact calibrated(const Calibration& calibration, Contact contact) noexcept {
  const auto at = mapped(calibration, contact.x, contact.y);
  return {contact.id, static_cast<float>(std::clamp(at[0], 0.0, 1.0)),
          static_cast<float>(std::clamp(at[1], 0.0, 1.0))};
}

std::string to_text(const Calibration& k) {
  return fmt::format("{}{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n", heading, k.a, k.b, k.c, k.d,
                     k.e, k.f);
}

Result<Calibration> parse_calibration(std::string_view text, std::string_view file) {
  const auto refuse = [&] {
    return std::unexpected(
        Error{Errc::InvalidInput,
              fmt::format("{}: is no calibration of a glass; it is not used: calibrate again on "
                          "the staff's screens, or remove the file",
                          file)});
  };
  if (!text.starts_with(heading)) return refuse();
  const char* at = text.data() + heading.size();
  const char* const end = text.data() + text.size();
  std::array<double, 6> values{};
  for (double& value : values) {
    while (at != end && *at == ' ') ++at;
    const auto [rest, fault] = std::from_chars(at, end, value);
    if (fault != std::errc()) return refuse();
    at = rest;
  }
  if (std::string_view(at, end) != "\n") return refuse();
  const Calibration found{values[0], values[1], values[2], values[3], values[4], values[5]};
  if (!is_plausible(found)) return refuse();
  return found;
}

}  // namespace docent::input

#include "content/light/baked_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <thread>

namespace docent {
namespace {

constexpr double pi = std::numbers::pi;

Vec2 heading(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Azimuths at which the horizon is measured for the sky.
constexpr std::size_t sky_slices = 16;
/// Distances at which it is measured, metres: nearby things hide more sky.
constexpr std::array sky_steps{0.04, 0.09, 0.15, 0.23, 0.33, 0.45, 0.6,
                               0.8,  1.05, 1.4,  1.85, 2.4,  3.2};
/// Further away than this, a wall takes less than 2 % of the sky from the floor.
constexpr double sky_reach = 3.2;

/// Tangent of the horizon's elevation as seen from `height` above `point`.
double sky_horizon(const HeightField& field, Vec2 point, double height, Vec2 direction) noexcept {
  double tangent = 0;
  for (const double distance : sky_steps) {
    const double rise = field.at(point + direction * distance) - height;
    tangent = std::max(tangent, rise / distance);
  }
  return tangent;
}

/// The integral over elevation, from `horizon` to the zenith, of the light that a face takes from a
/// slice of sky: max(0, n.w) cos(e) de with n.w = level * cos(e) + up * sin(e).
double slice_of_sky(double level, double up, double horizon) noexcept {
  // Below this elevation the slice is behind the face.
  const double behind = level >= 0 ? 0 : up > 0 ? std::atan(-level / up) : pi / 2;
  const double from = std::max(horizon, behind);
  const double sine = std::sin(from);
  return level * ((pi / 2 - from) / 2 - std::sin(2 * from) / 4) + up * (1 - sine * sine) / 2;
}

float sky_share(const HeightField& field, Vec2 point, double height, Vec3 normal) noexcept {
  double seen = 0;
  double all = 0;
  const Vec2 level_normal = to_floor(normal);
  for (std::size_t i = 0; i < sky_slices; ++i) {
    const Vec2 direction = heading(2 * pi * (static_cast<double>(i) + 0.5) / sky_slices);
    const double level = dot(level_normal, direction);
    all += slice_of_sky(level, normal.y, 0);
    seen += slice_of_sky(level, normal.y, std::atan(sky_horizon(field, point, height, direction)));
  }
  return all > 0 ? static_cast<float>(std::clamp(seen / all, 0.0, 1.0)) : 0.5F;
}

/// The same for a face that looks up: the mean of cos^2 of the horizon, without the sines.
float sky_share_of_floor(const HeightField& field, Vec2 point) noexcept {
  double seen = 0;
  for (std::size_t i = 0; i < sky_slices; ++i) {
    const Vec2 direction = heading(2 * pi * (static_cast<double>(i) + 0.5) / sky_slices);
    const double tangent = sky_horizon(field, point, 0, direction);
    seen += 1 / (1 + tangent * tangent);
  }
  return static_cast<float>(seen / sky_slices);
}

/// Vertical slices of the sun's disc.
constexpr std::size_t sun_slices = 7;

/// Elevation of the horizon towards the sun, in units of tangent; looks no further than the tallest
/// thing's shade.
double sun_horizon(const HeightField& field, Vec2 point, double height, Vec2 direction,
                   double tallest, double lowest_tangent) noexcept {
  double tangent = 0;
  const double reach = (tallest - height) / lowest_tangent;
  const double step = field.texel();
  for (double distance = step; distance < reach; distance += step)
    tangent = std::max(tangent, (field.at(point + direction * distance) - height) / distance);
  return tangent;
}

float sun_share(const HeightField& field, const Sun& sun, Vec2 point, double height,
                double tallest) noexcept {
  if (tallest <= height) return 1;
  const double lowest = std::tan(sun.elevation - sun.radius);
  double seen = 0;
  double all = 0;
  for (std::size_t i = 0; i < sun_slices; ++i) {
    const double across = 2 * (static_cast<double>(i) + 0.5) / sun_slices - 1;
    const double half_chord = sun.radius * std::sqrt(1 - across * across);
    const Vec2 direction = heading(sun.azimuth + across * sun.radius / std::cos(sun.elevation));
    const double horizon = std::atan(sun_horizon(field, point, height, direction, tallest, lowest));
    const double top = sun.elevation + half_chord;
    seen += std::clamp(top - horizon, 0.0, 2 * half_chord);
    all += 2 * half_chord;
  }
  return static_cast<float>(seen / all);
}

/// Up to which height above the floor the sun's middle is hidden.
double shade_height(const HeightField& field, const Sun& sun, Vec2 point, double tallest) noexcept {
  const Vec2 direction = heading(sun.azimuth);
  const double fall = std::tan(sun.elevation);
  double height = 0;
  for (double distance = field.texel(); distance * fall < tallest; distance += field.texel())
    height = std::max(height, field.at(point + direction * distance) - distance * fall);
  return height;
}

std::byte as_byte(double share) {
  return static_cast<std::byte>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

void bake_rows(const HeightField& field, const Sun& sun, const std::vector<float>& nearby,
               std::uint32_t from, std::uint32_t to, Scenery& scenery) {
  for (std::uint32_t y = from; y < to; ++y) {
    for (std::uint32_t x = 0; x < field.width(); ++x) {
      const std::size_t texel = std::size_t{y} * field.width() + x;
      std::byte* out = &scenery.lightmap[texel * Scenery::lightmap_channels];
      const double tallest = nearby[texel];
      const Vec2 point = field.centre(x, y);
      const bool open = tallest <= 0;
      out[0] = open ? std::byte{255} : as_byte(sky_share_of_floor(field, point));
      out[1] = open ? std::byte{255} : as_byte(sun_share(field, sun, point, 0, tallest));
      out[2] = open ? std::byte{0}
                    : as_byte(shade_height(field, sun, point, tallest) / Scenery::shade_range);
    }
  }
}

/// Under what stands on the floor there is no light to speak of, but a texel there is blended with
/// its neighbours outside: give it their light, so that no dark seam runs along the walls.
void fill_under_solids(const HeightField& field, Scenery& scenery) {
  constexpr std::size_t channels = Scenery::lightmap_channels;
  const auto width = static_cast<std::int64_t>(field.width());
  const auto height = static_cast<std::int64_t>(field.height());
  std::vector<bool> known(static_cast<std::size_t>(width * height));
  for (std::int64_t i = 0; i < width * height; ++i)
    known[static_cast<std::size_t>(i)] =
        field.texel_height(static_cast<std::uint32_t>(i % width),
                           static_cast<std::uint32_t>(i / width)) <= 0;
  for (int round = 0; round < 2; ++round) {
    const std::vector<bool> before = known;
    for (std::int64_t y = 0; y < height; ++y)
      for (std::int64_t x = 0; x < width; ++x) {
        const auto texel = static_cast<std::size_t>(y * width + x);
        if (before[texel]) continue;
        std::array<int, channels> sum{};
        int count = 0;
        for (std::int64_t v = std::max<std::int64_t>(0, y - 1); v <= std::min(height - 1, y + 1);
             ++v)
          for (std::int64_t u = std::max<std::int64_t>(0, x - 1); u <= std::min(width - 1, x + 1);
               ++u) {
            const auto other = static_cast<std::size_t>(v * width + u);
            if (!before[other]) continue;
            for (std::size_t c = 0; c < channels; ++c)
              sum[c] += std::to_integer<int>(scenery.lightmap[other * channels + c]);
            ++count;
          }
        if (count == 0) continue;
        for (std::size_t c = 0; c < channels; ++c)
          scenery.lightmap[texel * channels + c] = static_cast<std::byte>(sum[c] / count);
        known[texel] = true;
      }
  }
}

}  // namespace

Vec3 towards(const Sun& sun) noexcept {
  return to_world(heading(sun.azimuth) * std::cos(sun.elevation), std::sin(sun.elevation));
}

Light light_at(const HeightField& field, const Sun& sun, Vec2 point, double height,
               Vec3 normal) noexcept {
  constexpr double tallest = 2.0;
  return {sky_share(field, point, height, normal), sun_share(field, sun, point, height, tallest)};
}

void bake_lightmap(const HeightField& field, const Sun& sun, Scenery& scenery) {
  scenery.lightmap_width = field.width();
  scenery.lightmap_height = field.height();
  scenery.lightmap_min = field.low();
  scenery.lightmap_max = field.high();
  scenery.sun = towards(sun);
  scenery.lightmap.resize(std::size_t{field.width()} * field.height() * Scenery::lightmap_channels);
  const std::vector<float> nearby = field.greatest_within(sky_reach);

  // Every row is computed from the field alone, so how rows are shared out does not matter.
  const std::uint32_t workers = std::clamp(std::thread::hardware_concurrency(), 1U, 8U);
  std::vector<std::jthread> threads;
  for (std::uint32_t w = 0; w < workers; ++w)
    threads.emplace_back([&, w] {
      bake_rows(field, sun, nearby, field.height() * w / workers,
                field.height() * (w + 1) / workers, scenery);
    });
  threads.clear();
  fill_under_solids(field, scenery);
}

}  // namespace docent

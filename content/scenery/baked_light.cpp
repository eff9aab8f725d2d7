#include "content/scenery/baked_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <thread>
#include <vector>

#include "content/parallel.h"

namespace docent::scenery {
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

/// Nothing that keeps the sun away is higher, metres.
constexpr double tallest = 2.3;

/// Vertical slices of the sun's disc.
constexpr std::size_t sun_slices = 7;

double across_disc(std::size_t slice) noexcept {
  return 2 * (static_cast<double>(slice) + 0.5) / sun_slices - 1;
}
double half_chord(const Sun& sun, std::size_t slice) noexcept {
  return sun.radius * std::sqrt(1 - across_disc(slice) * across_disc(slice));
}
double slice_azimuth(const Sun& sun, std::size_t slice) noexcept {
  return sun.azimuth + across_disc(slice) * sun.radius / std::cos(sun.elevation);
}

/// Elevation of the horizon towards the sun, in units of tangent; looks no further than the tallest
/// thing's shade.
double sun_horizon(const HeightField& field, Vec2 point, double height, Vec2 direction,
                   double lowest_tangent) noexcept {
  double tangent = 0;
  const double reach = (tallest - height) / lowest_tangent;
  const double step = field.texel();
  for (double distance = step; distance < reach; distance += step)
    tangent = std::max(tangent, (field.at(point + direction * distance) - height) / distance);
  return tangent;
}

float sun_share(const HeightField& field, const Sun& sun, Vec2 point, double height) noexcept {
  const double lowest = std::tan(sun.elevation - sun.radius);
  double seen = 0;
  double all = 0;
  for (std::size_t i = 0; i < sun_slices; ++i) {
    const double chord = 2 * half_chord(sun, i);
    const double horizon =
        std::atan(sun_horizon(field, point, height, heading(slice_azimuth(sun, i)), lowest));
    seen += std::clamp(sun.elevation + chord / 2 - horizon, 0.0, chord);
    all += chord;
  }
  return static_cast<float>(seen / all);
}

std::byte as_byte(double share) {
  return static_cast<std::byte>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

/// The field with room round it, so that a look along any direction stays inside, as rows of
/// floats.
class PaddedField {
 public:
  PaddedField(const HeightField& field, double reach)
      : pad_(static_cast<std::int64_t>(std::ceil(reach / field.texel())) + 2),
        stride_(field.width() + 2 * pad_),
        metres_(static_cast<std::size_t>(stride_ * (field.height() + 2 * pad_))) {
    for (std::uint32_t y = 0; y < field.height(); ++y)
      for (std::uint32_t x = 0; x < field.width(); ++x)
        metres_[static_cast<std::size_t>((y + pad_) * stride_ + x + pad_)] =
            field.texel_height(x, y);
  }
  /// The heights beside a row of texels, `offset` texels away.
  const float* row(std::uint32_t y, std::int64_t offset) const {
    return metres_.data() + (y + pad_) * stride_ + pad_ + offset;
  }
  /// Where the point `away` metres from a texel's centre lies, in texels.
  std::int64_t offset(Vec2 away, double texel) const {
    return std::llround(away.y / texel) * stride_ + std::llround(away.x / texel);
  }

 private:
  std::int64_t pad_, stride_;
  std::vector<float> metres_;
};

/// A place to look at on the way to the horizon.
struct SkySample {
  std::int64_t offset = 0;
  float distance = 0;
};

/// One direction in which the horizon is measured from every texel.
using Direction = std::vector<SkySample>;

Direction look_along(const PaddedField& field, double texel, Vec2 direction,
                     std::span<const double> distances) {
  Direction looks;
  for (const double distance : distances)
    looks.push_back({field.offset(direction * distance, texel), static_cast<float>(distance)});
  return looks;
}

/// Raises `tangent`, one per texel of the row, to the horizon's in this direction.
void raise_horizon(const PaddedField& field, std::uint32_t y, const Direction& looks,
                   std::span<float> tangent) {
  for (const SkySample& look : looks) {
    const float* heights = field.row(y, look.offset);
    const float scale = 1 / look.distance;
    for (std::size_t x = 0; x < tangent.size(); ++x)
      tangent[x] = std::max(tangent[x], heights[x] * scale);
  }
}

/// Light of the floor, a row of texels at a time.
class FloorLight {
 public:
  FloorLight(const HeightField& field, const Sun& sun)
      : field_(field), sun_(sun), padded_(field, sky_steps.back()) {
    for (std::size_t i = 0; i < sky_slices; ++i) {
      const Vec2 direction = heading(2 * pi * (static_cast<double>(i) + 0.5) / sky_slices);
      sky_.push_back(look_along(padded_, field.texel(), direction, sky_steps));
    }
    std::vector<double> steps;
    for (double d = field.texel();
         d < tallest / std::tan(sun.elevation - sun.radius) && d < sky_steps.back();
         d += field.texel())
      steps.push_back(d);
    for (std::size_t i = 0; i < sun_slices; ++i)
      sun_slices_.push_back(
          look_along(padded_, field.texel(), heading(slice_azimuth(sun, i)), steps));
    shade_ = look_along(padded_, field.texel(), heading(sun.azimuth), steps);
  }

  void bake_row(std::uint32_t y, std::span<std::byte> out) const {
    const std::size_t width = field_.width();
    std::vector<float> tangent(width);
    std::vector<float> sky(width);
    std::vector<float> sun(width);
    for (const Direction& looks : sky_) {
      std::fill(tangent.begin(), tangent.end(), 0.0F);
      raise_horizon(padded_, y, looks, tangent);
      // A face that looks up sees cos^2 of the horizon's elevation of this slice.
      for (std::size_t x = 0; x < width; ++x) sky[x] += 1 / (1 + tangent[x] * tangent[x]);
    }
    const float lowest = static_cast<float>(std::tan(sun_.elevation - sun_.radius));
    double all = 0;
    for (std::size_t i = 0; i < sun_slices; ++i) {
      std::fill(tangent.begin(), tangent.end(), 0.0F);
      raise_horizon(padded_, y, sun_slices_[i], tangent);
      const double chord = 2 * half_chord(sun_, i);
      all += chord;
      for (std::size_t x = 0; x < width; ++x)
        sun[x] +=
            tangent[x] <= lowest
                ? static_cast<float>(chord)
                : static_cast<float>(std::clamp(
                      sun_.elevation + chord / 2 - std::atan(double{tangent[x]}), 0.0, chord));
    }
    const auto fall = static_cast<float>(std::tan(sun_.elevation));
    std::fill(tangent.begin(), tangent.end(), 0.0F);
    for (const SkySample& look : shade_) {
      const float* heights = padded_.row(y, look.offset);
      for (std::size_t x = 0; x < width; ++x)
        tangent[x] = std::max(tangent[x], heights[x] - look.distance * fall);
    }
    for (std::size_t x = 0; x < width; ++x) {
      std::byte* texel = &out[x * Scenery::lightmap_channels];
      texel[0] = as_byte(sky[x] / sky_slices);
      texel[1] = as_byte(sun[x] / all);
      texel[2] = as_byte(tangent[x] / Scenery::shade_range);
    }
  }

 private:
  const HeightField& field_;
  Sun sun_;
  PaddedField padded_;
  std::vector<Direction> sky_, sun_slices_;
  Direction shade_;
};

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

/// The field has steps where a wall runs askew; the sun's shares are blended over a texel so that
/// the edges of shade have none. Texels under solids take no part.
void smooth_sun(const HeightField& field, Scenery& scenery) {
  constexpr std::size_t channels = Scenery::lightmap_channels;
  const std::size_t width = field.width();
  const auto pass = [&](std::size_t count, std::size_t lines, std::size_t step,
                        std::size_t line_step) {
    std::vector<int> before(count);
    for (std::size_t line = 0; line < lines; ++line) {
      const auto texel = [&](std::size_t i) { return line * line_step + i * step; };
      for (std::size_t i = 0; i < count; ++i) {
        const auto at = static_cast<std::uint32_t>(texel(i));
        const bool solid = field.texel_height(at % field.width(), at / field.width()) > 0;
        before[i] = solid ? -1 : std::to_integer<int>(scenery.lightmap[texel(i) * channels + 1]);
      }
      for (std::size_t i = 1; i + 1 < count; ++i) {
        if (before[i] < 0) continue;
        const int west = before[i - 1] < 0 ? before[i] : before[i - 1];
        const int east = before[i + 1] < 0 ? before[i] : before[i + 1];
        scenery.lightmap[texel(i) * channels + 1] =
            static_cast<std::byte>((west + 2 * before[i] + east + 2) / 4);
      }
    }
  };
  for (int round = 0; round < 2; ++round) {
    pass(width, field.height(), 1, width);
    pass(field.height(), width, width, 1);
  }
}

}  // namespace

Vec3 towards(const Sun& sun) noexcept {
  return to_world(heading(sun.azimuth) * std::cos(sun.elevation), std::sin(sun.elevation));
}

Light light_at(const HeightField& field, const Sun& sun, Vec2 point, double height,
               Vec3 normal) noexcept {
  // An upright face has the floor's own shade close by near its foot.
  const double near_floor =
      (1 - std::abs(normal.y)) * 0.30 * std::exp(-std::max(height, 0.0) / 0.25);
  const double sky = sky_share(field, point, height, normal) * (1 - near_floor);
  // The field knows no overhangs: what a leaning board covers would be buried.
  constexpr double least = 0.4;
  return {static_cast<float>(std::max(sky, least)), sun_share(field, sun, point, height)};
}

void bake_lightmap(const HeightField& field, const Sun& sun, Scenery& scenery) {
  scenery.lightmap_width = field.width();
  scenery.lightmap_height = field.height();
  scenery.lightmap_min = field.low();
  scenery.lightmap_max = field.high();
  scenery.sun = towards(sun);
  scenery.lightmap.resize(std::size_t{field.width()} * field.height() * Scenery::lightmap_channels);
  const FloorLight light(field, sun);
  const std::size_t stride = std::size_t{field.width()} * Scenery::lightmap_channels;

  // Every row is computed from the field alone, so how rows are shared out does not matter.
  const std::uint32_t workers = std::clamp(std::thread::hardware_concurrency(), 1U, 8U);
  content::for_each_index(field.height(), workers, [&](std::size_t y) {
    light.bake_row(static_cast<std::uint32_t>(y),
                   std::span(scenery.lightmap).subspan(y * stride, stride));
  });
  smooth_sun(field, scenery);
  fill_under_solids(field, scenery);
}

}  // namespace docent::scenery

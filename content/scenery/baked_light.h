#pragma once

#include "content/scenery/height_field.h"
#include "runtime/model/scenery.h"

namespace docent::scenery {

/// The sun: a soft disc in the sky. Floor frame.
struct Sun {
  double azimuth = 0;       ///< Radians: towards the sun, counter-clockwise from east.
  double elevation = 0.75;  ///< Radians above the horizon, of its middle.
  double radius = 0.05;     ///< Radians: a large lamp over the model, not the star.
};

Vec3 towards(const Sun& sun) noexcept;

/// How much light arrives at a point, each share of [0, 1].
struct Light {
  float sky = 1;  ///< Of the sky that a face with this normal could see, weighted by the cosine.
  float sun = 1;  ///< Of the sun's disc.
};

/// The light at a point of a face, `height` metres above the floor. `normal` is in the world frame.
Light light_at(const HeightField& field, const Sun& sun, Vec2 point, double height,
               Vec3 normal) noexcept;

/// Fills the scenery's lightmap: on every texel the sky and sun of the floor there, and how high
/// the shade reaches above it.
void bake_lightmap(const HeightField& field, const Sun& sun, Scenery& scenery);

}  // namespace docent::scenery

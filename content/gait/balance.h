#pragma once

#include <span>
#include <vector>

#include "content/gait/footsteps.h"

namespace docent::gait {

/// Frames of a clip's clock: frame f is at begin + f / rate seconds.
struct FrameTimes {
  double begin = 0, rate = 120;  ///< Seconds; frames a second.
  std::size_t count = 0;

  double at(std::size_t frame) const { return begin + static_cast<double>(frame) / rate; }
};

/// Share of the body's weight on each foot, by frame; they add up to one. It passes from foot to
/// foot in double support.
struct Loading {
  std::vector<double> left, right;
};
Loading loading_of(std::span<const Footstep> steps, const FrameTimes& times);

/// Where the feet push, by frame: the centre of pressure, rolling from heel to ball under the foot
/// that bears the weight and crossing over in double support. To start, it first shifts back and
/// towards the foot that will step (Breniere and Do 1986), which lets the body fall forward over
/// the other foot.
std::vector<GroundPoint> centre_of_pressure(std::span<const Footstep> steps,
                                            const FrameTimes& times);

/// Where the body's mass must be, by frame, so that it never falls: the bounded motion of a linear
/// inverted pendulum over that centre of pressure (Kajita et al. 2003). Sway, the ebb and flow of
/// speed, the fall into the first step and the lean into a turn come out of it.
std::vector<GroundPoint> balanced_mass(std::span<const GroundPoint> pressure, double rate);

/// Gaussian smoothing by `sigma` seconds; the ends go on as they are.
void smooth(std::vector<double>& values, double rate, double sigma);

}  // namespace docent::gait

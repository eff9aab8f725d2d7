#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "content/speech/pcm.h"

namespace docent::speech {

/// Gives a sound another number of samples a second, without what the fewer cannot hold: a windowed
/// sinc of 32 taps, in phases (Crochiere and Rabiner, "Multirate Digital Signal Processing", 1983).
/// Making the taps takes as long as a second of sound. Immutable, so any thread may use it.
class Resampler {
 public:
  Resampler(std::uint32_t from, std::uint32_t to);

  std::uint32_t from() const noexcept { return from_; }
  std::vector<float> resample(std::span<const float> samples) const;

 private:
  std::uint32_t from_;
  std::size_t phases_, step_;  ///< A new sample lies `step_` phases after the one before.
  std::size_t reach_;          ///< Samples on either side that it is made of.
  std::size_t width_;          ///< Taps of a phase: those, and zeros to fill the last lane.
  std::vector<float> taps_;    ///< For each phase, a place between two samples.
};

/// A single sound; itself where it has the rate.
std::vector<float> resample(const Pcm& sound, std::uint32_t rate);

}  // namespace docent::speech

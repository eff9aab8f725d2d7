#include "runtime/sound/tempo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace docent::sound {

namespace {

/// From 0 to 1 over the overlap; two that cross sum up to 1.
float rise(std::size_t i, std::size_t length) noexcept {
  const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(length);
  return static_cast<float>(0.5 - 0.5 * std::cos(std::numbers::pi * x));
}

}  // namespace

void Tempo::set_speed(float speed) noexcept {
  speed_ = speed >= slowest ? std::min(speed, fastest) : slowest;  // so of what is no number
}

void Tempo::push(std::span<const float> samples) noexcept {
  const auto taken = samples.first(std::min(samples.size(), room()));
  std::ranges::copy(taken, waiting_.begin() + static_cast<std::ptrdiff_t>(filled_));
  filled_ += taken.size();
}

/// Where, among the next samples, what follows is most like what is fading: the largest correlation
/// for its energy. Every third sample is enough to tell.
std::size_t Tempo::most_alike() const noexcept {
  std::size_t best = 0;
  float best_likeness = -1;
  for (std::size_t offset = 0; offset < search; offset += 3) {
    float together = 0, energy = 1e-9F;
    for (std::size_t i = 0; i < overlap; i += 3) {
      together += fading_[i] * waiting_[offset + i];
      energy += waiting_[offset + i] * waiting_[offset + i];
    }
    const float likeness = together / std::sqrt(energy);
    if (likeness > best_likeness) {
      best_likeness = likeness;
      best = offset;
    }
  }
  return best;
}

std::size_t Tempo::pull(std::span<float> out) noexcept {
  if (speed_ == 1 && !is_fading_) {
    const std::size_t given = std::min(out.size(), filled_);
    std::copy_n(waiting_.begin(), given, out.begin());
    drop(given);
    return given;
  }
  // How far the reading goes on for each window that is written.
  const double step = overlap * static_cast<double>(speed_) + surplus_;
  const auto whole = static_cast<std::size_t>(step);
  if (out.size() < overlap || filled_ < std::max(search + 2 * overlap, whole)) return 0;
  const std::size_t offset = is_fading_ ? most_alike() : 0;
  for (std::size_t i = 0; i < overlap; ++i) {
    const float in = is_fading_ ? rise(i, overlap) : 1;
    out[i] = fading_[i] * (1 - in) + waiting_[offset + i] * in;
    fading_[i] = waiting_[offset + overlap + i];
  }
  is_fading_ = true;
  surplus_ = step - static_cast<double>(whole);
  drop(whole);
  return overlap;
}

std::size_t Tempo::finish(std::span<float> out) noexcept {
  if (const std::size_t given = pull(out); given > 0) return given;
  if (!is_fading_ && filled_ == 0) return 0;
  if (out.size() < overlap) return 0;
  // The last window runs out into what is left, and that into silence.
  std::size_t given = std::min(filled_, out.size());
  std::copy_n(waiting_.begin(), given, out.begin());
  drop(given);
  if (is_fading_) {
    for (std::size_t i = 0; i < overlap; ++i) {
      const float in = rise(i, overlap);
      out[i] = fading_[i] * (1 - in) + (i < given ? out[i] * in : 0);
    }
    given = std::max(given, overlap);
    is_fading_ = false;
    fading_.fill(0);
  }
  return given;
}

void Tempo::clear() noexcept {
  filled_ = 0;
  fading_.fill(0);
  is_fading_ = false;
  surplus_ = 0;
}

void Tempo::drop(std::size_t samples) noexcept {
  std::move(waiting_.begin() + static_cast<std::ptrdiff_t>(samples),
            waiting_.begin() + static_cast<std::ptrdiff_t>(filled_), waiting_.begin());
  filled_ -= samples;
}

}  // namespace docent::sound

#include "tests/bench/measure.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace docent::bench {

double quantile(std::span<const double> values, double part) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}
double median(std::span<const double> values) {
  return quantile(values, 0.5);
}

double now() noexcept {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

double heap_in_use() noexcept {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0;
  while (status >> word)
    if (word == "VmHWM:") status >> kilobytes;
  return kilobytes / 1024;
}

void forget_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

PowerLaw fit_power_law(std::span<const Vec2> points) {
  Vec2 mean{};
  for (const Vec2 p : points) mean += glm::log(p) / static_cast<double>(points.size());
  double xx = 0, xy = 0;
  for (const Vec2 p : points) {
    const Vec2 d = glm::log(p) - mean;
    xx += d.x * d.x;
    xy += d.x * d.y;
  }
  const double exponent = xy / xx;
  return {std::exp(mean.y - exponent * mean.x), exponent};
}

}  // namespace docent::bench

#include "runtime/kiosk/statistics.h"

#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>

namespace docent::kiosk {
namespace {

constexpr double bin_ratio = 1.02;
constexpr double first_bin_ns = 100;

double memory_mb() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t total = 0, resident = 0;
  statm >> total >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// What is resident and of no file: the program's own, and its graphics driver's.
double anonymous_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("RssAnon:")) return std::strtod(line.c_str() + 8, nullptr) * 1024 / 1e6;
  return 0;
}

std::string percentiles(const Durations& durations) {
  return fmt::format(R"({{"p50": {:.4f}, "p99": {:.4f}, "max": {:.4f}}})",
                     durations.milliseconds_at(0.5), durations.milliseconds_at(0.99),
                     durations.longest_milliseconds());
}

}  // namespace

void Durations::add(std::chrono::nanoseconds duration) noexcept {
  const double bin =
      std::log(std::max(static_cast<double>(duration.count()), first_bin_ns) / first_bin_ns) /
      std::log(bin_ratio);
  ++bin_[std::min(static_cast<std::size_t>(bin), bin_count - 1)];
  ++count_;
  longest_ = std::max(longest_, duration);
}

double Durations::milliseconds_at(double share) const noexcept {
  if (count_ == 0) return 0;
  const double wanted = share * static_cast<double>(count_);
  double seen = 0;
  std::size_t bin = 0;
  for (; bin + 1 < bin_count; ++bin) {
    seen += bin_[bin];
    if (seen >= wanted) break;
  }
  const double upper = first_bin_ns * std::pow(bin_ratio, static_cast<double>(bin + 1)) / 1e6;
  return std::min(upper, longest_milliseconds());
}

double Durations::longest_milliseconds() const noexcept {
  return static_cast<double>(longest_.count()) / 1e6;
}

std::uint64_t missed_frames(std::chrono::nanoseconds since_last_frame,
                            double frames_per_second) noexcept {
  const double periods =
      std::chrono::duration<double>(since_last_frame).count() * frames_per_second;
  return periods > 1.5 ? static_cast<std::uint64_t>(std::round(periods)) - 1 : 0;
}

std::string to_json(const Statistics& s) {
  return fmt::format(
      "{{\n  \"frames\": {},\n  \"frame_cpu_ms\": {},\n  \"gl_ms\": {},\n"
      "  \"input_to_frame_ms\": {},\n  \"gpu_ms\": {},\n  \"allocations_in_frames\": {},\n"
      "  \"rss_mb\": {:.1f},\n  \"anonymous_mb\": {:.1f},\n  \"start_to_first_frame_ms\": "
      "{:.1f},\n  \"touches\": {},\n"
      "  \"routes\": {},\n  \"collisions\": {},\n  \"dropped_frames\": {},\n"
      "  \"video_frames\": {},\n  \"video_frames_dropped\": {},\n  \"video_decode_ms\": "
      "{:.2f}\n}}\n",
      s.frames, percentiles(s.frame_cpu), percentiles(s.gl), percentiles(s.input_to_frame),
      percentiles(s.gpu), s.allocations_in_frames, memory_mb(), anonymous_mb(),
      static_cast<double>(s.start_to_first_frame.count()) / 1e6, s.touches, s.routes, s.collisions,
      s.dropped_frames, s.video.shown, s.video.dropped,
      static_cast<double>(s.video.decoding.count()) / 1e6 /
          static_cast<double>(std::max<std::uint64_t>(1, s.video.decoded)));
}

Result<void> write_whole(const std::filesystem::path& file, std::string_view text) {
  const std::filesystem::path part = file.string() + ".part";
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(part, file, error);
  if (stream && !error) return {};
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  return std::unexpected(Error{Errc::Environment, file.string() + ": this file cannot be written"});
}

std::chrono::nanoseconds thread_cpu_now() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

}  // namespace docent::kiosk

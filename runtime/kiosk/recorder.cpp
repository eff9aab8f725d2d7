#include "runtime/kiosk/recorder.h"

#include <fmt/format.h>

#include <system_error>

#include "platform/file/read_file.h"

namespace docent::kiosk {

Result<Recorder> Recorder::open(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !file::is_folder(folder))
    return std::unexpected(
        Error{Errc::Environment, folder.string() + ": this folder cannot be made"});
  return Recorder(folder);
}

bool Recorder::wants_frame(double time) const noexcept {
  constexpr double frames_a_second = 30, tolerance = 1e-6;
  return time + tolerance >= static_cast<double>(frames_) / frames_a_second;
}

Result<void> Recorder::add_frame(const Pixels& picture) {
  return image::write_png(folder_ / fmt::format("frame-{:06}.png", frames_++), picture);
}

}  // namespace docent::kiosk

#include "runtime/kiosk/recorder.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <system_error>

#include "platform/file/read_file.h"
#include "runtime/kiosk/statistics.h"

namespace docent::kiosk {

std::string_view name_of(guide::AvatarState state) noexcept {
  switch (state) {
    case guide::AvatarState::Turn:
      return "turn";
    case guide::AvatarState::Walk:
      return "walk";
    case guide::AvatarState::Wait:
      return "wait";
    case guide::AvatarState::Look:
      return "look";
    case guide::AvatarState::Gesture:
      return "gesture";
    case guide::AvatarState::Idle:
      break;
  }
  return "idle";
}

Result<Recorder> Recorder::open(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !file::is_folder(folder))
    return std::unexpected(
        Error{Errc::Environment, folder.string() + ": this folder cannot be made"});
  return Recorder(folder);
}

void Recorder::add_states(double time, const guide::Guide& guide) {
  for (std::uint32_t i = 0; i < guide.crowd().size(); ++i) {
    const guide::Agent& one = guide.crowd()[i];
    if (!one.is_here) continue;
    const guide::Avatar& avatar = one.avatar;
    const double turned = std::remainder(avatar.body.heading, 2 * std::numbers::pi);
    fmt::format_to(std::back_inserter(states_), "{:.4f},{},{:.4f},{:.4f},{:.2f},{}\n", time, i,
                   avatar.body.position.x, avatar.body.position.y, turned * 180 / std::numbers::pi,
                   name_of(guide.state_of(i)));
  }
}

bool Recorder::wants_frame(double time) const noexcept {
  constexpr double frames_a_second = 30, tolerance = 1e-6;
  return time + tolerance >= static_cast<double>(frames_) / frames_a_second;
}

Result<void> Recorder::add_frame(const Pixels& picture) {
  return image::write_png(folder_ / fmt::format("frame-{:06}.png", frames_++), picture);
}

Result<void> Recorder::finish() {
  return write_whole(folder_ / "states.csv", states_);
}

}  // namespace docent::kiosk

#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "platform/handle.h"
#include "platform/image/image.h"
#include "runtime/guide/guide.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// Writes what happens into a folder: frame-000000.png... and states.csv, as docent(1) says.
class Recorder {
 public:
  /// Makes the folder. states.csv takes its name when the recording is finished.
  static Result<Recorder> open(const std::filesystem::path& folder);

  /// Adds a row for each avatar. `time`: seconds since the first frame.
  void add_states(double time, const guide::Guide& guide);
  /// Is a picture due at this time? There are 30 a second.
  bool wants_frame(double time) const noexcept;
  Result<void> add_frame(const Pixels& picture);
  Result<void> finish();

 private:
  explicit Recorder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_;
  std::string states_ = "time,avatar,x,y,heading,state\n";
  std::uint64_t frames_ = 0;
};

std::string_view name_of(guide::AvatarState state) noexcept;

}  // namespace docent::kiosk

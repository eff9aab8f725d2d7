#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "platform/handle.h"
#include "platform/image/image.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// Writes what is seen into a folder: frame-000000.png..., as docent(1) says.
class Recorder {
 public:
  /// Makes the folder.
  static Result<Recorder> open(const std::filesystem::path& folder);

  /// Is a picture due at this time? There are 30 a second.
  bool wants_frame(double time) const noexcept;
  Result<void> add_frame(const Pixels& picture);

 private:
  explicit Recorder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_;
  std::uint64_t frames_ = 0;
};

}  // namespace docent::kiosk

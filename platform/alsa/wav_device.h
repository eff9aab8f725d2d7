#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

#include "platform/alsa/sound_device.h"
#include "platform/handle.h"

namespace docent::alsa {

/// A WAV file that hears all that is played, without taking the time that it lasts. Its header is
/// right after each write.
class WavDevice final : public SoundDevice {
 public:
  static Result<std::unique_ptr<SoundDevice>> open(const std::filesystem::path& file);

  Result<void> write(std::span<const std::int16_t> samples) noexcept override;
  void drop() noexcept override {}
  void rest() noexcept override;

 private:
  std::unique_ptr<std::FILE, CloseWith<std::fclose>> file_;
  std::uint32_t bytes_ = 0;
};

}  // namespace docent::alsa

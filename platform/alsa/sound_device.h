#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "runtime/model/result.h"

namespace docent::alsa {

/// Where sound goes: two channels of 16 bits, 48,000 samples a second each. For the player's
/// thread.
class SoundDevice {
 public:
  SoundDevice() = default;
  SoundDevice(const SoundDevice&) = delete;
  SoundDevice& operator=(const SoundDevice&) = delete;
  virtual ~SoundDevice() = default;

  /// Takes samples, left and right in turn, as soon as there is room for them; says what is wrong
  /// where the device takes none any more. Waits for a second at most.
  virtual Result<void> write(std::span<const std::int16_t> samples) noexcept = 0;
  /// Forgets what it has not played yet.
  virtual void drop() noexcept = 0;
  /// Nothing follows for now: what was written is played to its end.
  virtual void rest() noexcept = 0;
};

/// Opens what kiosk.toml calls a device: an ALSA name such as "default" or "plughw:1,0", or
/// "file:NAME", a WAV file that is written.
Result<std::unique_ptr<SoundDevice>> open_device(const std::string& name);

}  // namespace docent::alsa

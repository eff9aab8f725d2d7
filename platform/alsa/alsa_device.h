#pragma once

#include <memory>
#include <string>

#include "platform/alsa/sound_device.h"

typedef struct _snd_pcm snd_pcm_t;  // NOLINT: ALSA's own name

namespace docent::alsa {

/// A device of ALSA, which PipeWire also offers where it runs.
class AlsaDevice final : public SoundDevice {
 public:
  static Result<std::unique_ptr<SoundDevice>> open(const std::string& name);

  Result<void> write(std::span<const std::int16_t> samples) noexcept override;
  void drop() noexcept override;
  void rest() noexcept override;

 private:
  struct Close {
    void operator()(snd_pcm_t* pcm) const noexcept;
  };
  [[nodiscard]] std::unexpected<Error> gone(int error) const;

  std::string name_;
  std::unique_ptr<snd_pcm_t, Close> pcm_;
};

}  // namespace docent::alsa

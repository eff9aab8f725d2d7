#include "platform/alsa/alsa_device.h"

#include <alsa/asoundlib.h>

#include <algorithm>
#include <cerrno>

#include "platform/alsa/wav_device.h"
#include "runtime/model/speech.h"

namespace docent::alsa {

namespace {

constexpr unsigned latency = 60'000;  // microseconds between a write and the ear
constexpr int patience = 200;         // milliseconds: a device that takes nothing for so long
constexpr int patiences = 5;          // so many times has gone

/// ALSA's library prints what fails; the journal is told in sentences.
void say_nothing(const char*, int, const char*, int, const char*, ...) {}  // NOLINT

std::unexpected<Error> failed(const std::string& name, const std::string& what, int error) {
  return std::unexpected(
      Error{Errc::Environment, "sound device '" + name + "' " + what + ": " + snd_strerror(error)});
}

std::string why(int error) {
  if (error == -EBUSY) return "is used by another program";
  if (error == -EACCES) return "may not be used: the user docent is to be in the group audio";
  return "cannot be opened";
}

}  // namespace

void AlsaDevice::Close::operator()(snd_pcm_t* pcm) const noexcept {
  snd_pcm_close(pcm);
}

Result<std::unique_ptr<SoundDevice>> AlsaDevice::open(const std::string& name) {
  snd_lib_error_set_handler(say_nothing);
  snd_pcm_t* pcm = nullptr;
  // Not blocking: where somebody else has the device, that is said instead of waited for.
  int error = snd_pcm_open(&pcm, name.c_str(), SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK);
  if (error < 0) return failed(name, why(error), error);
  auto device = std::make_unique<AlsaDevice>();
  device->name_ = name;
  device->pcm_.reset(pcm);
  error = snd_pcm_set_params(pcm, SND_PCM_FORMAT_S16, SND_PCM_ACCESS_RW_INTERLEAVED, 2,
                             SpeechSound::rate, 1, latency);
  if (error < 0) return failed(name, "does not take 48 kHz in two channels", error);
  return device;
}

Result<void> AlsaDevice::write(std::span<const std::int16_t> samples) noexcept {
  int waited = 0;
  while (!samples.empty()) {
    const auto frames = static_cast<snd_pcm_uframes_t>(samples.size() / 2);
    const snd_pcm_sframes_t taken = snd_pcm_writei(pcm_.get(), samples.data(), frames);
    if (taken == -EAGAIN) {
      if (++waited > patiences) return gone(-ETIMEDOUT);
      // A stream that is not full enough to have begun would wait for ever.
      if (snd_pcm_state(pcm_.get()) == SND_PCM_STATE_PREPARED) snd_pcm_start(pcm_.get());
      if (const int ready = snd_pcm_wait(pcm_.get(), patience); ready < 0 && ready != -EPIPE)
        return gone(ready);
    } else if (taken < 0) {
      // Silence between sentences lets the device run dry, which is no fault.
      const int error = snd_pcm_recover(pcm_.get(), static_cast<int>(taken), 1);
      if (error < 0 || ++waited > patiences) return gone(error < 0 ? error : -EIO);
    } else {
      samples = samples.subspan(2 * static_cast<std::size_t>(taken));
      waited = 0;
    }
  }
  return {};
}

void AlsaDevice::drop() noexcept {
  snd_pcm_drop(pcm_.get());
  snd_pcm_prepare(pcm_.get());
}

void AlsaDevice::rest() noexcept {
  if (snd_pcm_state(pcm_.get()) == SND_PCM_STATE_PREPARED) snd_pcm_start(pcm_.get());
}

std::unexpected<Error> AlsaDevice::gone(int error) const {
  return failed(name_, "takes no sound any more", error);
}

Result<std::unique_ptr<SoundDevice>> open_device(const std::string& name) {
  constexpr std::string_view file = "file:";
  if (name.starts_with(file)) return WavDevice::open(name.substr(file.size()));
  return AlsaDevice::open(name);
}

}  // namespace docent::alsa

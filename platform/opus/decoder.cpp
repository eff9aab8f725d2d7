#include "platform/opus/decoder.h"

#include <opus/opus.h>

#include "runtime/model/speech.h"

namespace docent::opus {

void close_decoder(OpusDecoder* decoder) noexcept {
  opus_decoder_destroy(decoder);
}

Result<Decoder> Decoder::open() {
  int error = OPUS_OK;
  Decoder decoder;
  decoder.decoder_.reset(opus_decoder_create(SpeechSound::rate, 1, &error));
  if (error != OPUS_OK)
    return std::unexpected(
        Error{Errc::Environment, std::string("Opus cannot be decoded: ") + opus_strerror(error)});
  return decoder;
}

std::size_t Decoder::decode(std::span<const std::byte> packet, std::span<float> out) noexcept {
  if (packet.empty()) return 0;  // libopus would make up what was lost
  const auto* bytes = reinterpret_cast<const unsigned char*>(packet.data());
  const int samples =
      opus_decode_float(decoder_.get(), bytes, static_cast<opus_int32>(packet.size()), out.data(),
                        static_cast<int>(out.size()), 0);
  return samples < 0 ? 0 : static_cast<std::size_t>(samples);
}

void Decoder::forget() noexcept {
  opus_decoder_ctl(decoder_.get(), OPUS_RESET_STATE);
}

}  // namespace docent::opus

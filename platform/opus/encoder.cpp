#include "platform/opus/encoder.h"

#include <opus/opus.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "platform/handle.h"
#include "runtime/model/speech.h"

namespace docent::opus {

namespace {

using EncoderHandle = std::unique_ptr<OpusEncoder, CloseWith<opus_encoder_destroy>>;

/// How a kind of sound is encoded.
struct Manner {
  std::uint32_t rate = 0;  ///< Samples a second.
  int application = 0, signal = 0, complexity = 0, bits_per_second = 0;

  [[nodiscard]] std::size_t frame() const { return rate / 50; }  // 20 ms
};
constexpr std::size_t longest_frame = SpeechSound::rate / 50;

std::unexpected<Error> failed(int error) {
  return std::unexpected(
      Error{Errc::Environment, std::string("Opus cannot be encoded: ") + opus_strerror(error)});
}

void append(std::span<const unsigned char> packet, std::vector<std::byte>& packets) {
  packets.push_back(static_cast<std::byte>(packet.size() & 0xffU));
  packets.push_back(static_cast<std::byte>(packet.size() >> 8U));
  const auto bytes = std::as_bytes(packet);
  packets.insert(packets.end(), bytes.begin(), bytes.end());
}

}  // namespace

namespace {

Result<Encoded> encode(std::span<const float> samples, const Manner& manner) {
  if (samples.empty()) return failed(OPUS_BAD_ARG);
  int error = OPUS_OK;
  const EncoderHandle encoder(
      opus_encoder_create(static_cast<opus_int32>(manner.rate), 1, manner.application, &error));
  if (error != OPUS_OK) return failed(error);
  opus_int32 lookahead = 0;
  opus_encoder_ctl(encoder.get(), OPUS_SET_BITRATE(manner.bits_per_second));
  opus_encoder_ctl(encoder.get(), OPUS_SET_SIGNAL(manner.signal));
  opus_encoder_ctl(encoder.get(), OPUS_SET_COMPLEXITY(manner.complexity));
  opus_encoder_ctl(encoder.get(), OPUS_GET_LOOKAHEAD(&lookahead));

  const std::uint32_t stored_for_each = SpeechSound::rate / manner.rate;
  const std::size_t frame = manner.frame();
  Encoded encoded{.skip = static_cast<std::uint32_t>(lookahead) * stored_for_each,
                  .samples = static_cast<std::uint32_t>(samples.size()) * stored_for_each,
                  .packets = {}};
  const std::size_t end = samples.size() + static_cast<std::size_t>(lookahead);
  for (std::size_t begin = 0; begin < end; begin += frame) {
    std::array<float, longest_frame> part{};  // silence after the end
    if (begin < samples.size())
      std::ranges::copy(samples.subspan(begin, std::min(frame, samples.size() - begin)),
                        part.begin());
    std::array<unsigned char, SpeechSound::longest_packet> packet{};
    const opus_int32 size =
        opus_encode_float(encoder.get(), part.data(), static_cast<int>(frame), packet.data(),
                          static_cast<opus_int32>(packet.size()));
    if (size < 0) return failed(size);
    append(std::span(packet).first(static_cast<std::size_t>(size)), encoded.packets);
  }
  return encoded;
}

}  // namespace

/// By transform (RFC 6716, CELT) instead of linear prediction: at the bits that speech has here
/// that is nearer to the sound and takes half the time (tests/bench/README.md, "speech").
Result<Encoded> encode(std::span<const float> samples, int bits_per_second) {
  return encode(samples, {.rate = encoder_rate,
                          .application = OPUS_APPLICATION_RESTRICTED_LOWDELAY,
                          .signal = OPUS_SIGNAL_VOICE,
                          .complexity = 5,
                          .bits_per_second = bits_per_second});
}

Result<Encoded> encode_sound(std::span<const float> samples) {
  return encode(samples, {.rate = SpeechSound::rate,
                          .application = OPUS_APPLICATION_AUDIO,
                          .signal = OPUS_AUTO,
                          .complexity = 5,
                          .bits_per_second = sound_bits});
}

const char* encoder_version() noexcept {
  return opus_get_version_string();
}

}  // namespace docent::opus

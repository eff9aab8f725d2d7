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

constexpr std::size_t frame = encoder_rate / 50;  // 20 ms
constexpr std::uint32_t stored_for_each = SpeechSound::rate / encoder_rate;

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

Result<Encoded> encode(std::span<const float> samples, int bits_per_second) {
  if (samples.empty()) return failed(OPUS_BAD_ARG);
  int error = OPUS_OK;
  const EncoderHandle encoder(opus_encoder_create(encoder_rate, 1, OPUS_APPLICATION_VOIP, &error));
  if (error != OPUS_OK) return failed(error);
  opus_int32 lookahead = 0;
  opus_encoder_ctl(encoder.get(), OPUS_SET_BITRATE(bits_per_second));
  opus_encoder_ctl(encoder.get(), OPUS_SET_SIGNAL(OPUS_SIGNAL_VOICE));
  opus_encoder_ctl(encoder.get(), OPUS_SET_COMPLEXITY(1));  // 5 takes twice as long
  opus_encoder_ctl(encoder.get(), OPUS_GET_LOOKAHEAD(&lookahead));

  Encoded encoded{.skip = static_cast<std::uint32_t>(lookahead) * stored_for_each,
                  .samples = static_cast<std::uint32_t>(samples.size()) * stored_for_each,
                  .packets = {}};
  const std::size_t end = samples.size() + static_cast<std::size_t>(lookahead);
  for (std::size_t begin = 0; begin < end; begin += frame) {
    std::array<float, frame> part{};  // silence after the end
    if (begin < samples.size())
      std::ranges::copy(samples.subspan(begin, std::min(frame, samples.size() - begin)),
                        part.begin());
    std::array<unsigned char, SpeechSound::longest_packet> packet{};
    const opus_int32 size = opus_encode_float(encoder.get(), part.data(), frame, packet.data(),
                                              static_cast<opus_int32>(packet.size()));
    if (size < 0) return failed(size);
    append(std::span(packet).first(static_cast<std::size_t>(size)), encoded.packets);
  }
  return encoded;
}

const char* encoder_version() noexcept {
  return opus_get_version_string();
}

}  // namespace docent::opus

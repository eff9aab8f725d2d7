#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "platform/handle.h"
#include "runtime/model/result.h"

struct OpusDecoder;

namespace docent::opus {

void close_decoder(OpusDecoder* decoder) noexcept;

/// Turns Opus packets (RFC 6716), one after another, into samples: 48,000 a second, one channel, in
/// [-1, 1]; two channels are mixed. For one thread at a time.
class Decoder {
 public:
  /// Samples that the longest packet holds: 120 ms.
  static constexpr std::size_t longest = 5760;

  /// Fails where memory is out.
  static Result<Decoder> open();

  /// Decodes a packet into `out`, which has room for `longest`; returns how many samples it held.
  /// What is no packet gives none. Does not allocate.
  std::size_t decode(std::span<const std::byte> packet, std::span<float> out) noexcept;

  /// The next packet is the first of another sound.
  void forget() noexcept;

 private:
  std::unique_ptr<OpusDecoder, CloseWith<close_decoder>> decoder_;
};

}  // namespace docent::opus

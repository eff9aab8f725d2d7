#include "runtime/sound/speech_queue.h"

#include <algorithm>
#include <cstring>

namespace docent::sound {

void SpeechQueue::say(std::span<const SpeechPart> parts) noexcept {
  const std::uint32_t next = sentence_.load(std::memory_order_relaxed) + 1;
  sentence_.store(next, std::memory_order_release);  // first: the player passes over what is queued
  push(parts);
  whole_.store(next, std::memory_order_release);
}

void SpeechQueue::push(std::span<const SpeechPart> parts) noexcept {
  Header silence{.sentence = sentence_.load(std::memory_order_relaxed)};
  for (const SpeechPart& part : parts) {
    if (part.sound != nullptr && !push(*part.sound)) return;
    silence.samples = part.pauses * pause;
    if (silence.samples > 0 && !push(silence, {})) return;
  }
}

bool SpeechQueue::push(const SpeechSound& sound) noexcept {
  Header header{.sentence = sentence_.load(std::memory_order_relaxed),
                .skip = sound.skip,
                .samples = sound.samples,
                .size = 0,
                .begins = 1};
  if (sound.archived) {
    header.size = sizeof(*sound.archived);
    header.is_archived = 1;
    return push(header, std::as_bytes(std::span(&*sound.archived, 1)));
  }
  std::span<const std::byte> rest = sound.packets;
  while (!rest.empty()) {
    const auto packet = take_packet(rest);
    if (packet.empty() || packet.size() > SpeechSound::longest_packet) return true;
    header.size = static_cast<std::uint16_t>(packet.size());
    if (!push(header, packet)) return false;
    header.begins = 0;
  }
  return true;
}

bool SpeechQueue::push(const Header& header, std::span<const std::byte> packet) noexcept {
  const std::size_t tail = tail_.load(std::memory_order_relaxed);
  const std::size_t used = tail - head_.load(std::memory_order_acquire);
  if (sizeof(Header) + packet.size() > capacity - used) return false;
  copy_in(tail, std::as_bytes(std::span(&header, 1)));
  copy_in(tail + sizeof(Header), packet);
  tail_.store(tail + sizeof(Header) + packet.size(), std::memory_order_release);
  return true;
}

bool SpeechQueue::pop(Item& item) noexcept {
  for (;;) {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head == tail_.load(std::memory_order_acquire)) return false;
    Header header;
    copy_out(head, std::as_writable_bytes(std::span(&header, 1)));
    const auto packet = std::span(packet_).first(header.size);
    copy_out(head + sizeof(Header), packet);
    head_.store(head + sizeof(Header) + header.size, std::memory_order_release);
    if (header.sentence != sentence_.load(std::memory_order_acquire)) continue;
    item = {.sentence = header.sentence,
            .begins = header.begins != 0,
            .skip = header.skip,
            .samples = header.samples,
            .packet = packet,
            .archived = std::nullopt};
    if (header.is_archived == 0) return true;
    std::uint32_t number = 0;
    std::memcpy(&number, packet.data(), sizeof number);
    item.archived = number;
    item.packet = {};
    return true;
  }
}

void SpeechQueue::copy_in(std::size_t at, std::span<const std::byte> bytes) noexcept {
  at %= capacity;
  const std::size_t first = std::min(bytes.size(), capacity - at);
  if (first > 0) std::memcpy(ring_.get() + at, bytes.data(), first);
  if (first < bytes.size()) std::memcpy(ring_.get(), bytes.data() + first, bytes.size() - first);
}

void SpeechQueue::copy_out(std::size_t at, std::span<std::byte> bytes) const noexcept {
  at %= capacity;
  const std::size_t first = std::min(bytes.size(), capacity - at);
  if (first > 0) std::memcpy(bytes.data(), ring_.get() + at, first);
  if (first < bytes.size()) std::memcpy(bytes.data() + first, ring_.get(), bytes.size() - first);
}

}  // namespace docent::sound

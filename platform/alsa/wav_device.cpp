#include "platform/alsa/wav_device.h"

#include <array>
#include <cerrno>
#include <cstring>

#include "runtime/model/speech.h"

namespace docent::alsa {

namespace {

void put(std::array<char, 44>& header, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) header[at + i] = static_cast<char>(value >> (8 * i));
}

bool write_header(std::FILE* file, std::uint32_t bytes) {
  std::array<char, 44> header{};
  std::memcpy(header.data(), "RIFF....WAVEfmt ....", 20);
  std::memcpy(header.data() + 36, "data", 4);
  put(header, 4, 36 + bytes);
  put(header, 16, 16);
  put(header, 20, 0x00020001);  // whole numbers, two channels
  put(header, 24, SpeechSound::rate);
  put(header, 28, 4 * SpeechSound::rate);
  put(header, 32, 0x00100004);  // 4 bytes a frame, 16 bits a sample
  put(header, 40, bytes);
  return std::fseek(file, 0, SEEK_SET) == 0 &&
         std::fwrite(header.data(), 1, header.size(), file) == header.size() &&
         std::fseek(file, 0, SEEK_END) == 0;
}

std::unexpected<Error> failed(const std::string& what) {
  return std::unexpected(Error{Errc::Environment, what + ": " + std::strerror(errno)});
}

}  // namespace

Result<std::unique_ptr<SoundDevice>> WavDevice::open(const std::filesystem::path& file) {
  auto device = std::make_unique<WavDevice>();
  device->file_.reset(std::fopen(file.c_str(), "wbe"));
  if (!device->file_ || !write_header(device->file_.get(), 0))
    return failed(file.string() + " cannot be written");
  return device;
}

Result<void> WavDevice::write(std::span<const std::int16_t> samples) noexcept {
  const auto bytes = std::as_bytes(samples);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size())
    return failed("the sound's file cannot be written");
  bytes_ += static_cast<std::uint32_t>(bytes.size());
  return {};
}

void WavDevice::rest() noexcept {
  write_header(file_.get(), bytes_);
  std::fflush(file_.get());
}

}  // namespace docent::alsa

#include "runtime/model/speech.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace docent::speech_test {
namespace {

std::vector<std::byte> packet(unsigned kind, unsigned low_bits, std::size_t size) {
  std::vector<std::byte> bytes(size, std::byte{7});
  if (size > 0) bytes[0] = static_cast<std::byte>((kind << 3U) | low_bits);
  return bytes;
}

TEST(Speech, KnowsHowLongAPacketIsFromItsFirstByte) {  // RFC 6716, table 2
  EXPECT_EQ(samples_of_packet(packet(0, 0, 9)), 480U);
  EXPECT_EQ(samples_of_packet(packet(9, 0, 9)), 960U);
  EXPECT_EQ(samples_of_packet(packet(10, 0, 9)), 1920U);
  EXPECT_EQ(samples_of_packet(packet(11, 0, 9)), SpeechSound::longest_frame);
  EXPECT_EQ(samples_of_packet(packet(12, 0, 9)), 480U);
  EXPECT_EQ(samples_of_packet(packet(15, 0, 9)), 960U);
  EXPECT_EQ(samples_of_packet(packet(16, 0, 9)), 120U);
  EXPECT_EQ(samples_of_packet(packet(31, 0, 1275)), 960U);
}

TEST(Speech, TakesNoPacketOfTwoChannelsSeveralFramesOrTooManyBytes) {
  EXPECT_EQ(samples_of_packet({}), 0U);
  EXPECT_EQ(samples_of_packet(packet(9, 1, 9)), 0U);
  EXPECT_EQ(samples_of_packet(packet(9, 4, 9)), 0U);
  EXPECT_EQ(samples_of_packet(packet(9, 0, 1276)), 0U);
}

RC_GTEST_PROP(SpeechProperty, AnyBytesArePacketsToTheirEndOrRefused,
              (const std::vector<std::uint8_t>& bytes)) {
  const auto packets = std::as_bytes(std::span(bytes));
  const auto samples = samples_of_packets(packets);
  auto rest = packets;
  std::uint64_t counted = 0;
  bool are_packets = true;
  while (!rest.empty() && are_packets) {
    const std::uint32_t more = samples_of_packet(take_packet(rest));
    are_packets = more != 0;
    counted += more;
  }
  RC_ASSERT(samples.has_value() == are_packets);
  if (samples) RC_ASSERT(*samples == counted);
}

RC_GTEST_PROP(SpeechProperty, PacketsComeBackAsTheyWereLaid, (std::vector<std::uint16_t> sizes)) {
  std::vector<std::byte> packets;
  for (std::uint16_t& size : sizes) {
    size = static_cast<std::uint16_t>(1 + size % 1275);
    packets.push_back(static_cast<std::byte>(size & 0xffU));
    packets.push_back(static_cast<std::byte>(size >> 8U));
    const auto bytes = packet(9, 0, size);
    packets.insert(packets.end(), bytes.begin(), bytes.end());
  }
  std::span<const std::byte> rest = packets;
  for (const std::uint16_t size : sizes) RC_ASSERT(take_packet(rest).size() == size);
  RC_ASSERT(rest.empty());
  RC_ASSERT(samples_of_packets(packets) == 960 * sizes.size());
}

TEST(Speech, FindsAPieceByLanguageAndText) {
  std::vector<SpeechSound> speech(3);
  speech[0].text = "door";
  speech[1].text = "left";
  speech[2].text = "door";
  speech[2].language = 1;

  EXPECT_EQ(find_sound(speech, 0, "door"), &speech[0]);
  EXPECT_EQ(find_sound(speech, 0, "left"), &speech[1]);
  EXPECT_EQ(find_sound(speech, 1, "door"), &speech[2]);
  EXPECT_EQ(find_sound(speech, 1, "left"), nullptr);
  EXPECT_EQ(find_sound({}, 0, "door"), nullptr);
}

}  // namespace
}  // namespace docent::speech_test

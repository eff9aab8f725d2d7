#include "runtime/input/report_descriptor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "runtime/input/hid_device_kind.h"
#include "tests/runtime/input/hid_bytes.h"

namespace docent::test::report_descriptor_test {
namespace {

using testing::HasSubstr;

TEST(ReportDescriptor, GivesEachFieldItsPlaceInTheReport) {
  const auto descriptor = input::parse_report_descriptor(
      join({begin_touch_screen(3), finger(), finger(), contact_count(), end_collection()}));

  ASSERT_TRUE(descriptor) << descriptor.error().what;
  ASSERT_EQ(descriptor->inputs.size(), 9U);
  EXPECT_TRUE(descriptor->numbered);
  EXPECT_EQ(descriptor->inputs[0].usage, input::usages::tip_switch);
  EXPECT_EQ(descriptor->inputs[1].bit_offset, 8U);
  EXPECT_EQ(descriptor->inputs[2].usage, input::usages::x);
  EXPECT_EQ(descriptor->inputs[2].bit_offset, 16U);
  EXPECT_EQ(descriptor->inputs[2].logical_max, 32767);
  EXPECT_EQ(descriptor->inputs[6].bit_offset, 64U);
  EXPECT_EQ(descriptor->inputs[8].usage, input::usages::contact_count);
  EXPECT_EQ(descriptor->inputs[8].bit_offset, 96U);
}

TEST(ReportDescriptor, ReadsFieldsThatStartInTheMiddleOfAByte) {
  input::ReportField field{.bit_offset = 4, .bit_size = 12, .logical_min = 0, .logical_max = 4095};

  EXPECT_EQ(input::field_value(field, bytes({0xc5, 0xab})), 0xabc);
  field.logical_min = -2048;
  EXPECT_EQ(input::field_value(field, bytes({0xf0, 0xff})), -1);
  EXPECT_EQ(input::field_value(field, bytes({0xf0})), 0) << "a short report holds nothing";
}

TEST(ReportDescriptor, PushAndPopBringTheGlobalItemsBack) {
  const auto descriptor = input::parse_report_descriptor(
      join({bytes({0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x75, 0x08, 0x95, 0x01, 0xa4, 0x75,
                   0x10, 0x09, 0x30, 0x81, 0x02, 0xb4, 0x09, 0x31, 0x81, 0x02, 0xc0})}));

  ASSERT_TRUE(descriptor) << descriptor.error().what;
  ASSERT_EQ(descriptor->inputs.size(), 2U);
  EXPECT_EQ(descriptor->inputs[0].bit_size, 16);
  EXPECT_EQ(descriptor->inputs[1].bit_size, 8);
  EXPECT_EQ(descriptor->inputs[1].bit_offset, 16U);
}

TEST(ReportDescriptor, SaysWhereItIsBroken) {
  const auto what = [](const std::vector<std::byte>& b) {
    const auto descriptor = input::parse_report_descriptor(b);
    return descriptor ? std::string("accepted") : descriptor.error().what;
  };

  EXPECT_THAT(what(bytes({0x05, 0x01, 0x26, 0xff})), HasSubstr("byte 2: it is cut short"));
  EXPECT_THAT(what(bytes({0xa1, 0x01})), HasSubstr("a collection is not closed"));
  EXPECT_THAT(what(bytes({0xc0})), HasSubstr("closed that was not opened"));
  EXPECT_THAT(what(bytes({0xb4})), HasSubstr("popped that was not pushed"));
  EXPECT_THAT(what(bytes({0x85, 0x00})), HasSubstr("report id"));
  EXPECT_THAT(what(bytes({0x75, 0x20, 0x97, 0xff, 0xff, 0xff, 0xff, 0x81, 0x02})),
              HasSubstr("larger than 16 KiB"));
}

RC_GTEST_PROP(ReportDescriptor, SurvivesAnyBytes, ()) {
  const auto raw =
      *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
  std::vector<std::byte> b;
  for (const std::uint8_t value : raw) b.push_back(static_cast<std::byte>(value));

  const auto descriptor = input::parse_report_descriptor(b);
  if (!descriptor) return;
  for (const input::ReportField& field : descriptor->inputs) {
    RC_ASSERT(field.bit_size >= 1 && field.bit_size <= 32);
    RC_ASSERT(field.collection < static_cast<std::int32_t>(descriptor->collections.size()));
  }
  input::classify(*descriptor);
}

RC_GTEST_PROP(ReportDescriptor, ReadsBackWhatWasWrittenIntoAnyBits, ()) {
  const auto offset = *rc::gen::inRange<std::uint32_t>(0, 100);
  const auto size = *rc::gen::inRange<std::uint32_t>(1, 33);
  const auto value = *rc::gen::arbitrary<std::uint32_t>() & ((1ULL << size) - 1);
  std::vector<std::byte> payload(20, static_cast<std::byte>(*rc::gen::arbitrary<std::uint8_t>()));
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t bit = offset + i;
    const auto mask = static_cast<std::byte>(1U << (bit % 8));
    payload[bit / 8] =
        ((value >> i) & 1U) != 0 ? payload[bit / 8] | mask : payload[bit / 8] & ~mask;
  }

  const input::ReportField field{.bit_offset = offset,
                                 .bit_size = static_cast<std::uint8_t>(size),
                                 .logical_min = 0,
                                 .logical_max = 1};
  RC_ASSERT(input::field_value(field, payload) == static_cast<std::int64_t>(value));
}

}  // namespace
}  // namespace docent::test::report_descriptor_test

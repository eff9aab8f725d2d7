#include "runtime/schema/blob.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cstring>
#include <vector>

#include "runtime/schema/elements.h"
#include "tests/runtime/schema/bytes.h"

namespace docent::schema::blob_test {
namespace {

using schema::decode;
using schema::encode;
using testing::ElementsAreArray;

TEST(Blob, HoldsNumbersWithTheLowByteFirst) {
  EXPECT_THAT(encode(std::vector<std::uint32_t>{1, 0x04030201}),
              ElementsAreArray(bytes({1, 0, 0, 0, 1, 2, 3, 4})));
  EXPECT_THAT(encode(std::vector<double>{1.0}),
              ElementsAreArray(bytes({0, 0, 0, 0, 0, 0, 0xF0, 0x3F})));
}

TEST(Blob, HoldsStructsWithoutPadding) {
  // A kind of one byte and an index of four, where the compiler would leave three bytes between.
  EXPECT_THAT(encode(std::vector<Site>{{Site::Kind::Corner, 7}}),
              ElementsAreArray(bytes({1, 7, 0, 0, 0})));
}

TEST(Blob, GivesBackAnyNumbersBitForBit) {
  EXPECT_TRUE(rc::check("doubles survive", [](const std::vector<std::uint64_t>& bits) {
    std::vector<double> written;
    for (const std::uint64_t b : bits) written.push_back(std::bit_cast<double>(b));
    std::vector<double> read;

    RC_ASSERT(decode(encode(written), read));
    RC_ASSERT(read.size() == written.size());
    for (std::size_t i = 0; i < read.size(); ++i)
      RC_ASSERT(std::bit_cast<std::uint64_t>(read[i]) == bits[i]);
  }));
}

TEST(Blob, DecodesAnyBytesOfAWholeNumberOfElementsAndNoOthers) {
  EXPECT_TRUE(rc::check("any bytes are safe", [](const std::vector<std::uint8_t>& raw) {
    std::vector<std::byte> blob;
    for (const std::uint8_t byte : raw) blob.push_back(std::byte{byte});
    std::vector<VoronoiEdge> edges;

    const bool whole = blob.size() % schema::encoded_size<VoronoiEdge>() == 0;

    RC_ASSERT(decode(blob, edges) == whole);
    RC_ASSERT(edges.size() == (whole ? blob.size() / schema::encoded_size<VoronoiEdge>() : 0));
  }));
}

TEST(Blob, LeavesTheValuesAloneThatItCannotDecode) {
  std::vector<std::uint32_t> values{5};

  EXPECT_FALSE(decode(bytes({1, 2, 3}), values));

  EXPECT_EQ(values, std::vector<std::uint32_t>{5});
}

TEST(Blob, KeepsTheOrderOfAQuaternionAndAMatrix) {
  const Quat q(0.5F, 1, 2, 3);  // w first
  Mat4 m(1);
  m[3] = {4, 5, 6, 1};
  std::vector<Quat> quats;
  std::vector<Mat4> matrices;

  ASSERT_TRUE(decode(encode(std::vector<Quat>{q}), quats));
  ASSERT_TRUE(decode(encode(std::vector<Mat4>{m}), matrices));

  EXPECT_EQ(quats.front(), q);
  EXPECT_EQ(matrices.front(), m);
}

TEST(Blob, ReadsFlagsFromAnyByteThatIsNotZero) {
  std::vector<bool> flags;

  ASSERT_TRUE(decode(bytes({0, 1, 255}), flags));

  EXPECT_EQ(flags, (std::vector<bool>{false, true, true}));
}

TEST(Blob, WantsExactlyAsManyElementsAsAnArrayHas) {
  std::array<std::uint32_t, 2> pair{};

  EXPECT_FALSE(decode(bytes({1, 0, 0, 0}), pair));
  EXPECT_TRUE(decode(bytes({1, 0, 0, 0, 2, 0, 0, 0}), pair));
  EXPECT_EQ(pair[1], 2U);
}

}  // namespace
}  // namespace docent::schema::blob_test

#include "runtime/kiosk/object_details.h"

#include <gtest/gtest.h>

#include <map>

#include "platform/headless/headless_display.h"
#include "runtime/schema/object_blob.h"

namespace docent::kiosk::object_details_test {
namespace {

std::vector<std::byte> detail_with(std::size_t pictures) {
  const Pixels red{2, 2, std::vector<std::byte>(16, std::byte{200})};
  ObjectDetail detail;
  detail.mesh.vertices.resize(3);
  detail.mesh.triangles = {0, 1, 2};
  detail.parts = {{.first_index = 0, .index_count = 3, .picture = -1, .wrap = {}}};
  for (std::size_t i = 0; i < pictures; ++i)
    detail.pictures.push_back(image::encode_png(red).value());
  return schema::encode(detail);
}

class TheObjectDetails : public ::testing::Test {
 protected:
  void SetUp() override {
    auto display = headless::open_headless({64, 64});
    if (!display) GTEST_SKIP() << display.error().what;
    display_ = std::move(*display);
    holdings_.emplace();
  }

  /// How many frames it takes until nothing changes any more.
  int frames() {
    details_.wait();
    int count = 0;
    while (details_.upload_next(*holdings_)) ++count;
    return count;
  }

  std::map<std::uint32_t, int> read_;
  std::vector<std::byte> bytes_;
  ObjectDetails details_{[this](std::uint32_t object) {
    ++read_[object];
    bytes_ = object == 9 ? std::vector<std::byte>(5) : detail_with(object);
    return std::span<const std::byte>(bytes_);
  }};
  std::unique_ptr<headless::HeadlessDisplay> display_;
  std::optional<gles::Holdings> holdings_;
};

TEST_F(TheObjectDetails, AreCarriedThereAPieceAFrame) {
  EXPECT_EQ(frames(), 0) << "nobody has come to one";
  details_.want(2);

  EXPECT_EQ(frames(), 3) << "its shape and two pictures";
  details_.want(2);
  EXPECT_EQ(frames(), 0);
  EXPECT_EQ(read_[2], 1);
}

TEST_F(TheObjectDetails, MakeWayForAnotherAndForNothing) {
  details_.want(1);
  frames();
  details_.want(2);

  EXPECT_EQ(frames(), 1 + 3);
  details_.want({});
  EXPECT_EQ(frames(), 1);
  details_.want(2);
  EXPECT_EQ(frames(), 3);
}

TEST_F(TheObjectDetails, OfWhoeverIsLookedAtLastWin) {
  for (std::uint32_t i = 0; i < 200; ++i) {
    details_.want(i % 3 == 2 ? std::nullopt : std::optional(i % 3 + 1));
    details_.upload_next(*holdings_);
  }
  details_.want(3);
  EXPECT_GE(frames(), 4);
  EXPECT_EQ(frames(), 0);
}

TEST_F(TheObjectDetails, ThatCannotBeReadLeaveTheObjectAsItIsFromAfar) {
  details_.want(9);

  EXPECT_LE(frames(), 1);
  EXPECT_EQ(frames(), 0);
}

}  // namespace
}  // namespace docent::kiosk::object_details_test

#include "content/film/contact_sheet.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace docent::film::contact_sheet_test {
namespace {

Pixels filled(std::byte shade) {
  return {.width = 2, .height = 3, .rgba = std::vector<std::byte>(std::size_t{4} * 2 * 3, shade)};
}
std::byte red_at(const Pixels& picture, std::size_t x, std::size_t y) {
  return picture.rgba[4 * (y * picture.width + x)];
}

TEST(ContactSheet, HasThePicturesInRowsAndWhiteWhereThereIsNone) {
  const std::array pictures{filled(std::byte{10}), filled(std::byte{20}), filled(std::byte{30})};
  const Pixels sheet = contact_sheet(pictures, 2);

  ASSERT_EQ(sheet.width, 4U);
  ASSERT_EQ(sheet.height, 6U);
  ASSERT_EQ(sheet.rgba.size(), std::size_t{4} * 4 * 6);
  EXPECT_EQ(red_at(sheet, 1, 2), std::byte{10});
  EXPECT_EQ(red_at(sheet, 2, 0), std::byte{20});
  EXPECT_EQ(red_at(sheet, 0, 3), std::byte{30});
  EXPECT_EQ(red_at(sheet, 3, 5), std::byte{255});
}

TEST(ContactSheet, IsNoWiderThanItsPictures) {
  const std::array pictures{filled(std::byte{10})};
  EXPECT_EQ(contact_sheet(pictures, 5).width, 2U);
  EXPECT_EQ(contact_sheet({}, 5).width, 0U);
}

TEST(ContactSheet, IsAboutTwiceAsWideAsHigh) {
  EXPECT_EQ(sheet_columns(1), 2U);
  EXPECT_EQ(sheet_columns(8), 4U);
  EXPECT_EQ(sheet_columns(12), 5U);
}

}  // namespace
}  // namespace docent::film::contact_sheet_test

#include "content/reading/pinyin.h"

#include <gtest/gtest.h>

namespace docent::reading::pinyin_test {
namespace {

TEST(Pinyin, IsASyllableForEachSignWithoutTones) {
  EXPECT_EQ(pinyin_of("青铜鼎"), "qing tong ding");
  EXPECT_EQ(pinyin_of("编钟"), "bian zhong");
  EXPECT_EQ(pinyin_of("女史箴图"), "nu shi zhen tu");
  EXPECT_EQ(pinyin_of("青銅鼎"), "qing tong ding") << "in traditional signs, too";
}

TEST(Pinyin, LeavesOtherLettersWhereTheyAre) {
  EXPECT_EQ(pinyin_of("T台"), "t tai");
  EXPECT_EQ(pinyin_of("Bronze Tripod"), "") << "there is nothing to read";
  EXPECT_EQ(pinyin_of(""), "");
}

}  // namespace
}  // namespace docent::reading::pinyin_test

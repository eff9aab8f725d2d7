#include "runtime/release/manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace docent::release::manifest_test {
namespace {

using testing::HasSubstr;

const std::string hash(64, 'a');

Manifest a_manifest() {
  return {.version = 42,
          .issued = *time_of("2026-11-23T15:00:00Z"),
          .expires = *time_of("2026-12-23T15:00:00Z"),
          .program = "0.1.0",
          .groups = {"foyer", "floor-2"},
          .rollout = {.start = *time_of("2026-11-23T16:00:00Z"), .hours = 24},
          .halted = {40, 41},
          .files = {{7, 18'201'600, hash, "museum-s7.db"}, {8, 1, hash, "museum-s8.db"}}};
}

TEST(Manifest, IsReadFromTheTextThatItIsWrittenAs) {
  EXPECT_EQ(parse_manifest(to_text(a_manifest()), "release.txt"), a_manifest());
}

TEST(Manifest, OfAThousandKiosksCostsFewBytes) {
  EXPECT_LT(to_text(a_manifest()).size(), 600U);
}

TEST(Manifest, WithALineThatIsNoneIsRefusedWhole) {
  const std::string good = to_text(a_manifest());
  for (const std::string& more :
       {std::string("colour red\n"), std::string("file 7 1 ") + hash + " again.db\n",
        std::string("file 9 1 ") + hash + " ../museum.db\n",
        std::string("file 9 1 ") + hash + " .hidden\n", std::string("file 9 1 short a.db\n"),
        std::string("file 4294967303 1 ") + hash + " a.db\n", std::string("version -1\n"),
        std::string("version 99999999999999999999\n"), std::string("issued yesterday\n"),
        std::string("expires 2026-02-30T00:00:00Z\n"), std::string("group a/b\n"),
        std::string("rollout 2026-11-23T16:00:00Z\n"), std::string("halted\n")}) {
    const auto manifest = parse_manifest(good + more, "release.txt");

    ASSERT_FALSE(manifest.has_value()) << more;
    EXPECT_THAT(manifest.error().what, HasSubstr("release.txt: has a line")) << more;
  }
}

TEST(Manifest, ThatIsCutShortOrForeignIsRefused) {
  EXPECT_THAT(parse_manifest("", "a").error().what, HasSubstr("is not the manifest"));
  EXPECT_THAT(parse_manifest("<html>", "a").error().what, HasSubstr("is not the manifest"));
  EXPECT_THAT(parse_manifest("docent release 2\n", "a").error().what,
              HasSubstr("is not the manifest"));
  EXPECT_THAT(parse_manifest("docent release 1\nversion 3\n", "a").error().what,
              HasSubstr("lacks its version, its times or its files"));
}

TEST(Time, IsReadAndWrittenAsPeopleDo) {
  EXPECT_EQ(time_of("1970-01-01T00:00:00Z"), 0);
  EXPECT_EQ(time_of("2024-02-29T12:00:01Z"), 1709208001);
  EXPECT_EQ(text_of(1709208001), "2024-02-29T12:00:01Z");
  for (const char* wrong : {"", "2024-02-30T12:00:01Z", "2024-13-01T12:00:01Z",
                            "2024-02-29 12:00:01Z", "2024-02-29T24:00:00Z", "2024-02-29T12:00:01"})
    EXPECT_FALSE(time_of(wrong)) << wrong;
}

}  // namespace
}  // namespace docent::release::manifest_test

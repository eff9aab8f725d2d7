#include "content/import/collection/decode_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "platform/file/text_encoding.h"

namespace docent::import::decode_text_test {
namespace {

TEST(DecodeText, TakesWhatIsAskedFor) {
  EXPECT_EQ(decode_text("\xe9", "Latin-1").text, "é");
  EXPECT_EQ(decode_text("é", "utf-8").text, "é");
  EXPECT_EQ(decode_text("\xe9", "no such encoding").text, "é");
}

TEST(DecodeText, JoinsSurrogates) {
  EXPECT_EQ(decode_text(std::string_view("\xff\xfe\x3c\xd8\x89\xdf", 6)).text, "🎉");
}

RC_GTEST_PROP(DecodeText, IsAlwaysUtf8, (const std::string& bytes)) {
  for (const char* encoding : {"", "utf-8", "windows-1252", "utf-16", "utf-16be"}) {
    const std::string text = decode_text(bytes, encoding).text;
    RC_ASSERT(file::shown_as_utf8(text) == text);
  }
}

}  // namespace
}  // namespace docent::import::decode_text_test

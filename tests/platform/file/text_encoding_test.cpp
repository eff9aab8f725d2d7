#include "platform/file/text_encoding.h"

#include <gmock/gmock.h>

#include <array>

#include "tests/support/wide_text.h"

namespace docent::file::text_encoding_test {
namespace {

using test::ByteOrder;
using test::wide;
using testing::HasSubstr;
using testing::StartsWith;

struct NamedForm {
  std::size_t unit;
  ByteOrder order;
  const char* name;
};
constexpr std::array<NamedForm, 4> forms{{{2, ByteOrder::Little, "UTF-16 (little endian)"},
                                          {2, ByteOrder::Big, "UTF-16 (big endian)"},
                                          {4, ByteOrder::Little, "UTF-32 (little endian)"},
                                          {4, ByteOrder::Big, "UTF-32 (big endian)"}}};

TEST(TextEncoding, IsToldByName) {
  for (const NamedForm& form : forms)
    for (const std::u32string& text :
         {std::u32string(U"\uFEFFname = 1\n"), std::u32string(U"name = 1\n"),
          std::u32string(U"{\"名\": \"青铜三足鼎\"}"), std::u32string(U"\uFEFF"),
          std::u32string(U"id = 1\nid = 2\nid = 3\nid = 4\nid = 5\ntitle = \"一\"\n"),
          std::u32string(U"\uFEFF鼎")}) {
      if (text == U"\uFEFF鼎" && form.unit == 4) continue;
      const std::optional<EncodingFault> fault = encoding_fault(wide(text, form.unit, form.order));

      ASSERT_TRUE(fault.has_value()) << form.name;
      EXPECT_THAT(fault->message, StartsWith(std::string("is ") + form.name));
      EXPECT_THAT(fault->hint, HasSubstr("UTF-8"));
      EXPECT_EQ(fault->line, 1U);
    }
}

TEST(TextEncoding, OfUtf8IsRightWithAndWithoutItsMark) {
  for (const std::string& text :
       {std::string(), std::string("a"), std::string("name = \"café 鼎 🏺\"\n"),
        std::string("\xEF\xBB\xBFname = 1"), std::string("\xEF\xBB\xBF")})
    EXPECT_FALSE(encoding_fault(text).has_value()) << text;
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBFname"), "name");
  EXPECT_EQ(without_byte_order_mark("name"), "name");
}

TEST(TextEncoding, OfOneStrayZeroByteIsNotWide) {
  std::string text(1000, 'x');
  text[501] = '\0';

  EXPECT_FALSE(wide_encoding(text).has_value());
  EXPECT_FALSE(wide_encoding(std::string("{\"a\":\0 1}", 9)).has_value());
}

TEST(TextEncoding, OfAnythingButTextIsNone) {
  const std::optional<EncodingFault> fault = encoding_fault(std::string("SQLite\0 \x91\x00", 10));

  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->message, "is not a text: it holds zero bytes");
}

TEST(TextEncoding, SaysWhereALetterOfLatin1StandsAndWhichItIs) {
  const std::optional<EncodingFault> fault = encoding_fault("a = 1\nb = \"né Caf\xE9\"\n");

  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->line, 2U);
  EXPECT_EQ(fault->column, 12U);
  EXPECT_EQ(
      fault->message,
      "is not UTF-8 but, it seems, Windows-1252 (or Latin-1): the byte 0xE9 here is 'é' in it");
}

TEST(TextEncoding, NamesTheEncodingsThatALetterMayBeOf) {
  EXPECT_THAT(encoding_fault("title = \"Caf\x8E\"")->message,
              HasSubstr("Windows-1252 or Mac OS Roman: the byte 0x8E here is 'Ž' or 'é'"));
  EXPECT_THAT(encoding_fault("title = \"\x88 la carte\"")->message,
              HasSubstr("Mac OS Roman: the byte 0x88 here is 'à'"));
  EXPECT_THAT(encoding_fault("title = \"\xC7\xE1\xE3\xD1\xCC\xE1\"")->message,
              HasSubstr("Windows-1256 (Arabic), GBK or Big5 (Chinese)"));
}

TEST(TextEncoding, KnowsWhatIsNoCharacterOfUtf8) {
  for (const char* bytes : {"\xC0\xAF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
                            "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\x80", "\xC3", "\xE9 t"})
    EXPECT_TRUE(encoding_fault(bytes).has_value());
}

}  // namespace
}  // namespace docent::file::text_encoding_test

#include "platform/signature/key.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace docent::signature::key_test {
namespace {

using testing::HasSubstr;

TEST(Key, IsReadFromTheTextThatItIsWrittenAs) {
  const SecretKey secret = make_key();
  const PublicKey known = public_key(secret);

  EXPECT_EQ(parse_secret_key(to_text(secret), "a.key"), secret);
  EXPECT_EQ(parse_public_key(to_text(known), "a.pub"), known);
  EXPECT_THAT(to_text(known), HasSubstr(name_of(id_of(known))));
  EXPECT_NE(make_key(), secret);
}

TEST(Key, OfEd25519IsTheOneOfRfc8032) {
  // Section 7.1, test 1: the seed of that secret key, and the public key that it lists.
  const auto secret = parse_secret_key(
      "docent-secret-key-1 nWGxne/9WmC6hEr0kuwsxERJxWl7MmkZcDusAxyuf2A=", "rfc.key");

  ASSERT_TRUE(secret.has_value()) << secret.error().what;
  EXPECT_THAT(to_text(public_key(*secret)),
              HasSubstr("docent-public-key-1 11qYAYKxCrfVS/7TyWQHOg7hcvPapiMlrwIaaPcHURo="));
}

TEST(Key, OfTheOtherKindIsToldApart) {
  const SecretKey secret = make_key();

  EXPECT_THAT(parse_public_key(to_text(secret), "a.key").error().what,
              HasSubstr("a.key: is the secret key, which belongs on no kiosk"));
  EXPECT_THAT(parse_secret_key(to_text(public_key(secret)), "a.pub").error().what,
              HasSubstr("a.pub: is the public key, which signs nothing"));
}

TEST(Key, ThatIsNoneIsRefusedWithASentence) {
  const std::string good = to_text(public_key(make_key()));
  for (const std::string& text :
       {std::string(), std::string("# only a comment\n"), std::string("hello\n"), good + good,
        good.substr(0, good.size() - 3), good + "x\n", std::string("docent-public-key-1 "),
        std::string("docent-public-key-1 AAAA\n"), std::string(5000, '\0')}) {
    const auto key = parse_public_key(text, "a.pub");

    ASSERT_FALSE(key.has_value()) << text;
    EXPECT_EQ(key.error().code, Errc::InvalidInput);
    EXPECT_THAT(key.error().what, HasSubstr("a.pub: "));
  }
}

TEST(Key, MayHaveBeenThroughAnEditorThatEndsLinesAsWindowsDoes) {
  const PublicKey known = public_key(make_key());
  std::string text = to_text(known);
  text.insert(text.size() - 1, "\r");

  EXPECT_EQ(parse_public_key(text, "a.pub"), known);
}

TEST(Keys, ThatAreNotThereAreNamed) {
  const std::filesystem::path files[] = {"no/such/museum.pub"};

  EXPECT_THAT(read_public_keys(files).error().what, HasSubstr("no/such/museum.pub"));
}

}  // namespace
}  // namespace docent::signature::key_test

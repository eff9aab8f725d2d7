#include "platform/journal/message.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace docent::journal::message_test {
namespace {

TEST(Messages, HaveAnIdentifierOfTheirOwn) {
  std::set<std::string_view> ids;
  for (const MessageKind& kind : message_kinds()) {
    EXPECT_EQ(kind.id.size(), 32U);
    EXPECT_EQ(kind.id.find_first_not_of("0123456789abcdef"), std::string_view::npos) << kind.id;
    EXPECT_TRUE(ids.insert(kind.id).second) << kind.id << " stands twice";
  }
}

/// A fleet's monitoring asks for these: they stay what they are.
TEST(Messages, KeepTheirIdentifierForEver) {
  EXPECT_EQ(kind_of(Message::Shows).id, "1f67ddceca984559b931dec9c982f135");
  EXPECT_EQ(kind_of(Message::TakenUp).id, "1c73e7816a86427ea13f56605731a9ac");
  EXPECT_EQ(kind_of(Message::Refused).id, "6f5f0d645024461dba43c3a469f4da05");
  EXPECT_EQ(kind_of(Message::CannotStart).id, "0319b8e8da7b407cbbf1b0fb585e8ffb");
  EXPECT_EQ(kind_of(Message::ScreenLost).id, "4d7afe9a1704430bb917cf1e8d2d21b5");
  EXPECT_EQ(kind_of(Message::DeviceGone).id, "a6976ae455f5480d8aa85fa24c48e646");
}

TEST(Messages, AreExplained) {
  for (const MessageKind& kind : message_kinds()) {
    EXPECT_FALSE(kind.subject.empty()) << kind.id;
    EXPECT_TRUE(kind.remedy.ends_with('.')) << kind.id;
    EXPECT_EQ(&kind_of(kind.message), &kind);
  }
}

}  // namespace
}  // namespace docent::journal::message_test

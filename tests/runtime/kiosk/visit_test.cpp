#include "runtime/kiosk/visit.h"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <fstream>

#include "tests/support/temporary_folder.h"
#include "tests/support/wide_text.h"

namespace docent::kiosk::visit_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Visit, HoldsEveryKindOfCommand) {
  const Visit visit = parse_visit(
      "# a visit\n"
      "0.5 tap 0.25 0.75\n"
      "1 tap @exhibit:tripod-ding   # by name\n"
      "2 down 3 0.1 0.2\n"
      "2.1 move 3 0.2 0.2\n"
      "2.2 up 3\n"
      "3 key ENTER\n"
      "3.5 key F12\n"
      "4 shot picture.png\n"
      "5 quit\n",
      "v.visit");

  EXPECT_THAT(visit.mistakes, IsEmpty());
  ASSERT_THAT(visit.commands, SizeIs(9));
  EXPECT_EQ(visit.commands[0].contact.y, 0.75F);
  EXPECT_EQ(visit.commands[1].name, "exhibit:tripod-ding");
  EXPECT_EQ(visit.commands[2].contact.id, 3U);
  EXPECT_EQ(visit.commands[5].key.key, input::Key::Enter);
  EXPECT_EQ(visit.commands[6].key.character, 12);
  EXPECT_EQ(visit.commands[7].name, "picture.png");
}

TEST(Visit, MaySayFromWhichSeatOfASharedGlassAControlIsReached) {
  const Visit visit = parse_visit("1 tap @look:rose seat 3\n2 tap @home\n", "v.visit");

  ASSERT_THAT(visit.mistakes, IsEmpty());
  EXPECT_EQ(visit.commands[0].name, "look:rose");
  EXPECT_EQ(visit.commands[0].seat, 3U);
  EXPECT_FALSE(visit.commands[1].seat);
  for (const char* line : {"1 tap @home seat 0", "1 tap @home seat 9", "1 tap @home seat",
                           "1 tap @home seat x", "1 tap @home at 3"})
    EXPECT_THAT(parse_visit(line, "v.visit").mistakes, SizeIs(1)) << line;
}

TEST(Visit, IsPlayedInOrderOfTime) {
  const Visit visit = parse_visit("5 quit\n1 tap @home\n", "v.visit");

  EXPECT_EQ(visit.commands[0].kind, VisitCommand::Kind::TapNamed);
  EXPECT_EQ(visit.commands[1].kind, VisitCommand::Kind::Quit);
}

TEST(Visit, ReportsEveryMistakeWithItsLine) {
  const Visit visit = parse_visit(
      "1 dance\n"
      "soon tap @home\n"
      "2 tap 0.5\n"
      "3 tap 0.5 1.5\n"
      "4 key NOSE\n"
      "5\n"
      "6 quit\n",
      "v.visit");

  ASSERT_THAT(visit.mistakes, SizeIs(6));
  EXPECT_THAT(visit.mistakes[0].message, HasSubstr("'dance'"));
  for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ(visit.mistakes[i].line, i + 1);
  EXPECT_EQ(visit.mistakes[3].column, 11U);
}

TEST(Visit, ThatCannotBeReadIsAMistake) {
  EXPECT_THAT(load_visit("/nowhere/v.visit").mistakes, SizeIs(1));
}

TEST(Visit, OfAnotherEncodingSaysWhichAndWhatToDo) {
  const test::TemporaryFolder folder;
  const std::filesystem::path wide = folder.path() / "wide.visit",
                              old = folder.path() / "old.visit";
  std::ofstream(wide, std::ios::binary)
      << test::wide(U"\uFEFF1 quit\n", 2, test::ByteOrder::Little);
  std::ofstream(old, std::ios::binary) << "# f\xFCr Besucher\n1 quit\n";

  const Visit of_wide = load_visit(wide), of_old = load_visit(old);

  ASSERT_THAT(of_wide.mistakes, SizeIs(1));
  EXPECT_THAT(of_wide.mistakes[0].message, HasSubstr("is UTF-16 (little endian)"));
  EXPECT_THAT(of_wide.mistakes[0].hint, HasSubstr("UTF-8"));
  ASSERT_THAT(of_old.mistakes, SizeIs(1));
  EXPECT_EQ(of_old.mistakes[0].line, 1U);
  EXPECT_EQ(of_old.mistakes[0].column, 4U);
}

TEST(Visit, MayBeginWithAByteOrderMark) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "marked.visit";
  std::ofstream(file, std::ios::binary) << "\xEF\xBB\xBF" << "1 quit\n";

  const Visit visit = load_visit(file);

  EXPECT_THAT(visit.mistakes, IsEmpty());
  EXPECT_THAT(visit.commands, SizeIs(1));
}

TEST(Visit, IsDefinedForAnyText) {
  EXPECT_TRUE(rc::check("every line is a command or a mistake", [](const std::string& text) {
    const Visit visit = parse_visit(text, "v.visit");
    for (const VisitCommand& command : visit.commands) RC_ASSERT(command.time >= 0);
  }));
}

}  // namespace
}  // namespace docent::kiosk::visit_test

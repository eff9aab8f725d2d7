#include "content/import/building/keep_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace docent::test::keep_edits_test {
namespace {

using import::Edit;
using import::keep_edits;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> told(const import::MergedToml& merged, Edit::Kind kind) {
  std::vector<std::string> what;
  for (const Edit& edit : merged.edits)
    if (edit.kind == kind) what.push_back(edit.what);
  return what;
}

constexpr const char* base =
    "[museum]\ntitle.en = \"House\"\n\n"
    "[[room]]\nid = \"hall\"\ntitle.en = \"Hall\"\nlabel = [1, 2]\n\n"
    "[[room]]\nid = \"store\"\ntitle.en = \"Store\"\nlabel = [5, 2]\n";

TEST(KeepEdits, LeavesAFileAloneThatNeitherStaffNorThePlanHaveChanged) {
  const auto merged = keep_edits(base, base, base);

  EXPECT_EQ(merged.text, base);
  EXPECT_THAT(merged.edits, IsEmpty());
}

TEST(KeepEdits, KeepsATitleThatStaffWroteAndSaysSo) {
  std::string mine = base;
  mine.replace(mine.find("\"Hall\""), 6, "\"The Great Hall\"");

  const auto merged = keep_edits(base, mine, base);

  EXPECT_EQ(merged.text, mine);
  EXPECT_THAT(told(merged, Edit::Kind::Kept), ElementsAre("title.en of [[room]] \"hall\""));
}

TEST(KeepEdits, TakesOverWhatThePlanChangedBesideWhatStaffWrote) {
  std::string mine = base, theirs = base;
  mine.replace(mine.find("\"Hall\""), 6, "\"The Great Hall\"   # ours");
  theirs.replace(theirs.find("[1, 2]"), 6, "[1, 3]");

  const auto merged = keep_edits(base, mine, theirs);

  EXPECT_THAT(merged.text, HasSubstr("title.en = \"The Great Hall\"   # ours\nlabel = [1, 3]\n"));
  EXPECT_THAT(told(merged, Edit::Kind::Changed), ElementsAre("label of [[room]] \"hall\""));
}

TEST(KeepEdits, AddsNewRoomsAndTakesOutThoseThatAreGone) {
  std::string theirs = base;
  theirs.replace(theirs.find("id = \"store\""), 12, "id = \"cafe\"");

  const auto merged = keep_edits(base, base, theirs);

  EXPECT_THAT(merged.text, HasSubstr("id = \"cafe\""));
  EXPECT_THAT(merged.text, Not(HasSubstr("id = \"store\"")));
  EXPECT_THAT(told(merged, Edit::Kind::Added), ElementsAre("[[room]] \"cafe\""));
  EXPECT_THAT(told(merged, Edit::Kind::Removed), ElementsAre("[[room]] \"store\""));
}

TEST(KeepEdits, KeepsARoomThatIsGoneFromThePlanWhereStaffWroteInIt) {
  std::string mine = base;
  mine += "paving = \"stone\"\n";
  const std::string theirs(base, std::string(base).find("\n[[room]]\nid = \"store\""));

  const auto merged = keep_edits(base, mine, theirs);

  EXPECT_EQ(merged.text, mine);
  EXPECT_THAT(told(merged, Edit::Kind::Orphan), ElementsAre("[[room]] \"store\""));
}

TEST(KeepEdits, KeepsWhatStaffAddedAndDoesNotBringBackWhatTheyTookOut) {
  const std::string all = base;
  const std::string mine =
      all.substr(0, all.find("[[room]]\nid = \"store\"")) + "[[tour]]\nid = \"short\"\n";

  const auto merged = keep_edits(base, mine, base);

  EXPECT_EQ(merged.text, mine);
  EXPECT_THAT(told(merged, Edit::Kind::Kept), ElementsAre("that [[room]] \"store\" is not there"));
}

TEST(KeepEdits, ReadsValuesOverSeveralLinesAsOne) {
  const std::string was =
      "[[connection]]\nid = \"lift\"\nstops = [\n  {floor = \"0\"},\n  {floor = \"1\"}]\n";
  std::string is = was;
  is.replace(is.find("\"1\""), 3, "\"2\"");

  const auto merged = keep_edits(was, was, is);

  EXPECT_EQ(merged.text, is);
  EXPECT_THAT(told(merged, Edit::Kind::Changed), ElementsAre("stops of [[connection]] \"lift\""));
}

RC_GTEST_PROP(KeepEdits, NeverLosesALineOfStaffsThatThePlanDoesNotKnow, ()) {
  const auto at = *rc::gen::inRange<std::size_t>(0, 11);
  std::string mine, line;
  std::size_t count = 0;
  for (const char c : std::string(base)) {
    line += c;
    if (c != '\n') continue;
    mine += line;
    if (count++ == at) mine += "# mine\nown_field = 7\n";
    line.clear();
  }

  const auto merged = keep_edits(base, mine, base);

  RC_ASSERT(merged.text.find("# mine\nown_field = 7\n") != std::string::npos);
}

}  // namespace
}  // namespace docent::test::keep_edits_test

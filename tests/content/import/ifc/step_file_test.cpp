#include "content/import/ifc/step_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "content/content_error.h"

namespace docent::test::step_file_test {
namespace {

using testing::HasSubstr;

std::string with_data(const std::string& data) {
  return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n" + data +
         "ENDSEC;\nEND-ISO-10303-21;\n";
}

std::string complaint_about(const std::string& text) {
  try {
    import::parse_step("house.ifc", text);
    return "no complaint";
  } catch (const content::ContentError& error) {
    return std::to_string(error.line) + ": " + error.what();
  }
}

TEST(StepFile, ReadsEveryKindOfValue) {
  const import::StepFile step = import::parse_step(
      "house.ifc",
      with_data("#1=IFCWALL('it''s',$,*,#2,.T.,(1.5,-2E1),IFCLABEL('x')); /* so */\n"));

  const import::StepRecord& wall = step.at(1);
  EXPECT_EQ(step.schema, "IFC4");
  EXPECT_EQ(wall.type, "IFCWALL");
  EXPECT_EQ(wall.line, 6U);
  EXPECT_EQ(wall[0].text, "it's");
  EXPECT_EQ(wall[3].reference, 2U);
  EXPECT_EQ(wall[4].text, "T");
  EXPECT_EQ(wall[5].items.at(1).number, -20);
  EXPECT_EQ(wall[6].text, "x");
  EXPECT_EQ(wall[99].kind, import::StepValue::Kind::Absent);
  EXPECT_TRUE(step.at(wall[3]).type.empty());
}

TEST(StepFile, ReadsLettersOfEveryEncoding) {
  EXPECT_EQ(import::decoded_step_text("K\\X2\\00FC\\X0\\che"), "Küche");
  EXPECT_EQ(import::decoded_step_text("K\\X\\FCche"), "Küche");
  EXPECT_EQ(import::decoded_step_text("K\\S\\|che"), "Küche");
  EXPECT_EQ(import::decoded_step_text("K\xfc"
                                      "che"),
            "Küche");
  EXPECT_EQ(import::decoded_step_text("\\X2\\12"), "12");
}

TEST(StepFile, SaysWhereItIsDamaged) {
  EXPECT_THAT(complaint_about("solid cube"), HasSubstr("does not begin with ISO-10303-21"));
  EXPECT_THAT(complaint_about(with_data("#1=IFCWALL(?);\n")),
              testing::StartsWith("6: this IFC file has '?'"));
  EXPECT_THAT(complaint_about(with_data("#1=IFCWALL('a);\n")), HasSubstr("does not end"));
  EXPECT_THAT(complaint_about(with_data("#1=IFCWALL" + std::string(100, '('))),
              HasSubstr("nests lists deeper"));
}

TEST(StepFile, CutAnywhereIsAnErrorOrWholeRecords) {
  const std::string whole = with_data("#1=IFCWALL('a',(#2,$));\n#2=IFCDOOR(1.);\n");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    try {
      import::parse_step("house.ifc", std::string_view(whole).substr(0, length));
    } catch (const content::ContentError& error) {
      EXPECT_GT(error.line, 0U);
    }
  }
}

}  // namespace
}  // namespace docent::test::step_file_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "content/content_error.h"
#include "content/import/translation/translation.h"
#include "tests/support/reference_data.h"
#include "tests/support/run_program.h"

namespace docent::import::xliff_test {
namespace {

constexpr std::string_view head =
    "<xliff xmlns='urn:oasis:names:tc:xliff:document:2.0' version='2.0' srcLang='en' trgLang='ar'>"
    "<file id='f'>";

Translation read(const std::string& units) {
  return read_xliff("t.xlf", std::string(head) + units + "</file></xliff>");
}

TEST(Xliff, JoinsTheSegmentsOfAUnit) {
  const Translation t = read(
      "<unit id='a.text'><segment><source>One.</source><target>Eins.</target></segment>"
      "<ignorable><source> </source></ignorable>"
      "<segment><source>Two <pc id='1'>bold</pc>.</source><target>Zwei <pc "
      "id='1'>fett</pc>.</target>"
      "</segment></unit>");

  EXPECT_EQ(t.units.at(0).source, "One. Two bold.");
  EXPECT_EQ(t.units.at(0).target, "Eins. Zwei fett.");
  EXPECT_FALSE(t.units.at(0).is_partial);
}

TEST(Xliff, KnowsWhatIsTranslatedOnlyInPart) {
  const Translation t = read(
      "<unit id='a'><segment><source>One.</source><target>Eins.</target></segment>"
      "<segment><source>Two.</source></segment></unit>"
      "<unit id='b'><segment><source>None.</source></segment></unit>");

  EXPECT_TRUE(t.units.at(0).is_partial);
  EXPECT_FALSE(t.units.at(1).is_partial);
  EXPECT_EQ(t.units.at(1).target, "");
}

TEST(Xliff, RefusesWhatIsNone) {
  for (const char* text : {"", "no XML", "<xliff", "<html/>", "<xliff version='2.0'/>", "<xliff/>"})
    EXPECT_THROW(read_xliff("t.xlf", text), content::ContentError) << text;
}

TEST(Xliff, OpensNoOtherFile) {
  const Translation t = read_xliff(
      "t.xlf", "<!DOCTYPE x [<!ENTITY e SYSTEM 'file:///etc/passwd'>]>" + std::string(head) +
                   "<unit id='a'><segment><source>&e;</source></segment></unit></file></xliff>");

  EXPECT_EQ(t.units.at(0).source, "&e;");
}

RC_GTEST_PROP(Xliff, ReadsBackWhatItWrites, (std::vector<std::string> texts)) {
  Translation written{.from = "en", .to = "zh-Hant", .units = {}};
  for (std::string& text : texts) {
    std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n'; });
    std::erase_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; });
    written.units.push_back({.id = "u" + std::to_string(written.units.size()),
                             .source = "<&\"" + text,
                             .target = text.empty() ? "" : text + "é]]>"});
  }

  const Translation back = read_xliff("t.xlf", write_xliff(written));
  const Translation table = read_translation_csv("t.csv", write_translation_csv(written));

  RC_ASSERT(back.to == "zh-Hant");
  RC_ASSERT(back.units.size() == written.units.size());
  RC_ASSERT(table.units.size() == written.units.size());
  for (std::size_t i = 0; i < back.units.size(); ++i) {
    RC_ASSERT(back.units[i].id == written.units[i].id);
    RC_ASSERT(back.units[i].source == written.units[i].source);
    RC_ASSERT(back.units[i].target == written.units[i].target);
  }
}

TEST(Xliff, FilesOfToolsAndOfTheStandardAreRead) {
  NEEDS_REFERENCE_DATA("collections/xliff/xliff.facts.json");
  const auto folder = test::reference_data() / "collections/xliff";
  const auto facts = nlohmann::json::parse(std::ifstream(folder / "xliff.facts.json"));
  std::size_t read_files = 0;

  for (const auto& [name, fact] : facts.items()) {
    if (name.find("/invalid/") != std::string::npos) continue;
    const Translation t = read_xliff(name, test::text_of(folder / name));
    ++read_files;
    EXPECT_EQ(t.units.size(), fact["units"].get<std::size_t>()) << name;
    for (const auto& expected : fact["expected"]) {
      if (!expected["source"].is_string()) continue;
      // Files of one XLIFF may use an id each.
      EXPECT_TRUE(std::ranges::any_of(t.units, [&](const TranslationUnit& unit) {
        return unit.id == expected["unit"].get<std::string>() &&
               unit.source.find(expected["source"].get<std::string>()) != std::string::npos;
      })) << name;
    }
  }
  EXPECT_GE(read_files, 35U);
}

TEST(Xliff, FaultyFilesNeverEndOtherwiseThanWithASentence) {
  NEEDS_REFERENCE_DATA("collections/xliff/xliff.facts.json");
  const auto folder = test::reference_data() / "collections/xliff";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".xlf") continue;
    try {
      read_xliff(entry.path().string(), test::text_of(entry.path()));
    } catch (const content::ContentError& error) {
      EXPECT_FALSE(std::string_view(error.what()).empty());
    }
  }
}

}  // namespace
}  // namespace docent::import::xliff_test

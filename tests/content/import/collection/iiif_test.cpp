#include "content/import/collection/iiif.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "content/content_error.h"
#include "tests/support/reference_data.h"
#include "tests/support/run_program.h"

namespace docent::import::iiif_test {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(Iiif, ReadsAManifestOfVersion3) {
  const Collection read = read_iiif("m.json", R"({"id": "https://m.example/1", "type": "Manifest",
    "label": {"en": ["Jar", "Pot"], "none": ["Inv. 7"]}, "summary": {"en": ["<p>Old.</p>"]},
    "metadata": [{"label": {"en": ["Date"]}, "value": {"en": ["1650"]}},
                 {"label": {"en": ["Subject"]}, "value": {"en": ["clay"]}}],
    "items": [{"type": "Canvas", "items": [{"type": "AnnotationPage", "items": [{
      "type": "Annotation", "body": {"id": "https://m.example/1.jpg", "type": "Image"}}]}]}]})");

  ASSERT_EQ(read.objects.size(), 1U);
  const CollectionObject& object = read.objects[0];
  EXPECT_EQ(object.id, "https://m.example/1");
  EXPECT_THAT(object.title, ElementsAre(Pair("en", "Jar | Pot"), Pair("und", "Inv. 7")));
  EXPECT_THAT(object.text, ElementsAre(Pair("en", "Old.")));
  EXPECT_EQ(object.image, "https://m.example/1.jpg");
  EXPECT_THAT(object.subject, ElementsAre("clay"));
  EXPECT_THAT(object.period, ElementsAre(Pair("en", "1650")));
}

TEST(Iiif, ReadsAManifestOfVersion2) {
  const Collection read =
      read_iiif("m.json", R"({"@id": "https://m.example/2", "@type": "sc:Manifest",
    "label": [{"@value": "Krug", "@language": "de"}, "Jug"], "description": "Old",
    "sequences": [{"canvases": [{"images": [{"resource": {"@id": "2.jpg", "@type": "dctypes:Image"}}]}]}]})");

  ASSERT_EQ(read.objects.size(), 1U);
  EXPECT_THAT(read.objects[0].title, ElementsAre(Pair("de", "Krug"), Pair("und", "Jug")));
  EXPECT_EQ(read.objects[0].image, "2.jpg");
}

TEST(Iiif, SaysWhatItIsInsteadOfAManifest) {
  EXPECT_THROW(read_iiif("m.json", R"({"type": "FeatureCollection"})"), content::ContentError);
  EXPECT_THROW(read_iiif("m.json", "[]"), content::ContentError);
  EXPECT_THROW(read_iiif("m.json", "{"), content::ContentError);
}

TEST(Iiif, ListsTheAddressesOfACollection) {
  const Collection read = read_iiif("c.json", R"({"id": "c", "type": "Collection", "items": [
    {"id": "https://m.example/1", "type": "Manifest", "label": {"en": ["A"]}}, {"type": "Manifest"}]})");

  EXPECT_THAT(read.members, ElementsAre("https://m.example/1"));
  EXPECT_EQ(read.doubts.size(), 1U);
}

TEST(Iiif, RealManifestsAreReadAsAnIndependentReaderReadsThem) {
  NEEDS_REFERENCE_DATA("collections/iiif/iiif.facts.json");
  const auto folder = test::reference_data() / "collections/iiif";
  const auto facts = nlohmann::json::parse(std::ifstream(folder / "iiif.facts.json"));
  std::size_t compared = 0;

  for (const auto& [name, fact] : facts.items()) {
    Collection read;
    try {
      read = read_iiif(name, test::text_of(folder / name));
    } catch (const content::ContentError& error) {
      EXPECT_THAT(name, testing::StartsWith("broken/")) << error.what();
      continue;
    }
    if (!fact.contains("expected") || name.starts_with("broken/")) continue;
    if (read.objects.empty()) {
      EXPECT_FALSE(read.members.empty()) << name;
      continue;
    }
    ++compared;
    const auto& expected = fact["expected"];
    EXPECT_EQ(read.objects[0].id, expected["id"].get<std::string>()) << name;
    for (const auto& [language, title] : expected["title"].items())
      EXPECT_EQ(read.objects[0].title[language], title.get<std::string>()) << name;
    if (!expected["image"].is_string()) continue;
    EXPECT_EQ(read.objects[0].image, expected["image"].get<std::string>()) << name;
  }
  EXPECT_GE(compared, 20U);
}

}  // namespace
}  // namespace docent::import::iiif_test

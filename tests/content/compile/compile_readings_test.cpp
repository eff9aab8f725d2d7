#include "content/compile/compile_readings.h"

#include <gtest/gtest.h>

namespace docent::compile::compile_readings_test {
namespace {

TEST(Readings, AreThoseOfChineseTitlesAndTagsAndWhatStaffSayInstead) {
  Museum museum;
  Exhibit& exhibit = museum.exhibits.emplace_back();
  exhibit.title = {{"en", "Bronze Tripod"}, {"zh", "青铜鼎"}, {"ja", "青銅の鼎"}};
  exhibit.period = {{"zh", "商"}};
  config::MuseumConfig config;
  config::SpeechSection& said = config.speech.emplace_back();
  said.text.value = "青銅の鼎";
  said.reading.value = "せい どう の かなえ";
  said.text.given = said.reading.given = true;

  compile_readings(config, museum);

  EXPECT_EQ(museum.readings.size(), 3U);
  EXPECT_EQ(museum.readings.at("青铜鼎"), "qing tong ding");
  EXPECT_EQ(museum.readings.at("商"), "shang");
  EXPECT_EQ(museum.readings.at("青銅の鼎"), "せい どう の かなえ");
}

}  // namespace
}  // namespace docent::compile::compile_readings_test

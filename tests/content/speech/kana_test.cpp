#include "content/speech/kana.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>

#include "content/content_error.h"
#include "content/speech/run_program.h"
#include "content/speech/voice.h"
#include "tests/support/temporary_folder.h"

namespace docent::speech::kana_test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Kana, JoinsWordsThatLeanOnTheOneBefore) {
  EXPECT_THAT(kana_of("鼎\t名詞\t一般\tカナエ\nは\t助詞\t係助詞\tワ\n部屋\t名詞\t一般\tヘヤ\n"
                      "に\t助詞\t格助詞\tニ\nあり\t動詞\t自立\tアリ\nます\t助動詞\t*\tマス\n"
                      "。\t記号\t句点\t。\nEOS\n"),
              ElementsAre("カナエワ ヘヤニ アリマス。"));
}

TEST(Kana, AreOneTextForEachEnd) {
  EXPECT_THAT(kana_of("EOS\n左\t名詞\t一般\tヒダリ\nEOS\n"), ElementsAre("", "ヒダリ"));
}

TEST(Kana, LeaveWhatHasNoReadingAsItIs) {
  EXPECT_THAT(kana_of("docent\t\t\t\n龘\t名詞\t一般\t*\nEOS\n"), ElementsAre("docent 龘"));
}

TEST(Kana, CallAWayOutAsPeopleDo) {
  EXPECT_THAT(kana_of("出口\t名詞\t一般\tイデグチ\nEOS\n"), ElementsAre("デグチ"));
}

TEST(Kana, AreDefinedForAnyText) {
  rc::check([](const std::string& text) { kana_of(text); });
}

TEST(Kana, SayNumbersAsTheyAreSaid) {
  EXPECT_EQ(number_in_kana(0), "ゼロ");
  EXPECT_EQ(number_in_kana(10), "ジュウ");
  EXPECT_EQ(number_in_kana(19), "ジュウキュウ");
  EXPECT_EQ(number_in_kana(300), "サンビャク");
  EXPECT_EQ(number_in_kana(3'608), "サンゼンロッピャクハチ");
  EXPECT_EQ(number_in_kana(8'888), "ハッセンハッピャクハチジュウハチ");
  EXPECT_EQ(number_in_kana(10'000), "イチマン");
  EXPECT_EQ(number_in_kana(21'000'400), "ニセンヒャクマンヨンヒャク");
}

std::string counted(const std::string& number, const std::string& counter) {
  return kana_of(number + "\t\t\t\n" + counter + "\t名詞\t接尾\tX\nEOS\n").at(0);
}

TEST(Kana, ChangeTheSoundsOfCountersAsTheirNumbersDo) {
  EXPECT_EQ(counted("1", "分"), "イップン");
  EXPECT_EQ(counted("2", "分"), "ニフン");
  EXPECT_EQ(counted("3", "分"), "サンプン");
  EXPECT_EQ(counted("4", "分"), "ヨンプン");
  EXPECT_EQ(counted("10", "分"), "ジュップン");
  EXPECT_EQ(counted("16", "分"), "ジュウロップン");
  EXPECT_EQ(counted("1", "階"), "イッカイ");
  EXPECT_EQ(counted("3", "階"), "サンガイ");
  EXPECT_EQ(counted("4", "階"), "ヨンカイ");
  EXPECT_EQ(counted("8", "か所"), "ハッカショ");
  EXPECT_EQ(counted("3", "回"), "サンカイ");
  EXPECT_EQ(counted("7", "月"), "シチガツ");
  EXPECT_EQ(counted("6", "月"), "ロクガツ");
  EXPECT_EQ(counted("14", "時"), "ジュウヨジ");
  EXPECT_EQ(counted("9", "時"), "クジ");
  EXPECT_EQ(counted("2024", "年"), "ニセンニジュウヨネン");
  EXPECT_EQ(counted("19", "メートル"), "ジュウキュウX");
}

TEST(Kana, NeedADictionaryInUtf8) {
  EXPECT_EQ(fault_of_dictionary("filename:\t/x/sys.dic\nversion:\t102\ncharset:\tUTF-8\n"), "");
  EXPECT_EQ(fault_of_dictionary("charset:\tutf8\n"), "");
  EXPECT_EQ(fault_of_dictionary("charset:\tEUC-JP\n"), "its dictionary is not in UTF-8");
  EXPECT_EQ(fault_of_dictionary(""), "it has no dictionary");
}

TEST(Kana, OfAReaderThatIsNotThereTellWhatToInstall) {
  const std::vector<std::string_view> texts{"館"};
  try {
    read_in_kana(texts, "/nowhere/mecab");
    FAIL() << "it is not there";
  } catch (const content::ContentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is not installed"));
    EXPECT_THAT(error.hint, HasSubstr("mecab-ipadic-utf8"));
  }
}

TEST(Kana, OfAReaderThatAnswersTooLittleAreRefused) {
  const test::TemporaryFolder folder;
  const auto program = folder.path() / "mecab";
  std::ofstream(program) << "#!/bin/sh\n[ \"$1\" = -D ] && echo 'charset: utf8' && exit 0\n"
                            "cat >/dev/null\nprintf 'a\\t\\t\\tb\\nEOS\\n'\n";
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const std::vector<std::string_view> texts{"館", "左"};

  EXPECT_THROW(read_in_kana(texts, program.string()), content::ContentError);
}

TEST(Kana, OfThisMachinesReaderAreReadByItsVoice) {
  for (const char* const program : {"mecab", "espeak-ng"})
    if (run_program({program, "--version"}, {}, 20s).kind == Outcome::Kind::Missing)
      GTEST_SKIP() << "no " << program;
  const std::vector<std::string_view> texts{"青銅の鼎は部屋の中央の\nガラスケースにあります。",
                                            "約30秒、19メートル、段差なし", "博物館へようこそ"};

  const std::vector<std::string> said = read_in_kana(texts);

  ASSERT_EQ(said.size(), 3U);
  EXPECT_THAT(said[0], HasSubstr("カナエワ"));
  EXPECT_THAT(said[1], HasSubstr("サンジュウビョー"));
  EXPECT_THAT(said[2], HasSubstr("ハクブツカンエ"));
  const Espeak espeak = Espeak::find();
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_EQ(reading_fault(espeak.phonemes("ja", said[i])), "") << said[i];
    EXPECT_NE(reading_fault(espeak.phonemes("ja", texts[i])), "");
  }
}

}  // namespace
}  // namespace docent::speech::kana_test

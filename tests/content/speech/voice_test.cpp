#include "content/speech/voice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "content/content_error.h"
#include "content/speech/run_program.h"
#include "tests/content/speech/made_recordings.h"
#include "tests/support/temporary_folder.h"

namespace docent::speech::voice_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

TEST(Voice, OfChineseIsTheOneThatReadsItsOwnPinyin) {
  EXPECT_EQ(voice_name("zh"), "cmn-latn-pinyin");
  EXPECT_EQ(voice_name("zh-Hans"), "cmn-latn-pinyin");
  EXPECT_EQ(voice_name("en-GB"), "en");
  EXPECT_EQ(voice_name("de"), "de");
}

// What espeak-ng 1.51 of Debian 12 answers to a line of each language.
TEST(Voice, IsKnownByItsPhonemes) {
  EXPECT_EQ(reading_fault("tˈʌtʃ tə bɪɡˈɪn\nwˈɛlkʌm"), "");
  EXPECT_EQ(reading_fault("tɕˈiɛ5n tsʰˈai̪51 tsˈou21 jˈiou51"), "");
  EXPECT_EQ(reading_fault("bɭʲɪʐˈaɪʂɨj ˈis tuaɭʲˈɛtɨ v muzʲˈej"), "");
  EXPECT_THAT(reading_fault(" (en)tʃˈaɪniːz(ja)lˈɛtə (en)tʃˈaɪniːz(ja)lˈɛtə hˈe jˈo ˈu kˈo sˈo"),
              HasSubstr("does not know the script"));
  EXPECT_THAT(reading_fault("mˈi jlχ ʔtχm χˈalon vlˈi mdʁ"),
              HasSubstr("50 of 100 words have none"));
  EXPECT_EQ(reading_fault(" \n \n"), "its voice reads nothing of it");
}

TEST(Voice, MayNameSomethingInForeignLetters) {
  EXPECT_EQ(reading_fault("eɪ̯n rˈʊntɡaŋ ɪm mjuːzˈeːʊm mɪt diːm (en)bˈɪtɹ(de) ʊnt nˈɔxt mˈeːɐ "
                          "vˈɔɾtən dˈi nˈɪxts ˈɛndɐn ˈan dˈem"),
            "");
}

// A few lines of what espeak-ng 1.51 of Debian 12 lists.
constexpr std::string_view listed =
    "Pty Language       Age/Gender VoiceName          File                 Other Languages\n"
    " 5  cmn-latn-pinyin --/M      Chinese_(Mandarin,_latin_as_Pinyin) sit/cmn-Latn-pinyin  (zh "
    "5)\n"
    " 2  en-gb           --/M      English_(Great_Britain) gmw/en               (en 2)\n"
    " 5  ko              --/M      Korean             ko                   \n"
    " 5  xx              --/M      One                one/xx               \n"
    " 5  xx              --/M      Another            other/xx             \n";

TEST(Voice, HasAFileThatIsItsAlone) {
  EXPECT_THAT(voice_files(listed),
              ElementsAre(Pair("cmn-latn-pinyin", "sit/cmn-Latn-pinyin"), Pair("en", "gmw/en")));
  EXPECT_THAT(voice_files("what is that?\n\n1 2"), IsEmpty());
}

/// A program that says that it is espeak-ng, and then does as `script` says.
class FakeEspeak {
 public:
  explicit FakeEspeak(std::string_view script) {
    std::ofstream(file()) << "#!/bin/sh\n"
                             "[ \"$1\" = --version ] && echo 'eSpeak NG text-to-speech: 9.9  Data "
                             "at: /x' && exit 0\n"
                             "[ \"$1\" = --voices ] && echo '"
                          << listed << "' && exit 0\n"
                          << script << "\n";
    std::filesystem::permissions(file(), std::filesystem::perms::owner_all);
  }
  std::string file() const { return (folder_.path() / "espeak-ng").string(); }

 private:
  test::TemporaryFolder folder_;
};

std::string what_is_said_of(const auto& run) {
  try {
    run();
    return {};
  } catch (const content::ContentError& error) {
    return error.what();
  }
}

TEST(Espeak, SaysItsVersion) {
  EXPECT_EQ(Espeak::find(FakeEspeak("").file()).version(), "9.9");
}

TEST(Espeak, ThatIsMissingOrAnotherProgramIsToldInASentence) {
  EXPECT_EQ(what_is_said_of([] { Espeak::find("no-such-program-of-docent"); }),
            "the program is not there");
  EXPECT_EQ(what_is_said_of([] { Espeak::find("true"); }), "the program does not say its version");
}

TEST(Espeak, ThatFailsIsToldInASentence) {
  const FakeEspeak failing("echo 'out of luck' >&2; exit 3");
  EXPECT_EQ(what_is_said_of([&] { Espeak::find(failing.file()).say("en", "hello"); }),
            "the program failed (3): out of luck");
  const FakeEspeak voiceless("echo 'Error: The specified voice does not exist.' >&2; exit 1");
  EXPECT_EQ(what_is_said_of([&] { Espeak::find(voiceless.file()).phonemes("xx", "hello"); }),
            "there is no voice for it");
  const FakeEspeak babbling("echo no sound");
  EXPECT_EQ(what_is_said_of([&] { Espeak::find(babbling.file()).say("en", "hello"); }),
            "this is no WAV file");
}

TEST(Espeak, IsAskedForAVoiceByItsFileWhereItSaysWhichThatIs) {
  const FakeEspeak answering("echo \"$@\"");
  const Espeak espeak = Espeak::find(answering.file());
  EXPECT_THAT(espeak.phonemes("en", "hello"), HasSubstr("-v gmw/en --stdin"));
  EXPECT_THAT(espeak.phonemes("xx", "hello"), HasSubstr("-v xx --stdin"));
}

TEST(Espeak, GetsTheTextByItsInputWithoutItsOwnCodes) {
  const FakeEspeak listening("cat");
  EXPECT_EQ(Espeak::find(listening.file()).phonemes("en", "-w file; [[h@l'oU]] [[["),
            "-w file; [ h@l'oU]] [ [\n");
}

TEST(Espeak, ThatComplainsBeforeItsSoundIsAskedAgain) {
  const test::TemporaryFolder folder;
  const std::string wav = (folder.path() / "a.wav").string(),
                    asked = (folder.path() / "asked").string();
  std::ofstream(wav, std::ios::binary) << test::wav_of(test::tone(200, 22'050, 2'205), 22'050);
  const FakeEspeak stumbling("[ -e '" + asked + "' ] || echo -n 'Invalid phoneme code 117.'\n: >'" +
                             asked + "'\ncat '" + wav + "'");
  EXPECT_EQ(Espeak::find(stumbling.file()).say("ar", "119").samples.size(), 2'205U);
}

/// Numbers that end in nine are what espeak-ng 1.51 stumbles over.
TEST(Espeak, OfThisMachineSaysTheSameEachTime) {
  if (std::system("espeak-ng --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no espeak-ng";
  const bool is_still =
      run_program({"setarch", "-R", "true"}, {}, std::chrono::seconds(20)).status == 0;
  const Espeak espeak = Espeak::find();
  const Pcm first = espeak.say("ar", "نحو 119 دقيقة");
  EXPECT_GT(first.samples.size(), first.rate / 2);
  for (int i = 0; i < 40; ++i) {
    const Pcm next = espeak.say("ar", "نحو 119 دقيقة");
    if (is_still) {
      ASSERT_EQ(next.samples, first.samples) << i;
    }
  }
}

TEST(Espeak, OfThisMachineSaysTheSameByAVoicesNameAndByItsFile) {
  const Outcome list = run_program({"espeak-ng", "--voices"}, {}, std::chrono::seconds(20));
  if (list.kind != Outcome::Kind::Ended) GTEST_SKIP() << "no espeak-ng";
  const auto files = voice_files(list.output);
  for (const std::string voice : {"en", "de", "fr", "es", "ru", "ar", "hi", "cmn-latn-pinyin"}) {
    const auto said = [](const std::string& by) {
      return run_program({"espeak-ng", "-v", by, "--stdin", "--stdout"}, "12 museum\n",
                         std::chrono::seconds(20))
          .output;
    };
    ASSERT_TRUE(files.contains(voice)) << voice;
    EXPECT_EQ(said(files.at(voice)), said(voice)) << voice;
  }
}

TEST(Espeak, IsGivenAPlayerThatPlaysNothing) {
  const FakeEspeak asking("echo \"$LD_LIBRARY_PATH\"");
  const std::string folder = Espeak::find(asking.file()).phonemes("en", "hello");
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(folder.substr(0, folder.find('\n'))) /
                                      "libpcaudio.so.0"))
      << folder;
}

TEST(Espeak, ThatAsksMoreOfItsPlayerGetsItsOwn) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "espeak-ng";
  std::ofstream(file)
      << "#!/bin/sh\n[ -z \"$LD_LIBRARY_PATH\" ] || [ -z \"$LD_BIND_NOW\" ] || exit 127\n"
         "echo 'eSpeak NG text-to-speech: 2.0  Data at: /'\n";
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  const char* const before = std::getenv("LD_LIBRARY_PATH");
  const std::string kept = before == nullptr ? "" : before;
  unsetenv("LD_LIBRARY_PATH");
  EXPECT_EQ(Espeak::find(file.string()).version(), "2.0");
  if (before != nullptr) setenv("LD_LIBRARY_PATH", kept.c_str(), 1);
}

TEST(Espeak, OfThisMachineSaysTheSameWithoutAPlayer) {
  const std::vector<std::string> say{"espeak-ng", "-v", "en", "--stdin", "--stdout"};
  const Outcome with_player = run_program(say, "12 museums\n", std::chrono::seconds(20));
  if (with_player.kind != Outcome::Kind::Ended) GTEST_SKIP() << "no espeak-ng";
  const FakeEspeak asking("echo \"$LD_LIBRARY_PATH\"");
  std::string folder = Espeak::find(asking.file()).phonemes("en", "hello");
  folder.resize(folder.find('\n'));
  const Outcome without =
      run_program(say, "12 museums\n", std::chrono::seconds(20), most_output, folder);
  EXPECT_EQ(without.status, 0) << without.errors;
  EXPECT_EQ(without.output, with_player.output);
}

TEST(Espeak, OfThisMachineSpeaks) {
  if (std::system("espeak-ng --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no espeak-ng";
  const Espeak espeak = Espeak::find();
  const Pcm said = espeak.say("en", "Welcome to the museum");
  EXPECT_GT(said.samples.size(), said.rate);
  EXPECT_GT(test::power(said.samples), 0.001);
  EXPECT_EQ(reading_fault(espeak.phonemes("en", "Welcome to the museum")), "");
  EXPECT_NE(reading_fault(espeak.phonemes("ja", "博物館へようこそ")), "");
  EXPECT_NE(reading_fault(espeak.phonemes("he", "ברוכים הבאים למוזיאון של העיר")), "");
  EXPECT_EQ(reading_fault(espeak.phonemes(voice_name("zh"), "第一展厅在右边")), "");
  EXPECT_EQ(what_is_said_of([&] { espeak.say("xx", "hello"); }), "there is no voice for it");
}

}  // namespace
}  // namespace docent::speech::voice_test

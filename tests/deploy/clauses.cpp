#include "tests/deploy/clauses.h"

#include <fmt/format.h>

#include <array>

namespace docent::test {
namespace {

using State = Clause::State;

constexpr std::string_view above = R"(# For whom docent works, clause by clause

What docent does about EN 301 549 (V3.2.1), the standard by which the European Accessibility Act is judged: chapter 5 and chapter 8, as far as they
have to do with a kiosk. Made by the tests from `tests/deploy/clauses.cpp`: what is called *met* is proved by the tests that are named, which run
with every change. Nobody outside the project has judged it, and nobody who is blind has tried it yet.

*The museum's* is what the standard asks of the cabinet, the keypad, the loudspeaker and the floor before them: it is listed, because the standard is met
only where that is met too.
)";

constexpr std::string_view below = R"(
Where it hangs: say `mount_height` in `kiosk.toml`, the millimetres from the floor to the glass's lower edge. Visitors can then bring everything that is
touched within 380 to 1,220 mm of the floor. Keep 760 by 1,220 mm of level floor free before it, and put the keypad and the jack of the headphones within
the same heights. `same_key_delay` is for hands that tremble, `reduced_motion` for whom movement makes ill, `text_scale` for a hall where many read badly.
)";

const std::array table{
    Clause{"5.1.2.2",
           "Without assistive technology of one's own",
           State::InPart,
           "Everything is reached by touch, and by a keypad of six keys with speech; headphones "
           "are not needed to begin it. Open: nothing is spoken on a glass that visitors share.",
           {"Guide.CanBeUsedByKeysAlone", "ClosedEyes.MakeAWholeVisitByTheTranscriptAlone"}},
    Clause{"5.1.3.1",
           "Audio output of visual information",
           State::InPart,
           "Every control and text is spoken to one visitor. Open: nothing is spoken where several "
           "share a glass; the model itself is told only as the "
           "sentences of a way.",
           {"Speech.SaysNameRoleAndStateOfEveryControl",
            "OnGlass.EveryControlIsSpokenAndWithLowReachWithinReachOfAWheelchair",
            "Speech.TellsOnTheWayTheThreeSentencesAndThenTheText"}},
    Clause{"5.1.3.2",
           "Auditory output, speech included",
           State::Met,
           "By any device that ALSA knows: a loudspeaker, or a jack for headphones, whose plug "
           "begins it.",
           {"Player.SaysASentenceToItsEnd", "JackWatch.TellsEachChangeOnce"}},
    Clause{"5.1.3.3",
           "Correlation of speech and screen",
           State::Met,
           "What has the focus is said in the frame that outlines it.",
           {"Voice.SaysWhatTheFocusComesToInTheSameFrame"}},
    Clause{"5.1.3.4",
           "Speech can be interrupted and repeated",
           State::Met,
           "Any key ends a sentence; a key says it again; it goes slower and faster.",
           {"Voice.IsLouderFasterAndSaysItAgainByKeys", "Player.EndsASentenceForTheNext"}},
    Clause{"5.1.3.5",
           "Speech ends when somebody acts",
           State::Met,
           "",
           {"Player.EndsASentenceForTheNext"}},
    Clause{"5.1.3.6",
           "Speech for what is no text",
           State::InPart,
           "What staff write as an exhibit's `description` is spoken after its title, and compile "
           "says how many pictures have none; where there are several, each is described as one "
           "leafs to "
           "it. Open: of those without, the exhibit's text alone is read.",
           {"Speech.DescribesThePictureAfterTheTitle",
            "ACloserLook.LeafsRoundAndRoundThroughThePicturesAndSaysWhichOneIsSeen",
            "AnExhibitWithoutAPicture.IsDescribedWhereThePictureWouldBe",
            "Found.SaysHowManyPicturesHaveNoDescription"}},
    Clause{"5.1.3.7",
           "Speech for video",
           State::InPart,
           "A video is silent and lasts a minute at most: its caption and its `description` are "
           "spoken as one leafs to it, and it is played and stopped by a control. Open: nothing is "
           "said while it plays.",
           {"ControlGraph.AVideoIsPlayedAndStoppedWhereItIsSeen",
            "ACloserLook.LeafsRoundAndRoundThroughThePicturesAndSaysWhichOneIsSeen"}},
    Clause{"5.1.3.8",
           "Masked entry",
           State::NotConcerned,
           "Visitors enter nothing that is secret.",
           {}},
    Clause{"5.1.3.9",
           "Private access to personal data",
           State::NotConcerned,
           "None is asked for and none is kept.",
           {}},
    Clause{"5.1.3.10",
           "No sound that interferes",
           State::Met,
           "Nothing sounds until somebody wants to hear, and then one voice or one sound alone: "
           "what is spoken ends a sound.",
           {"Voice.IsSilentUntilSomebodyWantsToHear",
            "Listening.WithClosedEyesIsToTheSoundAloneUntilItEnds",
            "Listening.WithClosedEyesEndsForWhateverIsSaid"}},
    Clause{"5.1.3.11",
           "Volume of private listening",
           State::Met,
           "By two keys, without seeing; of a sound, too.",
           {"Voice.IsLouderFasterAndSaysItAgainByKeys",
            "Listening.IsLouderAndSofterByTheKeysWithoutAWord"}},
    Clause{"5.1.3.12",
           "Volume of a loudspeaker",
           State::TheMuseums,
           "Ten steps of 4 dB; that the loudspeaker reaches 65 dBA is the cabinet's. `[sound] "
           "volume` bounds it.",
           {}},
    Clause{"5.1.3.13",
           "Volume is reset",
           State::Met,
           "To the middle of the ten steps, after each visitor.",
           {"Voice.IsBackToNormalForTheNextVisitor"}},
    Clause{"5.1.3.14",
           "Spoken in the language that is shown",
           State::InPart,
           "Each language by its own voice, Japanese through the kana that MeCab reads. Open: no "
           "voice of Debian reads Hebrew and Thai well enough; the compiler says so, and staff's "
           "recordings stand in.",
           {"Speech.NamesEachLanguageInThatLanguage", "Kana.OfThisMachinesReaderAreReadByItsVoice",
            "Speech.IsMadeOfPreparedPiecesAloneInEveryLanguage", "Voice.IsKnownByItsPhonemes"}},
    Clause{"5.1.3.15",
           "Errors are told without seeing",
           State::Met,
           "Why there is no way is said.",
           {"Speech.SaysWhyThereIsNoWay"}},
    Clause{"5.1.3.16", "Receipts and tickets", State::NotConcerned, "There are none.", {}},
    Clause{"5.1.4",
           "Larger text",
           State::InPart,
           "One touch makes letters half as large again: capitals of 7.5 mm on a screen of 32 "
           "inches, 0.7 degrees from 60 cm away. Open: on smaller "
           "screens less; on a glass that visitors share letters are as kiosk.toml says.",
           {"Senses.AreAsOneVisitorWantsThemAndNormalForTheNext",
            "OnGlass.SaysHowHighLettersAreOnTheGlass"}},
    Clause{
        "5.1.5",
        "What is heard can be seen",
        State::InPart,
        "What is said and heard in a video is read on its lower edge, as staff have captioned it; "
        "what a sound is like stands beside its button, and its captions are read while it plays, "
        "or all at once where nothing can be heard. "
        "While something is said to one visitor, the glass shows it as a caption, page by page, "
        "each for as long as it sounds. Open: recordings of staff that say something else are "
        "captioned with what they stand for; captions of a sound are staff's to write.",
        {"Listening.BeginsByATouchAndEndsBySelfWithItsCaptionsReadMeanwhile",
         "Listening.IsOfferedNowhereWhereNothingCanBeHeardAndIsReadInstead",
         "Captions.ShowWhatIsSaidWhileItSounds", "Caption.ShowsAllThatIsSaidPageByPage",
         "Caption.TurnsItsPagesAsLongAsTheSpeechThatWasPreparedTakes",
         "Caption.CoversNothingThatCanBeTouched", "Watching.HasTheCaptionsReadAtTheirTimes",
         "Cues.LieInTheLowerHalfOfTheVideoInAnyLanguageAndSizeOfLetters",
         "Speech.IsMadeOfPreparedPiecesAloneInEveryLanguage"}},
    Clause{"5.1.6.1",
           "Without a keyboard",
           State::Met,
           "A keypad of six keys, without seeing.",
           {"ClosedEyes.MakeAWholeVisitByTheTranscriptAlone"}},
    Clause{"5.1.6.2",
           "The focus moves on",
           State::Met,
           "Into everything and out again.",
           {"Guide.CanBeUsedByKeysAlone", "OnGlass.EveryControlOfAScreenIsReached"}},
    Clause{"5.1.7", "Without speaking", State::NotConcerned, "Nobody needs to speak to it.", {}},
    Clause{"5.2",
           "Helps are turned on by those who need them",
           State::InPart,
           "Larger letters, contrast, low reach and speech are four buttons of every screen; "
           "speech also begins with headphones or the key HELP. Open: a glass that visitors share "
           "has none of them.",
           {"Guide.ComesToTheHelpsLastByKeys", "Voice.IsSilentUntilSomebodyWantsToHear"}},
    Clause{"5.3", "Biometrics", State::NotConcerned, "None.", {}},
    Clause{
        "5.4", "Conversion keeps what helps", State::NotConcerned, "Visitors convert nothing.", {}},
    Clause{"5.5.1",
           "Parts that need no grip",
           State::Met,
           "Touches of one finger and keys: nothing is held, pinched or turned.",
           {"OnGlass.EveryControlOfAScreenIsReached", "Gestures.AreAReleaseWhereTheFingerStayed"}},
    Clause{"5.5.2",
           "Parts are found without pressing them",
           State::InPart,
           "By keys what has the focus is said before it is pressed. That the keys can be felt is "
           "the keypad's.",
           {"Voice.SaysWhatTheFocusComesToInTheSameFrame"}},
    Clause{"5.6.1",
           "Switches tell by ear how they are",
           State::Met,
           "",
           {"Speech.SaysNameRoleAndStateOfEveryControl"}},
    Clause{"5.6.2",
           "Switches tell by eye how they are",
           State::Met,
           "A switch that is on is darker and has a frame.",
           {"Senses.ThatAreOnHaveAFrame"}},
    Clause{"5.7",
           "Key repeat",
           State::Met,
           "There is none: a key that is held acts once.",
           {"Keys.GoDownAndUpOnce"}},
    Clause{"5.8",
           "Double strikes",
           State::Met,
           "`same_key_delay` in `kiosk.toml`, 0 to 2 seconds.",
           {"SameKey.IsLeftOutUntilTheDelayIsOver"}},
    Clause{"5.9",
           "Simultaneous actions",
           State::Met,
           "None is asked for.",
           {"Guide.CanBeUsedByKeysAlone"}},
    Clause{"8.1.2",
           "Standard connections",
           State::TheMuseums,
           "Keypads by USB HID, headphones by any jack that ALSA knows.",
           {}},
    Clause{"8.1.3", "Colour of the hardware", State::TheMuseums, "", {}},
    Clause{"8.2.1",
           "Range of the volume of speech",
           State::Met,
           "36 dB in steps of 4 dB.",
           {"Volume.GrowsEvenlyToTheEar"}},
    Clause{"8.2.2", "Magnetic coupling", State::NotConcerned, "It is no telephone.", {}},
    Clause{"8.3",
           "Reach",
           State::Met,
           "With low reach everything that is touched lies 380 to 1,220 mm above the floor, where "
           "`mount_height` is said, unless it hangs so high that two fifths of the glass are above "
           "that: then the journal says so, and how low it has to hang.",
           {"OnGlass.EveryControlIsSpokenAndWithLowReachWithinReachOfAWheelchair",
            "Senses.BringAllThatIsTouchedWithinReachOfAWheelchairSpotsIncluded",
            "LowReach.SaysHowLowAGlassHasToHangThatHangsTooHigh"}},
    Clause{"8.3", "Floor, knees, toes and sight of the screen", State::TheMuseums, "", {}},
    Clause{"8.3",
           "Instructions for hanging it",
           State::Met,
           "Below.",
           {"AccessibilityPage.SaysHowItIsHung"}},
    Clause{"8.4", "Keys, and the force that they take", State::TheMuseums, "", {}},
    Clause{"8.5",
           "A mark to feel where speech begins",
           State::TheMuseums,
           "At the jack, or the key HELP.",
           {}}};

std::string_view name_of(State state) {
  switch (state) {
    case State::Met:
      return "met";
    case State::InPart:
      return "in part";
    case State::Open:
      return "open";
    case State::TheMuseums:
      return "the museum's";
    case State::NotConcerned:
      return "not concerned";
  }
  return "";
}

}  // namespace

std::span<const Clause> clauses() {
  return table;
}

std::string accessibility_page() {
  std::string page(above);
  page += "\n| clause | asks for | docent | how | proved by |\n| --- | --- | --- | --- | --- |\n";
  for (const Clause& clause : table) {
    std::string tests;
    for (const std::string_view test : clause.tests)
      tests += fmt::format("{}`{}`", tests.empty() ? "" : ", ", test);
    page += fmt::format("| {} | {} | {} | {} | {} |\n", clause.number, clause.title,
                        name_of(clause.state), clause.says, tests);
  }
  return page += below;
}

}  // namespace docent::test

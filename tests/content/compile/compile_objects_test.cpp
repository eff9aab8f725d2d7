#include "content/compile/compile_objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "runtime/schema/invariants.h"
#include "tests/content/compile/thing_folder.h"

namespace docent::compile::compile_objects_test {
namespace {

using test_things::Compiled;
using test_things::Folder;
using test_things::pyramid;
using ::testing::Contains;
using ::testing::HasSubstr;

Compiled compiled(const std::string& exhibit, const std::string& model, bool only_check = false) {
  return Folder(exhibit, model).compiled(false, only_check);
}

const Exhibit& thing(const Museum& museum) {
  return *std::ranges::find(museum.exhibits, "thing", &Exhibit::id);
}

TEST(CompileObjects, StandsAnObjectOnAPlinthInsteadOfItsPicture) {
  const Compiled it = compiled("position = [3.0, 6.0]\n", pyramid);

  ASSERT_TRUE(it.museum.has_value()) << ::testing::PrintToString(it.told);
  ASSERT_EQ(it.museum->objects.size(), 1U);
  EXPECT_EQ(thing(*it.museum).object, 0);
  EXPECT_NEAR(it.museum->objects[0].size.y, 0.4, 1e-4);
  EXPECT_GT(thing(*it.museum).stand.base, 0.3);
  EXPECT_EQ(thing(*it.museum).stand.scale, 1);
  const auto index = static_cast<std::int32_t>(&thing(*it.museum) - it.museum->exhibits.data());
  for (const SceneryPart& part : it.museum->scenery[0].parts) EXPECT_NE(part.exhibit, index);
  EXPECT_EQ(schema::broken_invariant(*it.museum), "");
  EXPECT_THAT(it.told, Contains(HasSubstr("object-guessed: 'models/thing.obj': it says no unit")));
}

TEST(CompileObjects, MakesItAsHighAsStaffSay) {
  const Compiled it = compiled("position = [3.0, 6.0]\nheight = 0.2\nup = \"y\"\n", pyramid);

  ASSERT_TRUE(it.museum.has_value()) << ::testing::PrintToString(it.told);
  EXPECT_NEAR(it.museum->objects[0].size.y, 0.2, 1e-5);
  EXPECT_THAT(it.told, ::testing::Not(Contains(HasSubstr("object-guessed"))));
}

TEST(CompileObjects, TellsWhatIsWrongWithAFileWhenItChecksToo) {
  for (const bool only_check : {true, false}) {
    const Compiled it = compiled("position = [3.0, 6.0]\n", "v 0 0 0\nf 1 2 3\n", only_check);

    EXPECT_FALSE(it.museum.has_value());
    EXPECT_THAT(it.told, Contains(HasSubstr("unreadable-model: 'models/thing.obj': it holds no "
                                            "triangle that can be used: line 2")));
  }
}

TEST(CompileObjects, TellsWhatWasLeftOut) {
  const Compiled it = compiled("position = [3.0, 6.0]\n", std::string(pyramid) + "f 1 2 99\n");

  EXPECT_TRUE(it.museum.has_value());
  EXPECT_THAT(it.told, Contains(HasSubstr("object-mended: 'models/thing.obj': line 11: a face")));
}

TEST(CompileObjects, ShowsThePictureOfWhatHangsOnAWall) {
  const Compiled it = compiled("position = [5.0, 8.0]\n", pyramid);

  ASSERT_TRUE(it.museum.has_value()) << ::testing::PrintToString(it.told);
  EXPECT_THAT(it.told, Contains(HasSubstr("object-on-wall: exhibit 'thing' hangs on a wall")));
  EXPECT_EQ(thing(*it.museum).object, -1);
  EXPECT_TRUE(it.museum->objects.empty());
}

/// The small museum with a thing whose shape its exhibit tells, from line 7 on: what is told is
/// "line: code: sentence (hint)".
Compiled told(const std::string& shape, bool only_check = true) {
  const Folder folder("");
  folder.it.write("exhibits/thing.toml",
                  "[[exhibit]]\nid = \"thing\"\nfacing = 270\ntitle.en = \"Thing\"\n"
                  "title.ar = \"شيء\"\nposition = [3.0, 6.0]\n" +
                      shape);
  folder.it.write("images/busy.svg",
                  "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 40 40'>"
                  "<rect width='40' height='40' fill='red'/>"
                  "<rect width='20' height='40' fill='blue'/></svg>");
  folder.it.write("images/words.png", "these are words");
  Report report;
  Progress progress(Progress::Output::Nothing);
  CompileOptions options;
  options.sources = {folder.it.path().string()};
  options.with_motion = options.with_speech = false;
  options.only_check = only_check;
  Compiled compiled{compile(options, report, progress), {}};
  for (const Diagnostic& one : report.in_order())
    compiled.told.push_back(std::to_string(one.line) + ": " + one.code + ": " + one.message + " (" +
                            one.hint + ")");
  return compiled;
}

TEST(CompileObjects, TurnsAnOutline) {
  const Compiled it =
      told("turned = [[0.1, 0], [0.2, 0.2], [0.1, 0.4]]\nwrapped = \"images/busy.svg\"\n", false);

  ASSERT_TRUE(it.museum.has_value()) << ::testing::PrintToString(it.told);
  ASSERT_EQ(it.museum->objects.size(), 1U);
  EXPECT_NEAR(it.museum->objects[0].size.y, 0.4, 1e-4);
  EXPECT_NEAR(it.museum->objects[0].size.x, 0.4, 1e-2);
  EXPECT_EQ(it.museum->objects[0].name, "thing");
  EXPECT_EQ(schema::broken_invariant(*it.museum), "");
}

TEST(CompileObjects, TurnsAnOutlineAsHighAsStaffSay) {
  const Compiled it = told("turned = [[1, 0], [2, 2], [1, 4]]\nheight = 0.4\n", false);

  ASSERT_TRUE(it.museum.has_value()) << ::testing::PrintToString(it.told);
  EXPECT_NEAR(it.museum->objects[0].size.y, 0.4, 1e-4);
  EXPECT_NEAR(it.museum->objects[0].size.z, 0.4, 1e-2);
}

TEST(CompileObjects, TurnsWhatIsLargerThanAScanMayBe) {
  const Compiled it = told("turned = [[0.5, 0], [0.4, 7]]\n", false);

  ASSERT_TRUE(it.museum.has_value()) << ::testing::PrintToString(it.told);
  EXPECT_NEAR(it.museum->objects[0].size.y, 7, 1e-3) << "metres, not millimetres";
}

TEST(CompileObjects, CutsAReliefOutOfAPicture) {
  const Compiled it = told("relief = \"images/disc.svg\"\nheight = 0.3\n", false);

  ASSERT_TRUE(it.museum.has_value()) << ::testing::PrintToString(it.told);
  ASSERT_EQ(it.museum->objects.size(), 1U);
  EXPECT_NEAR(it.museum->objects[0].size.y, 0.3, 1e-4);
  EXPECT_NEAR(it.museum->objects[0].size.x, 0.3, 0.01) << "a disc";
  EXPECT_LT(it.museum->objects[0].size.z, 0.25);
  EXPECT_EQ(schema::broken_invariant(*it.museum), "");
}

struct Mistake {
  const char* name;
  const char* shape;
  const char* told;
};
void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

class MistakenShape : public ::testing::TestWithParam<Mistake> {};

TEST_P(MistakenShape, IsToldWithItsLineAndWhatToDo) {
  const Compiled it = told(GetParam().shape);

  EXPECT_FALSE(it.museum.has_value());
  EXPECT_THAT(it.told, Contains(HasSubstr(GetParam().told)));
  EXPECT_THAT(it.told, ::testing::Not(Contains(HasSubstr("()")))) << "each has a hint";
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, MistakenShape,
    ::testing::Values(
        Mistake{"NegativeRadius", "turned = [[0.1, 0],\n [-0.2, 0.2]]\n",
                "8: out-of-range: 'turned' should be from 0 to 30"},
        Mistake{"NotANumber", "turned = [[0.1, 0], [nan, 0.2]]\n", "7: out-of-range"},
        Mistake{"Millimetres", "turned = [[100, 0], [180, 200]]\n",
                "is it in the right unit, and the point in its place?"},
        Mistake{"DecimalCommas", "turned = [[0.1, 0], [0,2, 0,4]]\n",
                "decimals are written with a full stop: [[0.1, 0], [0.2, 0.4]]"},
        Mistake{"ListOfNumbers", "turned = [0.1, 0, 0.2, 0.2, 0.1, 0.4]\n",
                "write turned = [[0.1, 0], [0.2, 0.2], [0.1, 0.4]]"},
        Mistake{"Text", "turned = \"round\"\n", "7: wrong-type: 'turned' should be a list of"},
        Mistake{"OnePoint", "turned = [[0.1, 0]]\n",
                "7: bad-outline: 'turned' of exhibit 'thing': it has one point"},
        Mistake{"NoPoint", "turned = []\n", "7: bad-outline: "},
        Mistake{"Flat", "turned = [[0.1, 0.2], [0.3, 0.2]]\n",
                "7: bad-outline: 'turned' of "
                "exhibit 'thing': its heights go "
                "nowhere"},
        Mistake{"Crossing", "turned = [\n [0.1, 0],\n [0.3, 0.3],\n [0.1, 0.3],\n [0.3, 0.0]]\n",
                "11: bad-outline: 'turned' of exhibit 'thing': it touches or crosses itself near "
                "its points"},
        Mistake{"NoColour", "turned = [[0.1, 0], [0.1, 0.2]]\ncolour = \"brown\"\n",
                "8: bad-value: 'colour' cannot be \"brown\""},
        Mistake{"NoPicture", "turned = [[0.1, 0], [0.1, 0.2]]\nwrapped = \"images/jar.png\"\n",
                "8: missing-file: there is no file 'images/jar.png'"},
        Mistake{"NoPictureButWords",
                "turned = [[0.1, 0], [0.1, 0.2]]\nwrapped = \"images/words.png\"\n",
                "8: unreadable-image: 'turned' of exhibit 'thing': 'images/words.png': this is"},
        Mistake{"ColourOfNothing", "colour = \"#804020\"\n",
                "7: bad-value: exhibit 'thing' has 'colour', which is of what is turned"},
        Mistake{"UpOfWhatIsTurned", "turned = [[0.1, 0], [0.1, 0.2]]\nup = \"z\"\n",
                "8: bad-value: exhibit 'thing' has 'up', which is of a 'model', and 'turned'"},
        Mistake{"Misspelled", "turnd = [[0.1, 0], [0.1, 0.2]]\n",
                "7: unknown-key: [[exhibit]] has no 'turnd' (did you mean 'turned'?"},
        Mistake{"Twice", "model = \"models/thing.obj\"\nturned = [[0.1, 0], [0.1, 0.2]]\n",
                "8: bad-value: exhibit 'thing' has both 'model' and 'turned' (keep one of them"},
        Mistake{"ReliefToo",
                "turned = [[0.1, 0], [0.1, 0.2]]\nrelief = \"images/disc.svg\"\nheight = 1\n",
                "8: bad-value: exhibit 'thing' has both 'turned' and 'relief'"},
        Mistake{"ReliefWithoutHeight", "relief = \"images/disc.svg\"\n",
                "7: missing-field: exhibit 'thing' has a relief, and no height"},
        Mistake{"ReliefThatIsNotThere", "relief = \"images/dish.svg\"\nheight = 1\n",
                "7: missing-file: there is no file 'images/dish.svg' (did you mean"},
        Mistake{"ReliefOfABusyPicture", "relief = \"images/busy.svg\"\nheight = 1\n",
                "7: busy-picture: 'images/busy.svg': its ground is busy: "},
        Mistake{"ReliefOfWords", "relief = \"images/words.png\"\nheight = 1\n",
                "7: unreadable-image: 'images/words.png': this is"}),
    [](const auto& mistake) { return mistake.param.name; });

TEST(CompileObjects, TellsOfAnOutlineOfThousandsOfPointsAtTheFirstTooMany) {
  std::string shape = "turned = [\n";
  for (int i = 0; i < 3000; ++i) shape += "[0.1, 0." + std::to_string(10000 + i) + "],\n";

  EXPECT_THAT(told(shape + "]\n").told,
              Contains(HasSubstr("108: bad-outline: 'turned' of exhibit 'thing': it has 3000")));
}

}  // namespace
}  // namespace docent::compile::compile_objects_test

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

}  // namespace
}  // namespace docent::compile::compile_objects_test

#include "content/compile/found.h"

#include <gmock/gmock.h>

namespace docent::compile::found_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(Found, SaysHowManyPicturesHaveNoDescription) {
  Museum museum;
  museum.images = {{.name = "jar.png", .bytes = {}}, {.name = "", .bytes = {}}};
  museum.exhibits.resize(3);
  museum.exhibits[1].description = {{"en", "A red jar."}};
  museum.exhibits[2].image = 1;  // a blank one, which shows nothing

  EXPECT_EQ(undescribed_pictures(museum), 1U);
  EXPECT_THAT(found_text(museum, nullptr), EndsWith("; 1 picture has no description"));
  museum.pictures = {{.exhibit = 0, .image = 0}};
  EXPECT_THAT(found_text(museum, nullptr), EndsWith("; 2 pictures have no description"));
  museum.pictures.clear();
  museum.exhibits[1].description.clear();
  EXPECT_THAT(found_text(museum, nullptr), EndsWith("; 2 pictures have no description"));
  for (Exhibit& exhibit : museum.exhibits) exhibit.description = {{"en", "A jar."}};
  EXPECT_THAT(found_text(museum, nullptr), Not(HasSubstr("description")));
}

}  // namespace
}  // namespace docent::compile::found_test

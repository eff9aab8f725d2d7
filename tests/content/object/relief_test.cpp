#include "content/object/relief.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "content/content_error.h"
#include "content/object/cut_out.h"
#include "content/object/make_object.h"
#include "content/object/shape.h"
#include "content/object/trace.h"
#include "runtime/schema/object_blob.h"
#include "tests/content/object/solid.h"

namespace docent::object::relief_test {
namespace {

using test::corner;
using test::is_closed;
using test::volume_of;

using ::testing::HasSubstr;
using Rgba = std::array<int, 4>;

Pixels picture(std::uint32_t width, std::uint32_t height,
               const std::function<Rgba(double x, double y)>& colour) {
  Pixels made{.width = width, .height = height, .rgba = {}};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (const int channel : colour(x + 0.5, y + 0.5))
        made.rgba.push_back(static_cast<std::byte>(channel));
  return made;
}

/// A jar with two handles that one sees through, in a picture of 400 by 500, y down.
bool is_jar(double x, double y) {
  const auto within = [&](double cx, double cy, double rx, double ry) {
    return std::pow((x - cx) / rx, 2) + std::pow((y - cy) / ry, 2) < 1;
  };
  const bool belly = within(200, 290, 110, 150), neck = std::abs(x - 200) < 34 && y > 60 && y < 220;
  const bool lip = std::abs(x - 200) < 60 && y > 50 && y < 74;
  const bool foot = std::abs(x - 200) < 70 && y > 410 && y < 450;
  const bool handles = within(110, 170, 50, 60) || within(290, 170, 50, 60);
  const bool eyes = within(110, 165, 30, 38) || within(290, 165, 30, 38);
  return belly || neck || lip || foot || (handles && !eyes);
}
constexpr Rgba red{150, 60, 30, 255}, clear{0, 0, 0, 0}, wall{228, 226, 220, 255};

Pixels clear_jar() {
  return picture(400, 500, [](double x, double y) { return is_jar(x, y) ? red : clear; });
}
/// On a wall that is darker to one side, with the grain of a photograph.
Pixels jar_on_wall() {
  unsigned state = 1;
  return picture(400, 500, [&](double x, double y) {
    state = state * 1664525U + 1013904223U;
    const int grain = static_cast<int>(state >> 28U) - 8, shade = static_cast<int>(x / 12);
    Rgba colour = is_jar(x, y) ? red : wall;
    for (std::size_t c = 0; c < 3; ++c)
      colour[c] = std::clamp(colour[c] + grain - (is_jar(x, y) ? 0 : shade), 0, 255);
    return colour;
  });
}

Shape shape_of(const Pixels& pixels) {
  std::vector<std::string> notes;
  return object::shape_of(relief_of(pixels, "jar.png").model, "jar.png", notes);
}

/// Does the shape, seen from in front, cover a place? In pixels of the picture, whose thing begins
/// at `left` and ends at `bottom`.
struct Seen {
  explicit Seen(const Shape& of, double pixels_high) : shape(of), scale(pixels_high) {}
  bool covers(double x, double y) const {
    for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
      const Vec3 a = corner(shape, k), b = corner(shape, k + 1), c = corner(shape, k + 2);
      const auto side = [&](Vec3 p, Vec3 q) {
        return (q.x - p.x) * scale * (y - p.y * scale) - (q.y - p.y) * scale * (x - p.x * scale);
      };
      if (side(a, b) >= 0 && side(b, c) >= 0 && side(c, a) >= 0) return true;
    }
    return false;
  }
  const Shape& shape;
  double scale;
};

/// Pixels of the picture where the relief is, and its thing is not, or the other way round: but
/// for those beside the outline, where either may be.
int wrong_pixels(const Pixels& pixels) {
  const CutOut cut = cut_out(pixels, "jar.png");
  const Shape shape = shape_of(pixels);
  // The lowest and leftmost pixels of the thing are where the mask has them.
  const Seen seen(shape, cut.mask.height);
  int left = 1000, bottom = 0;
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 400; ++x)
      if (is_jar(x + 0.5, y + 0.5)) {
        left = std::min(left, x);
        bottom = std::max(bottom, y);
      }
  constexpr int border = 3;
  int wrong = 0;
  for (int y = 2; y < 498; y += 3)
    for (int x = 2; x < 398; x += 3) {
      const bool is_thing = is_jar(x + 0.5, y + 0.5);
      bool is_inner = true;  // within a pixel all is the same
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) is_inner &= is_jar(x + dx + 0.5, y + dy + 0.5) == is_thing;
      if (is_inner && seen.covers(x - left + border + 0.5, bottom - y + border + 0.5) != is_thing)
        ++wrong;
    }
  return wrong;
}

TEST(Relief, HasTheOutlineOfAPictureWithAClearGround) {
  EXPECT_EQ(wrong_pixels(clear_jar()), 0);
}

TEST(Relief, HasTheOutlineOfAPhotographBeforeAWall) {
  EXPECT_EQ(wrong_pixels(jar_on_wall()), 0);
}

TEST(Relief, IsClosedAndLooksOutwards) {
  for (const Pixels& pixels : {clear_jar(), jar_on_wall()}) {
    const Shape shape = shape_of(pixels);

    EXPECT_TRUE(is_closed(shape));
    EXPECT_GT(volume_of(shape), 0);
  }
}

TEST(Relief, SwellsInItsMiddleAndIsThinAtItsRim) {
  const Shape shape = shape_of(clear_jar());
  float deepest = 0, at_lip = 0;
  for (const ShapeVertex& v : shape.vertices) {
    deepest = std::max(deepest, v.position.z);
    if (v.position.y > 0.96F) at_lip = std::max(at_lip, v.position.z);
  }

  EXPECT_GT(deepest, 0.05F);
  EXPECT_LT(deepest, 0.2F);
  EXPECT_LT(at_lip, 0.5F * deepest);
}

TEST(Relief, BearsItsPictureOnBothFacesWithoutItsGround) {
  const import::object::ObjectFile file = relief_of(jar_on_wall(), "jar.png");
  const Pixels& picture = file.model.images.front();

  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    ASSERT_LT(std::to_integer<int>(picture.rgba[i + 2]), 60) << "no pixel is of the wall";
    ASSERT_EQ(picture.rgba[i + 3], std::byte{255});
  }
}

TEST(Relief, IsMadeAsHighAsStaffSayWithinTheBudget) {
  const MadeObject it =
      make_object(relief_of(clear_jar(), "jar.png"), "jar.png", {.height = 0.5, .up = {}});
  ObjectDetail detail;
  ASSERT_TRUE(schema::decode(it.object.detail, detail));

  EXPECT_NEAR(it.object.size.y, 0.5, 1e-4);
  EXPECT_NEAR(it.object.size.x, 0.5 * 280 / 400, 0.02);
  EXPECT_LE(detail.mesh.triangles.size() / 3, ObjectDetail::most_triangles);
  EXPECT_LE(it.object.detail.size(), ExhibitObject::most_bytes);
}

TEST(Relief, OfSeveralPiecesIsTheLargestAndSaysSo) {
  const Pixels two = picture(200, 200, [](double x, double y) {
    const bool large = x > 20 && x < 120 && y > 20 && y < 180;
    const bool small = x > 150 && x < 170 && y > 20 && y < 60;
    return large || small ? red : clear;
  });
  const import::object::ObjectFile file = relief_of(two, "two.png");

  EXPECT_THAT(file.model.warnings, ::testing::ElementsAre(HasSubstr("it shows 2 pieces")));
  EXPECT_NEAR(file.model.images.front().width, 106, 1);
}

TEST(Relief, ThatTouchesTheEdgesOfItsPictureIsClosedThere) {
  const Pixels cut = picture(100, 100, [](double x, double y) {
    return x < 60 && y > 30 ? red : clear;  // left and below it goes on
  });

  EXPECT_TRUE(is_closed(shape_of(cut)));
}

struct Bad {
  const char* name;
  Pixels pixels;
  const char* told;
};
void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.name;
}

class BadPicture : public ::testing::TestWithParam<Bad> {};

TEST_P(BadPicture, IsRefusedWithASentence) {
  try {
    (void)relief_of(GetParam().pixels, "images/thing.png");
    ADD_FAILURE() << "it is no relief";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "busy-picture");
    EXPECT_EQ(error.file, "images/thing.png");
    EXPECT_THAT(error.what(), HasSubstr(GetParam().told));
    EXPECT_THAT(error.hint, HasSubstr("plain wall"));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Pictures, BadPicture,
    ::testing::Values(
        Bad{"a busy ground",
            picture(120, 90,
                    [](double x, double y) {
                      const int a = static_cast<int>(x * 7 + y * 13) % 200;
                      return Rgba{a, 255 - a, (a * 3) % 255, 255};
                    }),
            "its ground is busy"},
        Bad{"a thing that fills it",
            picture(80, 80, [](double x, double) { return x < 40 ? red : Rgba{20, 60, 130, 255}; }),
            "its ground is busy"},
        Bad{"nothing but a wall", picture(80, 80, [](double, double) { return wall; }),
            "nothing but its ground"},
        Bad{"nothing at all", picture(80, 80, [](double, double) { return clear; }),
            "nothing but its ground"},
        Bad{"a stamp", picture(8, 8, [](double, double) { return red; }), "8 x 8 pixels"}));

TEST(CutOut, KeepsTheColourOfWhatIsThin) {
  for (const bool is_clear : {true, false}) {
    const Pixels pixels = picture(200, 200, [&](double x, double y) {
      const Rgba blue{20, 60, 170, is_clear ? 240 : 255};  // drawn a little clear
      if (x > 50 && x < 150 && y > 100 && y < 180) return red;
      return std::abs(x - 100) < 2 && y > 20 && y <= 100 ? blue : is_clear ? clear : wall;
    });
    const CutOut cut = cut_out(pixels, "strand.png");
    const auto at = [&](std::size_t x, std::size_t y) {
      return std::to_integer<int>(cut.picture.rgba[4 * (y * cut.picture.width + x) + 2]);
    };

    EXPECT_EQ(at(cut.picture.width / 2, 30), 170) << "half way up the strand it is blue";
    EXPECT_EQ(at(10, cut.picture.height - 10), 30) << "and the foot is red";
    EXPECT_EQ(at(10, 10), 170) << "what is beside the strand is as it is";
  }
}

TEST(CutOut, KeepsLargeHolesAndFillsSpecks) {
  const Pixels pixels = picture(200, 200, [](double x, double y) {
    const double r = std::hypot(x - 100, y - 100);
    const bool speck = std::hypot(x - 160, y - 100) < 2;
    return r < 80 && r > 20 && !speck ? red : clear;
  });
  const auto rings = trace(cut_out(pixels, "disc.png").mask, 0.4);

  ASSERT_EQ(rings.size(), 2U);
  for (const Vec2 p : rings[1]) EXPECT_NEAR(glm::distance(p, Vec2{83, 83}), 20, 0.8);
  for (const Vec2 p : rings[0]) EXPECT_NEAR(glm::distance(p, Vec2{83, 83}), 80, 0.8);
  EXPECT_LT(rings[0].size(), 100U) << "as few corners as the tolerance allows";
}

}  // namespace
}  // namespace docent::object::relief_test

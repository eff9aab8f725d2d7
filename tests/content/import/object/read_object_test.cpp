#include "content/import/object/read_object.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <string>

#include "content/content_error.h"
#include "platform/image/image.h"

namespace docent::import::object::read_object_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const gltf::Primitive& only_primitive(const ObjectFile& file) {
  EXPECT_EQ(file.model.meshes.size(), 1U);
  EXPECT_EQ(file.model.meshes[0].primitives.size(), 1U);
  return file.model.meshes[0].primitives[0];
}

ObjectFile read(const std::string& bytes, const std::string& name,
                const gltf::ReadBeside& beside = {}) {
  return parse_object(bytes, name, beside);
}

content::ContentError refusal_of(const std::string& bytes, const std::string& name) {
  try {
    read(bytes, name);
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "unreadable-model");
    EXPECT_EQ(error.file, name);
    return error;
  }
  ADD_FAILURE() << name << " was taken";
  return {"", 0, 0, "", ""};
}

std::string word(std::uint32_t value) {
  std::string bytes;
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
  return bytes;
}
std::string number(float value) {
  return word(std::bit_cast<std::uint32_t>(value));
}

/// A binary STL file of so many triangles, side by side, whose header says another number.
std::string stl(std::uint32_t stated, std::uint32_t there) {
  std::string bytes = "solid " + std::string(74, ' ') + word(stated);
  for (std::uint32_t i = 0; i < there; ++i) {
    for (int n = 0; n < 3; ++n) bytes += number(0);
    for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}})
      bytes += number(x + static_cast<float>(i)) + number(y) + number(0);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST(ReadObject, OfWavefrontHasItsFacesAndPicture) {
  const Pixels red{2, 2, std::vector<std::byte>(16, std::byte{255})};
  const std::vector<std::byte> png = image::encode_png(red).value();
  const auto beside = [&](const std::string& name) -> std::optional<std::string> {
    if (name == "vase.mtl") return "newmtl glaze\nKd 0.5 0.5 0.5\nmap_Kd -s 1 1 1 a picture.png\n";
    if (name == "a picture.png")
      return std::string(reinterpret_cast<const char*>(png.data()), png.size());
    return std::nullopt;
  };
  const ObjectFile file = read(
      "mtllib vase.mtl\nusemtl glaze\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n",
      "vase.obj", beside);

  EXPECT_THAT(only_primitive(file).indices, ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_EQ(only_primitive(file).uv[0], glm::vec2(0, 1));
  EXPECT_EQ(file.model.materials[0].image, 0);
  EXPECT_EQ(file.model.images[0].width, 2U);
  EXPECT_FALSE(file.is_in_metres);
  EXPECT_THAT(file.model.warnings, IsEmpty());
}

TEST(ReadObject, CountsFromTheEndWhereAnIndexIsNegative) {
  const ObjectFile file = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n", "a.obj");

  EXPECT_EQ(only_primitive(file).position[1], Vec3(1, 0, 0));
}

TEST(ReadObject, TellsTheLinesOfWavefrontThatAreWrong) {
  const ObjectFile file = read(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv x 0 0\nf 1 2 3\nf 1 2 99\nf 1 0 2\nf 1 4 2\nf 1\n", "a.obj");

  EXPECT_EQ(only_primitive(file).indices.size(), 3U);
  EXPECT_THAT(file.model.warnings, Contains(HasSubstr("line 4: a vertex")));
  EXPECT_THAT(file.model.warnings, Contains(HasSubstr("line 6: a face names a vertex")));
  EXPECT_THAT(file.model.warnings, Contains(HasSubstr("(3 times in all)")));
  EXPECT_THAT(file.model.warnings, Contains(HasSubstr("line 9: a face has less than three")));
}

TEST(ReadObject, OpensNothingOutsideOfItsFolder) {
  bool asked = false;
  const ObjectFile file = read("mtllib ../../etc/passwd\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                               "a.obj", [&](const std::string&) -> std::optional<std::string> {
                                 asked = true;
                                 return std::nullopt;
                               });

  EXPECT_FALSE(asked);
  EXPECT_THAT(file.model.warnings, Contains(HasSubstr("not in the model's own folder")));
}

TEST(ReadObject, OfPlyIsTheSameInTextAndInBothOrdersOfBytes) {
  const std::string head =
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  std::string little = "ply\nformat binary_little_endian 1.0\n" + head;
  for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}})
    little += number(x) + number(y) + number(0) + std::string("\xFF\0\0", 3);
  little += "\4" + word(0) + word(1) + word(2) + word(3);
  std::string big = "ply\nformat binary_big_endian 1.0\n" + head;
  const auto turned = [](std::string bytes) { return std::string(bytes.rbegin(), bytes.rend()); };
  for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}})
    big += turned(number(x)) + turned(number(y)) + number(0) + std::string("\xFF\0\0", 3);
  big += "\4" + turned(word(0)) + turned(word(1)) + turned(word(2)) + turned(word(3));

  const std::string text =
      "ply\nformat ascii 1.0\n" + head +
      "0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0 255 0 0\n0 1 0 255 0 0\n4 0 1 2 3\n";
  for (const std::string& bytes : {text, little, big}) {
    const ObjectFile file = read(bytes, "a.ply");
    EXPECT_THAT(only_primitive(file).indices, ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_EQ(only_primitive(file).position[2], Vec3(1, 1, 0));
    EXPECT_EQ(only_primitive(file).colour[0], Vec4(1, 0, 0, 1));
  }
}

TEST(ReadObject, OfPlyThatClaimsMoreThanItHoldsIsRefused) {
  const content::ContentError error = refusal_of(
      "ply\nformat ascii 1.0\nelement vertex 400000000\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n0 0 0\n",
      "a.ply");

  EXPECT_THAT(error.what(), HasSubstr("400000000 of vertex"));
  EXPECT_EQ(error.line, 3U);
}

TEST(ReadObject, OfPlyWithVerticesTwiceIsRefusedWithItsLine) {
  const auto error = refusal_of(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "end_header\n0 0 0\n1 1 1 9 9 9\n",
      "a.ply");
  EXPECT_THAT(error.what(), HasSubstr("vertices twice"));
  EXPECT_EQ(error.line, 7U);
}

TEST(ReadObject, OfPlyLeavesOutAFaceWithoutItsVertex) {
  const ObjectFile file = read(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_index\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 -7\n",
      "a.ply");

  EXPECT_EQ(only_primitive(file).indices.size(), 3U);
  EXPECT_THAT(file.model.warnings, Contains(HasSubstr("line 14: a face names a vertex")));
}

TEST(ReadObject, OfStlThatBeginsWithSolidAndIsBinaryIsJoinedAtItsCorners) {
  const ObjectFile file = read(stl(3, 3), "a.stl");

  EXPECT_EQ(only_primitive(file).indices.size(), 9U);
  EXPECT_EQ(only_primitive(file).position.size(), 7U);
  EXPECT_EQ(file.up, UpAxis::Z);
  EXPECT_THAT(file.model.warnings, IsEmpty());
}

TEST(ReadObject, OfStlThatLiesAboutItsCountKeepsWhatIsThere) {
  std::string bytes = stl(1'000'000, 3);
  bytes[0] = 'b';
  const ObjectFile file = read(bytes, "a.stl");

  EXPECT_EQ(only_primitive(file).indices.size(), 9U);
  EXPECT_THAT(file.model.warnings, Contains(HasSubstr("1000000 triangles, and holds 3")));
}

TEST(ReadObject, OfStlInTextHasItsTriangles) {
  const ObjectFile file = read(
      "solid a\r\nfacet normal 0 0 1\r\nouter loop\r\nvertex 0 0 0\r\nvertex 1 0 0\r\n"
      "vertex 0 1e0 0\r\nendloop\r\nendfacet\r\nendsolid a\r\n",
      "a.stl");

  EXPECT_EQ(only_primitive(file).indices.size(), 3U);
}

TEST(ReadObject, WithKtx2PicturesIsRefusedByTheirName) {
  const content::ContentError error = refusal_of(
      R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_texture_basisu"]})", "a.gltf");

  EXPECT_THAT(error.what(), HasSubstr("extensionsRequired[0] is KHR_texture_basisu"));
  EXPECT_THAT(error.what(), HasSubstr("KTX2"));
}

TEST(ReadObject, ThatIsNoneIsRefusedWithASentence) {
  EXPECT_THAT(refusal_of("", "a.glb").what(), HasSubstr("empty"));
  EXPECT_THAT(refusal_of("hello", "a.txt").what(),
              HasSubstr("neither glTF, GLB, OBJ, PLY nor STL"));
  EXPECT_THAT(refusal_of("v 0 0 0\n", "a.obj").what(), HasSubstr("no triangle"));
  EXPECT_THAT(refusal_of("ply\nformat ascii 1.0\n", "a.ply").what(), HasSubstr("cut short"));
  EXPECT_THAT(refusal_of("glTF", "a.glb").what(), HasSubstr("cut short"));
}

}  // namespace
}  // namespace docent::import::object::read_object_test

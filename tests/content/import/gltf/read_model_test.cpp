#include "content/import/gltf/read_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "content/content_error.h"
#include "tests/content/character/made_character.h"

namespace docent::import::gltf::read_model_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string refusal(std::string_view bytes, const ReadBeside& beside = {}) {
  try {
    parse_model(bytes, "it.gltf", beside);
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "unreadable-model");
    return error.what();
  }
  return {};
}

/// A text file with one triangle whose parts can be replaced.
std::string triangle(const std::string& part = "", const std::string& by = "") {
  std::string text = R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  if (const std::size_t at = text.find(part); !part.empty() && at != std::string::npos)
    text.replace(at, part.size(), by);
  return text;
}

TEST(ReadModel, ReadsATriangle) {
  const Model model = parse_model(triangle(), "it.gltf", {});

  ASSERT_EQ(model.meshes.size(), 1U);
  const Primitive& primitive = model.meshes[0].primitives[0];
  EXPECT_THAT(primitive.position, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
  EXPECT_THAT(primitive.indices, ElementsAre(0U, 1U, 2U));
  EXPECT_TRUE(model.warnings.empty());
}

TEST(ReadModel, NamesThePartThatIsWrong) {
  EXPECT_THAT(refusal(triangle("\"count\":3", "\"count\":4")), HasSubstr("accessors[0] claims 4"));
  EXPECT_THAT(refusal(triangle("\"count\":3", "\"count\":1e300")), HasSubstr("accessors[0].count"));
  EXPECT_THAT(refusal(triangle("\"count\":3", "\"count\":-3")), HasSubstr("accessors[0].count"));
  EXPECT_THAT(refusal(triangle("5126", "5127")), HasSubstr("accessors[0].componentType"));
  EXPECT_THAT(refusal(triangle("VEC3", "VEC9")), HasSubstr("accessors[0].type"));
  EXPECT_THAT(refusal(triangle("\"buffer\":0", "\"buffer\":1")), HasSubstr("buffer 1"));
  EXPECT_THAT(refusal(triangle("\"mesh\":0", "\"mesh\":3")), HasSubstr("nodes[0].mesh"));
  EXPECT_THAT(refusal(triangle("\"mesh\":0", "\"children\":[0]")), HasSubstr("ring"));
  EXPECT_THAT(refusal(triangle("gD8", "gH8")), HasSubstr("not finite"));  // infinite
  EXPECT_THAT(refusal(triangle("AAAA\"", "AAA!\"")), HasSubstr("buffers[0].uri"));
  EXPECT_THAT(refusal(triangle("\"asset\"", "\"extensionsRequired\":[\"X_y\"],\"asset\"")),
              HasSubstr("extensionsRequired[0] is X_y"));
}

TEST(ReadModel, OpensNothingOutsideItsFolder) {
  std::vector<std::string> asked;
  const ReadBeside beside = [&](const std::string& name) -> std::optional<std::string> {
    asked.push_back(name);
    return {};
  };
  const auto with_uri = [&](const std::string& uri) {
    std::string text = triangle();
    const std::size_t at = text.find("data:"), end = text.find('"', at);
    return refusal(text.replace(at, end - at, uri), beside);
  };

  for (const char* uri : {"/etc/passwd", "../secret.bin", "a/../../b.bin", "file:///x", "..\\\\b",
                          "%2e%2e/secret.bin", "https://example.org/b.bin"})
    EXPECT_THAT(with_uri(uri), HasSubstr("not in the model's own folder")) << uri;
  EXPECT_TRUE(asked.empty());
  EXPECT_THAT(with_uri("parts/b%20c.bin"), HasSubstr("which is not there"));
  EXPECT_THAT(asked, ElementsAre("parts/b c.bin"));
}

TEST(ReadModel, TakesNoMemoryOnAFilesWord) {
  EXPECT_THAT(refusal(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":
      [{"attributes":{"POSITION":0}}]}],"accessors":[{"componentType":5126,"count":3999999,
      "type":"VEC3"}]})"),
              HasSubstr("has no bufferView"));
  EXPECT_THAT(refusal("{\"asset\":" + std::string(100'000, '[')), HasSubstr("JSON"));
  EXPECT_THAT(refusal("{\"asset\":" + std::string(100'000, '[') + std::string(100'000, ']') + "}"),
              HasSubstr("nested too deeply"));
}

TEST(ReadModel, IsRefusedWhereverItIsCutShort) {
  const std::string glb = test::make_glb({});

  for (std::size_t size = 0; size < glb.size(); size += size < 200 ? 1 : 97)
    EXPECT_NE(refusal(std::string_view(glb).substr(0, size)), "") << size;
}

TEST(ReadModel, SurvivesEveryByteBeingAnother) {
  const std::string glb = test::make_glb({.is_vrm1 = true});

  for (std::size_t at = 0; at < glb.size(); at += 3) {
    std::string other = glb;
    other[at] = static_cast<char>(other[at] ^ 0x5A);
    refusal(other);
  }
}

}  // namespace
}  // namespace docent::import::gltf::read_model_test

#include "runtime/schema/object_blob.h"

#include <gtest/gtest.h>

namespace docent::schema::object_blob_test {
namespace {

ObjectDetail two_triangles() {
  ObjectDetail detail;
  detail.mesh.vertices.resize(4);
  detail.mesh.vertices[1].position = {65535, 1, 256};
  detail.mesh.vertices[1].normal = {-127, 5};
  detail.mesh.vertices[2].colour = {1, 2, 3};
  detail.mesh.vertices[3].uv = {7, 65535};
  detail.mesh.triangles = {0, 1, 2, 0, 2, 3};
  detail.parts = {{.first_index = 0, .index_count = 3, .picture = -1, .wrap = {}},
                  {.first_index = 3,
                   .index_count = 3,
                   .picture = 0,
                   .wrap = {ObjectWrap::Clamp, ObjectWrap::Mirror}}};
  detail.pictures = {{std::byte{9}, std::byte{8}, std::byte{7}}};
  detail.uv_low = {-0.5F, 2};
  detail.uv_size = {3, 4};
  return detail;
}

TEST(ObjectBlob, ComesBackAsItWas) {
  const ObjectDetail detail = two_triangles();
  ObjectDetail back;

  ASSERT_TRUE(decode(encode(detail), back));
  EXPECT_EQ(back.mesh.vertices[1].position, detail.mesh.vertices[1].position);
  EXPECT_EQ(back.mesh.vertices[1].normal, detail.mesh.vertices[1].normal);
  EXPECT_EQ(back.mesh.vertices[2].colour, detail.mesh.vertices[2].colour);
  EXPECT_EQ(back.mesh.vertices[3].uv, detail.mesh.vertices[3].uv);
  EXPECT_EQ(back.mesh.triangles, detail.mesh.triangles);
  EXPECT_EQ(back.parts[1].wrap, detail.parts[1].wrap);
  EXPECT_EQ(back.pictures, detail.pictures);
  EXPECT_EQ(back.uv_low, detail.uv_low);
  EXPECT_EQ(back.uv_size, detail.uv_size);
  EXPECT_EQ(encode(back), encode(detail));
}

TEST(ObjectBlob, CutShortAnywhereIsRefused) {
  const std::vector<std::byte> bytes = encode(two_triangles());
  ObjectDetail detail;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(decode(std::span(bytes).first(size), detail)) << size;
}

TEST(ObjectBlob, ThatBreaksItsPromisesIsRefused) {
  const auto is_refused = [](const auto& change) {
    ObjectDetail detail = two_triangles();
    change(detail);
    ObjectDetail back;
    return !decode(encode(detail), back);
  };

  EXPECT_TRUE(is_refused([](ObjectDetail& d) { d.mesh.triangles[2] = 4; }));
  EXPECT_TRUE(is_refused([](ObjectDetail& d) { d.parts[1].first_index = 2; }));
  EXPECT_TRUE(is_refused([](ObjectDetail& d) { d.parts.pop_back(); }));
  EXPECT_TRUE(is_refused([](ObjectDetail& d) { d.parts[1].picture = 1; }));
  EXPECT_TRUE(is_refused([](ObjectDetail& d) { d.parts[1].wrap[0] = ObjectWrap{3}; }));
  EXPECT_TRUE(is_refused([](ObjectDetail& d) { d.uv_size.x = 1.0F / 0.0F; }));
  EXPECT_TRUE(is_refused([](ObjectDetail& d) {
    d.mesh.triangles.assign(3 * ObjectDetail::most_triangles + 3, 0);
    d.parts = {{.first_index = 0,
                .index_count = 3 * ObjectDetail::most_triangles + 3,
                .picture = -1,
                .wrap = {}}};
  }));
}

}  // namespace
}  // namespace docent::schema::object_blob_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "content/content_error.h"
#include "content/object/make_object.h"
#include "platform/image/image.h"
#include "runtime/schema/object_blob.h"
#include "tests/content/object/silhouette.h"
#include "tests/content/object/varied_objects.h"
#include "tests/support/reference_data.h"
#include "tests/support/sanitized.h"

/// The objects of ../shared/models: measured one by one.
namespace docent::object::reference_objects_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> models_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    for (const char* kind : {".glb", ".gltf", ".vrm", ".obj", ".ply", ".stl"})
      if (entry.path().extension() == kind) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// The object as it is drawn from nearby.
Shape drawn(const ExhibitObject& object, const ObjectDetail& detail) {
  Shape shape;
  for (const ObjectVertex& v : detail.mesh.vertices) {
    ShapeVertex& it = shape.vertices.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      const float share = static_cast<float>(v.position[at]) / 65535;
      it.position[axis] = object.size[axis] * (share - (axis == 1 ? 0.0F : 0.5F));
    }
  }
  shape.indices.assign(detail.mesh.triangles.begin(), detail.mesh.triangles.end());
  return shape;
}

TEST(ReferenceObjects, AreMadeWithinTheirBudgetAndKeepTheirOutlines) {
  NEEDS_SPEED();
  NEEDS_REFERENCE_DATA("models/objects");
  const fs::path folder = test::reference_data() / "models" / "objects";
  for (const fs::path& file : models_below(folder)) {
    SCOPED_TRACE(file.string());
    const auto start = std::chrono::steady_clock::now();
    const import::object::ObjectFile source = import::object::read_object(file);
    const MadeObject made = make_object(source, file.string());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    ObjectDetail detail;
    ASSERT_TRUE(schema::decode(made.object.detail, detail));
    std::vector<std::string> notes;
    Shape shape = shape_of(source.model, file.string(), notes);
    stand_up(source, {}, shape, notes);
    // Where no triangle went, places differ by a 65,535th of the object.
    const bool is_simplified = made.triangles * 3 > detail.mesh.triangles.size();
    // Outlines take minutes under the sanitizers, and are the same there.
    const bool is_measured = is_simplified && !test::is_sanitized;
    const float error =
        is_measured ? test::silhouette_error(shape, drawn(made.object, detail), 4) : 0;

    EXPECT_LE(detail.mesh.triangles.size() / 3, ObjectDetail::most_triangles);
    EXPECT_LE(made.object.distant.triangles.size() / 3, ExhibitObject::most_distant_triangles);
    EXPECT_LE(made.object.detail.size(), ExhibitObject::most_bytes);
    EXPECT_TRUE(schema::is_whole(made.object.distant));
    EXPECT_LE(error, 1);
    for (const auto& picture : detail.pictures) EXPECT_TRUE(image::decode_image(picture));
    RecordProperty(
        fs::relative(file, folder).string(),
        fmt::format("{} of {} triangles, {} from afar, {} bytes, {:.2f} m high, {:.2f} s, "
                    "outline {:.2f} pixels",
                    detail.mesh.triangles.size() / 3, made.triangles,
                    made.object.distant.triangles.size() / 3, made.object.detail.size(),
                    made.object.size.y, took.count(), error));
  }
}

/// How many copies: few in the ordinary run, 200 in `.ci/objects`.
std::uint32_t copies() {
  const char* said = std::getenv("DOCENT_VARIED_OBJECTS");
  return said != nullptr ? static_cast<std::uint32_t>(std::strtoul(said, nullptr, 10)) : 12;
}

/// Within its budget, its outline kept within a pixel. Was it measured?
bool check_copy(const VariedObject& copy, const std::string& told) {
  const auto nothing_beside = [](const std::string&) { return std::optional<std::string>(); };
  const import::object::ObjectFile source =
      import::object::parse_object(copy.bytes, copy.name, nothing_beside);
  const MadeObject made = make_object(source, copy.name);
  ObjectDetail detail;
  EXPECT_TRUE(schema::decode(made.object.detail, detail));
  std::vector<std::string> notes;
  Shape shape = shape_of(source.model, copy.name, notes);
  stand_up(source, {}, shape, notes);
  const bool is_measured = made.triangles * 3 > detail.mesh.triangles.size() && !test::is_sanitized;
  const float error =
      is_measured ? test::silhouette_error(shape, drawn(made.object, detail), 2) : 0;
  EXPECT_LE(detail.mesh.triangles.size() / 3, ObjectDetail::most_triangles);
  EXPECT_LE(made.object.distant.triangles.size() / 3, ExhibitObject::most_distant_triangles);
  EXPECT_LE(made.object.detail.size(), ExhibitObject::most_bytes);
  EXPECT_TRUE(schema::is_whole(made.object.distant));
  EXPECT_GT(made.object.size.y, 0);
  EXPECT_LE(error, 1);
  std::cout << fmt::format("{}: {} of {} triangles, {} bytes, {:.2f} m high, outline {:.2f}\n",
                           told, detail.mesh.triangles.size() / 3, made.triangles,
                           made.object.detail.size(), made.object.size.y, error);
  return is_measured;
}

TEST(ReferenceObjects, AreMadeWithinTheirBudgetAsAStrangerWouldBringThem) {
  NEEDS_SPEED();
  NEEDS_REFERENCE_DATA("models/objects");
  const fs::path folder = test::reference_data() / "models" / "objects";
  const std::vector<fs::path> files = models_below(folder);
  std::vector<Shape> shapes;
  std::vector<std::string> notes;
  for (const fs::path& file : files)
    shapes.push_back(shape_of(import::object::read_object(file).model, file.string(), notes));
  ASSERT_GT(copies(), 0U) << "DOCENT_VARIED_OBJECTS is no number";
  std::uint32_t measured = 0;
  for (std::uint32_t i = 0; i < copies(); ++i) {
    const std::size_t of = i % files.size();
    const VariedObject copy = varied(shapes[of], shapes[(of + 1 + i / 7) % files.size()], i);
    const std::string told =
        fmt::format("{} {}: {}", i, fs::relative(files[of], folder).string(), copy.told);
    SCOPED_TRACE(told);

    try {
      measured += check_copy(copy, told) ? 1 : 0;
    } catch (const content::ContentError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  if (!test::is_sanitized) {
    EXPECT_GT(measured, 0U);
  }
}

TEST(ReferenceObjects, ThatAreBrokenAreASentence) {
  NEEDS_REFERENCE_DATA("models/broken");
  const fs::path folder = test::reference_data() / "models" / "broken";
  for (const fs::path& file : models_below(folder)) {
    SCOPED_TRACE(file.string());
    std::string said;
    try {
      const MadeObject made = make_object(import::object::read_object(file), file.string());
      ObjectDetail detail;
      EXPECT_TRUE(schema::decode(made.object.detail, detail));
      said = made.warnings.empty() ? "taken" : "taken: " + made.warnings.front();
      for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(std::isfinite(made.object.size[axis]));
    } catch (const content::ContentError& error) {
      EXPECT_EQ(error.code, "unreadable-model");
      EXPECT_EQ(error.file, file.string());
      said = error.what();
    }
    EXPECT_FALSE(said.empty());
    RecordProperty(fs::relative(file, folder).string(), said);
  }
}

}  // namespace
}  // namespace docent::object::reference_objects_test

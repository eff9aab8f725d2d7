// Exported walks, measured by the reference data's own program: see its head for what each figure
// is.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "runtime/model/geometry/vec2.h"
#include "tests/acceptance/run.h"
#include "tests/support/reference_data.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::walk_check_test {
namespace {

struct Shape {
  const char* name;
  std::vector<Vec2> path;
  double deviation_mean, deviation_max;  ///< Metres that are allowed.
};

std::vector<Vec2> curve(double end, Vec2 (*at)(double)) {
  std::vector<Vec2> path;
  for (int i = 0; i <= 600; ++i) path.push_back(at(end * i / 600));
  return path;
}

/// Bends of at least half a metre of radius, then corners, which a walker rounds.
std::vector<Shape> shapes() {
  constexpr double pi = std::numbers::pi;
  return {
      {"arc", curve(1.75, [](double t) { return Vec2{14 * std::sin(t), 6 - 6 * std::cos(t)}; }),
       0.01, 0.03},
      {"eight",
       curve(2 * pi, [](double u) { return Vec2{4.3 * std::sin(u), 2.75 * std::sin(2 * u)}; }),
       0.01, 0.03},
      {"s", curve(16, [](double x) { return Vec2{x, 1.5 * std::sin(x * pi / 4)}; }), 0.01, 0.03},
      {"straight", {{0, 0}, {12, 0}}, 0.01, 0.03},
      {"square", {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}}, 0.02, 0.1},
      {"zigzag", {{0, 0}, {3, 2}, {6, 0}, {9, 2}, {12, 0}}, 0.02, 0.1},
      {"jog", {{0, 0}, {4, 0}, {4.6, 0.8}, {9, 0.8}}, 0.02, 0.1},
  };
}

std::map<std::string, double> figures(const std::string& text) {
  std::map<std::string, double> out;
  std::istringstream in(text);
  std::string name;
  for (double value; in >> name >> value;) out[name] = value;
  return out;
}

/// Compiles a hall with the clips of a folder, walks all shapes in it and has them measured.
void check_walks(const std::filesystem::path& clips, const std::filesystem::path& reference) {
  const TemporaryFolder folder;
  const auto hall = folder.path() / "hall.geojson", database = folder.path() / "hall.db";
  write_file(hall, R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,9],[0,0]]]})");
  const Outcome compiled = run(
      program("docent-content"),
      {"compile", hall.string(), "--clips", clips.string(), "--quiet", "-o", database.string()});
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;

  for (const Shape& shape : shapes()) {
    std::ostringstream path;
    path << "x,y\n";
    for (const Vec2 p : shape.path) path << p.x << "," << p.y << "\n";
    const auto file = folder.path() / "path.csv", walk = folder.path() / "walk.bvh";
    write_file(file, path.str());
    const Outcome walked = run(program("docent-content"), {"walk", database.string(), "--path",
                                                           file.string(), "-o", walk.string()});
    ASSERT_EQ(walked.exit_code, 0) << walked.err;
    const Outcome measured =
        run("python3", {(reference_data() / "acceptance/walk_check.py").string(), walk.string(),
                        "--path", file.string(), "--reference", reference.string()});
    ASSERT_EQ(measured.exit_code, 0) << measured.err;

    auto of = figures(measured.out);
    EXPECT_GT(of.at("plants"), 10) << shape.name;
    EXPECT_LE(of.at("skate_cm_per_s"), 3) << shape.name;
    EXPECT_LE(of.at("drift_mm_p95"), 5) << shape.name;
    EXPECT_LE(of.at("snap_ratio"), 1) << shape.name;
    EXPECT_LE(of.at("deviation_mean"), shape.deviation_mean) << shape.name;
    EXPECT_LE(of.at("deviation_max"), shape.deviation_max) << shape.name;
    EXPECT_LE(of.at("end_gap"), 0.02) << shape.name;
  }
}

bool has_python() {
  return run("python3", {"--version"}).exit_code == 0;
}

TEST(WalkCheck, FindsTheShippedClipsWalkingAsTheyShould) {
  NEEDS_SPEED();
  NEEDS_REFERENCE_DATA("acceptance/walk_check.py");
  if (!has_python()) GTEST_SKIP() << "no python3";
  const auto clips = source_dir() / "content/clips";
  check_walks(clips, clips / "walk.bvh");
}

TEST(WalkCheck, FindsRecordedClipsWalkingAsTheyShould) {
  NEEDS_SPEED();
  NEEDS_REFERENCE_DATA("acceptance/walk_check.py");
  NEEDS_REFERENCE_DATA("mocap/cmu-walk");
  if (!has_python()) GTEST_SKIP() << "no python3";
  const auto clips = reference_data() / "mocap/cmu-walk";
  check_walks(clips, clips / "16_15-walk-forward.bvh");
}

}  // namespace
}  // namespace docent::test::walk_check_test

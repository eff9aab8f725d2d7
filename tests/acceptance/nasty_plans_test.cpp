#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/acceptance/run.h"
#include "tests/content/floor/plans.h"
#include "tests/support/reference_data.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::nasty_plans_test {
namespace {

using testing::HasSubstr;

std::string written(const Points& ring) {
  std::string text = "[";
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Vec2 p = ring[i % ring.size()];
    text += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", p.x, p.y);
  }
  return text + "]";
}

std::string geojson(const import::ImportedPlan& plan) {
  const import::ImportedPolygon& polygon = plan.polygons.front();
  std::string rings = written(polygon.outer.vertex);
  for (const import::ImportedRing& hole : polygon.holes) rings += ",\n" + written(hole.vertex);
  return R"({"type": "Polygon", "coordinates": [)" + rings + "]}";
}

std::size_t count_vertices(const import::ImportedPlan& plan) {
  std::size_t count = plan.polygons.front().outer.vertex.size();
  for (const import::ImportedRing& hole : plan.polygons.front().holes) count += hole.vertex.size();
  return count;
}

Outcome compile(const std::string& source, const std::filesystem::path& database,
                const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"compile",         source,        "-o",
                                     database.string(), "--no-motion", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(program("docent-content"), arguments);
}

/// What is reported of a malformed plan, by the beginning of its name.
struct Mending {
  const char* plan;
  const char* code;
};
constexpr std::array mendings = {
    Mending{"d03-", "warning[ring-runs-backwards]"},
    Mending{"d04-", "warning[repeated-corner]"},
    Mending{"d07-", "warning[spike]"},
    Mending{"d08-", "warning[hole-meets-wall]"},
    Mending{"d09-", "warning[hole-meets-wall]"},
    Mending{"d10-", "warning[holes-meet]"},
    Mending{"d11-", "warning[holes-meet]"},
    Mending{"d12-", "warning[holes-meet]"},
    Mending{"d13-", "warning[hole-without-effect]"},
    Mending{"d14-", "warning[hole-outside-floor]"},
    Mending{"d15-", "warning[hole-meets-wall]"},
    Mending{"d16-", "warning[ring-crosses-itself]"},
    Mending{"d18-", "warning[hole-meets-wall]"},
    Mending{"d19-", "warning[ring-without-area]"},
    Mending{"d20-", "warning[ring-without-area]"},
    Mending{"d27-", "error[not-in-metres]"},
    Mending{"d28-", "warning[hole-meets-wall]"},
    Mending{"d29-", "error[invalid-geojson]"},
    Mending{"d35-", "warning[holes-meet]"},
    Mending{"d36-", "error[no-floor]"},
};

TEST(NastyPlans, AreCompiledOrRefusedAsExpectedAndTheirMendingsReported) {
  NEEDS_REFERENCE_DATA("floorplans/nasty");
  const TemporaryFolder folder;
  for (const auto& file : plan_files("floorplans/nasty")) {
    const std::string name = file.stem().string();
    if (name == "d30-nan-coordinate") continue;  // Not even JSON; the reader's own tests have it.
    SCOPED_TRACE(name);
    const Polymap map = read_polymap(file);
    if (count_vertices(map.plan) > 1000) continue;  // The ways take time; mending's test has it.
    const auto source = folder.path() / (name + ".geojson");
    const auto database = folder.path() / (name + ".db");
    write_file(source, geojson(map.plan));

    const Outcome outcome = compile(source.string(), database);

    if (map.accept) {
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    if (map.must_fail) {
      EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    }
    EXPECT_EQ(std::filesystem::exists(database), outcome.exit_code == 0);
    const auto* const mending = std::ranges::find_if(
        mendings, [&name](const Mending& m) { return name.starts_with(m.plan); });
    if (mending == mendings.end())
      EXPECT_EQ(outcome.err, "");
    else
      EXPECT_THAT(outcome.err, HasSubstr(mending->code));
  }
}

TEST(RealPlans, CompileFromLongitudeAndLatitude) {
  NEEDS_REFERENCE_DATA("floorplans/native/sfomuseum");
  const TemporaryFolder folder;
  int compiled = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(reference_data() / "floorplans/native/sfomuseum")) {
    if (entry.path().extension() != ".geojson") continue;
    const Outcome outcome =
        compile(entry.path().string(), folder.path() / "sfo.db", {"--coordinates", "wgs84"});
    EXPECT_EQ(outcome.exit_code, 0) << entry.path() << outcome.err;
    ++compiled;
  }
  EXPECT_GE(compiled, 10);
}

TEST(RealPlans, CompileAndAreDrawn) {
  NEEDS_REFERENCE_DATA("floorplans/plans");
  const TemporaryFolder folder;
  for (const auto& file : plan_files("floorplans/plans")) {
    const Polymap map = read_polymap(file);
    if (count_vertices(map.plan) > 250) continue;  // Those take their time.
    SCOPED_TRACE(map.name);
    const auto source = folder.path() / "plan.geojson", database = folder.path() / "plan.db",
               picture = folder.path() / "plan.svg";
    write_file(source, geojson(map.plan));
    const Outcome compiled = compile(source.string(), database);
    ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
    const Outcome drawn_plan =
        run(program("docent-content"), {"show", database.string(), "-o", picture.string(),
                                        "--layers", "walls,skeleton,regions,clearance"});
    EXPECT_EQ(drawn_plan.exit_code, 0) << drawn_plan.err;
    EXPECT_THAT(read_file(picture), HasSubstr("medial axis"));
  }
}

}  // namespace
}  // namespace docent::test::nasty_plans_test

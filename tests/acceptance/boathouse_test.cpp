// A second museum, made of the plans that its architect sent: two drawings, and what staff wrote
// beside them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/acceptance/run.h"
#include "tests/support/reference_data.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::boathouse_test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class Boathouse : public testing::Test {
 protected:
  void SetUp() override {
    import();
    fs::copy(drawings() / "exhibits", museum() / "exhibits", fs::copy_options::recursive);
  }

  static fs::path drawings() { return source_dir() / "tests/acceptance/boathouse"; }
  fs::path museum() const { return folder_.path() / "boathouse"; }
  fs::path database() const { return folder_.path() / "boathouse.db"; }
  std::string text() const { return read_file(museum() / "museum.toml"); }

  Outcome import() const {
    return run(program("docent-content"),
               {"import", "--level", "0=" + (drawings() / "ground.dxf").string(), "--level",
                "1=" + (drawings() / "upper.dxf").string(), "-o", museum().string()});
  }
  Outcome compile() const {
    return run(program("docent-content"), {"compile", museum().string(), "-o", database().string(),
                                           "--no-motion", "--no-speech", "--quiet"});
  }
  nlohmann::json route(const std::string& exhibits) const {
    const Outcome told =
        run(program("docent-content"),
            {"route", database().string(), "--kind", "shortest", "--exhibits", exhibits, "--json"});
    return nlohmann::json::parse(told.out, nullptr, false);
  }

  /// Writes a line below the heading of the table that holds `words`.
  void write_into_table_of(const std::string& words, const std::string& line) const {
    std::string toml = text();
    const std::size_t at = toml.find(words);
    ASSERT_NE(at, std::string::npos) << toml;
    toml.insert(toml.find('\n', at) + 1, line + "\n");
    write_file(museum() / "museum.toml", toml);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Boathouse, IsCompiledFromTheDrawingsAndLeadsFromFloorToFloor) {
  const Outcome compiled = compile();
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;

  const nlohmann::json way = route("coxed-four,captains-letters");

  ASSERT_EQ(way["status"], "ok");
  EXPECT_EQ(way["floors"].size(), 2U);
  EXPECT_GT(way["length"].get<double>(), 30) << "round by the foyer and the stairs";
  EXPECT_EQ(route("harbour-map,captains-letters")["status"], "ok");
}

TEST_F(Boathouse, HasTheRoomsOfItsDrawingsByName) {
  for (const char* room :
       {"Boat hall", "Foyer", "Workshop", "Shop", "WC", "Gallery", "Reading room"})
    EXPECT_THAT(text(), HasSubstr("title.en = \"" + std::string(room) + "\""));
}

TEST_F(Boathouse, NamesTheDoubtfulDoorWithItsPlaceAndIsDecidedByOneLine) {
  const Outcome told = import();
  ASSERT_THAT(told.err, HasSubstr("doubtful-door"));
  ASSERT_THAT(told.err, HasSubstr("a gap of 1.80 m in the walls at (18.0, 8.9)"));
  ASSERT_THAT(told.err, HasSubstr("closed = true"));

  const std::size_t name = told.err.find("[[door]] ") + 9;
  write_into_table_of("name = \"" + told.err.substr(name, told.err.find('\n', name) - name) + "\"",
                      "closed = true");
  const Outcome compiled = compile();

  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  EXPECT_NE(route("harbour-map,captains-letters")["status"], "ok");
}

TEST_F(Boathouse, KeepsWhatStaffWroteWhenTheDrawingsComeAgain) {
  write_into_table_of("id = \"boat-hall\"", "closed = true");

  const Outcome told = import();

  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(text(), HasSubstr("id = \"boat-hall\"\nclosed = true"));
}

/// A real museum's drawing is not ours to ship: it is imported where it is at hand.
TEST(ImportedMuseum, OfARealDrawingIsCompiledWithExhibitsInItsHalls) {
  NEEDS_REFERENCE_DATA("floorplans/buildings/dxf/historical_museum.dxf");
  const TemporaryFolder folder;
  const fs::path museum = folder.path() / "museum", database = folder.path() / "museum.db";
  const fs::path drawing = reference_data() / "floorplans/buildings/dxf/historical_museum.dxf";
  ASSERT_EQ(
      run(program("docent-content"), {"import", drawing.string(), "-o", museum.string()}).exit_code,
      0);
  fs::create_directories(museum / "exhibits");
  write_file(
      museum / "exhibits/two.toml",
      "[[exhibit]]\nid = \"west\"\nposition = [35, 20]\nfacing = 270\ntitle.en = \"West\"\n"
      "[[exhibit]]\nid = \"east\"\nposition = [80, 14]\nfacing = 180\ntitle.en = \"East\"\n");

  const Outcome compiled =
      run(program("docent-content"), {"compile", museum.string(), "-o", database.string(),
                                      "--no-motion", "--no-speech", "--quiet"});
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  const Outcome told =
      run(program("docent-content"),
          {"route", database.string(), "--kind", "shortest", "--exhibits", "west,east", "--json"});

  EXPECT_EQ(nlohmann::json::parse(told.out, nullptr, false)["status"], "ok");
}

}  // namespace
}  // namespace docent::test::boathouse_test

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "platform/sqlite/content_reader.h"
#include "runtime/path/route.h"
#include "tests/support/kiosk_run.h"
#include "tests/support/sanitized.h"
#include "tests/support/started_program.h"

namespace docent::kiosk::kiosk_test {
namespace {

using testing::HasSubstr;

/// A row of states.csv.
struct State {
  int avatar = 0;
  double time = 0, x = 0, y = 0, heading = 0;
  std::string doing;
};

std::vector<State> read_states(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "time,avatar,x,y,heading,state");
  std::vector<State> states;
  while (std::getline(stream, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    State state;
    words >> state.time >> state.avatar >> state.x >> state.y >> state.heading >> state.doing;
    states.push_back(state);
  }
  return states;
}

/// Is every frame drawn and kept, or only where everybody is? That takes a tenth of the time.
enum class Pictures : std::uint8_t { None, All };

/// A run of docent without a screen: its visit, its states or its recording, its measurements.
class PlayedVisit {
 public:
  explicit PlayedVisit(const std::string& visit, const std::string& device = "# a new device\n",
                       Pictures pictures = Pictures::None, const std::string& size = "160x90") {
    std::ofstream(path("v.visit")) << visit;
    std::ofstream(path("kiosk.toml")) << device;
    ended_ = test::run_program(
        "docent",
        "--display headless --size " + size + " --config '" + path("kiosk.toml") + "' --content '" +
            test::sample_database().string() + "' --visit '" + path("v.visit") + "' --stats '" +
            path("stats.json") + "' --states '" + path("states.csv") + "'" +
            (pictures == Pictures::All ? " --record '" + path("record") + "'" : std::string()));
  }
  const test::ProgramRun& ended() const { return ended_; }
  std::string path(const char* name) const { return (folder_.path() / name).string(); }
  std::vector<State> states() const { return read_states(path("states.csv")); }
  std::string stats() const { return test::text_of(path("stats.json")); }

 private:
  test::TemporaryFolder folder_;
  test::ProgramRun ended_;
};

/// No step or turn that a body could not make in a sixtieth of a second.
void expect_no_jump(const std::vector<State>& states) {
  constexpr double longest_step = 0.05, widest_turn = 12;  // metres, degrees
  for (std::size_t i = 1; i < states.size(); ++i) {
    const State &a = states[i - 1], &b = states[i];
    ASSERT_LE(std::hypot(b.x - a.x, b.y - a.y), longest_step) << "at " << b.time << " s";
    ASSERT_LE(std::abs(std::remainder(b.heading - a.heading, 360)), widest_turn)
        << "at " << b.time << " s";
  }
}

void expect_clear_of_walls(const std::vector<State>& states, const Museum& museum) {
  const auto map = path::make_floor_map(museum.floors[museum.kiosk_floor]);
  for (const State& state : states)
    ASSERT_GE(path::clearance_at(*map, {state.x, state.y}), museum.body_radius - 0.01)
        << "at " << state.time << " s";
}

double distance_to(const State& state, Vec2 place) {
  return std::hypot(state.x - place.x, state.y - place.y);
}

const Exhibit& exhibit_of(const Museum& museum, std::string_view id) {
  return *std::ranges::find(museum.exhibits, id, &Exhibit::id);
}

/// Near the place from which one looks at the exhibit, but not in the way of whoever looks, showing
/// it or looking.
void expect_shown(const State& state, const Exhibit& exhibit) {
  EXPECT_LE(distance_to(state, exhibit.viewing_point.position), 1.1) << exhibit.id;
  EXPECT_GE(distance_to(state, exhibit.viewing_point.position), 0.5) << exhibit.id;
  EXPECT_THAT(state.doing, testing::AnyOf("look", "gesture")) << exhibit.id;
}

TEST(Visit, EndsBesideTheExhibitThatWasTouched) {
  const auto museum = sqlite::load_museum(test::sample_database());
  ASSERT_TRUE(museum.has_value());
  const Exhibit& exhibit = exhibit_of(*museum, "tripod-ding");

  const PlayedVisit run("1 tap @exhibit:tripod-ding\n50 quit\n", "# a new device\n", Pictures::All);

  ASSERT_EQ(run.ended().exit_code, 0) << run.ended().err;
  const std::vector<State> states = run.states();
  ASSERT_GT(states.size(), 2900U);
  EXPECT_LT(distance_to(states.front(), museum->kiosk.position), 0.05);
  EXPECT_EQ(states.front().doing, "idle");
  expect_shown(states.back(), exhibit);
  EXPECT_GT(std::ranges::count(states, "gesture", &State::doing), 180) << "it points";
  EXPECT_GT(std::ranges::count(states, "walk", &State::doing), 600);
  expect_clear_of_walls(states, *museum);
  expect_no_jump(states);
  EXPECT_TRUE(std::filesystem::exists(run.path("record/frame-000000.png")));
  EXPECT_THAT(run.stats(), HasSubstr("\"allocations_in_frames\": 0,"));
  EXPECT_THAT(run.stats(), HasSubstr("\"collisions\": 0,"));
  EXPECT_THAT(run.stats(), HasSubstr("\"routes\": 1,"));
}

TEST(Visit, TapsWhatLiesFurtherDownAListThatScrolls) {
  NEEDS_SPEED();
  const auto museum = sqlite::load_museum(test::sample_database());
  const PlayedVisit run("1 tap @larger\n2 tap @places\n4 tap @exhibit:standing-king\n40 quit\n",
                        "rotate = 90\n");

  ASSERT_EQ(run.ended().exit_code, 0) << run.ended().err;
  expect_shown(run.states().back(), exhibit_of(*museum, "standing-king"));
}

TEST(Visit, OfSeveralAtOnceEndsForEachBesideTheirExhibit) {
  NEEDS_SPEED();
  const auto museum = sqlite::load_museum(test::sample_database());
  const PlayedVisit run(
      "0.5 tap 0.06 0.9\n0.5 tap 0.5 0.9\n0.6 tap 0.94 0.9\n"
      "1 tap @look:rose seat 1\n1 tap @look:sky seat 5\n1 tap @look:plum seat 8\n"
      "2 tap @exhibit:tripod-ding seat 1\n2 tap @exhibit:painted-jar seat 5\n"
      "2 tap @exhibit:boundary-stone seat 8\n34 quit\n",
      // Pixels are not so coarse that letters, and with them cards, would be much larger.
      "screen_inches = 55\n", Pictures::None, "320x180");

  ASSERT_EQ(run.ended().exit_code, 0) << run.ended().err;
  std::map<int, std::vector<State>> tracks;
  for (const State& state : run.states()) tracks[state.avatar].push_back(state);
  ASSERT_EQ(tracks.size(), 8U);
  for (const auto& [guide, id] :
       {std::pair{5, "tripod-ding"}, {4, "painted-jar"}, {7, "boundary-stone"}}) {
    const std::vector<State>& track = tracks[guide];
    expect_no_jump(track);
    expect_shown(track.back(), exhibit_of(*museum, id));
  }
  EXPECT_EQ(tracks[0].back().doing, "idle");
  EXPECT_THAT(run.stats(), HasSubstr("\"allocations_in_frames\": 0,"));
  EXPECT_THAT(run.stats(), HasSubstr("\"collisions\": 0,"));
  EXPECT_THAT(run.stats(), HasSubstr("\"routes\": 3,"));
}

TEST(Visit, TurnsRoundWithoutAJumpWhenTheVisitorWantsSomethingElse) {
  const auto museum = sqlite::load_museum(test::sample_database());

  const PlayedVisit run(
      "0.5 tap @exhibit:tripod-ding\n"
      "5 tap @exhibit:coin-hoard\n"
      "9 tap @route:skeleton\n"
      "13 tap @route:offset\n"
      "17 tap @stop\n"
      "22 tap @home\n"
      "60 quit\n");

  ASSERT_EQ(run.ended().exit_code, 0) << run.ended().err;
  const std::vector<State> states = run.states();
  expect_no_jump(states);
  expect_clear_of_walls(states, *museum);
  EXPECT_LT(distance_to(states.back(), museum->kiosk.position), 0.3);
  EXPECT_THAT(run.stats(), HasSubstr("\"allocations_in_frames\": 0,"));
}

TEST(Visit, RepeatsExactly) {
  NEEDS_SPEED();
  const char* visit = "0.5 tap @exhibit:chime-bells\n3 tap @route:skeleton\n8 quit\n";

  const PlayedVisit once(visit, "# a new device\n", Pictures::All);
  const PlayedVisit again(visit, "# a new device\n", Pictures::All);

  EXPECT_EQ(test::text_of(once.path("states.csv")), test::text_of(again.path("states.csv")));
  EXPECT_EQ(test::text_of(once.path("states.csv")), test::text_of(once.path("record/states.csv")));
  EXPECT_EQ(test::text_of(once.path("record/frame-000200.png")),
            test::text_of(again.path("record/frame-000200.png")));
}

TEST(Visit, WithAnUnknownCommandIsNotBegun) {
  const PlayedVisit run("1 tap @home\n2 dance\n3 shout\n");

  EXPECT_EQ(run.ended().exit_code, 1);
  EXPECT_THAT(run.ended().err,
              HasSubstr(":2:3: error[unknown-command]: there is no command 'dance'"));
  EXPECT_THAT(run.ended().err, HasSubstr(":3:3: "));
  EXPECT_FALSE(std::filesystem::exists(run.path("states.csv")));
}

TEST(Visit, ToAnExhibitThatThereIsNotIsNotBegun) {
  const PlayedVisit run("1 tap @exhibit:mona-lisa\n");

  EXPECT_EQ(run.ended().exit_code, 1);
  EXPECT_THAT(run.ended().err,
              HasSubstr("no screen of this museum has a control '@exhibit:mona-lisa'"));
}

TEST(Docent, SaysWhatToDoAboutADatabaseThatIsMissing) {
  const auto run = test::run_program("docent", "--display headless --content /nowhere/museum.db");

  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("/nowhere/museum.db"));
  EXPECT_THAT(run.err, HasSubstr("docent-content compile"));
}

TEST(Docent, RefusesADatabaseThatIsCutShort) {
  const test::TemporaryFolder folder;
  const std::string cut = (folder.path() / "cut.db").string();
  const std::string whole = test::text_of(test::sample_database());
  std::ofstream(cut, std::ios::binary) << whole.substr(0, whole.size() / 2);

  const auto run = test::run_program("docent", "--display headless --content '" + cut + "'");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("cut.db"));
}

TEST(Docent, SaysWhichDisplayCannotBeOpened) {
  ::setenv("DISPLAY", ":99999", 1);  // no such server
  const auto run =
      test::run_program("docent", "--display window --content '" +
                                      test::sample_database().string() + "' --seconds 1");

  EXPECT_EQ(run.exit_code, 3);
  EXPECT_FALSE(run.err.empty());
}

TEST(Docent, SaysWhichSettingsFileIsNotThere) {
  const auto run = test::run_program("docent", "--display headless --config /nowhere/kiosk.toml");

  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("/nowhere/kiosk.toml"));
}

TEST(Docent, LeavesWithTwoWhereTheCommandLineIsWrong) {
  EXPECT_EQ(test::run_program("docent", "--sideways").exit_code, 2);
  EXPECT_EQ(test::run_program("docent", "--size big").exit_code, 2);
  EXPECT_EQ(test::run_program("docent", "hid").exit_code, 2);
  EXPECT_EQ(test::run_program("docent", "--help").exit_code, 0);
}

/// docent without a screen, until it is stopped. It records a picture of every second frame, by
/// which a test sees how far it is.
class RunningKiosk : public test::StartedProgram {
 public:
  explicit RunningKiosk(const test::TemporaryFolder& folder, const std::string& content)
      : StartedProgram(
            test::program("docent"),
            {"--display", "headless", "--size", "128x72", "--content", content, "--record",
             folder.path() / "record", "--stats", folder.path() / "stats.json"},
            folder.path() / "said"),
        folder_(folder) {}

  std::size_t pictures() const {
    while (std::filesystem::exists(picture(pictures_))) ++pictures_;
    return pictures_;
  }
  bool makes_another_picture() const {
    return runs_until([this, before = pictures()] { return pictures() > before; });
  }
  std::string said() const { return test::text_of(folder_.path() / "said"); }
  double frames() const {
    return test::number_in(test::text_of(folder_.path() / "stats.json"), "frames");
  }

 private:
  std::filesystem::path picture(std::size_t number) const {
    return folder_.path() / "record" / fmt::format("frame-{:06}.png", number);
  }

  const test::TemporaryFolder& folder_;
  mutable std::size_t pictures_ = 0;
};

TEST(Docent, EndsWithinASecondOfSigterm) {
  using namespace std::chrono_literals;
  const test::TemporaryFolder folder;
  RunningKiosk kiosk(folder, test::sample_database());
  ASSERT_TRUE(kiosk.makes_another_picture());
  ASSERT_TRUE(kiosk.halt());
  const std::size_t pictures = kiosk.pictures();
  const auto spent = kiosk.processor_time();

  kiosk.signal(SIGTERM);
  kiosk.signal(SIGCONT);

  EXPECT_EQ(kiosk.wait(), 0);
  EXPECT_LE(kiosk.frames(), static_cast<double>(2 * pictures + 1)) << "no further frame is begun";
  EXPECT_LT(kiosk.processor_time() - spent, 1s);
}

TEST(Docent, KeepsItsMuseumWhenTheNewDatabaseCannotBeRead) {
  const test::TemporaryFolder folder;
  const std::string content = folder.path() / "museum.db", broken = folder.path() / "broken.db";
  std::filesystem::copy_file(test::sample_database(), content);
  std::ofstream(broken) << "broken\n";
  RunningKiosk kiosk(folder, content);
  ASSERT_TRUE(kiosk.makes_another_picture());

  std::filesystem::rename(broken, content);
  kiosk.signal(SIGHUP);

  EXPECT_TRUE(kiosk.runs_until([&] { return kiosk.said().contains("museum.db"); }));
  EXPECT_TRUE(kiosk.makes_another_picture());
  kiosk.signal(SIGTERM);
  EXPECT_EQ(kiosk.wait(), 0);
}

TEST(Docent, SaysWhatItHasTakenUp) {
  const test::TemporaryFolder folder;
  RunningKiosk kiosk(folder, test::sample_database());
  ASSERT_TRUE(kiosk.makes_another_picture());
  EXPECT_EQ(kiosk.said(), "") << "a run without a screen is told by its statistics";

  kiosk.signal(SIGHUP);

  EXPECT_TRUE(kiosk.runs_until([&] { return kiosk.said().contains("languages"); }));
  EXPECT_THAT(kiosk.said(), AllOf(HasSubstr("docent: has taken up '"), HasSubstr("3 floors, ")));
  kiosk.signal(SIGTERM);
  EXPECT_EQ(kiosk.wait(), 0);
}

}  // namespace
}  // namespace docent::kiosk::kiosk_test

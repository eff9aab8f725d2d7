#include "runtime/kiosk/heat_watch.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/support/temporary_folder.h"

namespace docent::kiosk::heat_watch_test {
namespace {

using namespace std::chrono_literals;
using test::TemporaryFolder;

/// A folder as /sys/class/thermal is.
class Thermal {
 public:
  void zone(const std::string& name, long temperature, const std::string& type, long trip) const {
    const auto zone = path() / name;
    std::filesystem::create_directories(zone);
    std::ofstream(zone / "temp") << temperature << "\n";
    std::ofstream(zone / "trip_point_0_type") << "critical\n";
    std::ofstream(zone / "trip_point_0_temp") << "110000\n";
    std::ofstream(zone / "trip_point_1_type") << type << "\n";
    std::ofstream(zone / "trip_point_1_temp") << trip << "\n";
  }
  std::filesystem::path path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

/// A thread looks every millisecond: waits, for a minute at most, until it says so.
bool says(const HeatWatch& watch, bool too_hot) {
  for (int i = 0; i < 60000 && watch.is_too_hot() != too_hot; ++i) std::this_thread::sleep_for(1ms);
  return watch.is_too_hot() == too_hot;
}

TEST(ThermalZones, AreThoseWithAPassiveTrip) {
  const Thermal thermal;
  thermal.zone("thermal_zone0", 40000, "passive", 85000);
  thermal.zone("thermal_zone1", 90000, "hot", 85000);
  std::filesystem::create_directories(thermal.path() / "cooling_device0");
  const std::vector<ThermalZone> zones = read_thermal_zones(thermal.path());

  ASSERT_EQ(zones.size(), 1U);
  EXPECT_EQ(zones[0].temperature, 40000);
  EXPECT_EQ(zones[0].passive_trip, 85000);
  EXPECT_TRUE(read_thermal_zones(thermal.path() / "none").empty());
}

TEST(TooHot, LastsUntilItIsThreeDegreesCooler) {
  const auto at = [](long temperature, bool was) {
    const ThermalZone zones[]{{20000, 85000}, {temperature, 85000}};
    return is_too_hot(zones, was);
  };

  EXPECT_FALSE(at(84999, false));
  EXPECT_TRUE(at(85000, false));
  EXPECT_TRUE(at(82000, true));
  EXPECT_FALSE(at(81999, true));
  EXPECT_FALSE(is_too_hot({}, true));
}

TEST(HeatWatch, HalvesTheFramesFromWhenTheMachineIsTooHotUntilThatIsOver) {
  const Thermal thermal;
  thermal.zone("thermal_zone0", 40000, "passive", 85000);
  const HeatWatch watch(thermal.path(), 1ms);

  EXPECT_TRUE(says(watch, false));
  EXPECT_TRUE(watch.lets_show(6) && watch.lets_show(7));
  thermal.zone("thermal_zone0", 86000, "passive", 85000);
  EXPECT_TRUE(says(watch, true));
  EXPECT_TRUE(watch.lets_show(6) && !watch.lets_show(7) && watch.lets_show(8));
  thermal.zone("thermal_zone0", 60000, "passive", 85000);
  EXPECT_TRUE(says(watch, false));
}

}  // namespace
}  // namespace docent::kiosk::heat_watch_test

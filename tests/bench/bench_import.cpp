// How many rooms and doors are found in drawings of floors that are known: the reference data's
// plans, and made ones, drawn in many manners.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "content/content_error.h"
#include "content/import/building/museum_text.h"
#include "content/import/building/read_building.h"
#include "content/import/building/shape.h"
#include "tests/content/import/building/drawn_manners.h"
#include "tests/content/import/building/drawn_plan.h"
#include "tests/support/reference_data.h"

namespace docent::test {
namespace {

namespace fs = std::filesystem;

struct Plan {
  std::string name;
  import::ImportedLevel level;
};

/// Every level of the plans whose rooms are areas, not lines.
std::vector<Plan> reference_plans() {
  std::vector<Plan> plans;
  const fs::path root = reference_data() / "floorplans";
  for (const char* folder :
       {"native/building_xml", "native/osm", "buildings/ifc", "buildings/imdf"})
    for (const auto& entry : fs::directory_iterator(root / folder)) {
      if (entry.path().extension() == ".json" || entry.path().extension() == ".ifczip") continue;
      std::ifstream file(entry.path(), std::ios::binary);
      const import::BuildingSource source{
          entry.path().string(), std::string(std::istreambuf_iterator<char>(file), {}), ""};
      auto building = import::read_building({&source, 1}, {});
      if (!building) continue;
      for (import::ImportedLevel& level : building->levels)
        plans.push_back({entry.path().filename().string() + " " + level.name, std::move(level)});
    }
  std::ranges::sort(plans, {}, &Plan::name);
  return plans;
}

/// What a plan's facts say, as far as they say it.
struct Facts {
  struct Area {
    std::string name;
    double square_metres = 0;
  };
  std::vector<Area> areas;
  std::optional<std::size_t> levels, rooms, doors, connections;
};

using nlohmann::json;

void add(std::optional<std::size_t>& to, std::size_t count) {
  to = to.value_or(0) + count;
}

std::string text_of(const json& object, const char* key) {
  return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
}

/// Buildings' facts come in the words of their formats.
Facts facts_of(const fs::path& plan) {
  Facts facts;
  std::ifstream file(plan.string() + ".facts.json");
  const json all = json::parse(file, nullptr, false);
  if (!all.is_object()) return facts;
  const auto list = [&](const char* key) {
    return all.contains(key) && all[key].is_array() ? all[key] : json::array();
  };
  for (const json& space : list("spaces"))
    if (space.contains("area") && space["area"].is_object())
      facts.areas.push_back(
          {text_of(space, "name") + " " + text_of(space, "long_name"), space["area"]["m2"]});
  for (const json& storey : list("storeys")) {
    if (storey["spaces"] == 0) continue;
    add(facts.levels, 1);
    add(facts.rooms, storey["spaces"]);
    add(facts.doors, storey["elements"].value("door", 0U));
  }
  for (const json& area : list("named_areas"))
    for (std::size_t i = 0; i < area["levels"].size(); ++i)
      facts.areas.push_back({area["name"], area["area_m2"]});
  for (const json& level : list("levels")) {
    add(facts.levels, 1);
    add(facts.rooms, level["units"]);
    add(facts.doors, level["openings"]);
  }
  if (all.contains("levels") && all["levels"].is_object())
    for (const auto& [name, level] : all["levels"].items()) {
      if (name.starts_with("(")) continue;
      if (level.contains("areas")) {
        add(facts.levels, 1);
        add(facts.rooms, level["count"]);
        for (const json& room : level["areas"])
          facts.areas.push_back({room, all["areas_m2"][room.get<std::string>()]});
        continue;
      }
      const std::size_t rooms =
          level.value("room", 0U) + level.value("corridor", 0U) + level.value("area", 0U);
      if (rooms > 0) add(facts.levels, 1);
      add(facts.rooms, rooms);
    }
  if (all.contains("doors"))
    facts.doors =
        all["doors"].is_array() ? all["doors"].size() : all["doors"].value("total", std::size_t{0});
  if (all.contains("rooms_count")) facts.rooms = all["rooms_count"];
  if (all.contains("vertical")) facts.connections = all["vertical"].size();
  if (all.contains("vertical_pairs")) {
    facts.connections = 0;
    for (const auto& [kind, count] : all["vertical_pairs"].items()) add(facts.connections, count);
  }
  if (all.contains("elements")) {
    const std::size_t cells = all["elements"].value("CellSpace", std::size_t{0}) +
                              all["elements"].value("Room", std::size_t{0});
    if (cells > 0) facts.rooms = cells;
  }
  return facts;
}

/// How many of the known areas a room of that name has, to 5 %.
std::size_t areas_right(const Facts& facts, const import::ImportedBuilding& building) {
  std::vector<std::pair<std::string, double>> rooms;
  for (const import::ImportedLevel& level : building.levels)
    for (const import::ImportedRoom& room : level.rooms)
      rooms.emplace_back(room.name, room.stated_area.value_or(import::area_of(room)));
  std::size_t right = 0;
  for (const Facts::Area& area : facts.areas) {
    const auto same = std::ranges::find_if(rooms, [&](const auto& room) {
      const bool named = room.first == area.name || area.name == room.first + " " ||
                         (!room.first.empty() && area.name.ends_with(" " + room.first));
      return named && std::abs(room.second - area.square_metres) <= 0.05 * area.square_metres;
    });
    if (same == rooms.end()) continue;
    rooms.erase(same);
    ++right;
  }
  return right;
}

std::string beside(std::size_t found, std::optional<std::size_t> fact) {
  return fact ? fmt::format("{} of {}", found, *fact) : fmt::format("{}", found);
}

/// One row for each native plan: what was found, beside its facts.
void print_facts(const std::string& only) {
  fmt::print("{:48} {:>8} {:>11} {:>11} {:>11} {:>11} {:>7} {:>7}\n", "plan", "levels", "rooms",
             "areas +-5%", "doors", "connections", "doubts", "seconds");
  std::vector<fs::path> plans;
  const fs::path root = reference_data() / "floorplans";
  for (const char* folder :
       {"native/building_xml", "native/dxf", "native/indoorgml", "native/osm", "buildings/dirty",
        "buildings/dxf", "buildings/gml", "buildings/ifc", "buildings/imdf", "buildings/osm",
        "buildings/raster", "buildings/svg", "native/wrld", "native/houseexpo"})
    for (const auto& entry : fs::directory_iterator(root / folder))
      if (!entry.path().string().ends_with(".facts.json")) plans.push_back(entry.path());
  std::ranges::sort(plans);
  for (const fs::path& plan : plans) {
    if (plan.filename().string().find(only) == std::string::npos) continue;
    std::ifstream file(plan, std::ios::binary);
    const import::BuildingSource source{plan.filename().string(),
                                        std::string(std::istreambuf_iterator<char>(file), {}), ""};
    const auto begin = std::chrono::steady_clock::now();
    std::string refused;
    try {
      auto read = import::read_building({&source, 1}, {});
      if (read) {
        const Facts facts = facts_of(plan);
        const import::LaidBuilding laid = import::lay_out(std::move(*read));
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        std::size_t rooms = 0, doors = 0, levels = 0;
        for (const import::ImportedLevel& level : laid.building.levels) {
          rooms += level.rooms.size();
          doors += level.doors.size();
          levels += !level.rooms.empty();
        }
        fmt::print(
            "{:48} {:>8} {:>11} {:>11} {:>11} {:>11} {:>7} {:>7.2f}\n",
            plan.filename().string().substr(0, 48), beside(levels, facts.levels),
            beside(rooms, facts.rooms),
            facts.areas.empty() ? ""
                                : beside(areas_right(facts, laid.building), facts.areas.size()),
            beside(doors, facts.doors), beside(laid.building.connections.size(), facts.connections),
            laid.building.doubts.size(), seconds);
        continue;
      }
      refused = read.error().front().message;
    } catch (const content::ContentError& error) {
      refused = error.what();
    }
    fmt::print("{:48} refused: {}\n", plan.filename().string().substr(0, 48), refused);
  }
}

struct Options {
  std::string manner, plan, save;
  bool real = false, tell = false, facts = false;
  int seeds = 6;
};

void run(const Options& options) {
  std::vector<Plan> plans = options.real ? reference_plans() : std::vector<Plan>{};
  for (int seed = 1; seed <= options.seeds; ++seed) {
    plans.push_back({fmt::format("made {}", seed), random_level(static_cast<std::uint32_t>(seed))});
    plans.push_back(
        {fmt::format("curved {}", seed), curved_level(static_cast<std::uint32_t>(seed))});
  }
  std::erase_if(
      plans, [&](const Plan& plan) { return plan.name.find(options.plan) == std::string::npos; });
  for (const DrawnManner& each : drawn_manners()) {
    if (each.manner.name.find(options.manner) == std::string::npos) continue;
    FoundShare all;
    double worst = 2, slowest = 0;
    std::string worst_name, slowest_name;
    for (const Plan& plan : plans) {
      const KnownFloor floor = known_floor(plan.level, each.wall);
      if (floor.rooms.size() < 4) continue;
      const std::string text = draw_dxf({floor}, each.manner);
      if (!options.save.empty()) std::ofstream(options.save) << text;
      const auto begin = std::chrono::steady_clock::now();
      FoundShare share{.rooms = floor.rooms.size(), .doors = floor.doors.size()};
      try {
        const import::BuildingSource source{"drawn.dxf", text, ""};
        auto read = import::read_building({&source, 1}, {});
        if (!read)
          share.missed.push_back(read.error().front().message);
        else
          share = judge(floor, read->levels.front(), each.manner, read->moved_by.value_or(Vec2{}));
      } catch (const content::ContentError& error) {
        share.missed.emplace_back(error.what());
      }
      const double seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      if (seconds > slowest) {
        slowest = seconds;
        slowest_name = plan.name;
      }
      const double part = static_cast<double>(share.right) / static_cast<double>(share.rooms);
      if (part < worst) {
        worst = part;
        worst_name = plan.name;
      }
      if (options.tell) {
        fmt::print("  {:28} {:50} rooms {}/{} +{} doors {}/{} +{}\n", each.manner.name, plan.name,
                   share.right, share.rooms, share.extra, share.doors_right, share.doors,
                   share.doors_extra);
        for (std::size_t i = 0; i < std::min<std::size_t>(share.missed.size(), 8); ++i)
          fmt::print("      {}\n", share.missed[i]);
      }
      all += share;
    }
    fmt::print(
        "{:28} rooms {:5.1f} % of {:4} (+{:3}), doors {:5.1f} % of {:4} (+{:3}); worst {:5.1f} % "
        "{}; slowest {:.2f} s {}\n",
        each.manner.name, 100.0 * static_cast<double>(all.right) / static_cast<double>(all.rooms),
        all.rooms, all.extra,
        100.0 * static_cast<double>(all.doors_right) / static_cast<double>(all.doors), all.doors,
        all.doors_extra, 100 * worst, worst_name, slowest, slowest_name);
  }
}

}  // namespace
}  // namespace docent::test

int main(int argc, char** argv) {
  CLI::App app("How many rooms and doors are found in drawings of known floors");
  docent::test::Options options;
  app.add_option("--manner", options.manner, "Only manners with this in their name");
  app.add_option("--plan", options.plan, "Only plans with this in their name");
  app.add_option("--seeds", options.seeds, "How many made plans of each kind");
  app.add_option("--save", options.save, "Write the last drawing there");
  app.add_flag("--real", options.real, "The reference data's plans too");
  app.add_flag("--tell", options.tell, "Each plan, and what was missed");
  app.add_flag("--facts", options.facts, "The reference data's native plans, beside their facts");
  CLI11_PARSE(app, argc, argv);
  if (options.facts)
    docent::test::print_facts(options.plan);
  else
    docent::test::run(options);
}

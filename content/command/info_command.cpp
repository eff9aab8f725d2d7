#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/part_sizes.h"
#include "platform/signature/key.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/schema/schema.h"

namespace docent::command {

namespace {

using Json = nlohmann::ordered_json;

/// Sums something over all floors.
std::size_t count_on_floors(const Museum& museum, auto&& count) {
  std::size_t sum = 0;
  for (const Floor& floor : museum.floors) sum += count(floor);
  return sum;
}

/// Metres of medial axis on all floors.
double skeleton_length(const Museum& museum) {
  double length = 0;
  for (const Floor& floor : museum.floors)
    for (const RoadmapEdge& edge : floor.roadmap.edges) length += edge.length;
  return length;
}

/// {"walk, jog": 2.8}: how unlike the gaits of two classes are.
Json coefficients_between(const std::vector<MotionClass>& classes) {
  Json coefficients = Json::object();
  for (std::size_t i = 0; i < classes.size(); ++i)
    for (std::size_t j = i + 1; j < classes.size(); ++j)
      coefficients[classes[i].name + ", " + classes[j].name] = classes[i].coefficient[j];
  return coefficients;
}

/// Whose keys have signed it, as each signature says of itself; `verify` knows.
Json signers_of(const sqlite::Database& database) {
  Json signers = Json::array();
  for (const signature::Signature& each : database.signatures)
    signers.push_back(signature::name_of(each.key));
  return signers;
}

Json facts_about(const sqlite::Database& database, const Museum& museum) {
  Json facts;
  facts["schema_version"] = schema::version;
  facts["checksum"] = sqlite::checksum_text(database);
  facts["signed_with"] = signers_of(database);
  facts["kiosks"] = Json::array();
  for (const KioskPlace& kiosk : museum.kiosks) facts["kiosks"].push_back(kiosk.id);
  facts["floors"] = museum.floors.size();
  facts["exhibits"] = museum.exhibits.size();
  facts["exhibit_ids"] = Json::array();
  for (const Exhibit& exhibit : museum.exhibits) facts["exhibit_ids"].push_back(exhibit.id);
  facts["connections"] = museum.connections.size();
  facts["doors"] = count_on_floors(museum, [](const Floor& f) { return f.plan.doors.size(); });
  facts["places"] = museum.places.size();
  facts["place_kinds"] = Json::object();
  for (const Place& place : museum.places) {
    Json& count = facts["place_kinds"][std::string(info_of(place.kind).name)];
    count = count.is_null() ? 1 : count.get<int>() + 1;
  }
  facts["tours"] = museum.tours.size();
  facts["tour_ids"] = Json::array();
  for (const Tour& tour : museum.tours) facts["tour_ids"].push_back(tour.id);
  facts["languages"] = Json::array();
  for (const Language& language : museum.languages) facts["languages"].push_back(language.tag);
  facts["sites"] =
      count_on_floors(museum, [](const Floor& floor) { return floor.diagram.site.size(); });
  facts["voronoi_vertices"] =
      count_on_floors(museum, [](const Floor& floor) { return floor.diagram.vertex.size(); });
  facts["edges"] =
      count_on_floors(museum, [](const Floor& floor) { return floor.diagram.edge.size(); });
  facts["regions"] = count_on_floors(
      museum, [](const Floor& floor) { return floor.diagram.region_first.size() - 1; });
  facts["skeleton_length"] = skeleton_length(museum);
  std::size_t frames = 0;
  std::set<std::string> classes;
  for (const MotionClip& clip : museum.motion.clips) {
    frames += frame_count(clip);
    classes.insert(clip.motion_class);
  }
  facts["clips"] = museum.motion.clips.size();
  facts["frames"] = frames;
  facts["transitions"] = museum.motion.transitions.size();
  facts["motion_classes"] = classes;
  facts["class_coefficients"] = coefficients_between(museum.motion.classes);
  return facts;
}

Json sizes_of(const std::string& file) {
  const PartSizes sizes = part_sizes(file);
  Json parts;
  for (const auto& [part, bytes] : sizes.parts) parts[part] = bytes;
  parts["total"] = sizes.file;
  return parts;
}

/// "voronoi_vertices" as people read it.
std::string words_of(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

std::string line_of(const Json& value) {
  if (value.is_number_float()) return fmt::format("{:.2f} m", value.get<double>());
  if (value.is_object()) {
    std::vector<std::string> items;
    for (const auto& [key, number] : value.items())
      items.push_back(number.is_number_float() ? fmt::format("{} {:.2f}", key, number.get<double>())
                                               : fmt::format("{} {}", key, number.dump()));
    if (items.empty()) return "none";
    return fmt::format("{}", fmt::join(items, "; "));
  }
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  if (value.empty()) return "none";
  std::vector<std::string> items;
  for (const Json& item : value) items.push_back(item.get<std::string>());
  return fmt::format("{}", fmt::join(items, ", "));
}

void print_for_people(const Json& facts, const Json& sizes) {
  for (const auto& [key, value] : facts.items())
    fmt::print("{:<18} {}\n", words_of(key), line_of(value));
  fmt::print("bytes\n");
  for (const auto& [part, bytes] : sizes.items())
    fmt::print("  {:<16} {:>10}\n", words_of(part), bytes.get<std::uint64_t>());
}

int run_info(const std::string& file, bool json) {
  const sqlite::Database database = open_or_throw(file);
  Json facts = facts_about(database, read_or_throw(database, file));
  const Json sizes = sizes_of(file);
  if (json) {
    facts["bytes"] = sizes;
    fmt::print("{}\n", facts.dump());
  } else {
    print_for_people(facts, sizes);
  }
  return 0;
}

}  // namespace

terminal::Command info_command() {
  using terminal::Times;
  struct InfoOptions {
    std::string database;
    bool json = false;
  };
  const auto options = std::make_shared<InfoOptions>();
  return {.name = "info",
          .manual = "says what a database holds",
          .options = {{"DB", terminal::file("DB", options->database), "The museum's database",
                       Times::Once},
                      {"--json", terminal::flag(options->json), "Print it as JSON"}},
          .run = [options] { return run_info(options->database, options->json); }};
}

}  // namespace docent::command

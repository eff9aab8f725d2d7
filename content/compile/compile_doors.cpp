#include "content/compile/compile_doors.h"

#include <string>

namespace docent::compile {
namespace {

/// Doors wider than that have two leaves, metres.
constexpr double widest_leaf = 1.3;

/// How a door opens, and where its leaf hangs.
void hang(const config::DoorSection& section, Door& door) {
  const std::string &opens = section.opens.value, &swing = section.swing.value;
  if (swing == "none" || (opens.empty() && swing.empty())) return;
  door.opens = opens == "sliding" || swing == "sliding" ? DoorOpens::Sliding
               : opens == "pull"                        ? DoorOpens::Pull
                                                        : DoorOpens::Push;
  const bool is_wide = glm::distance(door.a, door.b) > widest_leaf;
  door.hinge = swing == "left"                ? DoorHinge::A
               : swing == "right"             ? DoorHinge::B
               : swing == "double" || is_wide ? DoorHinge::Both
                                              : DoorHinge::A;
}

}  // namespace

/// The doors of a floor that have both ends.
std::vector<const config::DoorSection*> door_sections(const config::MuseumConfig& config,
                                                      std::size_t floor) {
  std::vector<const config::DoorSection*> sections;
  for (const config::DoorSection& section : config.doors)
    if (section.a.given && section.b.given &&
        config::floor_index(config, section.floor.value) == floor)
      sections.push_back(&section);
  return sections;
}

std::vector<Door> doors_of(const config::MuseumConfig& config, std::size_t floor) {
  std::vector<Door> doors;
  for (const config::DoorSection* section : door_sections(config, floor)) {
    doors.push_back({.name = section->called().value,
                     .a = section->a.value,
                     .b = section->b.value,
                     .closed = section->closed.value,
                     .hours = section->hours.value});
    hang(*section, doors.back());
  }
  return doors;
}

}  // namespace docent::compile

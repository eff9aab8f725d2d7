#include "content/compile/compile_connections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "content/compile/check_footprints.h"

namespace docent::compile {
namespace {

constexpr double storey = 4;             // metres, where heights do not say
constexpr double stairs_sine = 0.5;      // 30 degrees, as comfortable stairs and all escalators
constexpr double speed_on_stairs = 0.5;  // metres a second along them; also an escalator's
constexpr double ordinary_slope = 0.06;  // of ramps for wheelchairs (DIN 18040-1)
constexpr double wait_for_lift = 25;     // seconds, with its doors
constexpr double lift_seconds_a_floor = 3;

template <typename Names, typename Enum>
void take_choice(const Names& names, const config::Located<std::string>& written, Enum& value) {
  const auto name = std::ranges::find(names, written.value);
  if (name != names.end()) value = static_cast<Enum>(name - names.begin());
}

class ConnectionCompiler {
 public:
  ConnectionCompiler(const config::MuseumConfig& config,
                     std::span<const std::shared_ptr<const path::FloorMap>> maps,
                     std::span<const CompiledFloor> floors, Museum& museum, Report& report)
      : config_(config), maps_(maps), floors_(floors), museum_(museum), report_(report) {}

  void add(const config::ConnectionSection& section) {
    Connection connection;
    connection.id = section.id.value;
    take_choice(config::connection_kinds, section.kind, connection.kind);
    take_choice(config::connection_directions, section.direction, connection.direction);
    connection.closed = section.closed.value;
    connection.hours = section.hours.value;
    for (const config::StopSection& stop : section.stops.value) add_stop(section, stop, connection);
    if (connection.stops.size() < std::max<std::size_t>(2, section.stops.value.size())) return;
    std::ranges::stable_sort(connection.stops, {}, [&](const ConnectionStop& stop) {
      return museum_.floors[stop.floor].plan.ordinal;
    });
    set_costs(section, connection);
    museum_.connections.push_back(std::move(connection));
  }

 private:
  void add_stop(const config::ConnectionSection& section, const config::StopSection& stop,
                Connection& connection) {
    const std::size_t floor = config::floor_index(config_, stop.floor.value);
    if (!stop.position.given || floor >= maps_.size() || !maps_[floor]) return;
    if (const auto problem = why_not_there(*maps_[floor], floors_[floor].standing,
                                           stop.position.value, museum_.body_radius))
      return report_.add(config::diagnostic_at(
          config_, stop.position.place, "connection-outside-floor",
          fmt::format("nobody can stand where connection '{}' is entered on floor '{}'",
                      section.id.value, config_.floors[floor].name.value),
          problem->label, problem->hint));
    connection.stops.push_back(
        {.floor = static_cast<std::uint32_t>(floor),
         .placement = {stop.position.value, stop.facing.value * std::numbers::pi / 180}});
  }

  /// Metres from one floor up to the next, between a connection's lowest stop and its highest.
  double rise(const Connection& connection) const {
    const FloorPlan& low = museum_.floors[connection.stops.front().floor].plan;
    const FloorPlan& high = museum_.floors[connection.stops.back().floor].plan;
    const double floors = std::max(1, high.ordinal - low.ordinal);
    return high.height > low.height ? (high.height - low.height) / floors : storey;
  }

  void set_costs(const config::ConnectionSection& section, Connection& connection) const {
    const double up = rise(connection);
    switch (connection.kind) {
      case ConnectionKind::Stairs:
      case ConnectionKind::Escalator:
        connection.metres_per_floor = up / stairs_sine;
        connection.seconds_per_floor = connection.metres_per_floor / speed_on_stairs;
        break;
      case ConnectionKind::Lift:
        connection.step_free = true;
        connection.wait_seconds = wait_for_lift;
        connection.seconds_per_floor = lift_seconds_a_floor;
        break;
      case ConnectionKind::Ramp:
        connection.step_free = true;
        connection.metres_per_floor =
            std::hypot(up, up / (section.slope.given ? section.slope.value : ordinary_slope));
        connection.seconds_per_floor = connection.metres_per_floor / strolling_pace;
        break;
    }
    if (section.step_free.given) connection.step_free = section.step_free.value;
    if (section.wait_seconds.given) connection.wait_seconds = section.wait_seconds.value;
    if (section.seconds_per_floor.given)
      connection.seconds_per_floor = section.seconds_per_floor.value;
  }

  const config::MuseumConfig& config_;
  std::span<const std::shared_ptr<const path::FloorMap>> maps_;
  std::span<const CompiledFloor> floors_;
  Museum& museum_;
  Report& report_;
};

}  // namespace

void compile_connections(const config::MuseumConfig& config,
                         std::span<const std::shared_ptr<const path::FloorMap>> maps,
                         std::span<const CompiledFloor> floors, Museum& museum, Report& report) {
  ConnectionCompiler compiler(config, maps, floors, museum, report);
  for (const config::ConnectionSection& section : config.connections) compiler.add(section);
}

}  // namespace docent::compile

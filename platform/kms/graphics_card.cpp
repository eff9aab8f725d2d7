#include "platform/kms/graphics_card.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>

namespace docent::kms {
namespace {

using Resources = std::unique_ptr<drmModeRes, CloseWith<drmModeFreeResources>>;
using DrmConnector = std::unique_ptr<drmModeConnector, CloseWith<drmModeFreeConnector>>;
using Encoder = std::unique_ptr<drmModeEncoder, CloseWith<drmModeFreeEncoder>>;
using PlaneList = std::unique_ptr<drmModePlaneRes, CloseWith<drmModeFreePlaneResources>>;
using Plane = std::unique_ptr<drmModePlane, CloseWith<drmModeFreePlane>>;
using ObjectProperties =
    std::unique_ptr<drmModeObjectProperties, CloseWith<drmModeFreeObjectProperties>>;
using Property = std::unique_ptr<drmModePropertyRes, CloseWith<drmModeFreeProperty>>;

struct PropertyValue {
  std::uint32_t id = 0;
  std::uint64_t value = 0;
};

std::optional<PropertyValue> find_property(int fd, std::uint32_t object, std::uint32_t type,
                                           std::string_view name) {
  const ObjectProperties all(drmModeObjectGetProperties(fd, object, type));
  if (!all) return std::nullopt;
  for (std::uint32_t i = 0; i < all->count_props; ++i) {
    const Property property(drmModeGetProperty(fd, all->props[i]));
    if (property && name == property->name)
      return PropertyValue{property->prop_id, all->prop_values[i]};
  }
  return std::nullopt;
}

/// Finds one object's properties by name; false where one is missing.
struct Wanted {
  std::uint32_t* id;
  const char* name;
};
bool find_properties(int fd, std::uint32_t object, std::uint32_t type,
                     std::initializer_list<Wanted> wanted) {
  return std::ranges::all_of(wanted, [&](const Wanted& w) {
    const auto found = find_property(fd, object, type, w.name);
    *w.id = found ? found->id : 0;
    return found.has_value();
  });
}

bool find_properties(int fd, Pipe& pipe) {
  PlaneProperties& p = pipe.on_plane;
  return find_properties(fd, pipe.connector, DRM_MODE_OBJECT_CONNECTOR,
                         {{&pipe.connector_crtc, "CRTC_ID"}}) &&
         find_properties(fd, pipe.crtc, DRM_MODE_OBJECT_CRTC,
                         {{&pipe.crtc_mode, "MODE_ID"}, {&pipe.crtc_active, "ACTIVE"}}) &&
         find_properties(fd, pipe.plane, DRM_MODE_OBJECT_PLANE,
                         {{&p.fb, "FB_ID"},
                          {&p.crtc, "CRTC_ID"},
                          {&p.src_x, "SRC_X"},
                          {&p.src_y, "SRC_Y"},
                          {&p.src_w, "SRC_W"},
                          {&p.src_h, "SRC_H"},
                          {&p.crtc_x, "CRTC_X"},
                          {&p.crtc_y, "CRTC_Y"},
                          {&p.crtc_w, "CRTC_W"},
                          {&p.crtc_h, "CRTC_H"}});
}

/// A bit for each CRTC that can feed the connector.
std::uint32_t crtcs_of(int fd, const drmModeConnector& connector) {
  std::uint32_t crtcs = 0;
  for (const std::uint32_t id :
       std::span(connector.encoders, static_cast<std::size_t>(connector.count_encoders)))
    if (const Encoder encoder(drmModeGetEncoder(fd, id)); encoder) crtcs |= encoder->possible_crtcs;
  return crtcs;
}

/// How the panel is built in (drm-kms, "Standard Connector Properties": panel orientation). Its
/// left side up: it was turned clockwise by a quarter.
Rotation panel_of(int fd, std::uint32_t connector) {
  constexpr std::array turns{Rotation::None, Rotation::Half, Rotation::Quarter,
                             Rotation::ThreeQuarters};
  const auto orientation =
      find_property(fd, connector, DRM_MODE_OBJECT_CONNECTOR, "panel orientation");
  return orientation && orientation->value < turns.size() ? turns[orientation->value]
                                                          : Rotation::None;
}

/// Thousandths of a hertz, from the pixel clock; the mode's own number is rounded.
std::uint32_t refresh_mhz(const drmModeModeInfo& mode) {
  const std::uint64_t pixels = std::uint64_t{mode.htotal} * mode.vtotal;
  if (pixels == 0 || mode.clock == 0) return mode.vrefresh * 1000;
  std::uint64_t mhz = std::uint64_t{mode.clock} * 1'000'000 / pixels;
  if ((mode.flags & DRM_MODE_FLAG_INTERLACE) != 0) mhz *= 2;
  if ((mode.flags & DRM_MODE_FLAG_DBLSCAN) != 0) mhz /= 2;
  return static_cast<std::uint32_t>(mhz);
}

Mode mode_of(const drmModeModeInfo& mode) {
  return {.size = {mode.hdisplay, mode.vdisplay},
          .refresh_mhz = refresh_mhz(mode),
          .is_preferred = (mode.type & DRM_MODE_TYPE_PREFERRED) != 0,
          .is_interlaced = (mode.flags & DRM_MODE_FLAG_INTERLACE) != 0};
}

void read_connectors(int fd, const drmModeRes& resources, Probe probe, CardReading& reading) {
  for (const std::uint32_t id :
       std::span(resources.connectors, static_cast<std::size_t>(resources.count_connectors))) {
    const DrmConnector connector(probe == Probe::Yes ? drmModeGetConnector(fd, id)
                                                     : drmModeGetConnectorCurrent(fd, id));
    if (!connector) continue;
    const char* kind = drmModeGetConnectorTypeName(connector->connector_type);
    Connector& here = reading.state.connectors.emplace_back();
    here.id = id;
    here.name =
        fmt::format("{}-{}", kind != nullptr ? kind : "screen", connector->connector_type_id);
    here.is_connected = connector->connection == DRM_MODE_CONNECTED;
    here.crtcs = crtcs_of(fd, *connector);
    here.width_mm = connector->mmWidth;
    here.height_mm = connector->mmHeight;
    here.panel = panel_of(fd, id);
    const std::span modes(connector->modes, static_cast<std::size_t>(connector->count_modes));
    reading.modes.emplace_back(modes.begin(), modes.end());
    for (const drmModeModeInfo& mode : modes) here.modes.push_back(mode_of(mode));
  }
}

void read_planes(int fd, CardState& state) {
  const PlaneList planes(drmModeGetPlaneResources(fd));
  if (!planes) return;
  for (const std::uint32_t id : std::span(planes->planes, planes->count_planes)) {
    const Plane plane(drmModeGetPlane(fd, id));
    if (!plane) continue;
    const auto type = find_property(fd, id, DRM_MODE_OBJECT_PLANE, "type");
    if (type && type->value == DRM_PLANE_TYPE_PRIMARY)
      state.planes.push_back({id, plane->possible_crtcs});
  }
}

/// Could be driven at all, and is a screen there that is wanted?
enum class Use : std::uint8_t { Now, Later };

Result<GraphicsCard> open_one(const std::string& path, const WantedOutput& wanted, Use use) {
  const auto failed = [&](std::string_view why) {
    return std::unexpected(Error{Errc::Environment, fmt::format("{}: {}", path, why)});
  };
  GraphicsCard card{path, FileDescriptor(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK))};
  const int fd = card.fd.get();
  if (fd < 0)
    return failed(fmt::format("{}; the user must be in the group video", std::strerror(errno)));
  if (drmSetClientCap(fd, DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1) != 0 ||
      drmSetClientCap(fd, DRM_CLIENT_CAP_ATOMIC, 1) != 0)
    return failed("its driver has no atomic mode setting");
  if (drmSetMaster(fd) != 0)
    return failed(
        "another program draws on it; end that program (a desktop, say) or use "
        "--display window");
  const CardState state = read_card(fd, Probe::Yes).state;
  if (use == Use::Now && output_plans(state, wanted).empty())
    return failed("no screen is connected to it");
  if (state.connectors.empty() || state.planes.empty())
    return failed("it has no socket for a screen");
  return card;
}

std::vector<std::string> card_paths() {
  constexpr int most_cards = 16;
  std::vector<std::string> paths;
  for (int i = 0; i < most_cards; ++i)
    if (std::string path = fmt::format("/dev/dri/card{}", i); access(path.c_str(), F_OK) == 0)
      paths.push_back(std::move(path));
  return paths;
}

Result<GraphicsCard> open_first(const WantedOutput& wanted, Use use) {
  Error why{Errc::Environment,
            "there is no graphics card (/dev/dri/card*); use --display window or headless"};
  for (const std::string& path : card_paths()) {
    auto card = open_one(path, wanted, use);
    if (card) return card;
    why = card.error();
  }
  return std::unexpected(why);
}

}  // namespace

Result<GraphicsCard> open_graphics_card(const WantedOutput& wanted) {
  auto card = open_first(wanted, Use::Now);
  return card ? std::move(card) : open_first(wanted, Use::Later);
}

bool is_a_card_free() noexcept {
  return open_first({}, Use::Now).has_value();
}

bool has_other_card(const GraphicsCard& card, const WantedOutput& wanted) noexcept {
  return std::ranges::any_of(card_paths(), [&](const std::string& path) {
    return path != card.path && open_one(path, wanted, Use::Now).has_value();
  });
}

CardReading read_card(int fd, Probe probe) {
  CardReading reading;
  const Resources resources(drmModeGetResources(fd));
  if (!resources) return reading;
  const std::span crtcs(resources->crtcs, static_cast<std::size_t>(resources->count_crtcs));
  reading.state.crtcs.assign(crtcs.begin(), crtcs.end());
  read_connectors(fd, *resources, probe, reading);
  read_planes(fd, reading.state);
  return reading;
}

std::vector<Pipe> pipes_of(int fd, const CardReading& reading, const OutputPlan& plan) {
  std::vector<Pipe> pipes;
  for (const Route& route : plan.routes) {
    Pipe& pipe = pipes.emplace_back();
    const Connector& connector = reading.state.connectors[route.connector];
    pipe.connector_name = connector.name;
    pipe.connector = connector.id;
    pipe.crtc = reading.state.crtcs[route.crtc];
    pipe.plane = reading.state.planes[route.plane].id;
    pipe.mode = reading.modes[route.connector][route.mode];
    pipe.place = route.place;
    if (!find_properties(fd, pipe)) return {};
  }
  return pipes;
}

std::vector<PropertyWrite> writes_turning_off_others(int fd, const CardReading& reading,
                                                     const std::vector<Pipe>& pipes) {
  std::vector<PropertyWrite> writes;
  const auto clear = [&](std::uint32_t object, std::uint32_t type,
                         std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (const auto found = find_property(fd, object, type, name); found && found->value != 0)
        writes.push_back({object, found->id, 0});
  };
  const auto is_driven = [&](std::uint32_t object) {
    return std::ranges::any_of(pipes, [&](const Pipe& pipe) {
      return pipe.connector == object || pipe.crtc == object || pipe.plane == object;
    });
  };
  for (const Connector& connector : reading.state.connectors)
    if (!is_driven(connector.id)) clear(connector.id, DRM_MODE_OBJECT_CONNECTOR, {"CRTC_ID"});
  for (const std::uint32_t crtc : reading.state.crtcs)
    if (!is_driven(crtc)) clear(crtc, DRM_MODE_OBJECT_CRTC, {"ACTIVE", "MODE_ID"});
  for (const PrimaryPlane& plane : reading.state.planes)
    if (!is_driven(plane.id)) clear(plane.id, DRM_MODE_OBJECT_PLANE, {"FB_ID", "CRTC_ID"});
  return writes;
}

}  // namespace docent::kms

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/model/geometry/vec2.h"
#include "runtime/path/way.h"
#include "runtime/scene/light.h"

namespace docent::scene {

/// A rectangle of the screen frame: [0, 1] by [0, 1], origin top left, y down, after rotation.
struct Rect {
  float x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Rect&) const = default;
};

constexpr bool contains(const Rect& r, float x, float y) noexcept {
  return x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height;
}

/// An edge of the glass at which somebody stands. What they read stands upright as they see it:
/// turned clockwise by a quarter for each (side.h).
enum class Side : std::uint8_t { Bottom, Left, Top, Right };

/// A picture or a set text in texture memory. The kiosk numbers the building's pictures from 1; the
/// planner's cache of pieces hands out the numbers after those.
enum class TextureId : std::uint32_t { None = 0 };

/// How a rectangle of the interface is filled.
enum class QuadFill : std::uint8_t {
  Solid,   ///< One colour.
  Text,    ///< The texture's red channel is coverage, tinted by the colour; drawn texel for pixel.
  Image,   ///< The texture's colours, times the colour.
  Shadow,  ///< A soft shadow of the rectangle with corners; `softness` is its reach.
  Ring,    ///< An annulus inscribed in the rectangle: the answer to a touch. `softness` is its
           ///< thickness.
  Frame,   ///< The outline of the rectangle with corners, within it, `softness` thick.
};

/// What is seen of a rectangle from its upper to its lower edge, where it lies in a part of the
/// glass that scrolls. Shares of the screen's height, as it is seen from the rectangle's side.
struct Clip {
  float top = -1, bottom = 2;
  float fade_above = 0, fade_below = 0;  ///< Within these it fades towards that edge.
  bool operator==(const Clip&) const = default;
};

/// One rectangle of the interface, in the order to be drawn.
struct Quad {
  Rect rect;
  QuadFill fill = QuadFill::Solid;
  Colour colour;
  TextureId texture = TextureId::None;
  Rect uv{0, 0, 1, 1};
  float corner = 0;    ///< Corner radius, as a share of the screen's shorter side.
  float softness = 0;  ///< As a share of the screen's shorter side.
  Clip clip{};
  Side side = Side::Bottom;  ///< From where its texture stands upright, and its clip is counted.
  bool operator==(const Quad&) const = default;
};

/// A camera that looks at the model.
struct CameraView {
  Vec3 eye{};
  Vec3 target{};
  float vertical_fov = 0.52F;  ///< Radians.
  Mat4 view{1};
  Mat4 projection{1};
  bool operator==(const CameraView&) const = default;
};

/// An avatar to be drawn: matrices_of(the mesh) matrices of DrawList::palette from `first_matrix`,
/// world frame: the skeleton's joints in their order, then its cloth's nodes.
struct AvatarDraw {
  std::uint32_t first_matrix = 0;
  std::uint32_t look = 0;  ///< Of `looks` (look.h).
  Vec3 feet[2]{};          ///< World frame: under each foot on the floor, for the contact shadows.
  float foot_height[2]{};  ///< Metres of each sole above the floor: the shadow fades as it rises.
  Vec3 centre{};           ///< World frame: the hips.
  float scale = 1;         ///< How much larger than life it is drawn.
};

/// An exhibit's own shape: Museum::objects[object], on its foot in the world frame.
struct ObjectDraw {
  std::uint32_t object = 0;
  Vec3 foot{};
  float heading = 0;  ///< Radians, floor frame: where its front looks.
  float scale = 1;    ///< Of its own size.
  float glow = 0;     ///< How much brighter it is than it is lit.
  bool operator==(const ObjectDraw&) const = default;
};

/// A way on the floor: `count` points of DrawList::ribbon_point from `first`. Width and pattern
/// follow the kind.
struct RibbonDraw {
  RouteKind kind = RouteKind::Shortest;
  /// Whose trail it is: the colour of that look; none: that of the kind.
  std::optional<std::uint32_t> look{};
  std::uint32_t first = 0, count = 0;
  std::uint32_t revision =
      0;  ///< Changes when the points do, so that the renderer rebuilds its strip only then.
  float length = 0;  ///< Metres.
  float walked = 0;  ///< Metres already behind the guide: dimmed.
  float flow = 0;    ///< Metres the pattern has moved towards the goal.
  float opacity = 1;
  bool operator==(const RibbonDraw&) const = default;
};

/// A mark on the floor, such as "you are here" or the goal. World frame; a disc of `radius` metres.
struct MarkerDraw {
  enum class Kind : std::uint8_t { YouAreHere, Goal, Exhibit, SelectedExhibit, Doorway };
  Kind kind = Kind::Goal;
  std::optional<std::uint32_t> look{};  ///< Whose it is: the colour of that look; none: vermilion.
  Vec3 position{};
  float radius = 0.3F;  ///< Metres; of a doorway half its width.
  float heading = 0;    ///< Radians, floor frame; YouAreHere shows it, a doorway is walked by it.
  float opacity = 1;
  bool operator==(const MarkerDraw&) const = default;
};

/// Metres above the floor to which walls sink where they would hide something.
inline constexpr double sunk_height = 0.12;

/// How far walls have sunk (sunk_walls.h), by cells of the floor: 0 stands, 255 is down. A cell
/// lies in column and row of its number modulo `side`; walls beyond the window stand.
struct WallLevels {
  static constexpr int side = 128;
  static constexpr double cell = 0.25;  ///< Metres.
  std::int32_t column = 0, row = 0;     ///< The window's first cell, in cells from the origin.
  bool any = false;                     ///< Has any wall sunk at all?
  std::vector<std::uint8_t> level;      ///< Row by row, `side` squared; may be empty.
  bool operator==(const WallLevels&) const = default;
};

/// A leaf of a door, from its hinges along the floor.
struct LeafDraw {
  Vec2 hinge{};            ///< Floor frame.
  Vec2 along{1, 0};        ///< Where its free end is; of length 1.
  float width = 1;         ///< Metres.
  float floor_height = 0;  ///< World y.
  bool operator==(const LeafDraw&) const = default;
};

/// Of a floor, at most.
inline constexpr std::size_t most_leaves = 64;

/// Everything that one frame shows, in the order to be drawn. The guide reserves its vectors when
/// it is made, so filling it does not allocate.
struct DrawList {
  std::uint32_t floor = 0;
  CameraView camera;
  Light light;
  /// Parts of the building further than a radius from the focus fade towards the paper colour.
  Vec2 focus{};               ///< Where the attention is, floor frame.
  float focus_radius = 1e3F;  ///< Metres within which nothing fades; below 0: even the focus does.
  float fade = 0.62F;         ///< How far they fade: 1 leaves nothing but paper.
  Vec2 goal{};                ///< Floor frame: it is a little brighter about the goal.
  float goal_radius = 0;      ///< Metres. 0: no goal.
  std::optional<std::uint32_t> highlighted_exhibit{};
  WallLevels walls;
  std::vector<LeafDraw> leaves;
  std::vector<AvatarDraw> avatars;
  std::vector<Mat4> palette;
  std::vector<Vec3> joint;  ///< Of each matrix: where its joint or node is, world frame.
  std::vector<ObjectDraw> objects;
  /// The one that is looked at, or about to be: it is drawn from nearby, where that is at hand.
  std::optional<std::uint32_t> near_object{};
  std::vector<RibbonDraw> ribbons;
  std::vector<Vec2> ribbon_point;
  std::vector<MarkerDraw> markers;
  std::vector<Quad> quads;  ///< Over everything, in order.
};

}  // namespace docent::scene

#include "platform/gles/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "platform/gles/avatar_pass.h"
#include "platform/gles/extension.h"
#include "platform/gles/extent.h"
#include "platform/gles/holdings_parts.h"
#include "platform/gles/object_pass.h"
#include "platform/gles/one_of_each.h"
#include "platform/gles/panel_pass.h"
#include "platform/gles/pieces.h"
#include "platform/gles/program.h"
#include "platform/gles/quad_pass.h"
#include "platform/gles/scene_buffer.h"
#include "platform/gles/scenery_pass.h"
#include "platform/gles/shaders.h"
#include "platform/gles/way_pass.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/scene/uncovered.h"

namespace docent::gles {
namespace {

/// Block `Frame` of frame.glsl, in std140 layout.
struct FrameBlock {
  Mat4 view_projection;
  Vec4 eye, sun, focus, goal, paper, lightmap, sun_colour, sky_colour, bounce_colour, lamp;
};

constexpr float light_of_goal = 0.16F;

Vec4 colour_of(const scene::Colour& c) noexcept {
  return {c.r, c.g, c.b, c.a};
}

Vec4 place_on_floor(Vec2 place, float radius, float amount) noexcept {
  const Vec3 world = to_world(place);
  return {world.x, world.z, radius, amount};
}

FrameBlock frame_block(const scene::DrawList& list, const Building* building) noexcept {
  FrameBlock frame{};
  frame.view_projection = list.camera.projection * list.camera.view;
  frame.eye = Vec4(list.camera.eye, 1);
  frame.focus = place_on_floor(list.focus, list.focus_radius, list.fade);
  frame.goal = place_on_floor(list.goal, list.goal_radius, light_of_goal);
  frame.paper = colour_of(list.light.paper);
  frame.sun = Vec4(0, 1, 0, 0);
  frame.sun_colour = colour_of(list.light.sun);
  frame.sky_colour = colour_of(list.light.sky);
  frame.bounce_colour = colour_of(list.light.bounce);
  frame.lamp = colour_of(list.light.lamp);
  if (building) {
    const Scenery& scenery = building->scenery;
    const Vec2 size = scenery.lightmap_max - scenery.lightmap_min;
    // The lightmap's rows run north, world z runs south.
    frame.lightmap = {static_cast<float>(scenery.lightmap_min.x),
                      static_cast<float>(-scenery.lightmap_min.y), static_cast<float>(1 / size.x),
                      static_cast<float>(-1 / size.y)};
    frame.sun = Vec4(scenery.sun, building->floor_height);
  }
  return frame;
}

/// Clearing costs something, too.
bool is_worth_hiding(const Region& region) noexcept {
  constexpr GLint least = 24;  // pixels
  return region.right - region.left >= least && region.high - region.low >= least;
}

using Held = Holdings::Parts;

/// What is drawn, and into which picture.
struct Shot {
  const scene::DrawList& list;
  const Held& held;
  const Building* building;  ///< None: there is none on that floor.
  Vec3 sun;
  GLuint framebuffer;  ///< Encodes sRGB.
  PixelSize size;
  const RenderTarget* panel;  ///< To which the picture is copied; null: that is the target itself.
  std::uint32_t age;          ///< As Display::age().
};

/// The interface in a part of the picture: where the model changes nothing of it, because nothing
/// is seen through it, and wherever else it lies.
struct Interface {
  std::array<Region, 8> opaque{};  ///< The largest.
  Pieces rest;
  std::int64_t area() const noexcept {
    std::int64_t sum = rest.area();
    for (const Region& region : opaque) sum += region.area();
    return sum;
  }
};

/// The region of all but what lies in that one of the others which has most of it.
std::array<Region, 4> without(std::span<const Region> others, const Region& region) noexcept {
  const auto& most = *std::ranges::max_element(
      others, {}, [&](const Region& other) { return common(other, region).area(); });
  return beside(common(most, region), region);
}

Interface interface_in(const Region& part, const Shot& shot) noexcept {
  Interface interface;
  for (const scene::Quad& quad : shot.list.quads) {
    Region& smallest = *std::ranges::min_element(interface.opaque, {}, &Region::area);
    const Region region = common(region_behind(quad, shot.size), part);
    if (region.area() > smallest.area()) smallest = region;
  }
  for (const scene::Quad& quad : shot.list.quads)
    for (const Region& piece :
         without(interface.opaque,
                 common(region_of(extent_of(scene::reach_of(quad)), shot.size), part)))
      interface.rest.add(piece);
  return interface;
}

}  // namespace

struct Renderer::Parts {
  explicit Parts(const RendererOptions& options)
      : buffer(options.samples, options.buffer_bytes),
        frame(make_buffer()),
        array(make_vertex_array()) {}

  Result<void> compile();
  /// Draws what differs; all of the model, where that is asked for, with this share of the
  /// picture's lines and columns.
  void draw(const Shot& shot, const scene::Change& change, float fineness) noexcept;
  /// `pixels`: of the model as it is drawn.
  void prepare(const Shot& shot, PixelSize pixels) noexcept;
  /// Where the picture has to be drawn anew: of the model, and of the interface, which often lie
  /// far from each other, as a video and a guide who breathes do. One is empty where both together
  /// are no larger. `seen`: where the interface does not cover the model.
  std::array<Region, 2> regions_of_change(const Shot& shot, const scene::Change& change,
                                          const Region& seen) noexcept;
  /// The next rows of what was drawn coarsely; empty where nothing was.
  Region take_coarse_rows() noexcept;
  void forget_coarse_picture() noexcept;
  void draw_part(const Shot& shot, const Region& part, const Region& seen) noexcept;
  /// Where all of the model is drawn with fewer `pixels`: what of the picture is `changed`.
  void draw_coarsely(const Shot& shot, const Region& changed, const scene::Change& change,
                     PixelSize pixels) noexcept;
  /// The model is enlarged onto the panel itself, and by way of the picture, which is large, only
  /// where the interface lets it be seen. `interface_changed`: where the interface in the picture
  /// is not that of now.
  void show_coarsely(const Shot& shot, const Region& changed, const Interface& interface,
                     const Region& interface_changed) noexcept;
  /// Enlarges that part of the coarse picture into the picture, with the interface on it.
  void enlarge_part(const Shot& shot, const Region& part) noexcept;
  void show(const Shot& shot, const Region& changed) noexcept;
  /// Draws a part of the model, so many pixels large, into a framebuffer of that size.
  void draw_model(const Shot& shot, const Region& part, PixelSize pixels,
                  GLuint framebuffer) noexcept;
  void draw_strip(const Shot& shot, PixelSize pixels, std::uint32_t strip,
                  const Region& part) noexcept;
  void draw_interface(const Shot& shot, const Region& part) noexcept;

  SceneBuffer buffer;
  Picture coarse_picture{GL_LINEAR};
  Region coarse;                  ///< Where that is what is seen.
  bool is_on_panel_only = false;  ///< The picture lacks it.
  SceneryPass scenery;
  ObjectPass objects;
  AvatarPass avatars;
  WayPass way;
  QuadPass quads;
  bool shaders_encode = false, enlarges_encoded = false;
  PanelPass panel;
  Program enlarge;
  GlBuffer frame;
  GlVertexArray array;
  /// What there is a picture of, and where.
  struct Drawn {
    const Holdings* holdings = nullptr;
    GLuint framebuffer = 0;
    PixelSize size;
    bool operator==(const Drawn&) const = default;
  };
  Drawn drawn;
};

Result<void> Renderer::Parts::compile() {
  shaders_encode = can_shaders_encode();
  for (auto made : {scenery.compile(), objects.compile(), avatars.compile(), way.compile(),
                    quads.compile(), panel.compile()})
    if (!made) return made;
  enlarges_encoded = shaders_encode && can_read_encoded();
  forget_coarse_picture();
  auto enlarger = link_program("enlarge", {shaders::copy_vert}, {shaders::as_it_is_frag});
  if (!enlarger) return std::unexpected(enlarger.error());
  enlarge = std::move(*enlarger);
  glReleaseShaderCompiler();  // nothing is compiled from source any more
  glBindBuffer(GL_UNIFORM_BUFFER, frame.get());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(FrameBlock), nullptr, GL_STREAM_DRAW);
  return {};
}

/// Front to back: what hides the floor comes before it. Then what lies on the floor, then glass.
void Renderer::Parts::draw_strip(const Shot& shot, PixelSize pixels, std::uint32_t strip,
                                 const Region& part) noexcept {
  const scene::DrawList& list = shot.list;
  const SceneBuffer::Rows rows = buffer.rows(part);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glClearColor(list.light.paper.r, list.light.paper.g, list.light.paper.b, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const scene::Quad& quad : list.quads)
    if (const Region hidden = common(region_behind(quad, pixels), part); is_worth_hiding(hidden))
      buffer.hide(strip, part, hidden);
  if (shaders_encode) glDisable(framebuffer_encodes);
  avatars.draw_bodies(rows);
  objects.draw(list, shot.held.objects);
  if (shot.building) {
    scenery.draw_solids(*shot.building, list.highlighted_exhibit, shot.held.textures);
    scenery.draw_floors(*shot.building);
  }
  if (shaders_encode) glEnable(framebuffer_encodes);

  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -2);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  way.draw(list);
  glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  avatars.draw_shadows(rows);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  if (shot.building) scenery.draw_glass(*shot.building);
  glDepthMask(GL_TRUE);
}

void Renderer::Parts::draw_model(const Shot& shot, const Region& part, PixelSize pixels,
                                 GLuint framebuffer) noexcept {
  for (std::uint32_t strip = 0; strip < buffer.strips(); ++strip) {
    const Region here = buffer.part(strip, part);
    if (here.is_empty()) continue;
    glEnable(GL_SCISSOR_TEST);
    buffer.begin(strip, here);
    draw_strip(shot, pixels, strip, here);
    buffer.resolve(strip, here, framebuffer);
  }
}

void Renderer::Parts::enlarge_part(const Shot& shot, const Region& part) noexcept {
  if (part.is_empty()) return;
  glBindFramebuffer(GL_FRAMEBUFFER, shot.framebuffer);
  glViewport(0, 0, static_cast<GLsizei>(shot.size.width), static_cast<GLsizei>(shot.size.height));
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.left, part.low, part.right - part.left, part.high - part.low);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  enlarge.use();
  bind_texture(static_cast<GLuint>(Unit::Image), coarse_picture.texture());
  glBindVertexArray(array.get());
  if (enlarges_encoded) glDisable(framebuffer_encodes);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  if (enlarges_encoded) glEnable(framebuffer_encodes);
  glDisable(GL_SCISSOR_TEST);
  draw_interface(shot, part);
}

void Renderer::Parts::draw_coarsely(const Shot& shot, const Region& changed,
                                    const scene::Change& change, PixelSize pixels) noexcept {
  coarse_picture.fit(pixels);
  draw_model(shot, scaled(coarse, shot.size, pixels), pixels, coarse_picture.framebuffer());
  const Interface interface = interface_in(coarse, shot);
  is_on_panel_only = shot.panel != nullptr && enlarges_encoded && panel.copies_encoded() &&
                     !change.everything && 2 * interface.area() < coarse.area();
  if (is_on_panel_only) {
    show_coarsely(shot, changed, interface, region_of(extent_of(change.interface), shot.size));
    return;
  }
  enlarge_part(shot, coarse);
  for (const Region& part : beside(coarse, changed)) draw_interface(shot, part);
  show(shot, changed);
}

void Renderer::Parts::show_coarsely(const Shot& shot, const Region& changed,
                                    const Interface& interface,
                                    const Region& interface_changed) noexcept {
  for (const Region& piece : interface.rest.regions()) enlarge_part(shot, piece);
  for (const Region& part : interface.opaque) draw_interface(shot, common(part, interface_changed));
  for (const Region& part : beside(coarse, changed)) draw_interface(shot, part);
  // All that goes into one framebuffer comes together.
  const Region lacking = panel.lacking(*shot.panel, changed, shot.age);
  panel.copy_of(coarse_picture.texture(), coarse);
  for (const Region& piece : interface.rest.regions()) panel.copy(piece);
  for (const Region& part : interface.opaque) panel.copy(part);
  for (const Region& part : beside(coarse, lacking)) panel.copy(part);
}

void Renderer::Parts::show(const Shot& shot, const Region& changed) noexcept {
  if (shot.panel != nullptr) panel.copy(panel.lacking(*shot.panel, changed, shot.age));
}

void Renderer::Parts::draw_interface(const Shot& shot, const Region& part) noexcept {
  if (part.is_empty()) return;
  glBindFramebuffer(GL_FRAMEBUFFER, shot.framebuffer);
  glViewport(0, 0, static_cast<GLsizei>(shot.size.width), static_cast<GLsizei>(shot.size.height));
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.left, part.low, part.right - part.left, part.high - part.low);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  // The picture is opaque where the interface is, and covers a model that was not drawn.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  quads.draw(shot.list.quads, shot.size, shot.held.textures, part);
  glDisable(GL_SCISSOR_TEST);
}

void Renderer::Parts::draw_part(const Shot& shot, const Region& part, const Region& seen) noexcept {
  draw_model(shot, common(part, seen), shot.size, shot.framebuffer);
  draw_interface(shot, part);
}

void Renderer::Parts::prepare(const Shot& shot, PixelSize pixels) noexcept {
  const FrameBlock block = frame_block(shot.list, shot.building);
  glBindBuffer(GL_UNIFORM_BUFFER, frame.get());
  glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof block, &block);
  glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(Block::Frame), frame.get());
  way.prepare(shot.list);
  scenery.prepare(shot.list.walls, shot.list.leaves);
  avatars.prepare(shot.list, shot.held.body, shot.sun, pixels);
  bind_texture(static_cast<GLuint>(Unit::LightMap),
               shot.building ? shot.building->lightmap.get() : 0);
  bind_texture(static_cast<GLuint>(Unit::ShadeMap),
               shot.building ? shot.building->shade_map.get() : 0);
  buffer.fit(pixels);
}

std::array<Region, 2> Renderer::Parts::regions_of_change(const Shot& shot,
                                                         const scene::Change& change,
                                                         const Region& seen) noexcept {
  const PixelSize size = shot.size;
  Region model = avatars.moved(shot.list, change, shot.held.body, shot.sun, size);
  if (change.everything)
    return {Region{0, 0, static_cast<GLint>(size.width), static_cast<GLint>(size.height)}, {}};
  const double floor = shot.building ? shot.building->floor_height : 0;
  if (change.ways) model.include(region_of(WayPass::extent_of_ribbons(shot.list, floor), size));
  model = change.model ? seen : common(model, seen);
  const Region interface = region_of(extent_of(change.interface), size);
  Region both = model;
  both.include(interface);
  // The interface is blended with what is there, so nothing may be drawn twice.
  if (model.overlaps(interface) || both.area() <= model.area() + interface.area())
    return {both, {}};
  return {model, interface};
}

Region Renderer::Parts::take_coarse_rows() noexcept {
  if (coarse.is_empty()) return {};
  const Region rows = buffer.part(buffer.strip_of(coarse.low), coarse);
  coarse.low = rows.high;
  return rows;
}

/// It takes memory only where it is needed.
void Renderer::Parts::forget_coarse_picture() noexcept {
  coarse_picture =
      Picture(GL_LINEAR, enlarges_encoded ? Picture::Read::Encoded : Picture::Read::Decoded);
}

void Renderer::Parts::draw(const Shot& shot, const scene::Change& change, float fineness) noexcept {
  const bool is_all_drawn = change.everything || change.model;
  const bool is_coarse = is_all_drawn && fineness < 1;
  const PixelSize pixels = is_coarse ? scaled(shot.size, fineness) : shot.size;
  prepare(shot, pixels);
  const Region seen = region_of(extent_of(scene::uncovered(shot.list.quads)), shot.size);
  const std::array<Region, 2> regions = regions_of_change(shot, change, seen);
  Region region = regions[0];
  region.include(regions[1]);
  if (is_all_drawn) coarse = is_coarse ? common(region, seen) : Region{};
  if (is_coarse) {
    draw_coarsely(shot, region, change, pixels);
    return;
  }
  if (std::exchange(is_on_panel_only, false) && !coarse.is_empty()) enlarge_part(shot, coarse);
  const Region finer = take_coarse_rows();
  if (finer.is_empty()) {
    for (const Region& part : regions) draw_part(shot, part, seen);
    show(shot, region);
    return;
  }
  // Nothing is drawn twice: the interface is blended with what is there.
  const GLint left = 0, right = static_cast<GLint>(shot.size.width);
  const auto height = static_cast<GLint>(shot.size.height);
  Region among = common(region, {left, finer.low, right, finer.high});
  among.include(finer);
  draw_part(shot, common(region, {left, 0, right, finer.low}), seen);
  draw_part(shot, among, seen);
  draw_part(shot, common(region, {left, finer.high, right, height}), seen);
  region.include(finer);
  show(shot, region);
}

Renderer::Renderer(std::unique_ptr<Parts> parts) noexcept : parts_(std::move(parts)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

void Renderer::draw(const scene::DrawList& list, const Holdings& holdings,
                    const RenderTarget& target, const scene::Change& change, float fineness,
                    std::uint32_t age) noexcept {
  if (target.size.width == 0 || target.size.height == 0) return;
  const bool direct = target.encoding == Encoding::Srgb;
  const GLuint framebuffer = direct ? target.framebuffer : parts_->panel.picture(target.size);
  const Parts::Drawn now{&holdings, framebuffer, target.size};
  const bool is_there = std::exchange(parts_->drawn, now) == now;
  const Held& held = holdings.parts();
  const Building* building = held.building(list.floor);
  const Shot shot{.list = list,
                  .held = held,
                  .building = building,
                  .sun = building ? Vec3(building->scenery.sun) : Vec3(0, 1, 0),
                  .framebuffer = framebuffer,
                  .size = target.size,
                  .panel = direct ? nullptr : &target,
                  .age = age};
  parts_->draw(shot, is_there ? change : scene::Change{}, fineness);
}

bool Renderer::is_coarse() const noexcept {
  return !parts_->coarse.is_empty();
}

/// A driver that compiles shaders for the state they are used in does so here and not in a frame.
/// It draws in a corner of the target: what is compiled is the same.
void Renderer::warm_up(RenderTarget target) {
  constexpr PixelSize corner{150, 90};
  target.size = {std::min(corner.width, target.size.width),
                 std::min(corner.height, target.size.height)};
  const OneOfEach each = one_of_each();
  draw(each.list, each.holdings, target, {}, 0.5F);
  if (target.encoding == Encoding::Plain)  // straight onto it
    draw(each.list, each.holdings, target, {.everything = false, .model = true}, 0.5F);
  draw(each.list, each.holdings, target);
  glFinish();
  parts_->drawn = {};
  parts_->panel.forget();
  parts_->forget_coarse_picture();
}

Result<Renderer> make_renderer(const RendererOptions& options) {
  auto parts = std::make_unique<Renderer::Parts>(options);
  if (auto compiled = parts->compile(); !compiled) return std::unexpected(compiled.error());
  return Renderer(std::move(parts));
}

}  // namespace docent::gles
